// SPDX-License-Identifier: GPL-3.0-or-later
// Borders between labels made straight over distances well above a face.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/surface/face_flood.h"

namespace mgf {
namespace border_relaxation {

/// Rounds at most; a border moves by about a face a round.
inline constexpr int kRounds = 16;

/// Finds which label holds most of the surface round a face.
class PatchVote {
 public:
  explicit PatchVote(std::size_t face_count) : last_visit_(face_count, 0) {}

  /// The label with most of the area of the patch of `centre`: the faces connected with it whose
  /// centroids lie within `reach` of its own. Of equals its own, then the smallest.
  Index winner(const FaceGraph& faces, const std::vector<Index>& label, Index centre,
               double reach) {
    ++visit_;
    areas_.clear();
    front_.assign(1, centre);
    last_visit_[centre] = visit_;
    while (!front_.empty()) {
      const Index f = front_.back();
      front_.pop_back();
      area_of(label[f]) += faces.area[f];
      for (const Index g : faces.neighbour[f]) {
        if (g == kNone || last_visit_[g] == visit_) continue;
        last_visit_[g] = visit_;
        const double squared = (faces.centroid[g] - faces.centroid[centre]).squaredNorm();
        if (squared <= reach * reach) front_.push_back(g);
      }
    }
    Index best = label[centre];
    double most = area_of(best);
    for (const auto& [other, area] : areas_) {
      if (area > most || (area == most && best != label[centre] && other < best)) {
        best = other;
        most = area;
      }
    }
    return best;
  }

 private:
  double& area_of(Index label) {
    for (auto& [other, area] : areas_) {
      if (other == label) return area;
    }
    return areas_.emplace_back(label, 0.0).second;
  }

  std::vector<Index> last_visit_;
  Index visit_ = 0;
  std::vector<Index> front_;
  std::vector<std::pair<Index, double>> areas_;  ///< by label, few
};

/// The labelled faces beside one of another label.
inline std::vector<Index> border_faces(const FaceGraph& faces, const std::vector<Index>& label) {
  std::vector<Index> border;
  for (Index f = 0; f < label.size(); ++f) {
    const auto differs = [&](Index g) {
      return g != kNone && label[g] != kNone && label[g] != label[f];
    };
    const auto& around = faces.neighbour[f];
    if (label[f] != kNone && std::any_of(around.begin(), around.end(), differs)) {
      border.push_back(f);
    }
  }
  return border;
}

}  // namespace border_relaxation

/// Up to which size steps of a border near each face are levelled, mesh units: a share of the local
/// `radius` (one per face), so that no limb is lost, and some face sizes, for it is faces that make
/// the steps.
inline std::vector<double> relaxation_reach(const FaceGraph& faces,
                                            const std::vector<double>& radius, double of_radius,
                                            double of_face_size) {
  std::vector<double> reach(faces.face_count());
  for (Index f = 0; f < reach.size(); ++f) {
    reach[f] = std::min(of_radius * radius[f], of_face_size * std::sqrt(faces.area[f]));
  }
  return reach;
}

/// Moves borders towards their shortest place nearby: a face at a border goes over to the label
/// that holds most of the surface within its `reach` (one per face, mesh units), again and again.
/// Steps up to about that size disappear, a border along a closed geodesic stays. (Threshold
/// dynamics: Merriman, Bence, Osher 1992.) Pieces may come apart where they are thinner than the
/// reach. The same for any number of `threads`. Cost: a patch a border face and round.
inline void relax_borders(const FaceGraph& faces, const std::vector<double>& reach,
                          unsigned threads, std::vector<Index>& label) {
  using border_relaxation::PatchVote;
  std::vector<PatchVote> votes(threads, PatchVote(label.size()));
  for (int round = 0; round < border_relaxation::kRounds; ++round) {
    const std::vector<Index> border = border_relaxation::border_faces(faces, label);
    std::vector<Index> winner(border.size());
    constexpr std::size_t kChunk = 16;
    parallel_for(border.size(), threads, kChunk, [&](std::size_t i, unsigned worker) {
      winner[i] = votes[worker].winner(faces, label, border[i], reach[border[i]]);
    });
    bool changed = false;
    for (std::size_t i = 0; i < border.size(); ++i) {
      changed = changed || label[border[i]] != winner[i];
      label[border[i]] = winner[i];
    }
    if (!changed) return;
  }
}

}  // namespace mgf
