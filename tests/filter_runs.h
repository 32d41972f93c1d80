// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the filters have in common: running one without a host, and meshes to run it
// on.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filter.h"
#include "filter_mgf_skeleton/workbench.h"
#include "tests/fixtures.h"

namespace mgf::plugin::test {

inline const Filter& filter_named(const std::string& name) {
  for (const Filter& filter : all_filters()) {
    if (filter.name == name) return filter;
  }
  throw std::logic_error("no filter " + name);
}

inline ParameterValues default_values(const Filter& filter, const TriangleSurface& mesh) {
  ParameterValues values;
  for (const Parameter& parameter : filter.parameters) {
    values.set(parameter.key, initial_value(parameter, bounding_box_diagonal(mesh.points)));
  }
  return values;
}

/// A filter run with its defaults, but for what `change` sets.
inline FilterOutcome run(const std::string& name, const TriangleSurface& mesh, Workbench& workbench,
                         const std::function<void(ParameterValues&)>& change = {}) {
  const Filter& filter = filter_named(name);
  ParameterValues values = default_values(filter, mesh);
  if (change) change(values);
  return run_filter(filter, {mesh, "mesh", values, workbench, {}});
}

inline TriangleSurface small_torus() {
  return fixtures::torus(36, 14, 2.0, 0.7);
}

inline TriangleSurface open_box() {
  TriangleSurface mesh = fixtures::midpoint_subdivided(fixtures::box(3, 1, 1));
  mesh.triangles.pop_back();
  return mesh;
}

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream stream(path);
  EXPECT_TRUE(stream) << path;
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace mgf::plugin::test
