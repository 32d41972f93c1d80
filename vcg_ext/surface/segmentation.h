// SPDX-License-Identifier: GPL-3.0-or-later
// Tubular and flat regions of the surface (paper, section 5.6).
#pragma once

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "vcg_ext/core/constants.h"
#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/input/refined_surface.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/skeleton/eccentricity_filter.h"
#include "vcg_ext/skeleton/weighted_median.h"
#include "vcg_ext/surface/border_relaxation.h"
#include "vcg_ext/surface/face_flood.h"
#include "vcg_ext/surface/face_pieces.h"
#include "vcg_ext/surface/geodesic_circles.h"

namespace mgf {

/// Per face of the input surface.
struct Segmentation {
  std::vector<char> tubular;         ///< 1 tubular, 0 flat; every face has a label
  std::vector<double> eccentricity;  ///< of the nearest geodesic circles, continuous; 0 if unknown
  std::vector<double> confidence;    ///< in [0, 1]: the share of the nearest circles, unfiltered,
                                     ///< that agree with the label, falling with their distance
  double tubular_area_share = 0.0;   ///< in [0, 1]
  Index unlabelled_faces = 0;        ///< 0 unless a component's skeleton has no edge
};

namespace segmentation {

/// What the circles that run through one face say about it.
struct Evidence {
  double eccentricity = 0.0;  ///< median of the filtered ones, the lower of two
  double agreement = 0.0;     ///< share of the unfiltered ones on the same side of the threshold
  double rho = 0.0;           ///< median local radius, MGF / pi
  Index face = 0;
};

inline Evidence weigh_evidence(Index face, const Row<Index>& circles, const CurveSkeleton& skeleton,
                               const std::vector<double>& filtered, double threshold) {
  const std::vector<double> once(circles.size(), 1.0);
  std::vector<double> eccentricities;
  std::vector<double> radii;
  for (const Index circle : circles) {
    eccentricities.push_back(filtered[circle]);
    radii.push_back(skeleton.mgf[circle] / kPi);
  }
  Evidence evidence;
  evidence.face = face;
  evidence.eccentricity = weighted_median(eccentricities, once);
  evidence.rho = weighted_median(radii, once);
  const bool tubular = evidence.eccentricity < threshold;
  for (const Index circle : circles) {
    if ((skeleton.eccentricity[circle] < threshold) == tubular) evidence.agreement += 1.0;
  }
  evidence.agreement /= static_cast<double>(circles.size());
  return evidence;
}

/// The evidence of all faces that circles run through, in an order by what it says, so
/// that a position in it serves as a label whose ties don't depend on the numbers of the faces.
inline std::vector<Evidence> collect_evidence(const Rows<Index>& circles_on_face,
                                              const CurveSkeleton& skeleton,
                                              const std::vector<double>& filtered,
                                              double threshold) {
  std::vector<Evidence> evidence;
  for (Index f = 0; f < circles_on_face.size(); ++f) {
    const Row<Index> circles = circles_on_face[f];
    if (circles.empty()) continue;
    evidence.push_back(weigh_evidence(f, circles, skeleton, filtered, threshold));
  }
  std::sort(evidence.begin(), evidence.end(), [](const Evidence& a, const Evidence& b) {
    return std::tie(a.eccentricity, a.agreement, a.rho, a.face) <
           std::tie(b.eccentricity, b.agreement, b.rho, b.face);
  });
  return evidence;
}

/// Clears the labels of pieces smaller than a disc of the local radius next to a larger piece.
inline std::vector<Index> without_islands(const FaceGraph& faces, std::vector<Index> label,
                                          const std::vector<double>& rho) {
  const FacePieces pieces = connected_pieces(faces, label);
  std::vector<double> disc(pieces.area.size(), 0.0);  // area of the local disc, mean over the piece
  std::vector<char> has_larger_neighbour(pieces.area.size(), 0);
  for (Index f = 0; f < label.size(); ++f) {
    const Index piece = pieces.of_face[f];
    if (piece == kNone) continue;
    disc[piece] += kPi * rho[f] * rho[f] * faces.area[f] / pieces.area[piece];
    for (const Index g : faces.neighbour[f]) {
      if (g == kNone || pieces.of_face[g] == kNone) continue;
      if (pieces.area[pieces.of_face[g]] > pieces.area[piece]) has_larger_neighbour[piece] = 1;
    }
  }
  for (Index f = 0; f < label.size(); ++f) {
    const Index piece = pieces.of_face[f];
    if (piece == kNone) continue;
    if (has_larger_neighbour[piece] && pieces.area[piece] < disc[piece]) label[f] = kNone;
  }
  return label;
}

/// Clears the labels of pieces without a seed of their label, whose faces nothing would speak for.
inline std::vector<Index> without_unfounded_pieces(const FaceGraph& faces, std::vector<Index> label,
                                                   const std::vector<Index>& label_of_seed) {
  const FacePieces pieces = connected_pieces(faces, label);
  std::vector<char> founded(pieces.area.size(), 0);
  for (Index f = 0; f < label.size(); ++f) {
    if (label[f] != kNone && label_of_seed[f] == label[f]) founded[pieces.of_face[f]] = 1;
  }
  for (Index f = 0; f < label.size(); ++f) {
    if (label[f] != kNone && founded[pieces.of_face[f]] == 0) label[f] = kNone;
  }
  return label;
}

/// A labelling with short borders: islands gone, steps and teeth levelled. Faces without a label
/// take that of the nearest. Every piece keeps a face whose `label_of_seed` is its label.
inline std::vector<Index> tidied(const FaceGraph& faces, std::vector<Index> label,
                                 const std::vector<double>& rho,
                                 const std::vector<Index>& label_of_seed, unsigned threads) {
  label = flood_faces(faces, without_islands(faces, std::move(label), rho)).label;
  // Half as far as for parts: a flat palm is narrower than the parts of a hand are long.
  relax_borders(faces, relaxation_reach(faces, rho, 0.25, 5.0), threads, label);
  label = flood_faces(faces, without_islands(faces, std::move(label), rho)).label;
  straighten_borders(faces, label);
  return flood_faces(faces, without_unfounded_pieces(faces, std::move(label), label_of_seed)).label;
}

/// The evidence that speaks for each face, as a position in `evidence`, and how far it is: that of
/// the nearest face with circles, once the labels are tidied.
inline FaceFlood nearest_evidence(const FaceGraph& faces, const std::vector<Evidence>& evidence,
                                  double threshold, unsigned threads) {
  const std::size_t n = faces.face_count();
  std::vector<Index> seeds(n, kNone);
  for (Index i = 0; i < evidence.size(); ++i) seeds[evidence[i].face] = i;
  const FaceFlood everyone = flood_faces(faces, seeds);

  const auto class_of = [&](Index i) {
    return i == kNone ? kNone : evidence[i].eccentricity < threshold ? 1U : 0U;
  };
  std::vector<Index> label(n, kNone);
  std::vector<Index> label_of_seed(n, kNone);
  std::vector<double> rho(n, 0.0);
  for (Index f = 0; f < n; ++f) {
    label_of_seed[f] = class_of(seeds[f]);
    if (everyone.label[f] == kNone) continue;
    label[f] = class_of(everyone.label[f]);
    rho[f] = evidence[everyone.label[f]].rho;
  }
  label = tidied(faces, std::move(label), rho, label_of_seed, threads);

  for (Index f = 0; f < n; ++f) {
    if (label_of_seed[f] != label[f]) seeds[f] = kNone;
  }
  return flood_faces(faces, seeds, [&](Index f, Index g) { return label[f] == label[g]; });
}

}  // namespace segmentation

/// Labels every face of `input` tubular or flat: a face that geodesic circles run through by the
/// majority of them (half and half: tubular), a circle being tubular if its eccentricity, filtered
/// along its branch, is below `eccentricity_threshold`; any other face as the nearest such face
/// along the surface. A piece smaller than a disc of the local radius then joins the larger piece
/// beside it, and borders are relaxed; such faces take the eccentricity of the nearest face with
/// their label. So the label always is `eccentricity` < threshold.
/// `refined` refines `input`, and the circles run on it. Cost: O(n log n) in the faces and circle
/// crossings.
inline Segmentation segment_surface(const TriangleSurface& input, const RefinedSurface& refined,
                                    const CurveSkeleton& skeleton, const BranchGraph& graph,
                                    const GeodesicCircles& circles, double eccentricity_threshold,
                                    unsigned threads = 0) {
  const std::size_t n = input.triangles.size();
  const FaceGraph faces = build_face_graph(input);
  const Rows<Index> circles_on_face = items_on_input_faces(circles.faces, refined.parent_face, n);
  const std::vector<segmentation::Evidence> evidence = segmentation::collect_evidence(
      circles_on_face, skeleton, filtered_eccentricity(skeleton, graph), eccentricity_threshold);
  const FaceFlood flood = segmentation::nearest_evidence(faces, evidence, eccentricity_threshold,
                                                         thread_count(threads));

  Segmentation result;
  result.tubular.assign(n, 0);
  result.eccentricity.assign(n, 0.0);
  result.confidence.assign(n, 0.0);
  double tubular_area = 0.0;
  for (Index f = 0; f < n; ++f) {
    if (flood.label[f] == kNone) {
      ++result.unlabelled_faces;
      continue;
    }
    const segmentation::Evidence& nearest = evidence[flood.label[f]];
    const double reach = nearest.rho + flood.distance[f];
    result.eccentricity[f] = nearest.eccentricity;
    result.confidence[f] = reach > 0.0 ? nearest.agreement * nearest.rho / reach : 0.0;
    result.tubular[f] = nearest.eccentricity < eccentricity_threshold ? 1 : 0;
    if (result.tubular[f]) tubular_area += faces.area[f];
  }
  const double area = std::accumulate(faces.area.begin(), faces.area.end(), 0.0);
  result.tubular_area_share = area > 0.0 ? tubular_area / area : 0.0;
  return result;
}

}  // namespace mgf
