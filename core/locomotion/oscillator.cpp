// SPDX-License-Identifier: MIT
#include "locomotion/oscillator.h"

#include "base/keep_only.h"
#include "base/math.h"

namespace planula {

std::vector<Oscillator> read_oscillators(const Network &network, const Tissue &tissue,
                                         const GaitParameters &p) {
    std::vector<Oscillator> oscillators;
    for (int cell = 0; cell < static_cast<int>(tissue.morphogens.size()); ++cell) {
        const auto output_of = [&](output::Channel channel) {
            return tissue.activations.at(cell, network.inputs + channel);
        };
        const double share = (output_of(output::period) + 1) / 2;
        oscillators.push_back({p.period_shortest + share * (p.period_longest - p.period_shortest),
                               math::pi * output_of(output::phase)});
    }
    return oscillators;
}

Oscillators::Oscillators(std::span<const Oscillator> oscillators, const GaitParameters &parameters) {
    for (const auto &[period, phase] : oscillators) {
        const double turn = 2 * math::pi * parameters.knot_interval / period;
        phasors_.push_back({math::sin(phase), math::cos(phase), math::sin(turn), math::cos(turn)});
    }
}

void Oscillators::keep(std::span<const int> cells, std::span<const Link>) { keep_only(cells, phasors_); }

void Oscillators::signals(int t, std::span<double> signal) {
    for (std::size_t i = 0; i < phasors_.size(); ++i) {
        if (t > 0) phasors_[i].turn();
        signal[i] = phasors_[i].sine;
    }
}

} // namespace planula
