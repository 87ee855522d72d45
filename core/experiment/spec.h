// SPDX-License-Identifier: MIT
// What was asked: one setting of an experiment, complete. A setting with a seed is a run.
#pragma once

#include "evaluation/conditions.h"
#include "evaluation/life.h"
#include "evolution/aims.h"
#include "evolution/evaluation.h"
#include "evolution/population.h"
#include "experiment/sample.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace planula {

/// The experiment's judgement of a finished life: fitness, behaviour and penalty (Eqs. 4 and 6).
using Judge = std::function<Evaluation(const Life &)>;

/// How generation 0 is evolved before the run: by some generations of novelty search on growth alone. The
/// judge is shown lives that end with development; their fitness is not read.
struct Start {
    int generations = 1;
    Judge judge;
};

/// A function of the judge by what it computes: functions of equal hashes give equal results. A function's text without
/// comments and layout decides, and whatever it reaches: values, tables, other functions.
struct FunctionMeaning {
    std::string name;   // "fitness", "penalty", "behaviour", "start.behaviour", "objective <name>"
    std::string sha256; // of the meaning
    std::string place;  // "file.lua:12", for messages; no part of the meaning
};

/// The conditions of every life, and how evolution goes. `parameters` hold population, generations and all else.
struct Spec : Conditions {
    std::string name;            // of the setting: file-name characters, unique in its experiment
    std::string title;           // for people
    std::string search = "neat"; // a name of evolution/searches.inl
    Aims aims;                   // what it is to aim at, beside fitness and behaviour
    Judge judge;                 // called on the main thread, in slot order
    std::optional<Start> start;  // none: generation 0 is random
    Recording record;
    /// Of each number of the environment that the experiment takes from a parameter (experiment/world_numbers.h) the
    /// parameter's name; no part of the conditions.
    std::map<std::string, std::string, std::less<>> world_sources;
    std::vector<FunctionMeaning>
        judgement; // what decides the results of `judge` and of the start's; may be empty
};

/// The networks that animats with this actuation have.
NetworkShape shape_of(Actuation actuation);

/// Throws InputError with the rule and the value if `name`, which is that of `what` ("a setting"), cannot name a
/// folder: it is 1 to 100 letters, digits, '-' and '_'.
void check_name(const std::string &what, const std::string &name);

/// Throws InputError with the rule and the value: an empty or unsafe name, an unknown search or engine, a
/// bad environment, inconsistent parameters, a range outside 0 … 0.9, no judge, an empty start, aims that the search
/// cannot have, bad names or ranges of these.
void check_spec(const Spec &spec);

} // namespace planula
