// SPDX-License-Identifier: MIT
#include "experiment/lives.h"

#include "base/check.h"
#include "base/error.h"
#include "base/text.h"

#include <cmath>

namespace planula {

std::vector<Life> live_all(const Population &population, const LifeOf &life_of, const Workers &workers,
                           const StopRequest &stop) {
    std::vector<Life> lives(population.genomes.size());
    workers.each(static_cast<int>(lives.size()), [&](int slot) {
        if (stop()) throw Stopped("stopped in generation " + to_text(population.generation));
        lives[slot] = life_of(slot, population.genomes[slot]);
    });
    return lives;
}

std::vector<Evaluation> judge_all(const Judge &judge, std::span<const Life> lives) {
    std::vector<Evaluation> evaluations;
    for (const Life &life : lives) {
        evaluations.push_back(judge(life));
        const Evaluation &e = evaluations.back();
        CHECK(std::isfinite(e.fitness) && e.fitness >= 0, e.fitness);
        CHECK(e.penalty >= 0 && e.penalty <= 1, e.penalty);
    }
    return evaluations;
}

} // namespace planula
