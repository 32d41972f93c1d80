// SPDX-License-Identifier: GPL-3.0-or-later
// Times CGAL's mean curvature flow skeletonization with its defaults, from file to skeleton; prints
// one line of JSON with the same members as skeleton_bench, as far as they apply.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>

#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

#include "bench/bench_support.h"

namespace {

// As in CGAL's own example of this package.
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Skeletonization = CGAL::Mean_curvature_flow_skeletonization<Mesh>;
using mgf::bench::Json;

Mesh to_cgal(const mgf::TriangleSurface& surface) {
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const mgf::Vec3& p : surface.points) {
    vertices.push_back(mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z())));
  }
  for (const mgf::Triangle& t : surface.triangles) {
    mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  }
  return mesh;
}

Json measure(const std::string& path) {
  const mgf::bench::Stopwatch total;
  const Mesh mesh = to_cgal(mgf::bench::read_surface(path));
  const double read = total.wall();
  if (!CGAL::is_closed(mesh)) throw std::runtime_error("the mesh is not closed");
  Skeletonization::Skeleton skeleton;
  CGAL::extract_mean_curvature_flow_skeleton(mesh, skeleton);
  const double wall = total.wall();
  return {{"mesh", path},
          {"vertices", mesh.number_of_vertices()},
          {"nodes", boost::num_vertices(skeleton)},
          {"edges", boost::num_edges(skeleton)},
          {"wall", wall},
          {"cpu", total.cpu()},
          {"seconds", {{"read", read}, {"skeleton", wall - read}, {"total", wall}}}};
}

}  // namespace

int main(int count, char** values) {
  if (count != 2) {
    std::cerr << "usage: cgal_mcf_bench MESH\n";
    return 2;
  }
  return mgf::bench::report_line([&] { return measure(values[1]); });
}
