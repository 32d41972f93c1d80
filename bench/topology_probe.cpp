// SPDX-License-Identifier: GPL-3.0-or-later
// Prints what the topology stage makes of each OFF file given: counts, certificate, CPU seconds.
#include <cstdio>
#include <ctime>
#include <fstream>
#include <string>

#include "vcg_ext/medial/recover_interior.h"

namespace {

mgf::TriangleSurface read_off(const std::string& path) {
  std::ifstream in(path);
  std::string word;
  std::size_t points = 0;
  std::size_t faces = 0;
  std::size_t edges = 0;
  in >> word >> points >> faces >> edges;
  mgf::TriangleSurface surface;
  surface.points.resize(points);
  surface.triangles.resize(faces);
  for (mgf::Vec3& p : surface.points) in >> p.x() >> p.y() >> p.z();
  for (mgf::Triangle& t : surface.triangles) {
    int corners = 0;
    in >> corners >> t[0] >> t[1] >> t[2];
    in.ignore(1000, '\n');
  }
  return surface;
}

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

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const mgf::TriangleSurface surface = read_off(argv[i]);
    const std::clock_t start = std::clock();
    const mgf::InteriorTetrahedra interior = mgf::recover_interior(surface, {});
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const mgf::TopologyCertificate& c = interior.certificate;
    const std::string path = argv[i];
    std::printf(
        "%s: %zu vertices, %u flips, +%u points, %zu tetrahedra, %s b %u/%u/%u (%u/%u/%u), "
        "missing %u extra %u negative %u conflicts %u buried %u, %.2f s\n",
        path.substr(path.rfind('/') + 1).c_str(), surface.points.size(), c.surface_flips,
        c.points_added, interior.tetrahedra.size(), word(c.topology), c.betti.b0, c.betti.b1,
        c.betti.b2, c.expected.b0, c.expected.b1, c.expected.b2, c.boundary_faces_missing,
        c.boundary_faces_extra, c.tetrahedra_not_positive, c.winding_conflicts, c.interior_vertices,
        seconds);
    std::fflush(stdout);
  }
  return 0;
}
