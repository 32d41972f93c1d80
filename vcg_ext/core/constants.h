// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of mathematics that C++17 does not name.
#pragma once

namespace mgf {

inline constexpr double kPi = 3.14159265358979323846;

}  // namespace mgf
