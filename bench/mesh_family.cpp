// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the meshes of the scaling series from one base mesh: finer ones by subdivision, coarser
// ones by decimation.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/bench_support.h"

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

constexpr const char* kUsage =
    "usage: mesh_family loop|midpoint MESH STEPS OUT.off\n"
    "       mesh_family decimate MESH VERTICES OUT.off\n";

// New vertices in the middle of edges, old ones stay: the same surface with four times the faces.
class MidpointMask {
 public:
  explicit MidpointMask(Mesh& mesh) : mesh_(mesh) {}
  void edge_node(Mesh::Halfedge_index h, Point& place) const {
    place = CGAL::midpoint(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)));
  }
  void vertex_node(Mesh::Vertex_index v, Point& place) const { place = mesh_.point(v); }
  void border_node(Mesh::Halfedge_index h, Point& edge_place, Point& vertex_place) const {
    edge_node(h, edge_place);
    vertex_node(mesh_.target(h), vertex_place);
  }

 private:
  Mesh& mesh_;
};

Mesh read(const std::string& path) {
  const mgf::TriangleSurface surface = mgf::bench::read_surface(path);
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const mgf::Vec3& p : surface.points) {
    vertices.push_back(mesh.add_vertex(Point(p.x(), p.y(), p.z())));
  }
  for (const mgf::Triangle& t : surface.triangles) {
    mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  }
  return mesh;
}

void subdivide(const std::string& rule, std::size_t steps, Mesh& mesh) {
  namespace subdivision = CGAL::Subdivision_method_3;
  const auto parameters = CGAL::parameters::number_of_iterations(static_cast<unsigned>(steps));
  if (rule == "loop") {
    subdivision::Loop_subdivision(mesh, parameters);
  } else {
    subdivision::PTQ(mesh, MidpointMask(mesh), parameters);
  }
}

void decimate(std::size_t vertices, Mesh& mesh) {
  namespace simplification = CGAL::Surface_mesh_simplification;
  // A collapse takes a vertex and, on a closed surface, three edges; it goes on until there are
  // fewer edges than the predicate says.
  const std::size_t all = mesh.number_of_vertices();
  const std::size_t surplus = all - std::min(vertices, all);
  const std::size_t edges = mesh.number_of_edges() - 3 * surplus + 1;
  simplification::edge_collapse(mesh, simplification::Count_stop_predicate<Mesh>(edges));
  mesh.collect_garbage();
}

void write_off(const std::string& path, const Mesh& mesh) {
  std::ofstream file(path);
  file.precision(std::numeric_limits<double>::max_digits10);
  file << "OFF\n" << mesh.number_of_vertices() << ' ' << mesh.number_of_faces() << " 0\n";
  for (const Mesh::Vertex_index v : mesh.vertices()) file << mesh.point(v) << '\n';
  for (const Mesh::Face_index f : mesh.faces()) {
    file << '3';
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f))) {
      file << ' ' << static_cast<std::size_t>(v);
    }
    file << '\n';
  }
  if (!file.flush()) throw std::runtime_error("can't write " + path);
}

}  // namespace

int main(int count, char** values) {
  const std::vector<std::string> words(values + 1, values + count);
  constexpr std::size_t kWords = 4;
  const bool known = words.size() == kWords &&
                     (words[0] == "loop" || words[0] == "midpoint" || words[0] == "decimate");
  if (!known) {
    std::cerr << kUsage;
    return 2;
  }
  try {
    Mesh mesh = read(words[1]);
    const std::size_t amount = std::stoul(words[2]);
    if (words[0] == "decimate") {
      decimate(amount, mesh);
    } else {
      subdivide(words[0], amount, mesh);
    }
    write_off(words[3], mesh);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
