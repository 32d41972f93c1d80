// SPDX-License-Identifier: GPL-3.0-or-later
// The repairs that harm nobody: equal points become one, what takes no part is left out, faces
// without area are taken out.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/input/cap_removal.h"
#include "vcg_ext/input/finding.h"

namespace mgf {

/// A surface after the harmless repairs, and where everything went. Without need for repair it is
/// the input itself.
struct CleanedSurface {
  TriangleSurface surface;             ///< in the input's order; equal points merged
  std::vector<Index> vertex_of_input;  ///< one per input vertex; kNone: in no face
  std::vector<Index> face_of_input;    ///< one per input face; kNone: taken out
  std::vector<Index> input_of_vertex;  ///< one per vertex: the least input vertex there
  std::vector<Index> input_of_face;    ///< one per face: the input face that it is part of
  std::vector<Finding> findings;       ///< what was repaired, and what could not be
};

namespace detail {

/// For each vertex the least vertex of the same position; kNone for a vertex of no face.
inline std::vector<Index> first_of_equal_points(const TriangleSurface& input) {
  std::vector<Index> first(input.points.size(), kNone);
  for (const Triangle& t : input.triangles) {
    for (const Index v : t) first[v] = v;
  }
  std::vector<Index> order;
  for (Index v = 0; v < first.size(); ++v) {
    if (first[v] != kNone) order.push_back(v);
  }
  const auto less = [&](Index v, Index w) {
    const Vec3& p = input.points[v];
    const Vec3& q = input.points[w];
    if (p.x() != q.x()) return p.x() < q.x();
    if (p.y() != q.y()) return p.y() < q.y();
    if (p.z() != q.z()) return p.z() < q.z();
    return v < w;
  };
  std::sort(order.begin(), order.end(), less);
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (input.points[order[i]] == input.points[order[i - 1]]) first[order[i]] = first[order[i - 1]];
  }
  return first;
}

/// Numbers the vertices that stay, in the input's order.
inline void weld_vertices(const TriangleSurface& input, CleanedSurface& result) {
  const std::vector<Index> first = first_of_equal_points(input);
  std::vector<Index> unreferenced;
  std::vector<Index> repeated;
  result.vertex_of_input.assign(input.points.size(), kNone);
  for (Index v = 0; v < first.size(); ++v) {
    if (first[v] == kNone) {
      unreferenced.push_back(v);
    } else if (first[v] != v) {
      repeated.push_back(v);
      result.vertex_of_input[v] = result.vertex_of_input[first[v]];
    } else {
      result.vertex_of_input[v] = to_index(result.surface.points.size());
      result.input_of_vertex.push_back(v);
      result.surface.points.push_back(input.points[v]);
    }
  }
  const auto report = [&](const char* code, std::vector<Index> vertices) {
    if (vertices.empty()) return;
    const std::size_t count = vertices.size();
    result.findings.push_back(
        make_finding(code, Severity::kHarmless, count, {}, std::move(vertices)));
  };
  report("unreferenced_vertices", std::move(unreferenced));
  report("duplicate_vertices", std::move(repeated));
}

/// Rotates the least corner to the front, so that equal faces compare equal.
inline Triangle least_corner_first(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// The faces that are the same as one of a smaller number; `faces_at` groups them by least corner.
inline std::vector<Index> repeated_faces(const std::vector<Triangle>& faces,
                                         const Rows<Index>& faces_at) {
  std::vector<Index> repeated;
  std::vector<std::array<Index, 3>> fan;  // the other two corners, face
  for (std::size_t v = 0; v < faces_at.size(); ++v) {
    fan.clear();
    for (const Index f : faces_at[v]) {
      const Triangle t = least_corner_first(faces[f]);
      fan.push_back({t[1], t[2], f});
    }
    std::sort(fan.begin(), fan.end());
    for (std::size_t i = 1; i < fan.size(); ++i) {
      if (fan[i][0] == fan[i - 1][0] && fan[i][1] == fan[i - 1][1]) repeated.push_back(fan[i][2]);
    }
  }
  std::sort(repeated.begin(), repeated.end());
  return repeated;
}

/// Takes over each face once, unless two of its corners have become one. Gives the input faces
/// left out for that.
inline std::vector<Index> take_over_faces(const TriangleSurface& input, CleanedSurface& result) {
  std::vector<Index> collapsed;
  std::vector<Triangle> renumbered;
  std::vector<Index> least_corner;  // kNone: collapsed
  renumbered.reserve(input.triangles.size());
  least_corner.reserve(input.triangles.size());
  for (Index f = 0; f < input.triangles.size(); ++f) {
    Triangle t = input.triangles[f];
    for (Index& v : t) v = result.vertex_of_input[v];
    const bool collapses = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    if (collapses) collapsed.push_back(f);
    renumbered.push_back(t);
    least_corner.push_back(collapses ? kNone : least_corner_first(t)[0]);
  }
  const std::vector<Index> repeated =
      repeated_faces(renumbered, group_by_key(least_corner, result.surface.points.size()));
  result.face_of_input.assign(input.triangles.size(), kNone);
  for (Index f = 0; f < renumbered.size(); ++f) {
    if (least_corner[f] == kNone || std::binary_search(repeated.begin(), repeated.end(), f)) {
      continue;
    }
    result.face_of_input[f] = to_index(result.surface.triangles.size());
    result.input_of_face.push_back(f);
    result.surface.triangles.push_back(renumbered[f]);
  }
  if (!repeated.empty()) {
    result.findings.push_back(
        make_finding("duplicate_faces", Severity::kHarmless, repeated.size(), repeated));
  }
  return collapsed;
}

/// Flips caps away; `collapsed` are the input faces without area that are out already.
inline void remove_caps(std::vector<Index> collapsed, CleanedSurface& result) {
  CapRemoval removal(result.surface);
  std::vector<Index> resisting;
  std::vector<Index>& removed = collapsed;
  const std::vector<Index> caps = removal.caps();
  removal.run();
  for (const Index f : removal.caps()) resisting.push_back(result.input_of_face[f]);
  for (const Index f : caps) {
    const Index cap = result.input_of_face[f];
    if (!std::binary_search(resisting.begin(), resisting.end(), cap)) removed.push_back(cap);
  }
  for (const auto& [cap, face] : removal.flips()) {
    result.face_of_input[result.input_of_face[cap]] = kNone;
    result.input_of_face[cap] = result.input_of_face[face];
  }
  std::sort(removed.begin(), removed.end());
  const auto report = [&](Severity severity, std::vector<Index> faces) {
    if (faces.empty()) return;
    const std::size_t count = faces.size();
    result.findings.push_back(make_finding("degenerate_faces", severity, count, std::move(faces)));
  };
  report(Severity::kHarmless, std::move(removed));
  report(Severity::kFatal, std::move(resisting));
}

}  // namespace detail

/// Repairs what harms nobody. Requires valid indices and finite points in use. O(n log n).
inline CleanedSurface clean_surface(const TriangleSurface& input) {
  CleanedSurface result;
  detail::weld_vertices(input, result);
  std::vector<Index> collapsed = detail::take_over_faces(input, result);
  detail::remove_caps(std::move(collapsed), result);
  return result;
}

}  // namespace mgf
