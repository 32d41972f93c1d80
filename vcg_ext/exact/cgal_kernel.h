// SPDX-License-Identifier: GPL-3.0-or-later
// The CGAL kernel behind the exact answers; for the compiled parts of this folder only, since its
// headers take longer to read than all of ours.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "vcg_ext/core/types.h"

namespace mgf::exact_detail {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline Kernel::Point_3 to_cgal(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

}  // namespace mgf::exact_detail
