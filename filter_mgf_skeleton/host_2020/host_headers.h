// SPDX-License-Identifier: GPL-3.0-or-later
// What the plugin takes from MeshLab 2020.09, under names that the files shared by all hosts use.
#pragma once

#include <common/filter_parameter/rich_parameter_list.h>
#include <common/interfaces.h>
#include <common/meshmodel.h>

namespace mgf::plugin {

/// The parameter that is asked for as a length and as a percentage of the diagonal.
using RichLength = RichAbsPerc;

}  // namespace mgf::plugin
