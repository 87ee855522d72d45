// SPDX-License-Identifier: MIT
// The last quarter of locomotion, in which a gait must still move to count as cyclic (§3.1, decision 0015).
#pragma once

namespace planula {

/// The step at which the last quarter begins, rounded down to a multiple of `interval`: signals are compared from knot
/// to knot, places from one point of the path to the next.
constexpr int last_quarter(int locomotion_steps, int interval) {
    return 3 * locomotion_steps / 4 / interval * interval;
}

} // namespace planula
