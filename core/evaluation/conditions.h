// SPDX-License-Identifier: MIT
// Everything that a life depends on beside its genome.
#pragma once

#include "body/damage.h"
#include "cell/channels.h"
#include "evaluation/observations.h"
#include "locomotion/course.h"
#include "parameters/parameters.h"
#include "physics/environment.h"

#include <optional>
#include <string>
#include <vector>

namespace planula {

/// A disturbance of a body before locomotion: each node is displaced by up to `reach` cells along x and along y, by a
/// hash of its number and `number`. Shows how sensitive a life is to small differences.
struct Nudge {
    double reach = 0;
    int number = 0;
};

struct Conditions {
    Actuation actuation = Actuation::oscillator;
    double actuation_range = 0; // largest change of a rest length when both cells agree (§2.5)
    Environment environment;
    std::vector<Phase> phases; // further worlds, in the order in which the body comes into them
    std::optional<Damage> damage;
    std::string engine = "native"; // a name of make_engine()
    int refinement = 1;            // the number of physics steps of locomotion for each of the parameters'
    Nudge nudge;                   // none in any evolution
    std::optional<int>
        held_from;           // the muscles hold still from this step of locomotion on; none in any evolution
    ObservationSet observed; // what lives tell beside their fields; decides none of these
    Parameters parameters;
};

/// Throws InputError with the rule and the value: a phase or a damage that does not begin with a knot of locomotion
/// before its end, phases that do not ascend, one that settles without gravity, and what check_environment() and
/// check_damage() say.
void check_course(const Conditions &conditions);

/// The parameters of locomotion with every physics step cut into `refinement`: the time step shrinks and all
/// durations keep their time. Development has its own step and is not refined.
Parameters refined(Parameters parameters, int refinement);

} // namespace planula
