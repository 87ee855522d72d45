// SPDX-License-Identifier: MIT
#include "physics/reference/rest_lengths.h"

#include "physics/laws/spring.h"

namespace planula::reference {

RestLengths::RestLengths(const SoftBodyModel &model)
    : model_(&model), now_(model.rest_lengths), at_knot_(model.rest_lengths), changes_(now_.size()) {}

void RestLengths::actuate(std::span<const double> extensions, int steps) {
    now_ = at_knot_;
    for (std::size_t i = 0; i < now_.size(); ++i) {
        const auto [a, b] = model_->links[i];
        at_knot_[i] = actuated_length(model_->rest_lengths[i], extensions[a], extensions[b]);
        changes_[i] = (at_knot_[i] - now_[i]) / steps;
    }
    steps_to_knot_ = steps;
}

void RestLengths::advance() {
    if (steps_to_knot_ == 0) return;
    --steps_to_knot_;
    for (std::size_t i = 0; i < now_.size(); ++i) now_[i] = at_knot_[i] - steps_to_knot_ * changes_[i];
}

} // namespace planula::reference
