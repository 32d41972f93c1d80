// SPDX-License-Identifier: GPL-3.0-or-later
// What the topology stage, on one thread, makes of meshes: a line each, and of several a summary.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/bench_support.h"
#include "bench/program.h"
#include "vcg_ext/mgf_skeleton.h"

namespace mgf {
namespace {

constexpr const char* kUsage =
    "usage: topology_probe [--keep-surface] [--no-sampling] [--squeeze X,Y,Z] MESH...\n"
    "  --keep-surface   no flips of the surface\n"
    "  --no-sampling    no vertices added beforehand, however coarse the mesh\n"
    "  --squeeze X,Y,Z  coordinates are multiplied by these first\n";

struct Arguments {
  MedialAxisOptions options;
  Vec3 factors = Vec3::Ones();
  std::vector<std::string> meshes;
};

Vec3 parse_factors(const std::string& text) {
  std::istringstream stream(text);
  Vec3 factors;
  char comma = ',';
  for (int i = 0; i < 3; ++i) {
    if (i > 0) stream >> comma;
    if (!(stream >> factors[i]) || comma != ',') throw std::invalid_argument(text);
  }
  if (stream.peek() != std::istringstream::traits_type::eof()) throw std::invalid_argument(text);
  return factors;
}

Arguments parse(int count, char** values) {
  Arguments arguments;
  arguments.options.use_threads(1);
  for (int i = 1; i < count; ++i) {
    const std::string word = values[i];
    if (word == "--keep-surface") {
      arguments.options.recovery.recover_input_surface = true;
    } else if (word == "--no-sampling") {
      arguments.options.sampling.length = 0.0;
    } else if (word == "--squeeze" && i + 1 < count) {
      arguments.factors = parse_factors(values[++i]);
    } else if (word.rfind("--", 0) == 0) {
      throw std::invalid_argument(word);
    } else {
      arguments.meshes.push_back(word);
    }
  }
  if (arguments.meshes.empty()) throw std::invalid_argument("no mesh");
  return arguments;
}

std::string to_text(const BettiNumbers& betti) {
  return std::to_string(betti.b0) + "/" + std::to_string(betti.b1) + "/" + std::to_string(betti.b2);
}

double seconds_of(const MedialAxis& axis, const std::string& stage) {
  const auto found = std::find_if(axis.times.begin(), axis.times.end(),
                                  [&](const StageTime& time) { return time.stage == stage; });
  return found != axis.times.end() ? found->seconds : 0.0;
}

struct Probe {
  TopologyVerdict topology = TopologyVerdict::kFailed;
  bool isotopic = false;
  double added_share = 0.0;  // points that recovery added, over the vertices that it was given
  double seconds = 0.0;      // of the topology stage
};

// Prints a line. Throws what the reader and the stage throw.
Probe probe(const std::string& path, const Arguments& arguments) {
  TriangleSurface surface = bench::read_surface(path);
  for (Vec3& p : surface.points) p = p.cwiseProduct(arguments.factors);
  const MedialAxis axis = compute_medial_axis(surface, arguments.options);
  const TopologyCertificate& c = axis.interior.certificate;
  const double seconds = seconds_of(axis, "topology");
  std::printf(
      "%s: %u vertices, %u flips, +%u points (%u exact), %zu tetrahedra, %s%s b %s (%s), missing "
      "%u extra %u negative %u flattened %u conflicts %u buried %u, %.2f s, complex %.2f s\n",
      path.substr(path.rfind('/') + 1).c_str(), axis.interior.input_points, c.surface_flips,
      c.points_added, c.exact_points, axis.interior.tetrahedra.size(), bench::word(c.topology),
      c.isotopic ? " isotopic" : "", to_text(c.betti).c_str(), to_text(c.expected).c_str(),
      c.boundary_faces_missing, c.boundary_faces_extra, c.tetrahedra_not_positive,
      c.tetrahedra_flattened, c.winding_conflicts, c.interior_vertices, seconds,
      seconds_of(axis, "medial_complex"));
  return {c.topology, c.isotopic,
          static_cast<double>(c.points_added) / static_cast<double>(axis.interior.input_points),
          seconds};
}

void print_summary(const std::vector<Probe>& probes) {
  const auto with_verdict = [&](TopologyVerdict verdict) {
    return std::count_if(probes.begin(), probes.end(),
                         [=](const Probe& p) { return p.topology == verdict; });
  };
  std::vector<double> shares;  // of the proven
  double slowest = 0.0;
  for (const Probe& p : probes) {
    if (p.topology == TopologyVerdict::kProven) shares.push_back(p.added_share);
    slowest = std::max(slowest, p.seconds);
  }
  std::sort(shares.begin(), shares.end());
  const auto more_than = [&](double share) {
    return std::distance(std::upper_bound(shares.begin(), shares.end(), share), shares.end());
  };
  std::printf(
      "%zu meshes: %td proven, %td of them isotopic, %td counted, %td failed; of the proven, "
      "points "
      "added on %td, more than 1 %% on %td, more than 6 %% on %td, at most %.1f %%; slowest %.2f "
      "s\n",
      probes.size(), with_verdict(TopologyVerdict::kProven),
      std::count_if(probes.begin(), probes.end(), [](const Probe& p) { return p.isotopic; }),
      with_verdict(TopologyVerdict::kCounted), with_verdict(TopologyVerdict::kFailed),
      more_than(0.0), more_than(0.01), more_than(0.06),
      shares.empty() ? 0.0 : 100.0 * shares.back(), slowest);
}

void run(const Arguments& arguments) {
  std::vector<Probe> probes;
  for (const std::string& mesh : arguments.meshes) {
    try {
      probes.push_back(probe(mesh, arguments));
    } catch (const std::exception& error) {
      std::printf("%s: %s\n", mesh.c_str(), error.what());
    }
    std::fflush(stdout);
  }
  if (arguments.meshes.size() > 1) print_summary(probes);
  if (probes.size() < arguments.meshes.size()) throw std::runtime_error("not all meshes served");
}

}  // namespace
}  // namespace mgf

int main(int count, char** values) {
  return mgf::bench::run_program(
      mgf::kUsage, [&] { return mgf::parse(count, values); }, mgf::run);
}
