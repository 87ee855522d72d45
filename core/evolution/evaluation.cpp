// SPDX-License-Identifier: MIT
#include "evolution/evaluation.h"

#include "base/error.h"
#include "base/text.h"

#include <cmath>

namespace planula {

namespace {

void check_behaviour(const std::vector<double> &behaviour, std::size_t &length) {
    if (behaviour.empty()) throw InputError("this search needs a behaviour, and a valid individual has none");
    if (length == 0) length = behaviour.size();
    if (behaviour.size() != length)
        throw InputError("all behaviours of a run have one length, but " + to_text(std::int64_t(length)) +
                         " and " + to_text(std::int64_t(behaviour.size())) + " numbers were given");
    for (const double value : behaviour)
        if (!std::isfinite(value))
            throw InputError("a behaviour must be finite, but " + to_text(value) + " was given");
}

} // namespace

void check_behaviours(std::span<const Evaluation> evaluations, std::size_t &length) {
    for (const Evaluation &evaluation : evaluations)
        if (evaluation.valid()) check_behaviour(evaluation.behaviour, length);
}

void save(const Evaluation &evaluation, StateWriter &writer) {
    writer.real(evaluation.fitness).real(evaluation.penalty);
    writer.integer(static_cast<std::int64_t>(evaluation.behaviour.size()));
    for (const double value : evaluation.behaviour) writer.real(value);
}

Evaluation load_evaluation(StateReader &reader) {
    Evaluation evaluation;
    evaluation.fitness = reader.finite();
    if (evaluation.fitness < 0) reader.refuse("a fitness is below 0");
    evaluation.penalty = reader.finite();
    if (evaluation.penalty < 0 || evaluation.penalty > 1) reader.refuse("a penalty is not within 0 and 1");
    evaluation.behaviour.resize(reader.count());
    for (double &value : evaluation.behaviour) value = reader.finite();
    return evaluation;
}

} // namespace planula
