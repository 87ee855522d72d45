// SPDX-License-Identifier: MIT
// Oscillator-driven actuation, Eq. (1) (§2.6.1): each cell's muscles follow a sine with its own period and
// phase, read from its network at the end of development.
#pragma once

#include "locomotion/gait.h"

#include <vector>

namespace planula {

struct Oscillator {
    double period = 0; // T, steps
    double phase = 0;  // φ, radians
};

/// T = period_shortest … period_longest over the output's [-1, 1], φ = π · output.
std::vector<Oscillator> read_oscillators(const Network &network, const Tissue &tissue,
                                         const GaitParameters &parameters);

/// sin(2πt/T + φ) at the knots, by turning each phase from knot to knot.
class Oscillators : public Gait {
  public:
    Oscillators(std::span<const Oscillator> oscillators, const GaitParameters &parameters);
    void signals(int t, std::span<double> signal) override;
    void keep(std::span<const int> cells, std::span<const Link> links) override;

    /// Of the cells, as they are now.
    std::span<const Phasor> phasors() const { return phasors_; }

  private:
    std::vector<Phasor> phasors_;
};

} // namespace planula
