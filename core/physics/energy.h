// SPDX-License-Identifier: MIT
// The energy in a soft body, in double precision and from its state alone, so that it means the same for every engine
// (decisions 0006 and 0026). In masses of a cell times cell²/t.u.².
#pragma once

#include "physics/soft_body.h"

#include <span>

namespace planula {

/// In springs with these rest lengths, Σ k/2 (l − L)², and in the pressure of triangles, Σ kp/2 (A0 − A)² /
/// max(A0, floor), the potentials of laws/spring.h and laws/pressure.h.
double elastic_energy(const SoftBodyModel &model, std::span<const double> rest_lengths,
                      std::span<const Vec2d> positions);

/// What a spring of this length gains when a muscle changes its rest length `from` → `to`: k/2 ((l − to)² − (l −
/// from)²). It is positive where a muscle shortens a stretched spring, or lengthens a compressed one.
inline double muscle_work(double stiffness, double length, double from, double to) {
    return stiffness * (from - to) * (length - 0.5 * (from + to));
}

} // namespace planula
