// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters between their descriptions and MeshLab's parameter lists.
#pragma once

#include <vector>

#include "filter_mgf_skeleton/parameter.h"
#include "host_headers.h"

namespace mgf::plugin {

/// Appends each description to `list`, with defaults for a mesh of the given diagonal.
void declare_parameters(const std::vector<Parameter>& parameters, double diagonal,
                        RichParameterList& list);

/// The values of the described parameters in `list`. Throws `InputError` when one is missing or of
/// another type.
ParameterValues read_parameters(const std::vector<Parameter>& parameters,
                                const RichParameterList& list);

}  // namespace mgf::plugin
