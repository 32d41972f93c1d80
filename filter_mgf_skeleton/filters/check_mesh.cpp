// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/culprits.h"
#include "filter_mgf_skeleton/filters/filters.h"

namespace mgf::plugin {
namespace {

const char* word(Severity severity) {
  switch (severity) {
    case Severity::kFatal:
      return "error";
    case Severity::kWarning:
      return "warning";
    case Severity::kHarmless:
      return "harmless";
  }
  return "";
}

FilterOutput check_mesh(const FilterInput& input) {
  input.progress.report(0.0, "Checking the mesh");
  const Diagnosis diagnosis = diagnose(input.mesh);
  FilterOutput output;
  output.notes.emplace_back(diagnosis.servable
                                ? "The mesh can be served by the curve skeleton filters."
                                : "The mesh can't be served by the curve skeleton filters:");
  for (const Finding& finding : diagnosis.findings) {
    output.notes.push_back(std::string(word(finding.severity)) + " | " + finding.code + " | " +
                           std::to_string(finding.count) + " | " + finding.meaning + " " +
                           finding.remedy);
  }
  output.measures.push_back(
      {"servable", "Can be served (1 yes, 0 no)", diagnosis.servable ? 1.0 : 0.0});
  output.measures.push_back({"vertices", "Vertices", double(input.mesh.points.size())});
  output.measures.push_back({"faces", "Faces", double(input.mesh.triangles.size())});
  output.measures.push_back({"shells", "Closed pieces", double(diagnosis.shells.size())});
  output.measures.push_back({"genus", "Genus", double(diagnosis.genus)});
  output.selection = culprits(diagnosis);
  return output;
}

}  // namespace

Filter check_mesh_filter() {
  Filter filter;
  filter.name = "Check Mesh for Curve Skeleton";
  filter.python_name = "get_curve_skeleton_diagnosis";
  filter.effect = FilterEffect::kSelects;
  filter.help =
      std::string(
          "Tells whether the curve skeleton filters can serve this mesh, and if not, <b>what is "
          "wrong with it and how to mend it</b>: holes, edges and vertices that aren't manifold, "
          "faces that look the wrong way, self-intersections, cavities, bad coordinates, and "
          "more.<br>"
          "Each finding is a line in the log: how grave it is, its code, how often it occurs, "
          "what it means, and which MeshLab filter mends it. The faces and vertices to blame for "
          "the gravest findings become the selection; nothing else changes.") +
      kReference;
  filter.run = check_mesh;
  return filter;
}

}  // namespace mgf::plugin
