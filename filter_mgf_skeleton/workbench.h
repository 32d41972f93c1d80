// SPDX-License-Identifier: GPL-3.0-or-later
// The results of former runs, kept so that one filter after another doesn't compute them again.
#pragma once

#include <cstdint>
#include <list>
#include <memory>

#include "vcg_ext/mgf_skeleton.h"

namespace mgf::plugin {

/// How far a study goes.
enum class Stage { kMedialAxis, kField, kHierarchy };

/// The options that a study depends on. In `skeleton`, theta and prune don't matter: every level
/// is in the hierarchy.
struct StudyOptions {
  MedialAxisOptions medial_axis;
  GeodesicOptions geodesics;
  SkeletonOptions skeleton;
};

/// What has been computed of one mesh with one set of options, each stage standing on the former.
/// A stage that was not asked for may be null.
struct Study {
  std::shared_ptr<const MedialAxis> axis;
  std::shared_ptr<const MedialGeodesicFunction> function;
  std::shared_ptr<const CurveSkeletonResult> result;
};

/// Keeps the studies of the few meshes used last. A mesh is known by its contents, so an edited
/// one is a new one. Thread counts don't matter, since results don't depend on them.
class Workbench {
 public:
  /// The study of `mesh` up to `stage`; computes what isn't kept yet. Throws what the stages throw,
  /// and keeps what was finished before.
  Study study(const TriangleSurface& mesh, const StudyOptions& options, Stage stage,
              const Progress& progress);

  /// The study of `mesh` used last that has a skeleton, whatever its options; else one with the
  /// default options.
  Study latest_study(const TriangleSurface& mesh, const Progress& progress);

 private:
  /// What a result depends on, as one number.
  using Key = std::uint64_t;

  struct Entry {
    Key mesh = 0;
    Key options = 0;  ///< of the medial axis
    Key skeleton_options = 0;
    Study study;
  };

  Entry& entry(Key mesh, Key options);

  std::list<Entry> entries_;  ///< the one used last comes first
};

}  // namespace mgf::plugin
