// SPDX-License-Identifier: MIT
#include "experiment/run.h"

#include "base/check.h"
#include "base/error.h"
#include "base/parallel.h"
#include "evaluation/live.h"

#include <algorithm>
#include <cmath>

namespace planula {

namespace {

/// Every individual's life, in parallel: lives are pure and share nothing.
std::vector<Life> live_all(const Spec &spec, const Population &population, int threads,
                           const StopRequest &stop) {
    std::vector<Life> lives(population.genomes.size());
    parallel_for(static_cast<int>(lives.size()), threads, [&](int slot) {
        if (stop()) throw Stopped("stopped in generation " + std::to_string(population.generation));
        lives[slot] = live(population.genomes[slot], spec);
    });
    return lives;
}

std::vector<Evaluation> judge_all(const Spec &spec, const std::vector<Life> &lives) {
    std::vector<Evaluation> evaluations;
    for (const Life &life : lives) {
        evaluations.push_back(spec.judge(life));
        const Evaluation &e = evaluations.back();
        CHECK(std::isfinite(e.fitness) && e.fitness >= 0, e.fitness);
        CHECK(e.penalty >= 0 && e.penalty <= 1, e.penalty);
    }
    return evaluations;
}

int fittest(const std::vector<Evaluation> &evaluations) {
    const auto less = [](const Evaluation &a, const Evaluation &b) { return a.fitness < b.fitness; };
    return static_cast<int>(std::max_element(evaluations.begin(), evaluations.end(), less) -
                            evaluations.begin());
}

} // namespace

RunState begin(const Spec &spec, std::uint64_t seed) {
    return {initial_population(shape_of(spec.actuation), spec.parameters, seed),
            make_search(spec.search, spec.parameters)};
}

void run(const Spec &spec, std::uint64_t seed, int threads, RunState &state, const Observer &observe,
         const Between &between, const StopRequest &stop) {
    const Parameters &p = spec.parameters;
    const NetworkShape shape = shape_of(spec.actuation);
    Population &population = state.population;
    for (;;) {
        const std::vector<Life> lives = live_all(spec, population, threads, stop);
        const std::vector<Evaluation> evaluations = judge_all(spec, lives);
        const std::vector<double> scores = state.search->score(population, evaluations);
        observe({population.generation, population, lives, evaluations, scores, *state.search,
                 fittest(evaluations)});
        if (population.generation + 1 >= p.generations) return;
        population = state.search->next(population, scores, shape, seed);
        between(state);
    }
}

void run(const Spec &spec, std::uint64_t seed, int threads, const Observer &observe,
         const StopRequest &stop) {
    RunState state = begin(spec, seed);
    run(
        spec, seed, threads, state, observe, [](const RunState &) {}, stop);
}

} // namespace planula
