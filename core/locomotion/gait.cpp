// SPDX-License-Identifier: MIT
#include "locomotion/gait.h"

#include "locomotion/grn.h"
#include "locomotion/oscillator.h"

#include <algorithm>

namespace planula {

std::unique_ptr<Gait> make_gait(Actuation actuation, const Network &network, const Body &body,
                                const Tissue &tissue, const Parameters &parameters) {
    if (actuation == Actuation::oscillator)
        return std::make_unique<Oscillators>(read_oscillators(network, tissue, parameters), parameters);
    return std::make_unique<GrnMuscles>(network, body, tissue, parameters);
}

double ramp(int t, const Parameters &parameters) {
    return std::min(1.0, static_cast<double>(t) / parameters.ramp_steps);
}

} // namespace planula
