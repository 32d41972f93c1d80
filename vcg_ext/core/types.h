// SPDX-License-Identifier: GPL-3.0-or-later
// The plain data that every stage speaks: indices, points, a triangle surface, compressed rows.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>  // cross products
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace mgf {

/// Position in an array. 32 bits serve meshes of up to four thousand million elements.
using Index = std::uint32_t;

/// The index of nothing: across the boundary, not computed, not there.
inline constexpr Index kNone = std::numeric_limits<Index>::max();

/// A point or a vector, in mesh units.
using Vec3 = Eigen::Vector3d;

/// Corner numbers of a triangle, anticlockwise seen from outside.
using Triangle = std::array<Index, 3>;

/// Corner numbers of a tetrahedron, positively oriented: det(p1-p0, p2-p0, p3-p0) > 0.
using Tetrahedron = std::array<Index, 4>;

/// A size as an Index. Requires `size` to fit, which the input diagnosis has made sure of.
inline Index to_index(std::size_t size) {
  return static_cast<Index>(size);
}

/// A triangle mesh as two arrays; what it must satisfy is said where it is taken.
struct TriangleSurface {
  std::vector<Vec3> points;         ///< one per vertex
  std::vector<Triangle> triangles;  ///< one per face
};

/// Length of the diagonal of the axis-parallel bounding box of `points`; 0 for none.
inline double bounding_box_diagonal(const std::vector<Vec3>& points) {
  if (points.empty()) return 0.0;
  Vec3 low = points.front();
  Vec3 high = points.front();
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

/// A read-only view of one row of `Rows`.
template <class T>
class Row {
 public:
  Row(const T* first, const T* last) : first_(first), last_(last) {}
  const T* begin() const { return first_; }
  const T* end() const { return last_; }
  std::size_t size() const { return static_cast<std::size_t>(last_ - first_); }
  bool empty() const { return first_ == last_; }
  const T& operator[](std::size_t i) const { return first_[i]; }
  const T& front() const { return *first_; }
  const T& back() const { return *(last_ - 1); }

 private:
  const T* first_;
  const T* last_;
};

/// Rows of different lengths in one array (compressed rows).
template <class T>
struct Rows {
  std::vector<Index> begin{0};  ///< row i is items[begin[i]] .. items[begin[i + 1] - 1]
  std::vector<T> items;

  std::size_t size() const { return begin.size() - 1; }
  Row<T> operator[](std::size_t i) const {
    return {items.data() + begin[i], items.data() + begin[i + 1]};
  }
  /// Ends the row under construction; items pushed from now on belong to the next one.
  void close_row() { begin.push_back(to_index(items.size())); }
};

/// Groups 0 .. keys.size()-1 by key: row k lists, ascending, the i with keys[i] == k.
/// Entries with key kNone are left out. Linear time.
inline Rows<Index> group_by_key(const std::vector<Index>& keys, std::size_t key_count) {
  Rows<Index> rows;
  rows.begin.assign(key_count + 1, 0);
  for (const Index key : keys) {
    if (key != kNone) ++rows.begin[key + 1];
  }
  for (std::size_t k = 0; k < key_count; ++k) rows.begin[k + 1] += rows.begin[k];
  rows.items.resize(rows.begin[key_count]);
  std::vector<Index> next(rows.begin.begin(), rows.begin.end() - 1);
  for (Index i = 0; i < keys.size(); ++i) {
    if (keys[i] != kNone) rows.items[next[keys[i]]++] = i;
  }
  return rows;
}

}  // namespace mgf
