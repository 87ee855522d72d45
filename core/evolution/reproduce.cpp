// SPDX-License-Identifier: MIT
#include "evolution/reproduce.h"

#include "base/check.h"
#include "evolution/breed.h"
#include "evolution/species.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace planula {

namespace {

/// Members by score, species by the best score before this generation, highest first; equals keep their order.
std::vector<Species> ranked(std::vector<Species> species, std::span<const double> scores) {
    for (auto &each : species)
        std::stable_sort(each.members.begin(), each.members.end(),
                         [&](int a, int b) { return scores[a] > scores[b]; });
    std::stable_sort(species.begin(), species.end(),
                     [](const Species &a, const Species &b) { return a.best_ever > b.best_ever; });
    return species;
}

/// One generation passes. The mark of the best species goes to the first that holds the population's record; a species
/// that loses it becomes young again.
void grow_older(double record, std::vector<Species> &species) {
    const auto holder = std::find_if(species.begin(), species.end(),
                                     [&](const Species &each) { return each.best_ever >= record; });
    for (auto each = species.begin(); each != species.end(); ++each) {
        ++each->age;
        ++each->stagnation;
        if (each->best && each != holder) each->age = each->stagnation = 0;
        each->best = each == holder;
    }
}

/// A rise of the best score ends stagnation.
void note_best(std::span<const double> scores, const NeatParameters &parameters,
               std::vector<Species> &species) {
    for (auto &each : species) {
        const double best = std::max(scores[each.members.front()], parameters.fitness_floor);
        if (best <= each.best_ever) continue;
        each.best_ever = best;
        each.stagnation = 0;
    }
}

/// What the scores of this species' members are multiplied by before offspring is shared out.
double worth(const Species &species, Adjustment adjustment, const NeatParameters &parameters) {
    double factor = 1;
    if (adjustment == Adjustment::none) return factor;
    if (species.age < parameters.young_age) factor *= parameters.young_boost;
    if (species.age > parameters.old_age) factor *= parameters.old_penalty;
    if (species.stagnation > parameters.stagnation_limit && !species.best)
        factor *= parameters.stagnation_penalty;
    return adjustment == Adjustment::age ? factor : factor / static_cast<double>(species.members.size());
}

/// The adjusted score of each species: the sum over its members.
std::vector<double> adjusted_scores(const std::vector<Species> &species, std::span<const double> scores,
                                    Adjustment adjustment, const NeatParameters &parameters) {
    std::vector<double> adjusted;
    for (const auto &each : species) {
        const double factor = worth(each, adjustment, parameters);
        double sum = 0;
        for (const int member : each.members)
            sum += factor * (scores[member] > 0 ? scores[member] : parameters.fitness_floor);
        adjusted.push_back(sum);
    }
    return adjusted;
}

/// The number of children of each species: its share of the population, halves rounded up.
std::vector<int> quotas(const std::vector<double> &adjusted, int population) {
    const double total = std::accumulate(adjusted.begin(), adjusted.end(), 0.0);
    CHECK(total > 0 && std::isfinite(total), total);
    std::vector<int> result;
    for (const double share : adjusted)
        result.push_back(static_cast<int>(std::floor(population * (share / total) + 0.5)));
    return result;
}

double moved_threshold(double threshold, std::size_t species, const NeatParameters &parameters) {
    const int count = static_cast<int>(species);
    if (count > parameters.species_high) threshold += parameters.compatibility_step;
    if (count < parameters.species_low) threshold -= parameters.compatibility_step;
    return std::max(threshold, parameters.compatibility_floor);
}

/// The next generation before any birth: the same species, empty, and a threshold that keeps their number in its range.
Population heir(const Population &population, std::span<const double> scores,
                const std::vector<Species> &species, const NeatParameters &parameters) {
    Population next;
    next.generation = population.generation + 1;
    next.species = species;
    for (auto &each : next.species) each.members.clear();
    next.threshold = moved_threshold(population.threshold, species.size(), parameters);
    next.best_ever = std::max(population.best_ever, *std::max_element(scores.begin(), scores.end()));
    next.next_genome = population.next_genome;
    next.next_species = population.next_species;
    next.innovations = population.innovations;
    return next;
}

} // namespace

Population reproduce(const Population &population, std::span<const double> scores, Adjustment adjustment,
                     bool recurrent, const NeatParameters &parameters, std::uint64_t seed) {
    CHECK(scores.size() == population.genomes.size(), scores.size(), population.genomes.size());
    CHECK(std::all_of(scores.begin(), scores.end(), [](double s) { return s >= 0 && std::isfinite(s); }));

    // Rank, age and judge the species by what was known before this generation, then by its scores.
    std::vector<Species> species = ranked(population.species, scores);
    grow_older(population.best_ever, species);
    note_best(scores, parameters, species);
    const std::vector<double> adjusted = adjusted_scores(species, scores, adjustment, parameters);
    const std::vector<int> quota = quotas(adjusted, parameters.population);

    // Each species breeds its champion, then its quota; a surplus from rounding is never born.
    Population next = heir(population, scores, species, parameters);
    const Parents parents{population.genomes, scores, species};
    for (std::size_t each = 0; each < species.size(); ++each)
        for (int child = 0; child < quota[each]; ++child) {
            const std::size_t birth = next.genomes.size();
            if (static_cast<int>(birth) == parameters.population) break;
            Stream stream(seed, next.generation, static_cast<std::uint32_t>(birth), Purpose::reproduction);
            add_child(parameters, next,
                      child == 0 ? copy_champion(parents, species[each])
                                 : breed(parents, species[each], next.genomes, recurrent, parameters,
                                         next.innovations, stream));
        }
    complete_generation(parameters.population, next);
    return next;
}

} // namespace planula
