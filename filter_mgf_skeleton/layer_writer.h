// SPDX-License-Identifier: GPL-3.0-or-later
// Plain data as MeshLab layers, paint and selection.
#pragma once

#include "filter_mgf_skeleton/layer.h"
#include "host_headers.h"

namespace mgf::plugin {

/// Whether `model` was written from a layer that later runs may replace.
bool is_replaceable(const MeshModel& model);

/// Empties `model`.
void clear_layer(MeshModel& model);

/// Fills the empty `model` with `layer` and gives it the transform of the input.
void write_layer(const Layer& layer, const Matrix44m& transform, MeshModel& model);

/// Sets quality and colour of the faces and vertices of `model`.
void write_paint(const Paint& paint, MeshModel& model);

/// Makes `selection` the selection of `model`.
void write_selection(const Selection& selection, MeshModel& model);

}  // namespace mgf::plugin
