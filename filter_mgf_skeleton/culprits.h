// SPDX-License-Identifier: GPL-3.0-or-later
// From the doctor's findings to a selection.
#pragma once

#include <algorithm>
#include <vector>

#include "filter_mgf_skeleton/layer.h"
#include "vcg_ext/input/diagnosis.h"

namespace mgf::plugin {

/// The faces and vertices to blame for the findings of the gravest kind that has any: selecting
/// what is harmless as well would hide what must be mended.
inline Selection culprits(const Diagnosis& diagnosis) {
  for (const Severity severity : {Severity::kFatal, Severity::kWarning, Severity::kHarmless}) {
    Selection selection;
    for (const Finding& finding : diagnosis.findings) {
      if (finding.severity != severity) continue;
      selection.faces.insert(selection.faces.end(), finding.faces.begin(), finding.faces.end());
      selection.points.insert(selection.points.end(), finding.vertices.begin(),
                              finding.vertices.end());
    }
    if (!selection.faces.empty() || !selection.points.empty()) return selection;
  }
  return {};
}

}  // namespace mgf::plugin
