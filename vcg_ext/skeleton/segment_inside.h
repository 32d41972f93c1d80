// SPDX-License-Identifier: GPL-3.0-or-later
// How the skeleton's stages ask whether a line stays inside the shape.
#pragma once

#include <functional>

#include "vcg_ext/core/types.h"

namespace mgf {

/// Whether the straight segment between two points stays inside the shape.
using SegmentInside = std::function<bool(const Vec3&, const Vec3&)>;

}  // namespace mgf
