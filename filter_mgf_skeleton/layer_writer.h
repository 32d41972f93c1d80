// SPDX-License-Identifier: GPL-3.0-or-later
// Plain data as MeshLab layers, paint and selection.
#pragma once

#include <optional>
#include <string>

#include "filter_mgf_skeleton/layer.h"
#include "host_headers.h"

namespace mgf::plugin {

/// Where a layer of this plugin comes from.
struct LayerOrigin {
  int source = 0;    ///< id of the layer that it was made from
  std::string name;  ///< of the `Layer`; labels also have the source's name, and perhaps a number
};

/// The origin of `model`, if this plugin made it.
std::optional<LayerOrigin> origin_of(MeshModel& model);

/// Empties `model`.
void clear_layer(MeshModel& model);

/// Fills the empty `model` with `layer`, made from `source`, and gives it the transform of that.
void write_layer(const Layer& layer, const MeshModel& source, MeshModel& model);

/// Sets quality and colour of the faces and vertices of `model`.
void write_paint(const Paint& paint, MeshModel& model);

/// Makes `selection` the selection of `model`.
void write_selection(const Selection& selection, MeshModel& model);

}  // namespace mgf::plugin
