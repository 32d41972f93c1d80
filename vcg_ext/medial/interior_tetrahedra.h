// SPDX-License-Identifier: GPL-3.0-or-later
// What the topology stage hands on: the shape's interior as tetrahedra, and the proof that it has
// the topology of the shape.
#pragma once

#include <array>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// Betti numbers of a complex: connected components, independent loops, enclosed voids.
struct BettiNumbers {
  Index b0 = 0;
  Index b1 = 0;
  Index b2 = 0;
  bool operator==(const BettiNumbers& other) const {
    return b0 == other.b0 && b1 == other.b1 && b2 == other.b2;
  }
  bool operator!=(const BettiNumbers& other) const { return !(*this == other); }
};

/// How far the topology of the interior is known to be that of the shape.
enum class TopologyVerdict {
  kProven,   ///< every check of the certificate holds, so the homotopy type is a theorem
  kCounted,  ///< the Betti numbers are those of the genus, but a check that the theorem needs fails
  kFailed,   ///< the Betti numbers differ; the result has the interior's topology, not the shape's
};

/// The checks behind a `TopologyVerdict`, made anew on the finished tetrahedra.
struct TopologyCertificate {
  TopologyVerdict topology = TopologyVerdict::kFailed;
  bool isotopic = false;  ///< proven, and some motion of space carries the input surface to T'
  bool gave_up = false;   ///< recovery ended early, its bounds on work spent; never if proven
  Index boundary_faces_missing = 0;   ///< faces of T' that are no face of the tetrahedra
  Index boundary_faces_extra = 0;     ///< boundary faces of the interior that are not in T'
  Index tetrahedra_not_positive = 0;  ///< by the exact orientation predicate
  Index winding_conflicts = 0;        ///< contradictions met by the winding flood
  Index interior_vertices = 0;        ///< vertices with all their tetrahedra inside (3-cells)
  BettiNumbers betti;                 ///< of the interior, by combinatorics
  BettiNumbers expected;              ///< shells, sum of genera, 0
  Index surface_flips = 0;            ///< edges flipped on the way from T to T'
  Index points_added = 0;             ///< points that recovery had to add on T'
  Index exact_points = 0;             ///< of these, made by exact splits: all checks hold for exact
                                      ///< positions on T, of which `points` are the nearest doubles
  Index tetrahedra_flattened = 0;     ///< tetrahedra that rounding to doubles leaves not positive
};

/// The interior of a closed surface as tetrahedra whose corners lie on the surface.
struct InteriorTetrahedra {
  std::vector<Vec3> points;  ///< the surface's vertices, then the points that recovery added
  Index input_points = 0;    ///< how many of `points` are the surface's own
  std::vector<Tetrahedron> tetrahedra;           ///< positively oriented
  std::vector<std::array<Index, 4>> neighbours;  ///< across the face opposite corner i, or kNone
  std::vector<Triangle> boundary;                ///< T': triangulates the same surface, outward
  TopologyCertificate certificate;
};

}  // namespace mgf
