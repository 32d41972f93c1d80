// SPDX-License-Identifier: GPL-3.0-or-later
// Exact shortest paths on a triangle surface between many near pairs of its vertices: the question
// and the answer. How it is answered is in coherent_paths.h and path_certificate.h.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"

namespace mgf {

/// Two vertices of the surface, a < b, whose distance on the surface is asked.
struct VertexPair {
  Index a = 0;
  Index b = 0;
};

/// What is known of a computed geodesic. All words are meant in double arithmetic, up to 1e-10 of
/// the mean edge length.
enum class Certification : std::uint8_t {
  kUnproven,   ///< a locally shortest path, its length an upper bound
  kWithin,     ///< the same, and no path is shorter by more than the factor 1 + epsilon
  kPractical,  ///< no shorter path was found, but the search met triangles too thin (1e-6) to be
               ///< certain of every angle
  kProven,     ///< no shorter path exists: the search that pruned by this bound was exhaustive
};

/// How much certification is wanted. A pair of which a search happens to prove more has the
/// stronger word.
struct GeodesicOptions {
  Certification wanted = Certification::kProven;
  unsigned threads = 0;   ///< 0: all; the answer is the same for any number
  double epsilon = 0.01;  ///< of `kWithin`, > 0
};

/// The answer, one entry per pair.
struct PairGeodesics {
  std::vector<double> length;   ///< of the shortest path from a to b
  std::vector<Vec3> tangent_a;  ///< unit, leaving a along the path; zero if length is 0
  std::vector<Vec3> tangent_b;  ///< unit, leaving b along the path
  std::vector<Certification> certification;
  Rows<Index> corridor;  ///< the directed edges (3 · triangle + i, the edge from corner i to corner
                         ///< i+1) that the path crosses or runs along, from a to b
};

}  // namespace mgf
