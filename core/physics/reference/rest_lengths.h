// SPDX-License-Identifier: MIT
// The rest lengths of the springs while muscles move: exact at knots, linear between them (rule G3; decision 0011).
#pragma once

#include "physics/soft_body.h"

#include <span>
#include <vector>

namespace planula::reference {

class RestLengths {
  public:
    RestLengths() = default;
    /// Without actuation. The model must outlive the use of this.
    explicit RestLengths(const SoftBodyModel &model);

    /// As of Engine::actuate.
    void actuate(std::span<const double> extensions, int steps);
    /// To the next step.
    void advance();
    /// Of each spring, in this step.
    std::span<const double> now() const { return now_; }

  private:
    const SoftBodyModel *model_ = nullptr;
    std::vector<double> now_, at_knot_, changes_; // per link: now, at the coming knot, in a step
    int steps_to_knot_ = 0;
};

} // namespace planula::reference
