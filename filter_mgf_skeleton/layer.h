// SPDX-License-Identifier: GPL-3.0-or-later
// What a filter gives back, as plain data: new layers, paint for the input, numbers for the log.
// Nothing here knows the host, so a filter can be tested without one.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "filter_mgf_skeleton/io/colour.h"
#include "vcg_ext/core/errors.h"
#include "vcg_ext/core/types.h"

namespace mgf::plugin {

using Colour = io::Colour;

/// A named number per vertex or face, kept beside the mesh.
struct Attribute {
  std::string name;
  std::vector<double> values;
};

/// A layer to be added. Arrays of quality and colour are empty or of full length.
struct Layer {
  std::string name;  ///< behind the input's name, as in "hand medial axis"
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  std::vector<std::uint8_t> faux_edges;  ///< one per triangle: bit i is set where the edge from
                                         ///< corner i lies inside a polygon
  std::vector<std::array<Index, 2>> edges;
  std::vector<double> point_quality;
  std::vector<double> face_quality;
  std::vector<Colour> point_colour;
  std::vector<Colour> face_colour;
  std::vector<Attribute> point_attributes;
  std::vector<Attribute> face_attributes;
  bool replaces_former = false;  ///< takes the place of a layer of the same name
  bool hidden = false;           ///< added, but not drawn until the user says so
};

/// Quality and colour for the faces and vertices of the input mesh.
struct Paint {
  std::vector<double> face_quality;   ///< one per face
  std::vector<Colour> face_colour;    ///< one per face
  std::vector<double> point_quality;  ///< one per vertex, or empty to leave it
};

/// A number of the result.
struct Measurement {
  std::string key;   ///< snake_case, for programs
  std::string text;  ///< what it is, for the log
  double value = 0.0;
};

/// Elements of the input mesh to select.
struct Selection {
  std::vector<Index> faces;
  std::vector<Index> points;
};

/// Everything that a successful filter changes in the document.
struct FilterOutput {
  std::vector<Layer> layers;
  std::optional<Paint> paint;
  std::optional<Selection> selection;  ///< replaces the input's selection
  std::vector<std::string> notes;      ///< sentences for the log, before the measures
  std::vector<Measurement> measures;
  Warnings warnings;
};

}  // namespace mgf::plugin
