// SPDX-License-Identifier: MIT
#include "experiment/run.h"

#include "experiment/start.h"

#include <algorithm>

namespace planula {

namespace {

int fittest(const std::vector<Evaluation> &evaluations) {
    const auto less = [](const Evaluation &a, const Evaluation &b) { return a.fitness < b.fitness; };
    return static_cast<int>(std::max_element(evaluations.begin(), evaluations.end(), less) -
                            evaluations.begin());
}

} // namespace

RunState begin(const Spec &spec, std::uint64_t seed, const Workers &workers, const StopRequest &stop) {
    return {first_population(spec, seed, workers, stop),
            make_search(spec.search, spec.parameters, spec.aims),
            {}};
}

void run(const Spec &spec, std::uint64_t seed, const Workers &workers, RunState &state,
         const Observer &observe, const StateObserver &observe_state, const StopRequest &stop) {
    const Parameters &p = spec.parameters;
    const NetworkShape shape = shape_of(spec.actuation);
    Memo memo(spec);
    const LifeOf life_of = [&](int slot, const Genome &genome) { return memo.live(slot, genome); };
    Population &population = state.population;
    for (;;) {
        memo.begin_generation(static_cast<int>(population.genomes.size()));
        const std::vector<Life> lives = live_all(population, life_of, workers, stop);
        const std::vector<Evaluation> evaluations = judge_all(spec.judge, lives);
        const std::vector<double> scores = state.search->score(population, evaluations);
        observe({population.generation, population, lives, evaluations, scores, *state.search, state.mothers,
                 fittest(evaluations), memo.known()});
        if (population.generation + 1 >= p.design.generations) return;
        state.mothers.add(population, lives, evaluations);
        population = state.search->next(population, scores, shape, seed);
        state.mothers.keep(population, state.search->kept_genomes());
        observe_state(state);
    }
}

void run(const Spec &spec, std::uint64_t seed, const Workers &workers, const Observer &observe,
         const StopRequest &stop) {
    RunState state = begin(spec, seed, workers, stop);
    run(
        spec, seed, workers, state, observe, [](const RunState &) {}, stop);
}

} // namespace planula
