// SPDX-License-Identifier: MIT
#include "locomotion/grn.h"

#include "base/keep_only.h"
#include "cell/senses.h"

#include <cmath>

namespace planula {

GrnMuscles::GrnMuscles(const Network &network, const Body &body, const Tissue &tissue,
                       const Parameters &parameters)
    : network_(network), parameters_(parameters), neighbours_(body.mesh.links, body.cells()),
      places_(body.positions), tissue_(tissue), previous_(body.positions.size(), 0.0),
      newest_(body.positions.size(), 0.0) {
    read_inputs(1);
}

void GrnMuscles::sense(std::span<const Vec2d> places) {
    if (!to_embryo_) to_embryo_ = centre_of_mass(places_) - centre_of_mass(places);
    for (std::size_t i = 0; i < places_.size(); ++i) places_[i] = places[i] + *to_embryo_;
}

void GrnMuscles::read_inputs(double time) {
    for (int cell = 0; cell < tissue_.activations.cells(); ++cell) {
        const auto inputs = planula::sense(places_[cell], 0, time, parameters_.network);
        for (int node = 0; node < input::count; ++node) tissue_.activations.at(cell, node) = inputs[node];
    }
}

void GrnMuscles::signals(int t, std::span<double> signal) {
    const int interval = parameters_.gait.update_interval;
    if (t % interval == 0 && t < parameters_.gait.locomotion_steps) update(t);
    const int since = t - last_update(t, interval, parameters_.gait.locomotion_steps);
    for (std::size_t i = 0; i < signal.size(); ++i)
        signal[i] = signal_between(previous_[i], newest_[i], since, interval);
}

double GrnMuscles::activity() const { return activity_of(change_, terms_); }

void GrnMuscles::keep(std::span<const int> cells, std::span<const Link> links) {
    tissue_.keep(cells);
    keep_only(cells, previous_), keep_only(cells, newest_), keep_only(cells, places_);
    neighbours_ = Neighbours(links, static_cast<int>(cells.size()));
    is_at_rest_ = false;
}

void GrnMuscles::update(int t) {
    if (updates_ > 0) terms_ += static_cast<double>(newest_.size());
    if (is_at_rest_) {
        ++updates_;
        return;
    }
    // Where no signal changed, nothing may have, and then nothing ever will.
    Activations &activations = tissue_.activations;
    const bool may_rest = !inputs_change() && updates_ > 1 && newest_ == previous_;
    if (may_rest) before_ = activations;

    if (inputs_change()) {
        const bool rises = parameters_.gait.gait_time == GaitTime::rising;
        read_inputs(rises ? 1 + static_cast<double>(t) / parameters_.development.development_steps : 1);
    }
    // All cells read the morphogens of the update before.
    const int cells = activations.cells();
    for (int i = 0; i < cells; ++i)
        activations.at(i, input::morphogen) = mean_morphogen(neighbours_[i], tissue_.morphogens);
    sound_ = step(network_, activations) && sound_;

    previous_.swap(newest_);
    for (int i = 0; i < cells; ++i) {
        tissue_.morphogens[i] = activations.at(i, network_.inputs + output::morphogen);
        newest_[i] = activations.at(i, network_.inputs + output::spring);
        if (updates_ > 0) change_ += std::abs(newest_[i] - previous_[i]);
    }
    ++updates_;
    is_at_rest_ = may_rest && identical(activations, before_);
}

} // namespace planula
