// SPDX-License-Identifier: GPL-3.0-or-later
// The surface cut into one connected part per branch.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/surface/face_flood.h"

namespace mgf {
namespace parting {

/// The branch of most of the circles through each face, the smaller id of equals; kNone for none.
inline std::vector<Index> majority_branches(const Rows<Index>& circles_on_face,
                                            const std::vector<Index>& branch_of_circle) {
  std::vector<Index> majority(circles_on_face.size(), kNone);
  std::vector<Index> branches;
  for (std::size_t f = 0; f < majority.size(); ++f) {
    branches.clear();
    for (const Index circle : circles_on_face[f]) branches.push_back(branch_of_circle[circle]);
    std::sort(branches.begin(), branches.end());
    std::size_t best = 0;
    for (std::size_t i = 0; i < branches.size();) {
      const auto end = std::upper_bound(branches.begin(), branches.end(), branches[i]);
      const std::size_t count = static_cast<std::size_t>(end - branches.begin()) - i;
      if (count > best) {
        best = count;
        majority[f] = branches[i];
      }
      i += count;
    }
  }
  return majority;
}

/// Keeps of each label its largest connected piece by area; the faces of the others become kNone.
inline std::vector<Index> largest_pieces(const FaceGraph& faces, std::vector<Index> label) {
  std::vector<Index> piece_of_face(label.size(), kNone);
  std::vector<double> piece_area;
  std::vector<Index> piece_label;
  std::vector<Index> front;
  for (Index start = 0; start < label.size(); ++start) {
    if (label[start] == kNone || piece_of_face[start] != kNone) continue;
    const Index piece = to_index(piece_area.size());
    piece_label.push_back(label[start]);
    piece_area.push_back(0.0);
    piece_of_face[start] = piece;
    front.assign(1, start);
    while (!front.empty()) {
      const Index f = front.back();
      front.pop_back();
      piece_area[piece] += faces.area[f];
      for (const Index g : faces.neighbour[f]) {
        if (g == kNone || label[g] != label[f] || piece_of_face[g] != kNone) continue;
        piece_of_face[g] = piece;
        front.push_back(g);
      }
    }
  }
  std::vector<Index> largest;  // by label
  for (Index piece = 0; piece < piece_area.size(); ++piece) {
    if (piece_label[piece] >= largest.size()) largest.resize(piece_label[piece] + 1, kNone);
    Index& best = largest[piece_label[piece]];
    if (best == kNone || piece_area[piece] > piece_area[best]) best = piece;
  }
  for (Index f = 0; f < label.size(); ++f) {
    if (label[f] != kNone && largest[label[f]] != piece_of_face[f]) label[f] = kNone;
  }
  return label;
}

/// Gives a face to the part that holds two of its neighbours wherever that shortens the border.
/// A face attached by one edge can leave its part without cutting it in two.
inline void straighten_borders(const FaceGraph& faces, std::vector<Index>& part) {
  const auto better_part = [&](Index f) {
    const std::array<Index, 3>& around = faces.neighbour[f];
    if (std::find(around.begin(), around.end(), kNone) != around.end()) return part[f];
    for (Index i = 0; i < 3; ++i) {  // i: the one edge to the own part
      const Index j = (i + 1) % 3;
      const Index k = (i + 2) % 3;
      const Index other = part[around[j]];
      if (other == part[f] || other == kNone || part[around[k]] != other) continue;
      if (part[around[i]] != part[f]) continue;
      const std::array<double, 3>& length = faces.edge_length[f];
      if (length[j] + length[k] > length[i]) return other;
    }
    return part[f];
  };
  // The border gets shorter with every change, so this ends.
  for (bool changed = true; changed;) {
    changed = false;
    for (Index f = 0; f < part.size(); ++f) {
      const Index better = better_part(f);
      if (better == part[f]) continue;
      part[f] = better;
      changed = true;
    }
  }
}

}  // namespace parting

/// The branch that each face belongs to: that of most of the geodesic circles through it, elsewhere
/// that of the nearest face with circles. The part of a branch is connected: its smaller pieces go
/// to their neighbours; a branch whose faces have all gone to others has none. Borders run where
/// the circles of different branches meet and are free of single teeth.
/// `circles_on_face` has a row per face, `branch_of_circle` an entry per circle. A face on a
/// component without circles gets kNone. Cost: O(n log n).
inline std::vector<Index> cut_into_parts(const FaceGraph& faces, const Rows<Index>& circles_on_face,
                                         const std::vector<Index>& branch_of_circle) {
  const std::vector<Index> seeds = parting::majority_branches(circles_on_face, branch_of_circle);
  const std::vector<Index> nearest = flood_faces(faces, seeds).label;
  std::vector<Index> part = flood_faces(faces, parting::largest_pieces(faces, nearest)).label;
  parting::straighten_borders(faces, part);
  return part;
}

}  // namespace mgf
