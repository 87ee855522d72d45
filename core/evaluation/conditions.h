// SPDX-License-Identifier: MIT
// Everything that a life depends on besides its genome.
#pragma once

#include "cell/channels.h"
#include "parameters/parameters.h"
#include "physics/environment.h"

#include <string>

namespace planula {

struct Conditions {
    Actuation actuation = Actuation::oscillator;
    double actuation_range = 0; // largest change of a rest length when both cells agree (§2.5)
    Environment environment;
    std::string engine = "native"; // a name of make_engine()
    int refinement = 1;            // locomotion takes so many physics steps for each of the parameters'
    Parameters parameters;
};

/// The parameters of locomotion with every physics step cut into `refinement`: the time step shrinks and all
/// durations keep their time. Development has its own step and is not refined.
Parameters refined(Parameters parameters, int refinement);

} // namespace planula
