// SPDX-License-Identifier: GPL-3.0-or-later
// VCG meshes in, numbers of the right elements out.
#include "vcg_ext/input/bridge.h"

#include <gtest/gtest.h>
#include <vcg/complex/complex.h>

#include <vector>

#include "tests/fixtures.h"
#include "vcg_ext/input/diagnosis.h"

namespace mgf {
namespace {

class FloatVertex;
class FloatFace;
struct FloatTypes
    : vcg::UsedTypes<vcg::Use<FloatVertex>::AsVertexType, vcg::Use<FloatFace>::AsFaceType> {};
class FloatVertex : public vcg::Vertex<FloatTypes, vcg::vertex::Coord3f, vcg::vertex::BitFlags> {};
class FloatFace : public vcg::Face<FloatTypes, vcg::face::VertexRef, vcg::face::BitFlags> {};
class FloatMesh : public vcg::tri::TriMesh<std::vector<FloatVertex>, std::vector<FloatFace>> {};

template <class Mesh>
void fill(const TriangleSurface& surface, Mesh& mesh) {
  using Scalar = typename Mesh::ScalarType;
  for (const Vec3& p : surface.points) {
    vcg::tri::Allocator<Mesh>::AddVertex(
        mesh, typename Mesh::CoordType(static_cast<Scalar>(p.x()), static_cast<Scalar>(p.y()),
                                       static_cast<Scalar>(p.z())));
  }
  for (const Triangle& t : surface.triangles) {
    vcg::tri::Allocator<Mesh>::AddFace(mesh, t[0], t[1], t[2]);
  }
}

TEST(Bridge, KeepsAMeshAsItIs) {
  FloatMesh mesh;
  fill(fixtures::box(3, 2, 1), mesh);
  const BridgedSurface bridge = bridge_from_mesh(mesh);
  EXPECT_EQ(bridge.surface.points, fixtures::box(3, 2, 1).points);
  EXPECT_EQ(bridge.surface.triangles, fixtures::box(3, 2, 1).triangles);
}

TEST(Bridge, SkipsWhatIsDeleted) {
  FloatMesh mesh;
  fill(fixtures::joined(fixtures::box(1, 1, 1), fixtures::tetrahedron()), mesh);
  for (Index f = 0; f < 12; ++f) vcg::tri::Allocator<FloatMesh>::DeleteFace(mesh, mesh.face[f]);
  for (Index v = 0; v < 8; ++v) vcg::tri::Allocator<FloatMesh>::DeleteVertex(mesh, mesh.vert[v]);
  const BridgedSurface bridge = bridge_from_mesh(mesh);
  EXPECT_EQ(bridge.surface.points, fixtures::tetrahedron().points);
  EXPECT_EQ(bridge.surface.triangles, fixtures::tetrahedron().triangles);
  EXPECT_EQ(bridge.mesh_vertex, (std::vector<Index>{8, 9, 10, 11}));
  EXPECT_EQ(bridge.mesh_face, (std::vector<Index>{12, 13, 14, 15}));
  EXPECT_EQ(bridge.vertex_of_mesh[3], kNone);
  EXPECT_EQ(bridge.vertex_of_mesh[9], 1U);
  EXPECT_EQ(bridge.face_of_mesh[11], kNone);
  EXPECT_EQ(bridge.face_of_mesh[12], 0U);
}

TEST(Bridge, HandsBrokenFacesToTheDoctor) {
  FloatMesh mesh;
  fill(fixtures::box(1, 1, 1), mesh);
  vcg::tri::Allocator<FloatMesh>::DeleteVertex(mesh, mesh.vert[7]);
  const Diagnosis diagnosis = diagnose(bridge_from_mesh(mesh).surface);
  EXPECT_NE(diagnosis.find("index_out_of_range"), nullptr);
}

TEST(Bridge, GivesAnEmptySurfaceForAnEmptyMesh) {
  const BridgedSurface bridge = bridge_from_mesh(FloatMesh());
  EXPECT_TRUE(bridge.surface.points.empty());
  EXPECT_TRUE(bridge.surface.triangles.empty());
}

TEST(Bridge, SelectsCulpritsInTheMesh) {
  FloatMesh mesh;
  fill(fixtures::box(1, 1, 1), mesh);
  vcg::tri::Allocator<FloatMesh>::AddVertex(mesh, FloatMesh::CoordType(5, 5, 5));
  vcg::tri::Allocator<FloatMesh>::DeleteFace(mesh, mesh.face[2]);
  const BridgedSurface bridge = bridge_from_mesh(mesh);
  const Diagnosis diagnosis = diagnose(bridge.surface);
  for (const Finding& finding : diagnosis.findings) select_culprits(finding, bridge, mesh);
  EXPECT_TRUE(mesh.vert[8].IsS());   // unreferenced
  EXPECT_FALSE(mesh.face[2].IsS());  // deleted
  int selected = 0;
  for (const FloatFace& face : mesh.face) selected += face.IsS() ? 1 : 0;
  EXPECT_EQ(selected, 3);  // round the hole
}

}  // namespace
}  // namespace mgf
