// SPDX-License-Identifier: GPL-3.0-or-later
// Sides for the sheets of a medial axis, so that a host's lighting shows each sheet as one surface.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/medial_complex.h"

namespace mgf::plugin {
namespace facet_orientation {

/// Whether the facet's cycle runs along the edge, which bounds it, from its second end to its
/// first.
inline bool runs_backwards(const MedialComplex& complex, Index facet, Index edge) {
  const Row<Index> edges = complex.facet_edges[facet];
  const Row<Index> vertices = complex.facet_vertices[facet];
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i] == edge) return vertices[i] == complex.edge_vertices[edge][1];
  }
  return false;
}

/// The other facet at an edge of exactly two, else kNone: where three meet, sheets end.
inline Index facet_across(const MedialComplex& complex, Index facet, Index edge) {
  Index other = kNone;
  int count = 0;
  for (const Index candidate : complex.edge_facets[edge]) {
    if (candidate == kNone) continue;
    ++count;
    if (candidate != facet) other = candidate;
  }
  return count == 2 ? other : kNone;
}

/// Height of twice the facet's area vector: positive where its cycle is anticlockwise from above.
inline double height_of_area(const MedialComplex& complex, Index facet) {
  const Row<Index> vertices = complex.facet_vertices[facet];
  Vec3 area = Vec3::Zero();
  const Vec3& origin = complex.position[vertices[0]];
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i) {
    area +=
        (complex.position[vertices[i]] - origin).cross(complex.position[vertices[i + 1]] - origin);
  }
  return area.z();
}

}  // namespace facet_orientation

/// One per facet: 1 where its cycle is to be reversed, so that facets of one sheet have one
/// orientation, and most of the sheet's area looks up (+z), to where a host's camera stands at
/// first. A one-sided sheet gets a seam. Linear time.
inline std::vector<char> facets_to_reverse(const MedialComplex& complex) {
  using namespace facet_orientation;
  std::vector<char> reverse(complex.facet_count(), 0);
  std::vector<char> reached(complex.facet_count(), 0);
  for (Index first = 0; first < complex.facet_count(); ++first) {
    if (reached[first]) continue;
    reached[first] = 1;
    std::vector<Index> sheet{first};
    double height = 0.0;
    for (std::size_t next = 0; next < sheet.size(); ++next) {
      const Index facet = sheet[next];
      height += (reverse[facet] ? -1.0 : 1.0) * height_of_area(complex, facet);
      for (const Index edge : complex.facet_edges[facet]) {
        const Index other = facet_across(complex, facet, edge);
        if (other == kNone || reached[other]) continue;
        // Facets of one orientation run along their common edge in opposite directions.
        const bool same =
            runs_backwards(complex, facet, edge) == runs_backwards(complex, other, edge);
        reverse[other] = static_cast<char>(reverse[facet] != (same ? 1 : 0));
        reached[other] = 1;
        sheet.push_back(other);
      }
    }
    if (height >= 0.0) continue;
    for (const Index facet : sheet) reverse[facet] = reverse[facet] ? 0 : 1;
  }
  return reverse;
}

}  // namespace mgf::plugin
