// SPDX-License-Identifier: GPL-3.0-or-later
// The surface cut into one connected part per branch.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/surface/border_relaxation.h"
#include "vcg_ext/surface/face_flood.h"
#include "vcg_ext/surface/face_pieces.h"

namespace mgf {
namespace parting {

/// The owner of most of the circles through each face, the smaller id of equals; kNone for none.
inline std::vector<Index> majority_owners(const Rows<Index>& circles_on_face,
                                          const std::vector<Index>& owner_of_circle) {
  std::vector<Index> majority(circles_on_face.size(), kNone);
  std::vector<Index> branches;
  for (std::size_t f = 0; f < majority.size(); ++f) {
    branches.clear();
    for (const Index circle : circles_on_face[f]) branches.push_back(owner_of_circle[circle]);
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
  const FacePieces pieces = connected_pieces(faces, label);
  std::vector<Index> largest;  // by label
  for (Index piece = 0; piece < pieces.area.size(); ++piece) {
    const Index own = pieces.label[piece];
    if (own >= largest.size()) largest.resize(own + 1, kNone);
    if (largest[own] == kNone || pieces.area[piece] > pieces.area[largest[own]]) {
      largest[own] = piece;
    }
  }
  for (Index f = 0; f < label.size(); ++f) {
    if (label[f] != kNone && largest[label[f]] != pieces.of_face[f]) label[f] = kNone;
  }
  return label;
}

/// At each face the mean radius of its circles, elsewhere that of the nearest face with circles; 0
/// where there is none.
inline std::vector<double> radii_at_faces(const FaceGraph& faces,
                                          const Rows<Index>& circles_on_face,
                                          const std::vector<double>& circle_radius) {
  std::vector<double> radius(faces.face_count(), 0.0);
  std::vector<Index> seeds(faces.face_count(), kNone);
  for (Index f = 0; f < seeds.size(); ++f) {
    const Row<Index> circles = circles_on_face[f];
    if (circles.empty()) continue;
    for (const Index circle : circles) radius[f] += circle_radius[circle];
    radius[f] /= static_cast<double>(circles.size());
    seeds[f] = f;
  }
  const std::vector<Index> nearest = flood_faces(faces, seeds).label;
  for (Index f = 0; f < seeds.size(); ++f) {
    if (nearest[f] != kNone) radius[f] = radius[nearest[f]];
  }
  return radius;
}

/// Each label's largest piece, and the rest as the nearest of them.
inline std::vector<Index> connected_parts(const FaceGraph& faces, std::vector<Index> label) {
  return flood_faces(faces, largest_pieces(faces, std::move(label))).label;
}

}  // namespace parting

/// The branch that each face belongs to: the owner of most of the geodesic circles through it,
/// elsewhere that of the nearest face with circles. The part of a branch is connected: its smaller
/// pieces go to their neighbours; a branch whose faces have all gone to others has none. Borders
/// run where the circles of different owners meet, without steps below a share of the local radius.
/// `circles_on_face` has a row per face; `owner_of_circle` and `circle_radius` (rho = MGF / pi) an
/// entry per circle. A face on a component without circles gets kNone. Cost: O(n log n), and the
/// patches of `relax_borders`.
inline std::vector<Index> cut_into_parts(const FaceGraph& faces, const Rows<Index>& circles_on_face,
                                         const std::vector<Index>& owner_of_circle,
                                         const std::vector<double>& circle_radius,
                                         unsigned threads = 0) {
  const std::vector<Index> seeds = parting::majority_owners(circles_on_face, owner_of_circle);
  std::vector<Index> part = parting::connected_parts(faces, flood_faces(faces, seeds).label);
  const std::vector<double> radius = parting::radii_at_faces(faces, circles_on_face, circle_radius);
  const std::vector<double> reach = relaxation_reach(faces, radius, 0.5, 10.0);
  relax_borders(faces, reach, thread_count(threads), part);
  part = parting::connected_parts(faces, std::move(part));
  straighten_borders(faces, part);
  return part;
}

}  // namespace mgf
