// SPDX-License-Identifier: MIT
#include "experiment/start.h"

#include "base/random.h"
#include "evaluation/live.h"
#include "evolution/novelty_search.h"
#include "evolution/species.h"

#include <utility>

namespace planula {

namespace {

/// The seed of all that comes before generation 0.
std::uint64_t seed_before(std::uint64_t seed) {
    Stream stream(seed, 0, 0, Purpose::start);
    const std::uint64_t high = stream.bits();
    return high << 32 | stream.bits();
}

/// The last generation of novelty search among bodies.
Population diverse_bodies(const Spec &spec, std::uint64_t seed, const Workers &workers,
                          const StopRequest &stop) {
    const NetworkShape shape = shape_of(spec.actuation);
    NoveltySearch search(spec.parameters);
    Population population = initial_population(shape, spec.parameters.neat, seed);
    const LifeOf grown = [&](int, const Genome &genome) { return develop(genome, spec); };
    while (population.generation < spec.start->generations) {
        const std::vector<Life> lives = live_all(population, grown, workers, stop);
        const auto scores = search.score(population, judge_all(spec.start->judge, lives));
        population = search.next(population, scores, shape, seed);
    }
    return population;
}

/// These genomes as the first of a run.
Population as_first(Population last, const NeatParameters &parameters) {
    Population first;
    first.threshold = parameters.compatibility_threshold;
    first.innovations = std::move(last.innovations);
    for (Genome &genome : last.genomes) {
        genome.mother = genome.father = -1;
        genome.origin = Origin::initial;
        add_child(parameters, first, std::move(genome));
    }
    complete_generation(parameters.population, first);
    return first;
}

} // namespace

Population first_population(const Spec &spec, std::uint64_t seed, const Workers &workers,
                            const StopRequest &stop) {
    if (!spec.start) return initial_population(shape_of(spec.actuation), spec.parameters.neat, seed);
    return as_first(diverse_bodies(spec, seed_before(seed), workers, stop), spec.parameters.neat);
}

} // namespace planula
