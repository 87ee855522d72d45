// SPDX-License-Identifier: MIT
#include "evolution/aims.h"

#include "base/check.h"
#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>

namespace planula {

const char *name_of(Objective::Goal goal) {
    return goal == Objective::Goal::maximise ? "maximise" : "minimise";
}

int niche_of(const DescriptorNumber &number, double value) {
    const double place = std::floor((value - number.from) / (number.to - number.from) * number.cells);
    return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(number.cells - 1)));
}

std::size_t Aims::stated() const {
    return static_cast<std::size_t>(
        std::count_if(objectives.begin(), objectives.end(), [](const Objective &objective) {
            return objective.value == Objective::Value::stated;
        }));
}

std::vector<std::string> Aims::stated_titles() const {
    std::vector<std::string> titles;
    for (const Objective &objective : objectives)
        if (objective.value == Objective::Value::stated)
            titles.push_back(std::string(objective_prefix) + objective.name);
    return titles;
}

std::vector<double> worths(std::span<const Objective> objectives, double fitness, double novelty,
                           std::span<const double> stated) {
    std::vector<double> result;
    std::size_t next = 0;
    for (const Objective &objective : objectives) {
        double value = objective.value == Objective::Value::fitness ? fitness : novelty;
        if (objective.value == Objective::Value::stated) {
            CHECK(next < stated.size(), objective.name);
            value = stated[next++];
        }
        result.push_back(objective.goal == Objective::Goal::maximise ? value : -value);
    }
    return result;
}

void check_objectives(std::span<const Evaluation> evaluations, std::size_t count) {
    for (const Evaluation &evaluation : evaluations) {
        if (!evaluation.valid()) continue;
        if (evaluation.objectives.size() != count)
            throw InputError("a valid individual has " + to_text(std::int64_t(count)) + " objectives, but " +
                             to_text(std::int64_t(evaluation.objectives.size())) + " were given");
        for (const double value : evaluation.objectives)
            if (!std::isfinite(value))
                throw InputError("an objective must be finite, but " + to_text(value) + " was given");
    }
}

} // namespace planula
