// SPDX-License-Identifier: GPL-3.0-or-later
// The input doctor: says all that is wrong with a mesh, before anything is computed.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/core/box_tree.h"
#include "vcg_ext/core/errors.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/self_intersections.h"
#include "vcg_ext/exact/surface_tree.h"
#include "vcg_ext/input/cleaning.h"
#include "vcg_ext/input/coarse_shells.h"
#include "vcg_ext/input/edge_table.h"
#include "vcg_ext/input/finding.h"
#include "vcg_ext/input/manifold_checks.h"
#include "vcg_ext/input/shells.h"

namespace mgf {

/// All that was found in a mesh.
struct Diagnosis {
  std::vector<Finding> findings;  ///< in the order of the checks
  std::vector<Shell> shells;      ///< by their least face; empty if the surface isn't closed
  Index genus = 0;                ///< sum over the solids; cavities don't count
  /// Pairs of the input's faces that intersect; behind the finding "self_intersections".
  std::vector<std::array<Index, 2>> crossings;
  bool servable = false;  ///< nothing fatal was found

  /// The finding of that code, or nullptr.
  const Finding* find(const std::string& code) const {
    const auto found = std::find_if(findings.begin(), findings.end(),
                                    [&](const Finding& finding) { return finding.code == code; });
    return found == findings.end() ? nullptr : &*found;
  }

  /// One line on the whole, then one a finding.
  std::string summary() const;
};

struct DiagnosisOptions {
  bool ignore_cavities = false;  ///< drop shells that are cavities instead of refusing
  unsigned threads = 0;          ///< 0: all; the result is the same for any number
};

/// Examines `input`, which may be anything: no index, number or shape makes it fail. The checks
/// stop where a later one would have no meaning: bad numbers hide the rest, and only a closed
/// oriented manifold has shells. `on_crossings` is called as soon as faces are known to cross.
/// O(n log n); 25 000 vertices take about 0.1 s.
Diagnosis diagnose(const TriangleSurface& input, const DiagnosisOptions& options = {},
                   const std::function<void()>& on_crossings = {});

/// Whether there are faces, of points that can be computed with: what `diagnose` asks first. O(n).
bool has_usable_points(const TriangleSurface& input);

/// Throws InputError with the first fatal finding's code and words if there is one.
void require_servable(const Diagnosis& diagnosis);

namespace detail {

/// Bounds on the extent, for sixth powers (products of areas and volumes) to stay normal numbers,
/// and for single precision to hold squares.
inline constexpr double kTiniest = 1e-40;
inline constexpr double kHugest = 1e40;
inline constexpr double kTiny = 1e-12;
inline constexpr double kHuge = 1e12;
/// Distance from the origin in extents; single precision then resolves 1/1000 of the extent.
inline constexpr double kFar = 1e4;

inline bool is_fatal(const std::vector<Finding>& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return finding.severity == Severity::kFatal; });
}

/// Are there faces, of vertices that exist.
inline std::vector<Finding> check_indices(const TriangleSurface& input) {
  if (input.points.empty() && input.triangles.empty()) {
    return {make_finding("empty", Severity::kFatal, 1)};
  }
  if (input.triangles.empty()) return {make_finding("no_faces", Severity::kFatal, 1)};
  if (input.points.size() >= kNone || 3 * input.triangles.size() >= kNone) {
    return {make_finding("too_large", Severity::kFatal, 1)};
  }
  std::vector<Index> faces;
  for (Index f = 0; f < input.triangles.size(); ++f) {
    const Triangle& t = input.triangles[f];
    if (std::any_of(t.begin(), t.end(), [&](Index v) { return v >= input.points.size(); })) {
      faces.push_back(f);
    }
  }
  if (faces.empty()) return {};
  const std::size_t count = faces.size();
  return {make_finding("index_out_of_range", Severity::kFatal, count, std::move(faces))};
}

/// Are the coordinates in use numbers that can be computed with.
inline std::vector<Finding> check_coordinates(const TriangleSurface& input) {
  std::vector<Index> bad;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  for (const Triangle& t : input.triangles) {
    for (const Index v : t) {
      if (!input.points[v].allFinite()) bad.push_back(v);
      low = low.cwiseMin(input.points[v]);
      high = high.cwiseMax(input.points[v]);
    }
  }
  if (!bad.empty()) {
    bad = sorted_unique(std::move(bad));
    const std::size_t count = bad.size();
    return {make_finding("non_finite", Severity::kFatal, count, {}, std::move(bad))};
  }
  std::vector<Finding> findings;
  // Not the diagonal: the squares of tiny numbers are 0.
  const double extent = (high - low).maxCoeff();
  const double largest = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  const auto outside = [&](double least, double most) {
    return (extent > 0.0 && extent < least) || largest > most;
  };
  if (outside(kTiny, kHuge)) {
    const Severity severity = outside(kTiniest, kHugest) ? Severity::kFatal : Severity::kWarning;
    findings.push_back(make_finding("huge_or_tiny_coordinates", severity, 1));
  }
  if (extent > 0.0 && largest > kFar * extent) {
    findings.push_back(make_finding("far_from_origin", Severity::kWarning, 1));
  }
  return findings;
}

/// Translates culprits from the cleaned surface to the input.
inline void translate(const CleanedSurface& cleaned, Finding& finding) {
  for (Index& f : finding.faces) f = cleaned.input_of_face[f];
  for (Index& v : finding.vertices) v = cleaned.input_of_vertex[v];
  finding.faces = sorted_unique(std::move(finding.faces));
  finding.vertices = sorted_unique(std::move(finding.vertices));
}

inline void check_self_intersections(const std::vector<std::array<Index, 2>>& pairs,
                                     std::vector<Finding>& findings) {
  if (pairs.empty()) return;
  std::vector<Index> faces;
  for (const auto& pair : pairs) faces.insert(faces.end(), pair.begin(), pair.end());
  findings.push_back(make_finding("self_intersections", Severity::kWarning, pairs.size(),
                                  sorted_unique(std::move(faces))));
}

/// A finding on the shells for which `chosen(shell)`, with their faces as culprits.
template <class Chosen>
void report_shells(const Shells& shells, const char* code, Severity severity, const Chosen& chosen,
                   std::vector<Finding>& findings) {
  std::size_t count = 0;
  for (Index s = 0; s < shells.shells.size(); ++s) count += chosen(s) ? 1 : 0;
  if (count == 0) return;
  std::vector<Index> faces;
  for (Index f = 0; f < shells.of_face.size(); ++f) {
    if (chosen(shells.of_face[f])) faces.push_back(f);
  }
  findings.push_back(make_finding(code, severity, count, std::move(faces)));
}

/// "shell 2 in shell 0, ...": names the first few cavities, with counts by which to know them.
inline std::string name_cavities(const std::vector<Shell>& shells) {
  constexpr int kNamed = 3;
  std::string names;
  int named = 0;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const Index outer = shells[s].inside_shell;
    if (outer == kNone) continue;
    if (named == kNamed) return names + ", and others";
    if (named++ > 0) names += ", ";
    names += "piece " + std::to_string(s) + " (" + std::to_string(shells[s].faces) +
             " faces) inside piece " + std::to_string(outer) + " (" +
             std::to_string(shells[outer].faces) + " faces)";
  }
  return names;
}

inline void check_shells(const Shells& shells, const DiagnosisOptions& options,
                         std::vector<Finding>& findings) {
  const auto is_cavity = [&](Index s) { return shells.shells[s].inside_shell != kNone; };
  const auto solids = std::count_if(shells.shells.begin(), shells.shells.end(),
                                    [](const Shell& s) { return s.inside_shell == kNone; });
  report_shells(
      shells, "flat", Severity::kFatal, [&](Index s) { return shells.flat[s] != 0; }, findings);
  report_shells(shells, "cavities", options.ignore_cavities ? Severity::kWarning : Severity::kFatal,
                is_cavity, findings);
  if (!findings.empty() && findings.back().code == "cavities") {
    findings.back().meaning += " These are: " + name_cavities(shells.shells) + ".";
  }
  report_shells(
      shells, "inside_out", Severity::kHarmless,
      [&](Index s) { return !is_cavity(s) && shells.shells[s].signed_volume < 0.0; }, findings);
  if (solids > 1) {
    findings.push_back(
        make_finding("several_shells", Severity::kHarmless, static_cast<std::size_t>(solids)));
  }
}

/// Faces that automatic sampling would split, whichever way the shells look.
inline void check_sampling(const TriangleSurface& surface, BoxTree boxes, const Shells& shells,
                           unsigned threads, std::vector<Finding>& findings) {
  TriangleSurface outward = surface;
  for (std::size_t f = 0; f < outward.triangles.size(); ++f) {
    Triangle& t = outward.triangles[f];
    if (shells.shells[shells.of_face[f]].signed_volume < 0.0) std::swap(t[1], t[2]);
  }
  std::vector<Index> faces =
      too_coarse_faces(outward, SurfaceTree(outward, std::move(boxes)), shells, threads);
  if (faces.empty()) return;
  const std::size_t count = faces.size();
  findings.push_back(make_finding("too_coarse", Severity::kWarning, count, std::move(faces)));
}

/// All findings on the cleaned surface, in its numbering; fills in the diagnosis' shells, and the
/// crossings in that numbering, too.
inline std::vector<Finding> examine(const TriangleSurface& surface, bool sound,
                                    const DiagnosisOptions& options,
                                    const std::function<void()>& on_crossings,
                                    Diagnosis& diagnosis) {
  std::vector<Finding> findings;
  if (surface.triangles.empty()) return {make_finding("no_faces", Severity::kFatal, 1)};
  const EdgeTable edges = make_edge_table(surface.triangles);
  findings = check_manifold(surface, edges);
  BoxTree boxes(face_boxes(surface.points, surface.triangles));
  diagnosis.crossings = exact::self_intersections(surface, boxes, options.threads);
  if (on_crossings && !diagnosis.crossings.empty()) on_crossings();
  check_self_intersections(diagnosis.crossings, findings);
  if (!sound || is_fatal(findings)) return findings;
  Shells shells = find_shells(surface, edges, diagnosis.crossings);
  check_shells(shells, options, findings);
  if (!is_fatal(findings))
    check_sampling(surface, std::move(boxes), shells, options.threads, findings);
  diagnosis.shells = std::move(shells.shells);
  for (const Shell& shell : diagnosis.shells) {
    if (shell.inside_shell == kNone) diagnosis.genus += static_cast<Index>(shell.genus);
  }
  return findings;
}

}  // namespace detail

inline bool has_usable_points(const TriangleSurface& input) {
  return detail::check_indices(input).empty() &&
         !detail::is_fatal(detail::check_coordinates(input));
}

inline Diagnosis diagnose(const TriangleSurface& input, const DiagnosisOptions& options,
                          const std::function<void()>& on_crossings) {
  Diagnosis diagnosis;
  const auto add = [&](std::vector<Finding> findings) {
    for (Finding& finding : findings) diagnosis.findings.push_back(std::move(finding));
    return !detail::is_fatal(diagnosis.findings);
  };
  if (!add(detail::check_indices(input)) || !add(detail::check_coordinates(input))) {
    return diagnosis;
  }
  CleanedSurface cleaned = clean_surface(input);
  const bool sound = add(std::move(cleaned.findings));
  std::vector<Finding> findings =
      detail::examine(cleaned.surface, sound, options, on_crossings, diagnosis);
  for (Finding& finding : findings) detail::translate(cleaned, finding);
  for (auto& pair : diagnosis.crossings) {
    for (Index& f : pair) f = cleaned.input_of_face[f];
  }
  diagnosis.servable = add(std::move(findings));
  return diagnosis;
}

inline std::string Diagnosis::summary() const {
  std::string text = servable ? "The mesh can be served: " + std::to_string(shells.size()) +
                                    (shells.size() == 1 ? " piece, genus " : " pieces, genus ") +
                                    std::to_string(genus) + "."
                              : "The mesh can't be served.";
  for (const Finding& finding : findings) {
    text += "\n[" + finding.code + "] " + finding.meaning + " " + finding.remedy;
  }
  return text;
}

inline void require_servable(const Diagnosis& diagnosis) {
  if (diagnosis.servable) return;
  const auto fatal =
      std::find_if(diagnosis.findings.begin(), diagnosis.findings.end(),
                   [](const Finding& finding) { return finding.severity == Severity::kFatal; });
  std::string message = fatal->meaning + " " + fatal->remedy;
  std::string others;
  for (auto other = fatal + 1; other != diagnosis.findings.end(); ++other) {
    if (other->severity != Severity::kFatal) continue;
    others += (others.empty() ? "" : ", ") + other->code;
  }
  if (!others.empty()) message += " Also found: " + others + ".";
  throw InputError(fatal->code, message);
}

}  // namespace mgf
