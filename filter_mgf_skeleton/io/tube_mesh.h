// SPDX-License-Identifier: GPL-3.0-or-later
// Tubes round polylines: a skeleton made of faces, so that its colour is seen and saved everywhere.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "vcg_ext/core/constants.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/skeleton/curve_skeleton.h"

namespace mgf::io {

/// A polyline to put a tube round. A closed one does not repeat its first point.
struct TubePath {
  std::vector<Vec3> points;
  std::vector<double> quality;  ///< one per point
  bool closed = false;
};

/// Closed triangle surfaces, one per path, with a quality per vertex.
struct TubeMesh {
  TriangleSurface surface;
  std::vector<double> quality;
};

namespace tube_detail {

inline constexpr Index kSides = 12;  // corners of a cross-section
inline constexpr Index kCapRings =
    3;  // rings from an open end's rim to its pole, the pole included

// A cross-section's place: origin, unit tangent, and a unit normal where its corners start.
struct Frame {
  Vec3 origin;
  Vec3 tangent;
  Vec3 normal;
  Vec3 binormal() const { return tangent.cross(normal); }
};

// A path without repeated points, which have no direction.
inline TubePath without_repeats(const TubePath& path) {
  TubePath result;
  result.closed = path.closed;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    if (!result.points.empty() && path.points[i] == result.points.back()) continue;
    result.points.push_back(path.points[i]);
    result.quality.push_back(path.quality[i]);
  }
  while (result.closed && result.points.size() > 1 &&
         result.points.front() == result.points.back()) {
    result.points.pop_back();
    result.quality.pop_back();
  }
  // Two points go forth and back: nothing to close.
  if (result.points.size() < 3) result.closed = false;
  return result;
}

// At each point the mean direction of the two sides; the outgoing one where they cancel.
inline std::vector<Vec3> tangents(const TubePath& path) {
  const std::size_t count = path.points.size();
  std::vector<Vec3> result(count, Vec3::UnitZ());
  if (count < 2) return result;
  const auto direction = [&](std::size_t i) {
    return (path.points[(i + 1) % count] - path.points[i % count]).normalized();
  };
  for (std::size_t i = 0; i < count; ++i) {
    const bool first = i == 0 && !path.closed;
    const bool last = i + 1 == count && !path.closed;
    const Vec3 incoming = direction(first ? 0 : i + count - 1);
    const Vec3 outgoing = last ? direction(i - 1) : direction(i);
    const Vec3 sum = first ? outgoing : last ? outgoing : Vec3(incoming + outgoing);
    constexpr double kCancelled = 1e-6;  // of unit vectors
    result[i] = sum.norm() > kCancelled ? Vec3(sum.normalized()) : outgoing;
  }
  return result;
}

// Frames that turn no more than the path does; along a closed path the twist that is left over is
// spread evenly, so that the last cross-section meets the first.
inline std::vector<Frame> frames(const TubePath& path) {
  constexpr double kTurnsBack = 1e-12;  // cosine of tangents above -1
  const std::vector<Vec3> tangent = tangents(path);
  std::vector<Frame> result;
  // The normal, turned as the tangent turns; where the path turns back, about the normal itself.
  const auto carried = [](const Frame& from, const Vec3& to) -> Vec3 {
    const double cosine = from.tangent.dot(to);
    if (cosine <= -1.0 + kTurnsBack) return from.normal;
    const Vec3 axis = from.tangent.cross(to);
    const Vec3& n = from.normal;
    return cosine * n + axis.cross(n) + axis * (axis.dot(n) / (1.0 + cosine));
  };
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    Vec3 normal = i == 0 ? tangent[0].unitOrthogonal() : carried(result.back(), tangent[i]);
    normal = (normal - tangent[i] * tangent[i].dot(normal)).normalized();
    result.push_back({path.points[i], tangent[i], normal});
  }
  if (!path.closed) return result;
  const Vec3 arrived = carried(result.back(), tangent[0]);
  const double twist = std::atan2(arrived.dot(result[0].binormal()), arrived.dot(result[0].normal));
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(result.size());
    result[i].normal = Eigen::AngleAxisd(-twist * share, result[i].tangent) * result[i].normal;
  }
  return result;
}

// Puts cross-sections and poles into a mesh, each joined to the one before it.
class TubeBuilder {
 public:
  TubeBuilder(double radius, TubeMesh& mesh) : radius_(radius), mesh_(mesh) {}

  // A ring `along` radii in front of the frame's origin and `scale` radii wide.
  Index add_ring(const Frame& frame, double along, double scale, double quality) {
    const Index first = to_index(mesh_.surface.points.size());
    for (Index k = 0; k < kSides; ++k) {
      const double angle = 2.0 * kPi * k / kSides;
      add_point(frame.origin + radius_ * (along * frame.tangent +
                                          scale * (std::cos(angle) * frame.normal +
                                                   std::sin(angle) * frame.binormal())),
                quality);
    }
    return first;
  }

  Index add_pole(const Frame& frame, double along, double quality) {
    add_point(frame.origin + radius_ * along * frame.tangent, quality);
    return to_index(mesh_.surface.points.size() - 1);
  }

  void join_rings(Index from, Index to) {
    for (Index k = 0; k < kSides; ++k) {
      const Index next = (k + 1) % kSides;
      mesh_.surface.triangles.push_back({from + k, from + next, to + next});
      mesh_.surface.triangles.push_back({from + k, to + next, to + k});
    }
  }

  void open_with(Index pole, Index ring) {
    for (Index k = 0; k < kSides; ++k) {
      mesh_.surface.triangles.push_back({pole, ring + (k + 1) % kSides, ring + k});
    }
  }

  void close_with(Index ring, Index pole) {
    for (Index k = 0; k < kSides; ++k) {
      mesh_.surface.triangles.push_back({ring + k, ring + (k + 1) % kSides, pole});
    }
  }

 private:
  void add_point(const Vec3& point, double quality) {
    mesh_.surface.points.push_back(point);
    mesh_.quality.push_back(quality);
  }

  double radius_;
  TubeMesh& mesh_;
};

inline void add_closed_tube(const TubePath& path, TubeBuilder& builder) {
  const std::vector<Frame> frame = frames(path);
  Index first = kNone;
  Index previous = kNone;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Index ring = builder.add_ring(frame[i], 0.0, 1.0, path.quality[i]);
    if (i == 0) {
      first = ring;
    } else {
      builder.join_rings(previous, ring);
    }
    previous = ring;
  }
  builder.join_rings(previous, first);
}

// A tube with a half ball at each end; of a single point, a ball.
inline void add_open_tube(const TubePath& path, TubeBuilder& builder) {
  const std::vector<Frame> frame = frames(path);
  const auto latitude = [](Index ring) { return 0.5 * kPi * ring / kCapRings; };
  const Index pole = builder.add_pole(frame.front(), -1.0, path.quality.front());
  Index previous = kNone;
  for (Index ring = kCapRings - 1; ring > 0; --ring) {
    const Index next = builder.add_ring(frame.front(), -std::sin(latitude(ring)),
                                        std::cos(latitude(ring)), path.quality.front());
    if (previous == kNone) {
      builder.open_with(pole, next);
    } else {
      builder.join_rings(previous, next);
    }
    previous = next;
  }
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Index next = builder.add_ring(frame[i], 0.0, 1.0, path.quality[i]);
    builder.join_rings(previous, next);
    previous = next;
  }
  for (Index ring = 1; ring < kCapRings; ++ring) {
    const Index next = builder.add_ring(frame.back(), std::sin(latitude(ring)),
                                        std::cos(latitude(ring)), path.quality.back());
    builder.join_rings(previous, next);
    previous = next;
  }
  builder.close_with(previous, builder.add_pole(frame.back(), 1.0, path.quality.back()));
}

}  // namespace tube_detail

/// A tube of `radius` (mesh units) round each path that has a point: faces outward, open ends
/// round, so that tubes that meet in a point close the joint. O(points).
inline TubeMesh make_tubes(const std::vector<TubePath>& paths, double radius) {
  TubeMesh mesh;
  tube_detail::TubeBuilder builder(radius, mesh);
  for (const TubePath& given : paths) {
    const TubePath path = tube_detail::without_repeats(given);
    if (path.points.empty()) continue;
    if (path.closed) {
      tube_detail::add_closed_tube(path, builder);
    } else {
      tube_detail::add_open_tube(path, builder);
    }
  }
  return mesh;
}

/// One path per branch, then one per isolated node. `edge_quality` has one value per skeleton edge;
/// a node inside a branch gets the mean of its two edges, an isolated one `isolated_quality`.
inline std::vector<TubePath> tube_paths(const CurveSkeleton& skeleton, const BranchGraph& graph,
                                        const std::vector<double>& edge_quality,
                                        double isolated_quality) {
  std::vector<TubePath> paths;
  for (const Branch& branch : graph.branches) {
    TubePath path;
    path.closed = branch.first_node == branch.last_node;
    const std::size_t edges = branch.edges.size();
    const std::size_t points = path.closed ? edges : branch.nodes.size();
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t before = i > 0 ? i - 1 : path.closed ? edges - 1 : 0;
      const std::size_t after = std::min(i, edges - 1);
      path.points.push_back(skeleton.position[branch.nodes[i]]);
      path.quality.push_back(
          0.5 * (edge_quality[branch.edges[before]] + edge_quality[branch.edges[after]]));
    }
    paths.push_back(path);
  }
  for (Index n = 0; n < skeleton.node_count(); ++n) {
    if (graph.node_kind[n] != NodeKind::kIsolated) continue;
    paths.push_back({{skeleton.position[n]}, {isolated_quality}, false});
  }
  return paths;
}

/// A thickness at which tubes are well seen and hide little: 1/250 of the skeleton's diagonal; a
/// tenth of the largest radius where the skeleton has no extent.
inline double default_tube_radius(const CurveSkeleton& skeleton) {
  constexpr double kShareOfDiagonal = 0.004;
  constexpr double kShareOfRadius = 0.1;
  const double diagonal = bounding_box_diagonal(skeleton.position);
  if (diagonal > 0.0 || skeleton.radius.empty()) return kShareOfDiagonal * diagonal;
  return kShareOfRadius * *std::max_element(skeleton.radius.begin(), skeleton.radius.end());
}

}  // namespace mgf::io
