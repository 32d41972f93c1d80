// SPDX-License-Identifier: GPL-3.0-or-later
// report.json: a `Report` as JSON.
#pragma once

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "filter_mgf_skeleton/io/atomic_file.h"
#include "filter_mgf_skeleton/io/branches_csv.h"
#include "filter_mgf_skeleton/io/report.h"
#include "filter_mgf_skeleton/io/table.h"

namespace mgf::io {

namespace report_detail {

using Json = nlohmann::ordered_json;

// The JSON library writes NaN and infinity as null without a word.
inline void require_finite(const Json& value, const std::string& name,
                           const std::filesystem::path& path) {
  if (value.is_number_float() && !std::isfinite(value.get<double>())) {
    throw FileError(path, name + " is not finite");
  }
  if (!value.is_structured()) return;
  for (const auto& [key, member] : value.items()) {
    require_finite(member, std::string(name).append(".").append(key), path);
  }
}

inline const char* word(ReportStatus status) {
  switch (status) {
    case ReportStatus::kOk:
      return "ok";
    case ReportStatus::kWarning:
      return "warning";
    case ReportStatus::kFailed:
      return "failed";
  }
  return "";
}

inline const char* word(TopologyVerdict verdict) {
  switch (verdict) {
    case TopologyVerdict::kProven:
      return "proven";
    case TopologyVerdict::kCounted:
      return "counted";
    case TopologyVerdict::kFailed:
      return "failed";
  }
  return "";
}

inline Json section(const BettiNumbers& betti) {
  return {{"b0", betti.b0}, {"b1", betti.b1}, {"b2", betti.b2}};
}

inline Json section(const Warning& warning) {
  return {{"code", warning.code}, {"message", warning.message}};
}

inline Json section(const InputReport& input) {
  Json json;
  if (!input.file.empty()) json["file"] = input.file;
  json.update({{"vertices", input.vertices},
               {"faces", input.faces},
               {"components", input.components},
               {"genus", input.genus}});
  return json;
}

inline Json section(const CrossingsReport& crossings) {
  return {{"pairs_mended", crossings.pairs_mended},
          {"pairs_left", crossings.pairs_left},
          {"vertices_moved", crossings.vertices_moved},
          {"largest_move", crossings.largest_move}};
}

inline Json section(const MedialAxisReport& medial_axis) {
  Json json{{"samples_added", medial_axis.samples_added},
            {"vertices", medial_axis.vertices},
            {"edges", medial_axis.edges},
            {"facets", medial_axis.facets}};
  json.update(section(medial_axis.betti));
  return json;
}

inline Json section(const TopologyCertificate& certificate) {
  return {{"topology", word(certificate.topology)},
          {"isotopic", certificate.isotopic},
          {"gave_up", certificate.gave_up},
          {"boundary_faces_missing", certificate.boundary_faces_missing},
          {"boundary_faces_extra", certificate.boundary_faces_extra},
          {"tetrahedra_not_positive", certificate.tetrahedra_not_positive},
          {"winding_conflicts", certificate.winding_conflicts},
          {"interior_vertices", certificate.interior_vertices},
          {"betti", section(certificate.betti)},
          {"expected", section(certificate.expected)},
          {"surface_flips", certificate.surface_flips},
          {"points_added", certificate.points_added},
          {"exact_points", certificate.exact_points},
          {"tetrahedra_flattened", certificate.tetrahedra_flattened}};
}

inline Json section(const MgfReport& mgf) {
  return {{"facets", mgf.facets}, {"certified", mgf.certified}};
}

inline Json section(const SkeletonReport& skeleton) {
  return {{"theta", skeleton.theta},
          {"prune", skeleton.prune},
          {"nodes", skeleton.nodes},
          {"edges", skeleton.edges},
          {"b0", skeleton.b0},
          {"b1", skeleton.b1},
          {"leaves", skeleton.leaves},
          {"junctions", skeleton.junctions},
          {"residual_facets", skeleton.residual_facets},
          {"outside_edges", skeleton.outside_edges}};
}

inline Json section(const SegmentationReport& segmentation) {
  return {{"eccentricity_threshold", segmentation.eccentricity_threshold},
          {"tubular_area_share", segmentation.tubular_area_share},
          {"unlabelled_faces", segmentation.unlabelled_faces}};
}

// An array of objects with the columns of branches.csv.
inline Json section(const BranchGraph& graph) {
  const Table table = branch_table(graph);
  Json branches = Json::array();
  for (std::size_t b = 0; b < table.rows; ++b) {
    Json branch;
    for (const Column& column : table.columns) {
      const double value = column.value(b);
      if (column.type == NumberType::kReal) {
        branch[column.name] = value;
      } else if (column.type == NumberType::kByte) {
        branch[column.name] = value != 0.0;
      } else if (value == kNothing) {
        branch[column.name] = nullptr;
      } else {
        branch[column.name] = static_cast<long>(value);
      }
    }
    branches.push_back(branch);
  }
  return branches;
}

inline Json seconds(const Report& report) {
  Json json = Json::object();
  for (const StageReport& stage : report.stages) {
    json[stage.stage] = json.value(stage.stage, 0.0) + stage.seconds;
  }
  json["total"] = report.total_seconds;
  return json;
}

inline Json to_json(const Report& report) {
  Json json;
  const auto add = [&json](const char* name, const auto& part) {
    if (part) json[name] = section(*part);
  };
  json["status"] = word(report.status);
  add("error", report.error);
  json["input"] = section(report.input);
  add("crossings", report.crossings);
  add("medial_axis", report.medial_axis);
  add("certificate", report.certificate);
  add("mgf", report.mgf);
  if (report.skeleton) json["theta"] = report.skeleton->theta;
  add("skeleton", report.skeleton);
  add("branches", report.branches);
  add("segmentation", report.segmentation);
  json["seconds"] = seconds(report);
  json["threads"] = report.threads;
  json["peak_memory_mb"] = report.peak_memory_mb;
  json["warnings"] = Json::array();
  for (const Warning& warning : report.warnings) json["warnings"].push_back(section(warning));
  return json;
}

}  // namespace report_detail

/// Writes the report, indented. Bytes that are no UTF-8 (in the name of the input) are replaced.
/// Throws `FileError`.
inline void write_report_json(const std::filesystem::path& path, const Report& report) {
  const report_detail::Json json = report_detail::to_json(report);
  report_detail::require_finite(json, "report", path);
  AtomicFile file(path);
  constexpr int kIndent = 2;
  file.append(json.dump(kIndent, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  file.commit();
}

}  // namespace mgf::io
