// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh of a MeshLab layer as plain data, and plain data as MeshLab layers, paint, selection.
#pragma once

#include "filter_mgf_skeleton/layer.h"
#include "host_headers.h"

namespace mgf::plugin {

/// The layer's vertices and faces in their order, deleted ones left out.
TriangleSurface read_mesh(const CMeshO& mesh);

/// Fills the empty `model` with `layer` and gives it the transform of the input.
void write_layer(const Layer& layer, const Matrix44m& transform, MeshModel& model);

/// Sets quality and colour of the faces and vertices of `model`.
void write_paint(const Paint& paint, MeshModel& model);

/// Makes `selection` the selection of `model`.
void write_selection(const Selection& selection, MeshModel& model);

}  // namespace mgf::plugin
