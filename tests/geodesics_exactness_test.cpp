// SPDX-License-Identifier: GPL-3.0-or-later
// Pair geodesics against closed forms and against themselves.
#include <gtest/gtest.h>

#include "geodesics_fixtures.h"
#include "vcg_ext/geodesics/compute_pair_geodesics.h"
#include "vcg_ext/geodesics/surface_path.h"

namespace mgf::test {
namespace {

PairGeodesics solve(const TriangleSurface& surface, const std::vector<VertexPair>& pairs,
                    unsigned threads = 1) {
  return compute_pair_geodesics(surface, pairs, {}, {Certification::kProven, threads});
}

Index vertex_at(const TriangleSurface& surface, const Vec3& p) {
  for (Index v = 0; v < surface.points.size(); ++v) {
    if ((surface.points[v] - p).norm() < 1e-9) return v;
  }
  return kNone;
}

double distance(const TriangleSurface& surface, const Vec3& p, const Vec3& q) {
  const Index a = vertex_at(surface, p);
  const Index b = vertex_at(surface, q);
  const PairGeodesics result = solve(surface, {{std::min(a, b), std::max(a, b)}});
  EXPECT_EQ(result.certification[0], Certification::kProven);
  return result.length[0];
}

TEST(GeodesicsExactness, OppositeCornersOfBoxesUnfold) {
  // The shortest of the three unfoldings over two faces.
  for (const Vec3& size : {Vec3(1, 1, 1), Vec3(3, 2, 1), Vec3(5, 1, 0.5), Vec3(1, 1, 8)}) {
    const double a = size.x(), b = size.y(), c = size.z();
    const double expected =
        std::min({std::hypot(a + b, c), std::hypot(a + c, b), std::hypot(b + c, a)});
    for (const int cells : {1, 2, 3, 7}) {
      const TriangleSurface box = gridded_box(size, cells, cells + 1, cells);
      EXPECT_NEAR(distance(box, Vec3::Zero(), size), expected, 1e-12 * expected) << cells;
    }
  }
}

TEST(GeodesicsExactness, TheFarthestPointFromABoxCornerLiesInsideTheFace) {
  // Kotani's box 1 x 1 x 2: the point a quarter in from the opposite corner is farther away.
  const TriangleSurface box = gridded_box(Vec3(1, 1, 2), 4, 4, 8);
  EXPECT_NEAR(distance(box, Vec3::Zero(), Vec3(1, 1, 2)), std::sqrt(8.0), 1e-12);
  EXPECT_NEAR(distance(box, Vec3::Zero(), Vec3(0.75, 0.75, 2)), std::sqrt(8.125), 1e-12);
}

TEST(GeodesicsExactness, PathsAcrossASubdividedPlateAreStraight) {
  const TriangleSurface plate = gridded_box(Vec3(6, 4, 0.5), 12, 8, 1);
  std::vector<VertexPair> pairs;
  for (const VertexPair& pair : random_pairs(plate, 4000, 3)) {
    if (plate.points[pair.a].z() == 0.0 && plate.points[pair.b].z() == 0.0) pairs.push_back(pair);
  }
  const PairGeodesics result = solve(plate, pairs);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Vec3 straight = plate.points[pairs[i].b] - plate.points[pairs[i].a];
    EXPECT_NEAR(result.length[i], straight.norm(), 1e-12 * straight.norm());
    EXPECT_LT((result.tangent_a[i] - straight.normalized()).norm(), 1e-7);
    EXPECT_LT((result.tangent_b[i] + straight.normalized()).norm(), 1e-7);
  }
}

TEST(GeodesicsExactness, ThePrismUnrolls) {
  const int n = 48;
  const double radius = 1.0, height = 6.0;
  const TriangleSurface tube = prism(radius, height, n, 12);
  const double side = 2.0 * radius * std::sin(kPi / n);
  for (const int turn : {1, 5, 12, 20, 24}) {
    for (const int rise : {0, 1, 4}) {
      const double angle = 2.0 * kPi * turn / n;
      const Vec3 from(radius, 0, 0.5 * height);
      const Vec3 to(radius * std::cos(angle), radius * std::sin(angle),
                    (0.5 + rise / 12.0) * height);
      const double expected = std::hypot(turn * side, rise / 12.0 * height);
      EXPECT_NEAR(distance(tube, from, to), expected, 1e-12 * expected) << turn << " " << rise;
    }
  }
}

TEST(GeodesicsExactness, SphereDistancesConverge) {
  double error = 1.0;
  for (const int levels : {3, 4, 5}) {
    const TriangleSurface sphere = bumpy_sphere(levels, 0.0, 0);
    const double found = distance(sphere, Vec3(1, 0, 0), Vec3(0, 1, 0));
    EXPECT_LT(std::abs(found - kPi / 2), 0.3 * error);
    error = std::abs(found - kPi / 2);
  }
  EXPECT_LT(error, 1e-3);
}

TEST(GeodesicsExactness, TetrahedronOppositeEdges) {
  // Unit regular tetrahedron split at midpoints: opposite midpoints are 1 apart over the surface.
  TriangleSurface simplex;
  simplex.points = {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)};
  for (Vec3& p : simplex.points) p /= std::sqrt(8.0);
  simplex.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  const TriangleSurface fine = midpoint_subdivided(midpoint_subdivided(simplex));
  const Vec3 p = (simplex.points[0] + simplex.points[1]) / 2.0;
  const Vec3 q = (simplex.points[2] + simplex.points[3]) / 2.0;
  EXPECT_NEAR(distance(fine, p, q), 1.0, 1e-12);
}

TEST(GeodesicsExactness, PathsBendAtASaddle) {
  // An L-shaped slab: the straight way between its arms leads over the notch, so the path bends at
  // the notch's corner, where the faces span 270 + 90 + 90 degrees.
  const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  SurfaceBuilder builder;
  for (const Vec3& cell : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
    builder.grid(cell, y, x, 2, 2);
    builder.grid(cell + z, x, y, 2, 2);
  }
  builder.grid(Vec3::Zero(), x * 2, z, 4, 2);
  builder.grid(Vec3::Zero(), z, y * 2, 2, 4);
  builder.grid(x * 2, y, z, 2, 2);
  builder.grid(y * 2, z, x, 2, 2);
  builder.grid(x + y, z, x, 2, 2);
  builder.grid(x + y, y, z, 2, 2);
  const double expected = 2.0 * std::hypot(1.0, 0.5);
  EXPECT_NEAR(distance(builder.surface(), Vec3(2, 0.5, 1), Vec3(0.5, 2, 1)), expected, 1e-12);
}

TEST(GeodesicsExactness, PruningChangesNothing) {
  const TriangleSurface rough = bumpy_sphere(3, 0.25, 5);
  const HalfedgeMesh mesh = make_halfedge_mesh(rough);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Index start : {0U, 17U, 100U, 200U}) {
    std::vector<PropagationTarget> targets;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      if (v != start) targets.push_back({place_of_vertex(mesh, v), infinity});
    }
    WindowPropagation plain(mesh, {true, false, false});
    ASSERT_TRUE(plain.run(place_of_vertex(mesh, start), targets));
    for (const PropagationPruning& pruning :
         {PropagationPruning{true, true, false}, PropagationPruning{true, true, true},
          PropagationPruning{true, false, true}}) {
      WindowPropagation pruned(mesh, pruning);
      ASSERT_TRUE(pruned.run(place_of_vertex(mesh, start), targets));
      for (std::size_t i = 0; i < targets.size(); ++i) {
        EXPECT_NEAR(pruned.distance(i), plain.distance(i), 1e-12 * plain.distance(i));
      }
    }
  }
}

TEST(GeodesicsExactness, VertexFiltersChangeNothing) {
  // Without the filters windows multiply, so this surface is tiny.
  const TriangleSurface rough = bumpy_sphere(2, 0.25, 9);
  const HalfedgeMesh mesh = make_halfedge_mesh(rough);
  for (Index start = 0; start < mesh.vertex_count(); start += 7) {
    std::vector<PropagationTarget> targets;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      if (v != start) targets.push_back({place_of_vertex(mesh, v), 4.0});
    }
    WindowPropagation plain(mesh, {false, true, true});
    WindowPropagation filtered(mesh, {});
    ASSERT_TRUE(plain.run(place_of_vertex(mesh, start), targets));
    ASSERT_TRUE(filtered.run(place_of_vertex(mesh, start), targets));
    for (std::size_t i = 0; i < targets.size(); ++i) {
      EXPECT_NEAR(filtered.distance(i), plain.distance(i), 1e-12 * plain.distance(i));
    }
  }
}

TEST(GeodesicsExactness, NumbersOfVerticesChangeNothing) {
  // Numbered from the other end, each pair runs the other way and so do its tangents.
  const TriangleSurface rough = bumpy_sphere(3, 0.2, 4);
  const Index last = to_index(rough.points.size()) - 1;
  TriangleSurface turned = rough;
  std::reverse(turned.points.begin(), turned.points.end());
  for (Triangle& t : turned.triangles) {
    for (Index& v : t) v = last - v;
  }
  const std::vector<VertexPair> pairs = random_pairs(rough, 200, 3);
  std::vector<VertexPair> turned_pairs;
  for (const auto& [a, b] : pairs) turned_pairs.push_back({last - b, last - a});
  const PairGeodesics one = compute_pair_geodesics(rough, pairs, {}, {});
  const PairGeodesics other = compute_pair_geodesics(turned, turned_pairs, {}, {});
  EXPECT_EQ(one.length, other.length);
  EXPECT_EQ(one.tangent_a, other.tangent_b);
  EXPECT_EQ(one.tangent_b, other.tangent_a);
}

TEST(GeodesicsExactness, TheTightestBoundStillFindsTheTarget) {
  // One target at a time, bounded by its own distance: nothing on the way may be dropped.
  const TriangleSurface rough = bumpy_sphere(3, 0.25, 11);
  const HalfedgeMesh mesh = make_halfedge_mesh(rough);
  std::vector<PropagationTarget> targets;
  for (Index v = 1; v < mesh.vertex_count(); ++v) {
    targets.push_back({place_of_vertex(mesh, v), std::numeric_limits<double>::infinity()});
  }
  WindowPropagation plain(mesh, {true, false, false});
  ASSERT_TRUE(plain.run(place_of_vertex(mesh, 0), targets));
  WindowPropagation pruned(mesh);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    PropagationTarget target = targets[i];
    target.known = target.limit = plain.distance(i);
    ASSERT_TRUE(pruned.run(place_of_vertex(mesh, 0), {target}));
    EXPECT_NEAR(pruned.distance(0), plain.distance(i), 1e-12 * plain.distance(i));
  }
}

TEST(GeodesicsExactness, SkippingFlatVerticesChangesNothing) {
  const TriangleSurface fine = midpoint_subdivided(midpoint_subdivided(bumpy_sphere(1, 0.4, 3)));
  const HalfedgeMesh mesh = make_halfedge_mesh(fine);
  EXPECT_LT(without_flat_vertices(fine).surface.points.size(), fine.points.size() / 8);
  const std::vector<VertexPair> pairs = random_pairs(fine, 3000, 6);
  PairPaths with(pairs.size());
  const std::vector<std::array<Index, 3>> no_links;
  CoherentPaths(mesh, pairs, no_links, ShorteningEffort::kFull, 1, with).run({});
  PairPaths without = with;
  PathCertificate(mesh, SearchSurface(fine, mesh), pairs, 1, {}, with).run(1, {});
  PathCertificate(mesh, SearchSurface(fine, mesh, false), pairs, 1, {}, without).run(1, {});
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(with.certification[i], Certification::kProven);
    EXPECT_EQ(without.certification[i], Certification::kProven);
    EXPECT_NEAR(with.length[i], without.length[i], 1e-11 * with.length[i]);
  }
}

TEST(GeodesicsExactness, TangentsAreThoseOfThePathInTheCorridor) {
  // On the second one, paths are searched for without flat vertices, and found again.
  for (const TriangleSurface& surface :
       {bumpy_sphere(3, 0.3, 5),
        midpoint_subdivided(midpoint_subdivided(bumpy_sphere(1, 0.4, 3)))}) {
    const HalfedgeMesh mesh = make_halfedge_mesh(surface);
    const std::vector<VertexPair> pairs = random_pairs(surface, 500, 9);
    const PairGeodesics found = solve(surface, pairs);
    Funnel funnel(mesh);
    for (Index i = 0; i < pairs.size(); ++i) {
      const auto [a, b] = pairs[i];
      const std::vector<Index> corridor(found.corridor[i].begin(), found.corridor[i].end());
      EXPECT_NEAR(funnel.straighten(a, b, corridor), found.length[i], 1e-11 * found.length[i]);
      EXPECT_LT((funnel.tangent_at_start(a, b, corridor) - found.tangent_a[i]).norm(), 1e-9);
      EXPECT_LT((funnel.tangent_at_end(a, b, corridor) - found.tangent_b[i]).norm(), 1e-9);
    }
  }
}

TEST(GeodesicsExactness, FlatVerticesGoFromPlanesAndCreasesOnly) {
  const TriangleSurface box = gridded_box(Vec3(2, 3, 4), 4, 6, 8);
  const CoarseSurface coarse = without_flat_vertices(box);
  EXPECT_EQ(coarse.surface.points.size(), 8U);
  EXPECT_EQ(coarse.surface.triangles.size(), 12U);
  const TriangleSurface round = bumpy_sphere(3, 0.1, 1);
  EXPECT_EQ(without_flat_vertices(round).surface.points.size(), round.points.size());
}

TEST(GeodesicsExactness, LinksChangeNoLength) {
  const TriangleSurface rough = bumpy_sphere(3, 0.2, 8);
  const HalfedgeMesh mesh = make_halfedge_mesh(rough);
  // All pairs of the first vertices, and all triangles between them.
  std::vector<VertexPair> pairs;
  std::map<std::pair<Index, Index>, Index> id;
  for (Index a = 0; a < 40; ++a) {
    for (Index b = a + 1; b < 40; ++b) {
      id[{a, b}] = to_index(pairs.size());
      pairs.push_back({a, b});
    }
  }
  std::vector<std::array<Index, 3>> links;
  for (Index u = 0; u < 40; ++u) {
    for (Index v = u + 1; v < 40; ++v) {
      for (Index w = v + 1; w < 40; w += 3) links.push_back({id[{u, v}], id[{v, w}], id[{u, w}]});
    }
  }
  const PairGeodesics linked = compute_pair_geodesics(rough, pairs, links, {});
  const PairGeodesics plain = solve(rough, pairs);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_NEAR(linked.length[i], plain.length[i], 1e-11 * plain.length[i]);
  }
}

TEST(GeodesicsExactness, DrawnPathsHaveTheLengthAndLieInTheirFaces) {
  for (const TriangleSurface& surface :
       {bumpy_sphere(3, 0.3, 4), gridded_box(Vec3(3, 2, 1), 6, 4, 2)}) {
    const HalfedgeMesh mesh = make_halfedge_mesh(surface);
    const std::vector<VertexPair> pairs = random_pairs(surface, 400, 12);
    const PairGeodesics result = solve(surface, pairs);
    for (Index i = 0; i < pairs.size(); ++i) {
      const SurfacePath path = path_of_pair(mesh, pairs, result, i);
      ASSERT_EQ(path.points.size(), path.faces.size() + 1);
      double length = 0.0;
      for (std::size_t k = 0; k < path.faces.size(); ++k) {
        length += (path.points[k + 1] - path.points[k]).norm();
        const Triangle& t = surface.triangles[path.faces[k]];
        const Vec3& corner = surface.points[t[0]];
        const Vec3 u = surface.points[t[1]] - corner;
        const Vec3 v = surface.points[t[2]] - corner;
        for (const Vec3& p : {path.points[k], path.points[k + 1]}) {
          const Vec3 n = u.cross(v);
          const double at_u = (p - corner).cross(v).dot(n) / n.squaredNorm();
          const double at_v = u.cross(p - corner).dot(n) / n.squaredNorm();
          EXPECT_NEAR(n.normalized().dot(p - corner), 0.0, 1e-9);
          EXPECT_GT(std::min({at_u, at_v, 1.0 - at_u - at_v}), -1e-9);
        }
      }
      EXPECT_NEAR(length, result.length[i], 1e-10);
      EXPECT_LT((path.points.front() - surface.points[pairs[i].a]).norm(), 1e-12);
      EXPECT_LT((path.points.back() - surface.points[pairs[i].b]).norm(), 1e-12);
    }
  }
}

TEST(GeodesicsExactness, TrianglesTooThinForProofAreSaidToBe) {
  TriangleSurface rough = bumpy_sphere(2, 0.2, 1);
  const Triangle t = rough.triangles.front();
  rough.points[t[0]] = rough.points[t[1]] + 1e-9 * (rough.points[t[0]] - rough.points[t[1]]);
  const PairGeodesics result = solve(rough, random_pairs(rough, 500, 3));
  EXPECT_GT(std::count(result.certification.begin(), result.certification.end(),
                       Certification::kPractical),
            0);
}

// Splits every so-maniest edge at a point that is that of one of its ends.
TriangleSurface with_doubled_vertices(TriangleSurface surface, Index every) {
  const HalfedgeMesh mesh = make_halfedge_mesh(surface);
  for (Index h = 0; h < mesh.halfedges.size(); h += every) {
    const Triangle& left = surface.triangles[triangle_of(h)];
    const Triangle& right = surface.triangles[triangle_of(mesh.opposite(h))];
    const Index a = mesh.tail(h), b = mesh.head(h);
    const Index c = mesh.apex(h), d = mesh.apex(mesh.opposite(h));
    if (left != Triangle{a, b, c} && left != Triangle{b, c, a} && left != Triangle{c, a, b})
      continue;  // split already, as is the next
    if (right != Triangle{b, a, d} && right != Triangle{a, d, b} && right != Triangle{d, b, a})
      continue;
    const Index twin = to_index(surface.points.size());
    surface.points.push_back(Vec3(surface.points[a]));
    surface.triangles[triangle_of(h)] = {a, twin, c};
    surface.triangles[triangle_of(mesh.opposite(h))] = {d, twin, a};
    surface.triangles.push_back({twin, b, c});
    surface.triangles.push_back({d, b, twin});
  }
  return surface;
}

TEST(GeodesicsExactness, VerticesOfOnePlaceChangeNoLength) {
  // As points on a surface that crosses itself come out, once rounded.
  const TriangleSurface rough = bumpy_sphere(3, 0.1, 5);
  const TriangleSurface doubled = with_doubled_vertices(rough, 7);
  ASSERT_GT(doubled.points.size(), rough.points.size() + 60);
  std::vector<VertexPair> pairs;
  std::vector<VertexPair> same;  // on the surface as it was
  std::vector<VertexPair> asked = random_pairs(doubled, 1000, 3);
  for (Index twin = to_index(rough.points.size()); twin < doubled.points.size(); ++twin) {
    const Index original = vertex_at(rough, doubled.points[twin]);
    for (const Index other : {5U, 50U, 100U}) {  // both are searched for at a time
      if (other == original) continue;
      asked.push_back({std::min(other, original), std::max(other, original)});
      asked.push_back({other, twin});
    }
  }
  for (const VertexPair& pair : asked) {
    const Index a = vertex_at(rough, doubled.points[pair.a]);
    const Index b = vertex_at(rough, doubled.points[pair.b]);
    if (a == b) continue;
    pairs.push_back(pair);
    same.push_back({std::min(a, b), std::max(a, b)});
  }
  const PairGeodesics result = solve(doubled, pairs);
  const PairGeodesics paths =
      compute_pair_geodesics(doubled, pairs, {}, {Certification::kUnproven});
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    // One by one, as a pair of places may come twice.
    const PairGeodesics expected = solve(rough, {same[i]});
    EXPECT_NEAR(result.length[i], expected.length[0], 1e-9);
    EXPECT_GE(result.certification[i], Certification::kPractical);
    EXPECT_GE(paths.length[i], expected.length[0] - 1e-9);
  }
}

TEST(GeodesicsExactness, LengthsWithinEpsilonAreSo) {
  const TriangleSurface rough = bumpy_sphere(4, 0.2, 8);
  const std::vector<VertexPair> pairs = near_pairs(rough, 12.0, 2000, 7);
  const PairGeodesics exact = compute_pair_geodesics(rough, pairs, {}, {});
  GeodesicOptions options;
  options.wanted = Certification::kWithin;
  options.epsilon = 0.05;
  const PairGeodesics close = compute_pair_geodesics(rough, pairs, {}, options);
  Index within = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    ASSERT_EQ(exact.certification[i], Certification::kProven);
    EXPECT_GE(close.length[i], exact.length[i] * (1.0 - 1e-10));
    ASSERT_NE(close.certification[i], Certification::kUnproven);
    within += close.certification[i] == Certification::kWithin ? 1 : 0;
    const double allowed = close.certification[i] == Certification::kWithin ? 0.05 : 1e-10;
    EXPECT_LE(close.length[i], exact.length[i] * (1.0 + allowed));
  }
  EXPECT_GT(within, 1000);
}

TEST(GeodesicsExactness, ASearchWithALimitFindsAllThatIsShorter) {
  // A false limit for one target must not hide the others from the search.
  const TriangleSurface rough = bumpy_sphere(3, 0.25, 11);
  const HalfedgeMesh mesh = make_halfedge_mesh(rough);
  std::vector<PropagationTarget> targets;
  for (Index v = 1; v < mesh.vertex_count(); ++v) targets.push_back({place_of_vertex(mesh, v)});
  WindowPropagation search(mesh);
  ASSERT_TRUE(search.run(place_of_vertex(mesh, 0), targets));
  std::vector<double> exact;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    exact.push_back(search.distance(i));
    targets[i].known = exact[i];
    targets[i].limit = i % 2 == 0 ? 0.5 * exact[i] : exact[i];
  }
  ASSERT_TRUE(search.run(place_of_vertex(mesh, 0), targets));
  for (std::size_t i = 1; i < targets.size(); i += 2) {
    EXPECT_NEAR(search.distance(i), exact[i], 1e-12 * exact[i]);
  }
}

TEST(GeodesicsExactness, ThreadsChangeNoBit) {
  const TriangleSurface rough = bumpy_sphere(4, 0.1, 2);
  const std::vector<VertexPair> pairs = near_pairs(rough, 6.0, 2000, 4);
  const PairGeodesics one = solve(rough, pairs, 1);
  const PairGeodesics two = solve(rough, pairs, 2);
  EXPECT_EQ(one.length, two.length);
  EXPECT_EQ(one.tangent_a, two.tangent_a);
  EXPECT_EQ(one.tangent_b, two.tangent_b);
  EXPECT_EQ(one.corridor.items, two.corridor.items);
  EXPECT_EQ(one.certification, two.certification);
}

TEST(GeodesicsExactness, TangentsAreTheGradientOfTheDistance) {
  // The tangent leaving a is minus the derivative of the length as a moves on the surface: with b
  // fixed, compare neighbours c of a on the straight line through a in a smooth region.
  const TriangleSurface box = gridded_box(Vec3(3, 2, 1), 30, 20, 10);
  const double step = 0.1;
  const Index from = vertex_at(box, Vec3(1.5, 1.0, 0.0));
  const Index ahead = vertex_at(box, Vec3(1.5 + step, 1.0, 0.0));
  const Index behind = vertex_at(box, Vec3(1.5 - step, 1.0, 0.0));
  const Index to = vertex_at(box, Vec3(3.0, 1.2, 0.7));
  std::vector<VertexPair> pairs;
  for (const Index v : {from, ahead, behind}) pairs.push_back({std::min(v, to), std::max(v, to)});
  const PairGeodesics result = solve(box, pairs);
  const double slope = (result.length[1] - result.length[2]) / (2.0 * step);
  const Vec3& tangent = pairs[0].a == from ? result.tangent_a[0] : result.tangent_b[0];
  EXPECT_NEAR(-tangent.x(), slope, 1e-3);
  EXPECT_NEAR(tangent.norm(), 1.0, 1e-12);
}

TEST(GeodesicsExactness, ShellsApartAreInfinitelyFar) {
  TriangleSurface two = gridded_box(Vec3(1, 1, 1), 1, 1, 1);
  const Index offset = to_index(two.points.size());
  const TriangleSurface other = two;
  for (const Vec3& p : other.points) two.points.emplace_back(p + Vec3(5, 0, 0));
  for (const Triangle& t : other.triangles) {
    two.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  const PairGeodesics result = solve(two, {{0, 1}, {0, offset}});
  EXPECT_TRUE(std::isfinite(result.length[0]));
  EXPECT_TRUE(std::isinf(result.length[1]));
  EXPECT_EQ(result.certification[1], Certification::kUnproven);
}

TEST(GeodesicsExactness, OpenSurfacesAreRefused) {
  TriangleSurface open = gridded_box(Vec3(1, 1, 1), 1, 1, 1);
  open.triangles.pop_back();
  EXPECT_THROW(solve(open, {{0, 1}}), InputError);
}

TEST(GeodesicsExactness, NeedlesKeepDistances) {
  // A cylinder whose facets are a thousand times longer than wide.
  const int n = 600;
  const TriangleSurface tube = prism(1.0, 10.0, n, 1);
  const double side = 2.0 * std::sin(kPi / n);
  const double expected = std::hypot(10.0, side * n / 4);
  EXPECT_NEAR(distance(tube, Vec3(1, 0, 0), Vec3(0, 1, 10)), expected, 1e-10);
}

}  // namespace
}  // namespace mgf::test
