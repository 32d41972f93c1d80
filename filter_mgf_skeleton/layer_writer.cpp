// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/layer_writer.h"

#include <vcg/complex/algorithms/update/bounding.h>
#include <vcg/complex/algorithms/update/selection.h>
#include <vcg/complex/allocate.h>

namespace mgf::plugin {
namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;

/// The mesh attribute that tells our layers from others.
const char* const kOrigin = "mgf_skeleton_origin";

Point3m host_point(const Vec3& p) {
  return {static_cast<Scalarm>(p.x()), static_cast<Scalarm>(p.y()), static_cast<Scalarm>(p.z())};
}

vcg::Color4b host_colour(const Colour& c) {
  return {c.red, c.green, c.blue, 255};
}

/// The layer's elements that are not deleted, in order: position i is our number i.
template <class Container>
auto live_elements(Container& container) {
  std::vector<typename Container::value_type*> elements;
  elements.reserve(container.size());
  for (auto& element : container) {
    if (!element.IsD()) elements.push_back(&element);
  }
  return elements;
}

void write_points(const Layer& layer, MeshModel& model) {
  CMeshO& mesh = model.cm;
  Allocator::AddVertices(mesh, layer.points.size());
  for (std::size_t i = 0; i < layer.points.size(); ++i) {
    mesh.vert[i].P() = host_point(layer.points[i]);
  }
  if (!layer.point_quality.empty()) {
    model.updateDataMask(MeshModel::MM_VERTQUALITY);
    for (std::size_t i = 0; i < layer.points.size(); ++i) {
      mesh.vert[i].Q() = static_cast<Scalarm>(layer.point_quality[i]);
    }
  }
  if (!layer.point_colour.empty()) {
    model.updateDataMask(MeshModel::MM_VERTCOLOR);
    for (std::size_t i = 0; i < layer.points.size(); ++i) {
      mesh.vert[i].C() = host_colour(layer.point_colour[i]);
    }
  }
}

void write_faces(const Layer& layer, MeshModel& model) {
  CMeshO& mesh = model.cm;
  Allocator::AddFaces(mesh, layer.triangles.size());
  for (std::size_t f = 0; f < layer.triangles.size(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      mesh.face[f].V(corner) = &mesh.vert[layer.triangles[f][static_cast<std::size_t>(corner)]];
      if (!layer.faux_edges.empty() && ((layer.faux_edges[f] >> corner) & 1U) != 0) {
        mesh.face[f].SetF(corner);
      }
    }
  }
  if (!layer.faux_edges.empty()) model.updateDataMask(MeshModel::MM_POLYGONAL);
  if (!layer.face_quality.empty()) {
    model.updateDataMask(MeshModel::MM_FACEQUALITY);
    for (std::size_t f = 0; f < layer.triangles.size(); ++f) {
      mesh.face[f].Q() = static_cast<Scalarm>(layer.face_quality[f]);
    }
  }
  if (!layer.face_colour.empty()) {
    model.updateDataMask(MeshModel::MM_FACECOLOR);
    for (std::size_t f = 0; f < layer.triangles.size(); ++f) {
      mesh.face[f].C() = host_colour(layer.face_colour[f]);
    }
  }
}

void write_edges(const Layer& layer, MeshModel& model) {
  CMeshO& mesh = model.cm;
  Allocator::AddEdges(mesh, layer.edges.size());
  for (std::size_t e = 0; e < layer.edges.size(); ++e) {
    mesh.edge[e].V(0) = &mesh.vert[layer.edges[e][0]];
    mesh.edge[e].V(1) = &mesh.vert[layer.edges[e][1]];
  }
}

void write_attributes(const Layer& layer, CMeshO& mesh) {
  for (const Attribute& attribute : layer.point_attributes) {
    auto handle = Allocator::GetPerVertexAttribute<Scalarm>(mesh, attribute.name);
    for (std::size_t i = 0; i < attribute.values.size(); ++i) {
      handle[i] = static_cast<Scalarm>(attribute.values[i]);
    }
  }
  for (const Attribute& attribute : layer.face_attributes) {
    auto handle = Allocator::GetPerFaceAttribute<Scalarm>(mesh, attribute.name);
    for (std::size_t f = 0; f < attribute.values.size(); ++f) {
      handle[f] = static_cast<Scalarm>(attribute.values[f]);
    }
  }
}

}  // namespace

std::optional<LayerOrigin> origin_of(MeshModel& model) {
  if (!vcg::tri::HasPerMeshAttribute(model.cm, kOrigin)) return std::nullopt;
  return Allocator::GetPerMeshAttribute<LayerOrigin>(model.cm, kOrigin)();
}

void clear_layer(MeshModel& model) {
  model.cm.Clear();
  model.cm.ClearAttributes();
  model.Clear();  // the data mask alone
}

void write_layer(const Layer& layer, const MeshModel& source, MeshModel& model) {
  write_points(layer, model);
  write_faces(layer, model);
  write_edges(layer, model);
  write_attributes(layer, model.cm);
  Allocator::GetPerMeshAttribute<LayerOrigin>(model.cm, kOrigin)() = {source.id(), layer.name};
  model.cm.Tr = source.cm.Tr;
  model.UpdateBoxAndNormals();
  // Without faces the normals are zero, and lines lit with them are almost black.
  if (layer.triangles.empty()) model.clearDataMask(MeshModel::MM_VERTNORMAL);
}

void write_paint(const Paint& paint, MeshModel& model) {
  model.updateDataMask(MeshModel::MM_FACEQUALITY | MeshModel::MM_FACECOLOR);
  const auto faces = live_elements(model.cm.face);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    faces[f]->Q() = static_cast<Scalarm>(paint.face_quality[f]);
    faces[f]->C() = host_colour(paint.face_colour[f]);
  }
  if (paint.point_quality.empty()) return;
  model.updateDataMask(MeshModel::MM_VERTQUALITY);
  const auto points = live_elements(model.cm.vert);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i]->Q() = static_cast<Scalarm>(paint.point_quality[i]);
  }
}

void write_selection(const Selection& selection, MeshModel& model) {
  vcg::tri::UpdateSelection<CMeshO>::Clear(model.cm);
  const auto faces = live_elements(model.cm.face);
  for (const Index f : selection.faces) faces[f]->SetS();
  const auto points = live_elements(model.cm.vert);
  for (const Index i : selection.points) points[i]->SetS();
  model.updateDataMask(MeshModel::MM_VERTFLAGSELECT | MeshModel::MM_FACEFLAGSELECT);
}

}  // namespace mgf::plugin
