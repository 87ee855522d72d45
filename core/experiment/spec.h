// SPDX-License-Identifier: MIT
// What was asked: one setting of an experiment, complete. A setting with a seed is a run.
#pragma once

#include "cell/channels.h"
#include "evaluation/life.h"
#include "evolution/evaluation.h"
#include "parameters/parameters.h"
#include "physics/environment.h"

#include <functional>
#include <string>
#include <vector>

namespace planula {

/// The experiment's judgement of a finished life: fitness, behaviour and penalty (Eqs. 4 and 6).
using Judge = std::function<Evaluation(const Life &)>;

struct Spec {
    std::string name;  // of the setting: file-name characters, unique in its experiment
    std::string title; // for people
    Actuation actuation = Actuation::oscillator;
    double actuation_range = 0;  // largest change of a rest length when both cells agree (§2.5)
    std::string search = "neat"; // a name of make_search()
    Environment environment;
    Parameters parameters; // population, generations and all others
    Judge judge;           // called on the main thread, in slot order
};

/// Throws InputError with the rule and the value: an empty or unsafe name, an unknown search, a bad
/// environment, inconsistent parameters, a range outside 0 … 0.9, no judge.
void check_spec(const Spec &spec);

} // namespace planula
