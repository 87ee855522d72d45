// SPDX-License-Identifier: MIT
// What one cell's muscles do, as numbers: the text that gaits and devices share (§2.5, 2.6; decisions 0011 and 0012).
#pragma once

#include "base/portable.h"

namespace planula {

/// The share by which a cell with signal a lengthens its springs. Of two cells they add up to L = (1 + r (a1 +
/// a2)/2) L0 (laws/spring.h). With r the largest change when both agree, this is Eq. (1) with A = r/2, which
/// adds two sines, and Eq. (3) with A = r, which averages two outputs. `ramp` in [0, 1] scales r.
PORTABLE inline double extension(double range, double ramp, double a) { return ramp * range * a / 2; }

/// min(1, t / ramp_steps): the amplitude rises at the start (§2.5).
PORTABLE inline double ramp(int t, int ramp_steps) {
    const double share = static_cast<double>(t) / ramp_steps;
    return share < 1 ? share : 1;
}

/// A phase of an oscillator and the angle by which it turns from knot to knot.
struct Phasor {
    double sine, cosine; // of the present phase
    double turn_sine, turn_cosine;

    PORTABLE void turn() {
        const double turned = sine * turn_cosine + cosine * turn_sine;
        cosine = cosine * turn_cosine - sine * turn_sine;
        sine = turned;
    }
};

/// When a network's output is the signal: the last update at or before step t, the last interval of locomotion being
/// without one at its end.
PORTABLE inline int last_update(int t, int interval, int locomotion_steps) {
    return (t < locomotion_steps - 1 ? t : locomotion_steps - 1) / interval * interval;
}
/// Eq. (2): a = s_prev + (t − t_u)(s_new − s_prev) / 50, with the outputs before and after the update at t_u.
PORTABLE inline double signal_between(double previous, double newest, int since_update, int interval) {
    return previous + static_cast<double>(since_update) / interval * (newest - previous);
}

/// b_a of Eq. (5): the sum of all changes of outputs from one update to the next, and of how many; 0 without any.
inline double activity_of(double change, double count) { return count > 0 ? change / (2 * count) : 0; }

} // namespace planula
