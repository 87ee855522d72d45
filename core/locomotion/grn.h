// SPDX-License-Identifier: MIT
// GRN-driven actuation, Eqs. (2), (3) and (5) (§2.6.2): the cells' networks go on being updated, and each
// cell's signal moves linearly from the spring output before the last update to the newest, one interval
// behind.
#pragma once

#include "locomotion/gait.h"

#include <optional>
#include <vector>

namespace planula {

/// The cell morphogen is that of the neighbours at the update before. X, Y and the maternal morphogens are those of the
/// cell's place at the end of development, or of its present one (gait_place); time stays 1, or goes on rising
/// (gait_time). A present place is that of the knot before, in the development frame moved to where the body rests.
class GrnMuscles : public Gait {
  public:
    GrnMuscles(const Network &network, const Body &body, const Tissue &tissue, const Parameters &parameters);
    bool senses() const override { return parameters_.gait.gait_place == GaitPlace::present; }
    void sense(std::span<const Vec2d> places) override;
    void signals(int t, std::span<double> signal) override;
    void keep(std::span<const int> cells, std::span<const Link> links) override;
    const Activations *activations() const override { return &tissue_.activations; }
    double activity() const override;
    bool is_sound() const override { return sound_; }

    /// Whether what the networks read beside morphogens changes on the way.
    bool inputs_change() const { return senses() || parameters_.gait.gait_time == GaitTime::rising; }
    const Network &network() const { return network_; }
    const Neighbours &neighbours() const { return neighbours_; }
    /// As it is now; before the first update with the inputs of that.
    const Tissue &tissue() const { return tissue_; }

  private:
    void read_inputs(double time);
    void update(int t);

    const Network &network_;
    const Parameters &parameters_;
    Neighbours neighbours_;
    std::vector<Vec2d> places_;      // of the cells, as their networks read them
    std::optional<Vec2d> to_embryo_; // from the world frame, once a place was sensed
    Tissue tissue_;
    std::vector<double> previous_, newest_; // spring output s of each cell, before and after the last update
    int updates_ = 0;
    double change_ = 0; // Σ |s_u − s_{u−1}| over cells and updates from the second on
    double terms_ = 0;  // how many those are
    bool sound_ = true;
    Activations before_;      // those before the last update, if it may have changed nothing
    bool is_at_rest_ = false; // whether it changed nothing, to the bit
};

} // namespace planula
