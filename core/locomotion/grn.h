// SPDX-License-Identifier: MIT
// GRN-driven actuation, Eqs. (2), (3) and (5) (§2.6.2): the cells' networks go on being updated, and each
// cell's signal moves linearly from the spring output before the last update to the newest, one interval
// behind.
#pragma once

#include "locomotion/gait.h"

#include <vector>

namespace planula {

/// X, Y and the maternal morphogens stay as at the end of development and time stays 1; the cell morphogen is
/// live.
class GrnMuscles : public Gait {
  public:
    GrnMuscles(const Network &network, const Body &body, const Tissue &tissue, const Parameters &parameters);
    void signals(int t, std::span<double> signal) override;
    double activity() const override;
    bool is_sound() const override { return sound_; }

  private:
    void update();

    const Network &network_;
    const Parameters &parameters_;
    Neighbours neighbours_;
    Tissue tissue_;
    std::vector<double> previous_, newest_; // spring output s of each cell, before and after the last update
    int updates_ = 0;
    double change_ = 0; // Σ |s_u − s_{u−1}| over cells and updates from the second on
    bool sound_ = true;
    Activations before_;      // those before the last update, if it may have changed nothing
    bool is_at_rest_ = false; // whether it changed nothing, to the bit
};

} // namespace planula
