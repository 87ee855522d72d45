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

NetworkShape shape_of(Actuation actuation) {
    return {input::count, output::count(actuation), is_recurrent(actuation)};
}

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

void run(const Spec &spec, std::uint64_t seed, int threads, const Observer &observe,
         const StopRequest &stop) {
    const Parameters &p = spec.parameters;
    const NetworkShape shape = shape_of(spec.actuation);
    const auto search = make_search(spec.search, p);
    Population population = initial_population(shape, p, seed);
    for (;;) {
        const std::vector<Life> lives = live_all(spec, population, threads, stop);
        const std::vector<Evaluation> evaluations = judge_all(spec, lives);
        const std::vector<double> scores = search->score(population, evaluations);
        observe(
            {population.generation, population, lives, evaluations, scores, *search, fittest(evaluations)});
        if (population.generation + 1 >= p.generations) return;
        population = search->next(population, scores, shape, seed);
    }
}

} // namespace planula
