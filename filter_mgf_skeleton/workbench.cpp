// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/workbench.h"

#include <algorithm>
#include <cstring>

#include "filter_mgf_skeleton/filter.h"

namespace mgf::plugin {
namespace {

/// How many studies are kept; one of a mesh of 50 000 vertices takes some hundred megabytes.
constexpr std::size_t kKept = 3;

/// Shares of the progress bar at which the stages end.
constexpr double kAxisDone = 0.2;
constexpr double kFunctionDone = 0.9;

/// A 64-bit hash of values fed one after another (FNV-1a by words, mixed at the end as in
/// splitmix64): quick, and two different meshes meet with a chance of 1e-19.
class Hash {
 public:
  void add(std::uint64_t word) { state_ = (state_ ^ word) * 0x100000001b3ULL + (state_ >> 29U); }
  void add(double number) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    add(bits);
  }
  std::uint64_t value() const {
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31U);
  }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

std::uint64_t key_of(const TriangleSurface& mesh) {
  Hash hash;
  hash.add(std::uint64_t{mesh.points.size()});
  for (const Vec3& p : mesh.points) {
    for (const double coordinate : {p.x(), p.y(), p.z()}) hash.add(coordinate);
  }
  for (const Triangle& t : mesh.triangles) {
    for (const Index corner : t) hash.add(std::uint64_t{corner});
  }
  return hash.value();
}

std::uint64_t key_of(const MedialAxisOptions& options, const GeodesicOptions& geodesics) {
  Hash hash;
  hash.add(std::uint64_t{options.diagnosis.ignore_cavities});
  hash.add(std::uint64_t{options.sampling.length.has_value()});
  hash.add(options.sampling.length.value_or(0.0));
  hash.add(std::uint64_t{options.recovery.recover_input_surface});
  hash.add(std::uint64_t{options.recovery.lift_overlaps});
  hash.add(static_cast<std::uint64_t>(geodesics.wanted));
  return hash.value();
}

std::uint64_t key_of(const SkeletonOptions& options) {
  Hash hash;
  hash.add(static_cast<std::uint64_t>(options.marking_rule));
  hash.add(std::uint64_t{options.open_pockets});
  return hash.value();
}

}  // namespace

std::shared_ptr<Workbench> make_workbench() {
  return std::make_shared<Workbench>();
}

Workbench::Entry& Workbench::entry(Key mesh, Key options) {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& candidate) {
    return candidate.mesh == mesh && candidate.options == options;
  });
  if (found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
  } else {
    entries_.push_front(Entry{mesh, options, 0, {}});
    if (entries_.size() > kKept) entries_.pop_back();
  }
  return entries_.front();
}

Study Workbench::study(const TriangleSurface& mesh, const StudyOptions& options, Stage stage,
                       const Progress& progress) {
  const Key mesh_key = key_of(mesh);
  const Key options_key = key_of(options.medial_axis, options.geodesics);
  Study study = entry(mesh_key, options_key).study;
  const auto keep = [&] { entry(mesh_key, options_key).study = study; };

  if (!study.axis) {
    study.axis = std::make_shared<MedialAxis>(
        compute_medial_axis(mesh, options.medial_axis, progress.slice(0.0, kAxisDone)));
    keep();
  }
  if (stage >= Stage::kField && !study.function) {
    study.function = std::make_shared<MedialGeodesicFunction>(compute_medial_geodesic_function(
        *study.axis, options.geodesics, progress.slice(kAxisDone, kFunctionDone)));
    keep();
  }
  const Key skeleton_key = key_of(options.skeleton);
  const bool fits = entry(mesh_key, options_key).skeleton_options == skeleton_key;
  if (stage == Stage::kHierarchy && !(study.result && fits)) {
    study.result = std::make_shared<CurveSkeletonResult>(compute_skeleton_hierarchy(
        *study.axis, study.function->field, options.skeleton, progress.slice(kFunctionDone, 1.0)));
    keep();
    entry(mesh_key, options_key).skeleton_options = skeleton_key;
  }
  return study;
}

Study Workbench::latest_study(const TriangleSurface& mesh, const Progress& progress) {
  const Key mesh_key = key_of(mesh);
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& candidate) {
    return candidate.mesh == mesh_key && candidate.study.result;
  });
  if (found == entries_.end()) return study(mesh, {}, Stage::kHierarchy, progress);
  entries_.splice(entries_.begin(), entries_, found);
  return entries_.front().study;
}

}  // namespace mgf::plugin
