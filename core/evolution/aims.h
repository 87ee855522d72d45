// SPDX-License-Identifier: MIT
// What an experiment states of a search's aims beside fitness and behaviour: a list of objectives, and the names and
// ranges of the numbers in a descriptor (decision 0027). Without either, each search does as its own file says.
#pragma once

#include "evolution/evaluation.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

struct Objective {
    enum class Value { stated, fitness, novelty }; // stated: a function of the experiment's
    enum class Goal { maximise, minimise };
    std::string name;
    Value value = Value::stated;
    Goal goal = Goal::maximise;
};
const char *name_of(Objective::Goal goal);
/// What stands before the names in the titles of columns.
inline constexpr std::string_view objective_prefix = "objective_", behaviour_prefix = "behaviour_";

/// A number of the descriptor. The range is divided into as many niches, `cells`; 0: no range is stated.
struct DescriptorNumber {
    std::string name;
    double from = 0, to = 0;
    int cells = 0;
};

/// The niche of a value, 0 … cells − 1. What lies outside the range belongs to the first or the last; an edge between
/// two to the upper one.
int niche_of(const DescriptorNumber &number, double value);

struct Aims {
    std::vector<Objective> objectives;
    std::vector<DescriptorNumber> descriptor;

    /// The objectives that are functions of the experiment's, whose values an Evaluation has in this order.
    std::size_t stated() const;
    /// The titles of their columns.
    std::vector<std::string> stated_titles() const;
};

/// What each objective is worth to a search, higher being better: its value, or minus that if it is minimised. `stated`:
/// the values of Aims::stated().
std::vector<double> worths(std::span<const Objective> objectives, double fitness, double novelty,
                           std::span<const double> stated);

/// Throws InputError unless each valid individual has this number of objectives, all finite.
void check_objectives(std::span<const Evaluation> evaluations, std::size_t count);

} // namespace planula
