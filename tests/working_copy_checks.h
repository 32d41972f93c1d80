// SPDX-License-Identifier: GPL-3.0-or-later
// What tests of the diagnosis and of the working copy ask.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "vcg_ext/input/diagnosis.h"
#include "vcg_ext/input/working_copy.h"

namespace mgf::test {

inline std::size_t count_of(const Diagnosis& diagnosis, const std::string& code) {
  const Finding* finding = diagnosis.find(code);
  return finding == nullptr ? 0 : finding->count;
}

inline bool same(const TriangleSurface& a, const TriangleSurface& b) {
  return a.points == b.points && a.triangles == b.triangles;
}

/// The maps of a working copy are each other's inverse where something stayed, and its positions
/// are the input's.
inline void expect_consistent_maps(const WorkingCopy& copy, const TriangleSurface& input) {
  ASSERT_EQ(copy.vertex_of_input.size(), input.points.size());
  ASSERT_EQ(copy.face_of_input.size(), input.triangles.size());
  ASSERT_EQ(copy.input_of_vertex.size(), copy.surface.points.size());
  ASSERT_EQ(copy.input_of_face.size(), copy.surface.triangles.size());
  ASSERT_EQ(copy.shell_of_vertex.size(), copy.surface.points.size());
  for (Index v = 0; v < input.points.size(); ++v) {
    const Index w = copy.vertex_of_input[v];
    if (w != kNone) {
      EXPECT_EQ(copy.surface.points[w], input.points[v]);
    }
  }
  for (Index v = 0; v < copy.surface.points.size(); ++v) {
    EXPECT_EQ(copy.vertex_of_input[copy.input_of_vertex[v]], v);
    EXPECT_LT(copy.shell_of_vertex[v], copy.solids);
  }
  for (Index f = 0; f < input.triangles.size(); ++f) {
    const Index g = copy.face_of_input[f];
    if (g != kNone) {
      EXPECT_EQ(copy.input_of_face[g], f);
    }
  }
}

}  // namespace mgf::test
