// SPDX-License-Identifier: GPL-3.0-or-later
// The results of former runs, kept so that one filter after another doesn't compute them again.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "vcg_ext/mgf_skeleton.h"

namespace mgf::plugin {

/// What has been computed of one mesh with one set of options, each stage standing on the former.
struct Study {
  std::shared_ptr<const MedialAxis> axis;
  std::shared_ptr<const MedialGeodesicField> field;
  std::shared_ptr<const SkeletonHierarchy> hierarchy;
};

/// How far a study goes.
enum class Stage { kMedialAxis, kField, kHierarchy };

/// The options that a study depends on.
struct StudyOptions {
  MedialAxisOptions medial_axis;
  GeodesicOptions geodesics;
  SkeletonOptions skeleton;  ///< `theta` and `prune` don't matter: every level is in the hierarchy
};

/// Keeps the studies of the few meshes used last. A mesh is known by its contents, so an edited
/// one is a new one; thread counts don't count.
class Workbench {
 public:
  /// The study of `mesh` up to `stage`, computed where it isn't kept yet. Throws what the stages
  /// throw; then nothing half done is kept.
  Study study(const TriangleSurface& mesh, const StudyOptions& options, Stage stage,
              const Progress& progress);

  /// The last study of `mesh` that has a hierarchy, whatever its options.
  std::optional<Study> last_with_hierarchy(const TriangleSurface& mesh) const;

 private:
  struct Entry {
    std::uint64_t mesh_key = 0;
    std::uint64_t axis_key = 0;
    std::uint64_t field_key = 0;
    std::uint64_t hierarchy_key = 0;
    Study study;
  };

  Entry& entry_for(std::uint64_t mesh_key, std::uint64_t axis_key);

  std::vector<Entry> entries_;  ///< the one used last comes first
};

}  // namespace mgf::plugin
