// SPDX-License-Identifier: MIT
#include "locomotion/grn.h"

#include "cell/senses.h"

#include <algorithm>
#include <cmath>

namespace planula {

GrnMuscles::GrnMuscles(const Network &network, const Body &body, const Tissue &tissue,
                       const Parameters &parameters)
    : network_(network), parameters_(parameters), neighbours_(neighbours(body.mesh, body.cells())),
      tissue_(tissue), previous_(body.positions.size(), 0.0), newest_(body.positions.size(), 0.0) {
    for (int cell = 0; cell < body.cells(); ++cell)
        sense(body.positions[cell], 0, 1, parameters, tissue_.row(cell));
}

void GrnMuscles::signals(int t, std::span<double> signal) {
    // The last interval ends without a further update.
    const int interval = parameters_.update_interval;
    if (t % interval == 0 && t < parameters_.locomotion_steps) update();
    const int last = std::min(t, parameters_.locomotion_steps - 1) / interval * interval;

    // Eq. (2): a = s_prev + (t − t_u)(s_new − s_prev) / 50.
    const double share = static_cast<double>(t - last) / interval;
    for (std::size_t i = 0; i < signal.size(); ++i)
        signal[i] = previous_[i] + share * (newest_[i] - previous_[i]);
}

double GrnMuscles::activity() const {
    const double terms = static_cast<double>(newest_.size()) * (updates_ - 1);
    return updates_ < 2 ? 0 : change_ / (2 * terms); // Eq. (5)
}

void GrnMuscles::update() {
    // All cells read the morphogens of the update before.
    const std::vector<double> morphogens = tissue_.morphogens;
    previous_ = newest_;
    for (std::size_t i = 0; i < newest_.size(); ++i) {
        const std::span<double> activations = tissue_.row(static_cast<int>(i));
        sense_morphogen(mean_morphogen(neighbours_[i], morphogens), activations);
        step(network_, activations);
        tissue_.morphogens[i] = activations[network_.inputs + output::morphogen];
        newest_[i] = activations[network_.inputs + output::spring];
        for (const double activation : activations) sound_ = sound_ && std::isfinite(activation);
        if (updates_ > 0) change_ += std::abs(newest_[i] - previous_[i]);
    }
    ++updates_;
}

} // namespace planula
