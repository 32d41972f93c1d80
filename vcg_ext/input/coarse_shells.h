// SPDX-License-Identifier: GPL-3.0-or-later
// Which shells have too few vertices for a medial axis.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/radix_sort.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/surface_tree.h"
#include "vcg_ext/input/shells.h"
#include "vcg_ext/input/thickness.h"

namespace mgf {

/// The shells of a surface that automatic sampling refines.
struct CoarseShells {
  Shells shells;
  std::vector<char> is_coarse;  ///< one per shell: faces coarser than the thickness make more than
                                ///< a quarter of its area

  bool any() const { return std::find(is_coarse.begin(), is_coarse.end(), 1) != is_coarse.end(); }
  bool has_face(Index face) const { return is_coarse[shells.of_face[face]] != 0; }
};

namespace detail {

/// Asks which faces are coarse until that decides over every shell. Large faces come first: a fine
/// mesh is known by a few rays.
class CoarseVote {
 public:
  CoarseVote(const TriangleSurface& surface, const SurfaceTree& tree, const Shells& shells)
      : surface_(surface),
        tree_(tree),
        shells_(shells),
        coarse_(shells.shells.size(), 0.0),
        fine_(shells.shells.size(), 0.0),
        whole_(shells.shells.size(), 0.0) {
    area_.reserve(surface.triangles.size());
    for (Index f = 0; f < surface.triangles.size(); ++f) {
      const Triangle& t = surface.triangles[f];
      const Vec3& a = surface.points[t[0]];
      area_.push_back((surface.points[t[1]] - a).cross(surface.points[t[2]] - a).norm());
      whole_[shells.of_face[f]] += area_[f];
    }
    std::vector<std::uint64_t> keys;
    keys.reserve(area_.size());
    for (const double area : area_) keys.push_back(descending_key(area));
    order_ = sorted_by_key(keys);
  }

  std::vector<char> run(unsigned threads) {
    std::vector<Index> block;
    std::vector<char> votes;
    for (std::size_t next = 0; next < order_.size();) {
      block.clear();
      for (; next < order_.size() && block.size() < kBlock; ++next) {
        if (!decided(shells_.of_face[order_[next]])) block.push_back(order_[next]);
      }
      votes.assign(block.size(), 0);
      parallel_for(block.size(), threads, kChunk, [&](std::size_t i, unsigned) {
        votes[i] = is_coarser_than_thickness(surface_, tree_, block[i]) ? 1 : 0;
      });
      for (std::size_t i = 0; i < block.size(); ++i) {
        (votes[i] != 0 ? coarse_ : fine_)[shells_.of_face[block[i]]] += area_[block[i]];
      }
    }
    std::vector<char> result;
    for (Index s = 0; s < whole_.size(); ++s) result.push_back(is_coarse(s) ? 1 : 0);
    return result;
  }

 private:
  /// Below it the medial axis was sound on round limbs cut off by marching tetrahedra, above it
  /// not; scans have less than 0.1.
  static constexpr double kCoarseShare = 0.25;
  static constexpr std::size_t kBlock = 2048;
  static constexpr std::size_t kChunk = 64;

  bool decided(Index shell) const {
    return is_coarse(shell) || fine_[shell] > (1.0 - kCoarseShare) * whole_[shell];
  }
  bool is_coarse(Index shell) const { return coarse_[shell] > kCoarseShare * whole_[shell]; }

  const TriangleSurface& surface_;
  const SurfaceTree& tree_;
  const Shells& shells_;
  std::vector<double> coarse_;  // area seen so far, of each shell
  std::vector<double> fine_;
  std::vector<double> whole_;
  std::vector<double> area_;  // of each face, doubled
  std::vector<Index> order_;
};

}  // namespace detail

/// Finds them among the `shells` of a surface. Requires a closed, outward-oriented surface without
/// collinear faces. Cost: a short ray for each of the faces that make three quarters of the area.
/// The same for any number of `threads` (0: all).
inline CoarseShells find_coarse_shells(const TriangleSurface& surface, const SurfaceTree& tree,
                                       Shells shells, unsigned threads = 0) {
  CoarseShells result;
  result.shells = std::move(shells);
  result.is_coarse = detail::CoarseVote(surface, tree, result.shells).run(thread_count(threads));
  return result;
}

/// The faces coarser than the thickness in those of the `shells` that are too coarse; ascending.
/// Arguments as above.
inline std::vector<Index> too_coarse_faces(const TriangleSurface& surface, const SurfaceTree& tree,
                                           const Shells& shells, unsigned threads = 0) {
  const CoarseShells coarse = find_coarse_shells(surface, tree, shells, threads);
  std::vector<Index> faces;
  for (Index f = 0; f < surface.triangles.size(); ++f) {
    if (coarse.has_face(f) && is_coarser_than_thickness(surface, tree, f)) faces.push_back(f);
  }
  return faces;
}

}  // namespace mgf
