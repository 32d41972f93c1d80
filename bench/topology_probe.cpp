// SPDX-License-Identifier: GPL-3.0-or-later
// Prints a line on each mesh given: what the topology stage, on one thread, makes of it.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "bench_support.h"
#include "vcg_ext/mgf_skeleton.h"

namespace {

constexpr const char* kUsage = "usage: topology_probe [--keep-surface] MESH...\n";

const char* word(mgf::TopologyVerdict verdict) {
  switch (verdict) {
    case mgf::TopologyVerdict::kProven:
      return "proven";
    case mgf::TopologyVerdict::kCounted:
      return "counted";
    case mgf::TopologyVerdict::kFailed:
      return "failed";
  }
  return "";
}

std::string to_text(const mgf::BettiNumbers& betti) {
  return std::to_string(betti.b0) + "/" + std::to_string(betti.b1) + "/" + std::to_string(betti.b2);
}

// Throws what the reader and the stage throw.
void probe(const std::string& path, const mgf::MedialAxisOptions& options) {
  const mgf::MedialAxis axis = mgf::compute_medial_axis(mgf::bench::read_surface(path), options);
  double stage = 0.0;
  double complex = 0.0;
  for (const mgf::StageTime& time : axis.times) {
    if (time.stage == "topology") stage = time.seconds;
    if (time.stage == "medial_complex") complex = time.seconds;
  }
  const mgf::TopologyCertificate& c = axis.interior.certificate;
  std::printf(
      "%s: %u vertices, %u flips, +%u points, %zu tetrahedra, %s b %s (%s), missing %u extra %u "
      "negative %u conflicts %u buried %u, %.2f s, complex %.2f s\n",
      path.substr(path.rfind('/') + 1).c_str(), axis.interior.input_points, c.surface_flips,
      c.points_added, axis.interior.tetrahedra.size(), word(c.topology), to_text(c.betti).c_str(),
      to_text(c.expected).c_str(), c.boundary_faces_missing, c.boundary_faces_extra,
      c.tetrahedra_not_positive, c.winding_conflicts, c.interior_vertices, stage, complex);
}

}  // namespace

int main(int count, char** values) {
  mgf::MedialAxisOptions options;
  options.use_threads(1);
  int status = EXIT_SUCCESS;
  int meshes = 0;
  for (int i = 1; i < count; ++i) {
    const std::string argument = values[i];
    if (argument == "--keep-surface") {
      options.recovery.recover_input_surface = true;
      continue;
    }
    ++meshes;
    try {
      probe(argument, options);
    } catch (const std::exception& error) {
      std::printf("%s: %s\n", argument.c_str(), error.what());
      status = EXIT_FAILURE;
    }
    std::fflush(stdout);
  }
  if (meshes == 0) std::fputs(kUsage, stderr);
  return meshes == 0 ? 2 : status;
}
