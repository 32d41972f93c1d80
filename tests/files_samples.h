// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the file writers write: small results made by hand, and a folder to put them
// in.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "graph_fixtures.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/medial_complex.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/surface/geodesic_circles.h"
#include "vcg_ext/surface/segmentation.h"
#include "vcg_ext/surface/surface_map.h"

namespace mgf::test {

/// A folder for one test, removed with all it holds.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::temp_directory_path() /
            (std::string("mgf-") + test.test_suite_name() + "-" + test.name() + "-" +
             std::to_string(::getpid()));
    std::filesystem::create_directories(path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  TemporaryFolder(TemporaryFolder&&) = delete;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  /// Names of the files in it, hidden ones too.
  std::size_t file_count() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_),
                                                  std::filesystem::directory_iterator()));
  }

 private:
  std::filesystem::path path_;
};

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// A ring of four edges with a tail of two at node 0, and a node apart from all; every measure of
/// every edge another number. The ring is narrowest at the edge between nodes 1 and 2.
inline CurveSkeleton ring_with_tail() {
  CurveSkeleton skeleton = tube_skeleton(
      {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {2, 0, 0}, {3, 0.1, 0}, {9, 9, 9}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {4, 5}}, 0.25);
  for (std::size_t e = 0; e < skeleton.edge_count(); ++e) {
    const double number = static_cast<double>(e);
    skeleton.mgf[e] = 0.1 + number;
    skeleton.girth[e] = e == 1 ? 0.5 : 1.0 + number / 8.0;
    skeleton.circumference[e] = 2.0 + number / 3.0;
    skeleton.eccentricity[e] = skeleton.girth[e] / skeleton.circumference[e];
    skeleton.theta_birth[e] = e < 4 ? kAlwaysThere : -0.9 + number / 10.0;
  }
  return skeleton;
}

/// A square facet and a triangle that share an edge.
inline MedialComplex two_facets() {
  MedialComplex complex;
  complex.position = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0.5, 1.0 / 3.0}};
  complex.radius = {1.0, 0.5, 0.25, 0.125, 1.0 / 3.0};
  complex.facet_contacts = {{0, 3}, {2, 5}};
  for (const Index v : {0U, 1U, 2U, 3U}) complex.facet_vertices.items.push_back(v);
  complex.facet_vertices.close_row();
  for (const Index v : {1U, 4U, 2U}) complex.facet_vertices.items.push_back(v);
  complex.facet_vertices.close_row();
  return complex;
}

inline TriangleSurface tetrahedron_surface() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

inline Segmentation tetrahedron_segmentation() {
  return {{1, 0, 0, 1}, {1.0, 1.5, 2.0, 1.25}, {1.0, 0.5, 0.75, 1.0}, 0.5, 0};
}

/// The faces of the tetrahedron on branches 0, 1, 0 and none.
inline SkeletonCorrespondence tetrahedron_parts() {
  return {{0, 1, 0, kNone},
          {0, 4, 1, kNone},
          {0.5, 0.25, 1.5, 0.0},
          {0.1, 0.2, 0.3, 0.0},
          {6.0, 5.0, 6.0, 0.0}};
}

/// A triangle, a square, and a circle shrunk to a point.
inline GeodesicCircles three_circles() {
  GeodesicCircles circles;
  const std::vector<std::vector<Vec3>> curves = {
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}},
      {{0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}, {0, 0, 2}},
      {{5, 5, 5}, {5, 5, 5}}};
  for (const std::vector<Vec3>& curve : curves) {
    for (const Vec3& point : curve) circles.polyline.items.push_back(point);
    circles.polyline.close_row();
    circles.faces.close_row();
  }
  circles.eccentricity = {1.0, 1.4, 0.0};
  return circles;
}

}  // namespace mgf::test
