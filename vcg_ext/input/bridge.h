// SPDX-License-Identifier: GPL-3.0-or-later
// From any VCG mesh to flat arrays, and back from their numbers to the mesh's elements.
#pragma once

#include <cstddef>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/input/finding.h"

namespace mgf {

/// A mesh's surface without its deleted elements, and who is who. A polygon that VCG keeps as
/// triangles joined by faux edges counts as those triangles.
struct BridgedSurface {
  TriangleSurface surface;
  std::vector<Index> mesh_vertex;     ///< one per vertex: its place in `mesh.vert`
  std::vector<Index> mesh_face;       ///< one per face: its place in `mesh.face`
  std::vector<Index> vertex_of_mesh;  ///< one per entry of `mesh.vert`; kNone: deleted
  std::vector<Index> face_of_mesh;    ///< one per entry of `mesh.face`; kNone: deleted
};

/// The surface of a VCG mesh, which may be broken: a corner that is a deleted or missing vertex
/// becomes kNone, for the diagnosis to find. Linear time.
template <class Mesh>
BridgedSurface bridge_from_mesh(const Mesh& mesh) {
  BridgedSurface result;
  result.vertex_of_mesh.assign(mesh.vert.size(), kNone);
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    if (mesh.vert[v].IsD()) continue;
    const auto& p = mesh.vert[v].cP();
    result.vertex_of_mesh[v] = to_index(result.mesh_vertex.size());
    result.mesh_vertex.push_back(to_index(v));
    result.surface.points.emplace_back(static_cast<double>(p[0]), static_cast<double>(p[1]),
                                       static_cast<double>(p[2]));
  }
  const auto corner = [&](const typename Mesh::VertexType* vertex) {
    if (vertex == nullptr || mesh.vert.empty()) return kNone;
    const auto place = static_cast<std::size_t>(vertex - &mesh.vert[0]);
    return place < mesh.vert.size() ? result.vertex_of_mesh[place] : kNone;
  };
  result.face_of_mesh.assign(mesh.face.size(), kNone);
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    const auto& face = mesh.face[f];
    if (face.IsD()) continue;
    result.face_of_mesh[f] = to_index(result.mesh_face.size());
    result.mesh_face.push_back(to_index(f));
    result.surface.triangles.push_back(
        {corner(face.cV(0)), corner(face.cV(1)), corner(face.cV(2))});
  }
  return result;
}

/// Selects the culprits of a finding in the mesh that `bridge` was made from; what was selected
/// before stays so.
template <class Mesh>
void select_culprits(const Finding& finding, const BridgedSurface& bridge, Mesh& mesh) {
  for (const Index f : finding.faces) mesh.face[bridge.mesh_face[f]].SetS();
  for (const Index v : finding.vertices) mesh.vert[bridge.mesh_vertex[v]].SetS();
}

}  // namespace mgf
