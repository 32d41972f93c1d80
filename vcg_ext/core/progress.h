// SPDX-License-Identifier: GPL-3.0-or-later
// Progress as a value that a stage can hand on in slices; the way a user's wish to stop comes in.
#pragma once

#include <functional>
#include <utility>

#include "vcg_ext/core/errors.h"

namespace mgf {

/// Where a computation reports how far it is. The default one listens to nobody.
/// `report` may be called only from the thread that was given the value.
class Progress {
 public:
  /// Takes the share done in [0, 1] and a stage's name; returns false to stop.
  using Callback = std::function<bool(double, const char*)>;

  Progress() = default;
  explicit Progress(Callback callback) : callback_(std::move(callback)) {}

  /// The part [from, to] of this progress, itself counted from 0 to 1.
  Progress slice(double from, double to) const {
    Progress part = *this;
    part.from_ = from_ + (to_ - from_) * from;
    part.to_ = from_ + (to_ - from_) * to;
    return part;
  }

  /// Reports `share` in [0, 1] of this slice. Throws `Cancelled` if the listener says stop.
  void report(double share, const char* stage) const {
    if (callback_ && !callback_(from_ + (to_ - from_) * share, stage)) throw Cancelled();
  }

 private:
  Callback callback_;
  double from_ = 0.0;
  double to_ = 1.0;
};

}  // namespace mgf
