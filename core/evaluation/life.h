// SPDX-License-Identifier: MIT
// What one genome did: the finished, read-only record that an experiment judges.
#pragma once

#include "base/vec2.h"
#include "body/outcome.h"
#include "body/shape.h"

#include <vector>

namespace planula {

struct Life {
    Outcome outcome = Outcome::died_out;
    int cells = 0;     // at the end of development
    int largest = 0;   // most cells alive at once
    int births = 0;    // cells created, the zygote included
    int links = 0;     // springs of the body
    int triangles = 0; // of the body
    double elongation =
        0; // length over width of the developed body by its principal axes, >= 1; 0 if no width
    ShapeDistribution shape{}; // of the developed body; all 0 if growth did not end viable
    int settle_steps = 0;      // steps until the body came to rest; 0 in water
    Vec2d rest;                // centre of mass when the body had come to rest (Eq. 4: x_s, y_s)
    Vec2d end;                 // centre of mass at the end of locomotion (Eq. 4: x_f, y_f)
    double activity = 0;       // b_a of Eq. 5; 0 with oscillators
    double late_actuation = 0; // share of all change of muscle signals in the last quarter of locomotion
    std::vector<Vec2d> path;   // centre of mass every Parameters::path_interval steps, from rest to end

    /// |end - rest|, the bare distance; 0 unless viable.
    double displacement() const { return length(end - rest); }
};

} // namespace planula
