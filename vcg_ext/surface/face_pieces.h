// SPDX-License-Identifier: GPL-3.0-or-later
// Connected pieces of equally labelled faces, and their borders.
#pragma once

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/surface/face_flood.h"

namespace mgf {

/// Maximal sets of faces with the same label, connected across edges.
struct FacePieces {
  std::vector<Index> of_face;  ///< one per face; kNone where the label is kNone
  std::vector<Index> label;    ///< one per piece
  std::vector<double> area;    ///< one per piece
};

/// The pieces of a labelling, numbered by their first face. Linear time.
inline FacePieces connected_pieces(const FaceGraph& faces, const std::vector<Index>& label) {
  FacePieces pieces;
  pieces.of_face.assign(label.size(), kNone);
  std::vector<Index> front;
  for (Index start = 0; start < label.size(); ++start) {
    if (label[start] == kNone || pieces.of_face[start] != kNone) continue;
    const Index piece = to_index(pieces.area.size());
    pieces.label.push_back(label[start]);
    pieces.area.push_back(0.0);
    pieces.of_face[start] = piece;
    front.assign(1, start);
    while (!front.empty()) {
      const Index f = front.back();
      front.pop_back();
      pieces.area[piece] += faces.area[f];
      for (const Index g : faces.neighbour[f]) {
        if (g == kNone || label[g] != label[f] || pieces.of_face[g] != kNone) continue;
        pieces.of_face[g] = piece;
        front.push_back(g);
      }
    }
  }
  return pieces;
}

namespace border_straightening {

/// A change of one face's label and by how much it shortens the border.
struct Flip {
  Index label = kNone;  ///< the new one, or kNone for no change
  double gain = 0.0;
};

/// The label that two neighbours of a face share, if taking it shortens the border. A face attached
/// to its own piece by one edge can leave it without cutting it in two.
inline Flip best_flip(const FaceGraph& faces, const std::vector<Index>& label, Index f) {
  const std::array<Index, 3>& around = faces.neighbour[f];
  if (std::find(around.begin(), around.end(), kNone) != around.end()) return {};
  for (Index i = 0; i < 3; ++i) {  // i: the one edge to the own piece
    const Index j = (i + 1) % 3;
    const Index k = (i + 2) % 3;
    const Index other = label[around[j]];
    if (label[around[i]] != label[f] || other == label[f]) continue;
    if (other == kNone || label[around[k]] != other) continue;
    const std::array<double, 3>& length = faces.edge_length[f];
    const double gain = length[j] + length[k] - length[i];
    if (gain > 0.0) return {other, gain};
  }
  return {};
}

}  // namespace border_straightening

/// Levels single teeth: gives a face the label that two of its neighbours share wherever that
/// shortens the border, the best changes first, until none is left. Pieces stay connected. Doesn't
/// depend on the order of the faces.
inline void straighten_borders(const FaceGraph& faces, std::vector<Index>& label) {
  using border_straightening::Flip;
  std::vector<Flip> flip(label.size());
  std::vector<Index> candidates;
  for (Index f = 0; f < label.size(); ++f) candidates.push_back(f);
  const auto precedes = [&](Index f, Index g) {  // of two neighbours, which changes first
    const Vec3& a = faces.centroid[f];
    const Vec3& b = faces.centroid[g];
    return std::make_tuple(-flip[f].gain, a.x(), a.y(), a.z(), f) <
           std::make_tuple(-flip[g].gain, b.x(), b.y(), b.z(), g);
  };
  // The border gets shorter with every change, so this ends.
  while (!candidates.empty()) {
    for (const Index f : candidates) flip[f] = border_straightening::best_flip(faces, label, f);
    std::vector<Index> changing;
    for (const Index f : candidates) {
      if (flip[f].label == kNone) continue;
      bool is_first = true;
      for (const Index g : faces.neighbour[f]) {
        if (flip[g].label != kNone && precedes(g, f)) is_first = false;
      }
      if (is_first) changing.push_back(f);
    }
    std::vector<Index> next;
    for (const Index f : changing) {
      label[f] = flip[f].label;
      next.push_back(f);
      next.insert(next.end(), faces.neighbour[f].begin(), faces.neighbour[f].end());
    }
    for (const Index f : candidates) {
      if (flip[f].label != kNone) next.push_back(f);
    }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    for (const Index f : changing) flip[f] = {};
    candidates = changing.empty() ? std::vector<Index>() : std::move(next);
  }
}

}  // namespace mgf
