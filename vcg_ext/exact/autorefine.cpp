// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL's cut may meet faces that cross in ways it isn't made for. Only its assertions tell; without
// them it goes on and may never end.
#define CGAL_DEBUG

#include "vcg_ext/exact/autorefine.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions_behaviour.h>

#include <array>
#include <exception>
#include <map>

#include "vcg_ext/exact/cgal_kernel.h"

namespace mgf {
namespace {

using exact_detail::Kernel;
using exact_detail::to_cgal;

using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

// None if CGAL's mesh can't hold the surface, which a closed, oriented, manifold one never is.
std::optional<SurfaceMesh> to_surface_mesh(const TriangleSurface& surface) {
  SurfaceMesh mesh;
  for (const Vec3& p : surface.points) mesh.add_vertex(to_cgal(p));
  for (const Triangle& t : surface.triangles) {
    const auto face =
        mesh.add_face(SurfaceMesh::Vertex_index(t[0]), SurfaceMesh::Vertex_index(t[1]),
                      SurfaceMesh::Vertex_index(t[2]));
    if (face == SurfaceMesh::null_face()) return std::nullopt;
  }
  return mesh;
}

// While it lives, CGAL's failed assertions throw without a word on standard error.
class QuietAssertions {
 public:
  QuietAssertions()
      : previous_(CGAL::set_error_handler(
            [](const char*, const char*, const char*, int, const char*) {})) {}
  ~QuietAssertions() { CGAL::set_error_handler(previous_); }
  QuietAssertions(const QuietAssertions&) = delete;
  QuietAssertions& operator=(const QuietAssertions&) = delete;

 private:
  CGAL::Failure_function previous_;
};

}  // namespace

std::optional<TriangleSurface> autorefined(const TriangleSurface& surface) {
  auto mesh = to_surface_mesh(surface);
  if (!mesh) return std::nullopt;
  const QuietAssertions quiet;
  try {
    CGAL::Polygon_mesh_processing::experimental::autorefine(*mesh);
  } catch (const std::exception&) {
    return std::nullopt;  // the caller has another way
  }
  TriangleSurface result;
  result.points = surface.points;
  std::map<std::array<double, 3>, Index> number;
  for (Index v = 0; v < surface.points.size(); ++v) {
    const Vec3& p = surface.points[v];
    number.emplace(std::array<double, 3>{p.x(), p.y(), p.z()}, v);
  }
  for (const auto face : mesh->faces()) {
    Triangle triangle{};
    unsigned corner = 0;
    for (const auto vertex : mesh->vertices_around_face(mesh->halfedge(face))) {
      const auto& p = mesh->point(vertex);
      const auto [place, added] = number.emplace(std::array<double, 3>{p.x(), p.y(), p.z()},
                                                 to_index(result.points.size()));
      if (added) result.points.emplace_back(p.x(), p.y(), p.z());
      triangle[corner++] = place->second;
    }
    const auto [a, b, c] = triangle;
    if (a != b && b != c && c != a) result.triangles.push_back(triangle);
  }
  return result;
}

}  // namespace mgf
