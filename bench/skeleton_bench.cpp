// SPDX-License-Identifier: GPL-3.0-or-later
// Times the way from a mesh file to its curve skeleton, stage by stage; prints one line of JSON.
#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

#include "bench/bench_support.h"
#include "vcg_ext/core/constants.h"
#include "vcg_ext/exact/surface_tree.h"
#include "vcg_ext/mgf_skeleton.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/skeleton/smoothing.h"

namespace {

using mgf::Certification;
using mgf::bench::Json;

constexpr const char* kUsage =
    "usage: skeleton_bench MESH [--certify unproven|within|proven] [--epsilon E] [--threads N]\n";

struct Arguments {
  std::string mesh;
  mgf::GeodesicOptions geodesics;
};

Arguments parse(int count, char** values) {
  const std::map<std::string, Certification> words{{"unproven", Certification::kUnproven},
                                                   {"within", Certification::kWithin},
                                                   {"proven", Certification::kProven}};
  Arguments arguments;
  for (int i = 1; i < count; ++i) {
    const std::string word = values[i];
    const bool has_value = i + 1 < count;
    if (word == "--certify" && has_value) {
      arguments.geodesics.wanted = words.at(values[++i]);
    } else if (word == "--epsilon" && has_value) {
      arguments.geodesics.epsilon = std::stod(values[++i]);
    } else if (word == "--threads" && has_value) {
      arguments.geodesics.threads = static_cast<unsigned>(std::stoul(values[++i]));
    } else if (arguments.mesh.empty() && word.rfind("--", 0) != 0) {
      arguments.mesh = word;
    } else {
      throw std::invalid_argument(word);
    }
  }
  if (arguments.mesh.empty()) throw std::invalid_argument("no mesh");
  return arguments;
}

// The mean angle between the segments of a branch of the smooth curve, degrees.
double turning_of(const mgf::MedialAxis& axis, const mgf::CurveSkeleton& skeleton) {
  const mgf::SurfaceTree tree(axis.working.surface);
  const mgf::SmoothSkeleton smooth =
      mgf::smooth_skeleton(skeleton, mgf::build_branches(skeleton),
                           mgf::shape_interior(tree, axis.working.self_intersecting()));
  return smooth.mean_turning * 180.0 / mgf::kPi;
}

Json measure(const Arguments& arguments) {
  const mgf::bench::Stopwatch total;
  Json seconds;
  const auto add = [&seconds](const mgf::StageTimes& times) {
    for (const mgf::StageTime& time : times) seconds[time.stage] = time.seconds;
  };
  const mgf::TriangleSurface surface = mgf::bench::read_surface(arguments.mesh);
  seconds["read"] = total.wall();
  mgf::MedialAxisOptions axis_options;
  axis_options.use_threads(arguments.geodesics.threads);
  const mgf::MedialAxis axis = mgf::compute_medial_axis(surface, axis_options);
  add(axis.times);
  const double cpu_before_geodesics = total.cpu();
  const mgf::MedialGeodesicFunction function =
      mgf::compute_medial_geodesic_function(axis, arguments.geodesics);
  add(function.times);
  const double cpu_of_geodesics = total.cpu() - cpu_before_geodesics;
  mgf::SkeletonOptions options;
  options.threads = arguments.geodesics.threads;
  const mgf::CurveSkeletonResult result =
      mgf::compute_skeleton_hierarchy(axis, function.field, options);
  add(result.times);
  const mgf::CurveSkeleton skeleton =
      mgf::skeleton_at(result.hierarchy, options.theta, options.prune);
  seconds["total"] = total.wall();
  const double cpu = total.cpu();

  const auto& certification = function.field.geodesics.certification;
  const mgf::BettiNumbers betti = mgf::betti_numbers(skeleton);
  return {
      {"mesh", arguments.mesh},
      {"vertices", surface.points.size()},
      {"genus", axis.working.genus},
      {"topology", mgf::bench::word(axis.interior.certificate.topology)},
      {"facets", axis.complex.facet_count()},
      {"pairs", certification.size()},
      {"proven", std::count(certification.begin(), certification.end(), Certification::kProven)},
      {"within", std::count(certification.begin(), certification.end(), Certification::kWithin)},
      {"nodes", skeleton.node_count()},
      {"b0", betti.b0},
      {"b1", betti.b1},
      {"outside_edges", std::count(skeleton.outside.begin(), skeleton.outside.end(), char{1})},
      {"turning", turning_of(axis, skeleton)},
      {"wall", seconds["total"]},
      {"cpu", cpu},
      {"cpu_geodesics", cpu_of_geodesics},
      {"seconds", seconds}};
}

}  // namespace

int main(int count, char** values) {
  return mgf::bench::run_program(
      kUsage, [&] { return parse(count, values); },
      [](const Arguments& arguments) { mgf::bench::print_line(measure(arguments)); });
}
