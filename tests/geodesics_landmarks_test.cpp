// SPDX-License-Identifier: GPL-3.0-or-later
// Landmarks: what they measure, that they change no length, and when they are used.
#include <gtest/gtest.h>

#include "geodesics_fixtures.h"
#include "vcg_ext/geodesics/compute_pair_geodesics.h"
#include "vcg_ext/geodesics/landmark_search.h"

namespace mgf::test {
namespace {

constexpr std::size_t kPlenty = std::size_t{1} << 30U;  // of windows
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A sphere whose upper half is pushed into the lower one, three times as deep: a cup with a thin
/// wall. Points of equal x and y on the sphere, above and below, are on the two faces of the wall.
TriangleSurface cup(int levels, double roughness) {
  TriangleSurface surface = bumpy_sphere(levels, roughness, 7);
  for (Vec3& p : surface.points) {
    if (p.z() > 0.0) p = (1.0 - 0.1 * p.z()) * Vec3(p.x(), p.y(), -p.z());
    p.z() *= 3.0;
  }
  return surface;
}

/// Every vertex inside the cup with the one outside that is nearest.
std::vector<VertexPair> pairs_across_the_wall(int levels) {
  const TriangleSurface sphere = bumpy_sphere(levels, 0.0, 0);
  std::map<std::pair<double, double>, Index> below;
  for (Index v = 0; v < sphere.points.size(); ++v) {
    const Vec3& p = sphere.points[v];
    if (p.z() < 0.0) below[{p.x(), p.y()}] = v;
  }
  std::vector<VertexPair> pairs;
  for (Index v = 0; v < sphere.points.size(); ++v) {
    const auto it = below.find({sphere.points[v].x(), sphere.points[v].y()});
    if (sphere.points[v].z() > 0.0 && it != below.end()) {
      pairs.push_back({std::min(v, it->second), std::max(v, it->second)});
    }
  }
  return pairs;
}

TriangleSurface two_of(const TriangleSurface& one) {
  TriangleSurface both = one;
  const Index count = to_index(one.points.size());
  for (const Vec3& p : one.points) both.points.emplace_back(p + Vec3(5, 0, 0));
  for (const Triangle& t : one.triangles) {
    both.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
  }
  return both;
}

TEST(Landmarks, MeasureEveryVertex) {
  const HalfedgeMesh mesh = make_halfedge_mesh(cup(3, 0.02));
  const Landmarks landmarks = place_landmarks(mesh, kPlenty, 2);
  ASSERT_EQ(landmarks.distance.size(), 32U);
  std::vector<PropagationTarget> targets;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    targets.push_back({place_of_vertex(mesh, v), kInfinity});
  }
  WindowPropagation plain(mesh, {true, true, false});
  std::set<Index> places;
  for (const std::vector<double>& row : landmarks.distance) {
    const auto place = static_cast<Index>(std::min_element(row.begin(), row.end()) - row.begin());
    EXPECT_EQ(row[place], 0.0);
    EXPECT_TRUE(places.insert(place).second) << "two landmarks at one vertex";
    ASSERT_TRUE(plain.run(place_of_vertex(mesh, place), targets));
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const double exact = v != place ? plain.distance(v) : 0.0;
      EXPECT_NEAR(row[v], exact, 1e-12);
    }
  }
}

TEST(Landmarks, SayNothingOfAnotherShell) {
  const HalfedgeMesh mesh = make_halfedge_mesh(two_of(cup(2, 0.02)));
  const Index half = to_index(mesh.vertex_count() / 2);
  const Landmarks landmarks = place_landmarks(mesh, kPlenty, 1);
  std::size_t on_first = 0;
  for (const std::vector<double>& row : landmarks.distance) {
    const double first = *std::max_element(row.begin(), row.begin() + half);
    const double second = *std::max_element(row.begin() + half, row.end());
    EXPECT_EQ(std::min(first, second), 0.0);
    EXPECT_GT(std::max(first, second), 2.0);
    on_first += first > 0.0 ? 1 : 0;
  }
  EXPECT_GE(on_first, 8U);
  EXPECT_LE(on_first, landmarks.distance.size() - 8);
}

TEST(Landmarks, BoundTheDistanceOfAPointInATriangle) {
  const HalfedgeMesh mesh = make_halfedge_mesh(gridded_box(Vec3(4, 4, 1), 1, 1, 1));
  const Landmarks landmarks = place_landmarks(mesh, kPlenty, 1);
  ASSERT_FALSE(landmarks.distance.empty());
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const Vec3 middle = (mesh.points[mesh.tail(3 * t)] + mesh.points[mesh.tail(3 * t + 1)] +
                         mesh.points[mesh.tail(3 * t + 2)]) /
                        3.0;
    const SurfacePlace place = place_in_triangle(mesh, t, middle);
    for (const std::vector<double>& row : landmarks.distance) {
      const auto at = static_cast<Index>(std::min_element(row.begin(), row.end()) - row.begin());
      WindowPropagation search(mesh);
      ASSERT_TRUE(search.run(place_of_vertex(mesh, at), {{place, kInfinity}}));
      const DistanceRange range = distance_of_place(mesh, row, place);
      EXPECT_LE(range.least, search.distance(0) + 1e-12);
      EXPECT_GE(range.most, search.distance(0) - 1e-12);
      EXPECT_LE(range.most - range.least, 2.0 * 4.0 * std::sqrt(2.0));
    }
  }
}

TEST(Landmarks, AreNotPlacedWhereTheyTakeTooLongOrATriangleIsThin) {
  TriangleSurface surface = cup(2, 0.02);
  EXPECT_TRUE(place_landmarks(make_halfedge_mesh(surface), 1000, 1).distance.empty());
  const Triangle& t = surface.triangles[0];
  surface.points[t[0]] = surface.points[t[1]] * (1.0 - 1e-9) + surface.points[t[2]] * 1e-9;
  EXPECT_TRUE(place_landmarks(make_halfedge_mesh(surface), kPlenty, 1).distance.empty());
}

TEST(Landmarks, CutTheWayRoundARim) {
  const HalfedgeMesh mesh = make_halfedge_mesh(cup(5, 0.0));
  const Landmarks landmarks = place_landmarks(mesh, kPlenty, 2);
  WindowPropagation plain(mesh);
  WindowPropagation with(mesh, {}, &landmarks);
  std::size_t plain_windows = 0;
  std::size_t windows = 0;
  const std::vector<VertexPair> pairs = pairs_across_the_wall(5);
  // Not from the pole, the first of them: from there, all ways are equally long.
  for (std::size_t i = 100; i < pairs.size(); i += 100) {
    const SurfacePlace from = place_of_vertex(mesh, pairs[i].a);
    PropagationTarget target{place_of_vertex(mesh, pairs[i].b), kInfinity};
    ASSERT_TRUE(plain.run(from, {target}));
    target.known = target.limit = plain.distance(0);  // the tightest bound
    ASSERT_TRUE(plain.run(from, {target}));
    ASSERT_TRUE(with.run(from, {target}));
    EXPECT_NEAR(with.distance(0), plain.distance(0), 1e-12);
    plain_windows += plain.window_count();
    windows += with.window_count();
  }
  EXPECT_LT(10 * windows, plain_windows);
}

TEST(Landmarks, ChangeNoLength) {
  const TriangleSurface rough = cup(3, 0.02);
  const TriangleSurface flat = midpoint_subdivided(midpoint_subdivided(cup(2, 0.02)));
  for (const TriangleSurface& surface : {rough, flat, two_of(cup(2, 0.02))}) {
    const HalfedgeMesh mesh = make_halfedge_mesh(surface);
    const std::vector<VertexPair> pairs = random_pairs(surface, 1500, 5);
    PairPaths with(pairs.size());
    const std::vector<std::array<Index, 3>> no_links;
    CoherentPaths(mesh, pairs, no_links, ShorteningEffort::kFull, 1, with).run({});
    PairPaths without = with;
    PathCertificate plain(mesh, SearchSurface(surface, mesh), pairs, 1, {}, without);
    plain.run(1, {});
    PathCertificate bounded(mesh, SearchSurface(surface, mesh), pairs, 2, {}, with);
    EXPECT_GT(bounded.use_landmarks(kPlenty, {}), 0U);
    bounded.run(1, {});
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      EXPECT_EQ(with.certification[i], without.certification[i]);
      if (with.length[i] < kInfinity) {
        EXPECT_NEAR(with.length[i], without.length[i], 1e-11 * with.length[i]);
      }
    }
  }
}

TEST(Landmarks, AreUsedWhereTheyPay) {
  const auto landmarks_of = [](const TriangleSurface& surface,
                               const std::vector<VertexPair>& pairs) {
    const HalfedgeMesh mesh = make_halfedge_mesh(surface);
    PairPaths paths(pairs.size());
    const std::vector<std::array<Index, 3>> no_links;
    CoherentPaths(mesh, pairs, no_links, ShorteningEffort::kRough, 1, paths).run({});
    PathCertificate certificate(mesh, SearchSurface(surface, mesh), pairs, 1, {}, paths);
    EXPECT_EQ(certificate.use_landmarks({}), 0U) << "before any search";
    certificate.run(32, {});
    return certificate.use_landmarks({});
  };
  EXPECT_GE(landmarks_of(cup(5, 0.0), pairs_across_the_wall(5)), 8U);
  const TriangleSurface ball = bumpy_sphere(4, 0.05, 2);
  EXPECT_EQ(landmarks_of(ball, near_pairs(ball, 6.0, 1000, 4)), 0U);
}

TEST(Landmarks, AndThreadsChangeNoBit) {
  const TriangleSurface surface = cup(5, 0.0);
  const std::vector<VertexPair> pairs = pairs_across_the_wall(5);
  const PairGeodesics one = compute_pair_geodesics(surface, pairs, {}, {Certification::kProven, 1});
  const PairGeodesics two = compute_pair_geodesics(surface, pairs, {}, {Certification::kProven, 2});
  EXPECT_EQ(one.length, two.length);
  EXPECT_EQ(one.tangent_a, two.tangent_a);
  EXPECT_EQ(one.tangent_b, two.tangent_b);
  EXPECT_EQ(one.certification, two.certification);
  EXPECT_EQ(one.corridor.items, two.corridor.items);
}

TEST(PathPieces, AddUpToTheLength) {
  const HalfedgeMesh mesh = make_halfedge_mesh(bumpy_sphere(3, 0.2, 3));
  std::vector<PropagationTarget> targets;
  for (Index v = 1; v < mesh.vertex_count(); v += 3) {
    targets.push_back({place_of_vertex(mesh, v), kInfinity});
  }
  const Vec3 middle =
      (mesh.points[mesh.tail(0)] + mesh.points[mesh.tail(1)] + mesh.points[mesh.tail(2)]) / 3.0;
  targets.push_back({place_in_triangle(mesh, 0, middle), kInfinity});
  const SurfacePlace start = place_of_vertex(mesh, 200);
  WindowPropagation search(mesh);
  ASSERT_TRUE(search.run(start, targets));
  for (std::size_t i = 0; i < targets.size(); ++i) {
    double length = 0.0;
    Vec3 at = start.position;
    for (const PathPiece& piece : search.pieces(i)) {
      ASSERT_EQ(piece.points.size(), piece.crossed.size());
      for (const Vec3& p : piece.points) {
        length += (p - at).norm();
        at = p;
      }
      const Vec3& to = piece.to != kNone ? mesh.points[piece.to] : targets[i].place.position;
      length += (to - at).norm();
      at = to;
    }
    EXPECT_NEAR(length, search.distance(i), 1e-9 * length);
  }
}

}  // namespace
}  // namespace mgf::test
