// SPDX-License-Identifier: GPL-3.0-or-later
// Exact answers about triangles and segments. Coordinates are taken as they are; no tolerance.
#pragma once

#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf::exact {

/// True if the three points lie on one line (two of them may coincide).
bool collinear(const Vec3& a, const Vec3& b, const Vec3& c);

/// True if the closed segment pq and the closed triangle abc share a point.
/// Requires p != q and abc not collinear.
bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b,
                            const Vec3& c);

/// True if two triangles of a mesh share a point that isn't on a corner or side that they have in
/// common by number. Requires corners of different number to differ in position and neither
/// triangle to be collinear. Two triangles on the same three corners intersect.
bool triangles_intersect(const std::vector<Vec3>& points, const Triangle& s, const Triangle& t);

}  // namespace mgf::exact
