// SPDX-License-Identifier: GPL-3.0-or-later
// Counts what the skeletons of meshes, and of their noisy copies, have: a Markdown row a mesh.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/bench_support.h"
#include "bench/program.h"
#include "vcg_ext/mgf_skeleton.h"
#include "vcg_ext/skeleton/branches.h"

namespace {

using namespace mgf;

constexpr const char* kUsage =
    "usage: leaf_study [--noise PERCENT [--any-direction] [--seeds N]] [--theta T] [--prune P]\n"
    "                  [--threads N] [--keep-crossings] MESH...\n"
    "--noise: every vertex moved along its normal by up to that share of the diagonal;\n"
    "--any-direction: by a normally distributed vector of that standard deviation instead;\n"
    "--keep-crossings: without mending crossing faces\n";

struct Arguments {
  std::vector<std::string> meshes;
  double noise = 0.0;  // per cent of the diagonal
  bool any_direction = false;
  unsigned seeds = 4;
  SkeletonOptions skeleton;
  MedialAxisOptions axis;
  GeodesicOptions geodesics;
};

Arguments parse(int count, char** values) {
  Arguments arguments;
  for (int i = 1; i < count; ++i) {
    const std::string word = values[i];
    const auto value = [&]() -> std::string {
      if (++i == count) throw std::invalid_argument(word);
      return values[i];
    };
    if (word == "--noise") {
      arguments.noise = std::stod(value());
    } else if (word == "--any-direction") {
      arguments.any_direction = true;
    } else if (word == "--seeds") {
      arguments.seeds = static_cast<unsigned>(std::stoul(value()));
    } else if (word == "--theta") {
      arguments.skeleton.theta = std::stod(value());
    } else if (word == "--prune") {
      arguments.skeleton.prune = std::stod(value());
    } else if (word == "--keep-crossings") {
      arguments.axis.preparation.mend_crossings = false;
    } else if (word == "--threads") {
      const auto threads = static_cast<unsigned>(std::stoul(value()));
      arguments.skeleton.threads = threads;
      arguments.axis.use_threads(threads);
      arguments.geodesics.threads = threads;
    } else if (word.rfind("--", 0) != 0) {
      arguments.meshes.push_back(word);
    } else {
      throw std::invalid_argument(word);
    }
  }
  if (arguments.meshes.empty()) throw std::invalid_argument("no mesh");
  return arguments;
}

std::vector<Vec3> vertex_normals(const TriangleSurface& surface) {
  std::vector<Vec3> normals(surface.points.size(), Vec3::Zero());
  for (const Triangle& t : surface.triangles) {
    const Vec3 side = surface.points[t[1]] - surface.points[t[0]];
    const Vec3 area = side.cross(surface.points[t[2]] - surface.points[t[0]]);
    for (const Index v : t) normals[v] += area;
  }
  for (Vec3& normal : normals) normal.normalize();  // zero stays zero
  return normals;
}

TriangleSurface noisy(TriangleSurface surface, const Arguments& arguments, unsigned seed) {
  const double size = 0.01 * arguments.noise * bounding_box_diagonal(surface.points);
  const std::vector<Vec3> normals = vertex_normals(surface);
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> along(-size, size);
  std::normal_distribution<double> component(0.0, size);
  for (std::size_t v = 0; v < normals.size(); ++v) {
    if (arguments.any_direction) {
      for (double& coordinate : surface.points[v]) coordinate += component(engine);
    } else {
      surface.points[v] += along(engine) * normals[v];
    }
  }
  return surface;
}

// The counts of the copies of a mesh, as lists.
struct Row {
  std::vector<std::string> leaves;
  std::vector<std::string> junctions;
  std::vector<std::string> cycles;
  std::vector<std::string> verdicts;
  std::vector<std::string> crossings;  // pairs mended / pairs left
  double largest_move = 0.0;           // share of the diagonal
  double cpu_seconds = 0.0;
};

void add_run(const TriangleSurface& surface, const Arguments& arguments, Row& row) {
  const bench::Stopwatch clock;
  const MedialAxis axis = compute_medial_axis(surface, arguments.axis);
  const MedialGeodesicFunction function =
      compute_medial_geodesic_function(axis, arguments.geodesics);
  const CurveSkeletonResult result =
      compute_skeleton_hierarchy(axis, function.field, arguments.skeleton);
  row.cpu_seconds += clock.cpu();
  const BranchGraph graph = build_branches(
      skeleton_at(result.hierarchy, arguments.skeleton.theta, arguments.skeleton.prune));
  const auto tips = std::count(graph.node_kind.begin(), graph.node_kind.end(), NodeKind::kTip);
  const Untangling& untangling = axis.working.untangling;
  row.leaves.push_back(std::to_string(tips));
  row.junctions.push_back(std::to_string(graph.junction_clusters));
  row.cycles.push_back(std::to_string(graph.cycles));
  row.verdicts.emplace_back(bench::word(axis.interior.certificate.topology));
  row.crossings.push_back(std::to_string(untangling.pairs_mended) + "/" +
                          std::to_string(untangling.left.size()));
  row.largest_move =
      std::max(row.largest_move, untangling.largest_move / bounding_box_diagonal(surface.points));
}

// "2, 2, 3", or "2" if all are the same.
std::string list(const std::vector<std::string>& words) {
  const bool alike = std::all_of(words.begin(), words.end(),
                                 [&](const std::string& word) { return word == words.front(); });
  std::string text = words.front();
  for (std::size_t i = 1; i < words.size() && !alike; ++i) text += ", " + words[i];
  return text;
}

void study(const std::string& path, const Arguments& arguments) {
  const TriangleSurface clean = bench::read_surface(path);
  const unsigned runs = arguments.noise > 0.0 ? arguments.seeds : 1;
  Row row;
  for (unsigned seed = 1; seed <= runs; ++seed) {
    add_run(arguments.noise > 0.0 ? noisy(clean, arguments, seed) : clean, arguments, row);
  }
  std::printf("| %s | %g | %s | %s | %s | %s | %s | %.2f | %.2f |\n",
              std::filesystem::path(path).stem().string().c_str(), arguments.noise,
              list(row.leaves).c_str(), list(row.junctions).c_str(), list(row.cycles).c_str(),
              list(row.verdicts).c_str(), list(row.crossings).c_str(), 100 * row.largest_move,
              row.cpu_seconds / runs);
  std::fflush(stdout);
}

void run(const Arguments& arguments) {
  std::printf(
      "| mesh | noise %% | leaves | junctions | cycles | topology | crossings mended/left | moved "
      "%% |"
      " cpu s |\n|---|---:|---|---|---|---|---|---:|---:|\n");
  for (const std::string& mesh : arguments.meshes) study(mesh, arguments);
}

}  // namespace

int main(int count, char** values) {
  return bench::run_program(
      kUsage, [&] { return parse(count, values); }, run);
}
