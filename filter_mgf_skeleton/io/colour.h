// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of files and layers: the paper's ramp, tubular and flat, one colour per branch.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "filter_mgf_skeleton/io/table.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/branches.h"

namespace mgf::io {

struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  bool operator==(const Colour& other) const {
    return red == other.red && green == other.green && blue == other.blue;
  }
};

/// The paper's Figures 12 and 13: tubular regions blue, flat ones white, the rest grey.
inline constexpr Colour kTubularColour{70, 110, 230};
inline constexpr Colour kFlatColour{245, 245, 245};
inline constexpr Colour kUnlabelledColour{128, 128, 128};

/// The paper's ramp over [low, high]: blue small, green medium, red large; values beyond are
/// clamped. Where low == high, every value gets the middle.
struct ColourScale {
  double low = 0.0;
  double high = 1.0;

  Colour operator()(double value) const {
    const double share = high > low ? std::clamp((value - low) / (high - low), 0.0, 1.0) : 0.5;
    // Blue, cyan, green, yellow, red: in each quarter one component goes up or down.
    const auto component = [](double level) {
      return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(level, 0.0, 1.0)));
    };
    const double middle = std::abs(share - 0.5);
    return {component(4.0 * share - 2.0), component(2.0 - 4.0 * middle),
            component(2.0 - 4.0 * share)};
  }
};

/// The scale whose ends are the quantiles `tail` and 1 - `tail` of `values`, so that a few extreme
/// values don't leave all others in one colour; [0, 1] for no values. Requires 0 <= tail < 0.5.
inline ColourScale quantile_scale(std::vector<double> values, double tail) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const double last = static_cast<double>(values.size() - 1);
  return {values[static_cast<std::size_t>(std::floor(tail * last))],
          values[static_cast<std::size_t>(std::ceil((1.0 - tail) * last))]};
}

/// One colour per branch, different wherever two branches meet as long as no more than the palette
/// has meet there. The palette is Okabe and Ito's for all kinds of colour vision (without its
/// black), then the same hues lighter.
inline std::vector<Colour> branch_colours(const BranchGraph& graph) {
  constexpr std::array<Colour, 14> kPalette{{{230, 159, 0},
                                             {86, 180, 233},
                                             {0, 158, 115},
                                             {240, 228, 66},
                                             {0, 114, 178},
                                             {213, 94, 0},
                                             {204, 121, 167},
                                             {243, 207, 128},
                                             {171, 218, 244},
                                             {128, 207, 185},
                                             {248, 242, 161},
                                             {128, 185, 217},
                                             {234, 175, 128},
                                             {230, 188, 211}}};
  std::vector<std::vector<Index>> branches_at(graph.node_kind.size());
  for (Index b = 0; b < graph.branches.size(); ++b) {
    branches_at[graph.branches[b].first_node].push_back(b);
    branches_at[graph.branches[b].last_node].push_back(b);
  }
  std::array<std::size_t, kPalette.size()> uses{};
  std::vector<Index> choice(graph.branches.size(), kNone);
  std::vector<Colour> colours;
  for (Index b = 0; b < graph.branches.size(); ++b) {
    std::array<bool, kPalette.size()> taken{};
    for (const Index node : {graph.branches[b].first_node, graph.branches[b].last_node}) {
      for (const Index other : branches_at[node]) {
        if (choice[other] != kNone) taken[choice[other]] = true;
      }
    }
    // A free entry before a taken one, then the least used, then the first of the palette.
    const auto worse = [&](Index i, Index j) {
      return taken[i] != taken[j] ? taken[i] : uses[i] > uses[j];
    };
    Index best = 0;
    for (Index i = 1; i < kPalette.size(); ++i) {
      if (worse(best, i)) best = i;
    }
    choice[b] = best;
    ++uses[best];
    colours.push_back(kPalette[best]);
  }
  return colours;
}

/// Appends the columns red, green, blue.
inline void add_colour_columns(std::function<Colour(std::size_t)> colour,
                               std::vector<Column>& columns) {
  const auto add = [&](const char* name, std::uint8_t Colour::*component) {
    columns.push_back({name, NumberType::kByte, [colour, component](std::size_t row) {
                         return static_cast<double>(colour(row).*component);
                       }});
  };
  add("red", &Colour::red);
  add("green", &Colour::green);
  add("blue", &Colour::blue);
}

}  // namespace mgf::io
