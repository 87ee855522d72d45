// SPDX-License-Identifier: MIT
#include "benchmarks/solve.h"

#include "evolution/search.h"

namespace planula::benchmark {

Solution solve(const Task &task, std::string_view search, const Parameters &parameters, std::uint64_t seed,
               int generations) {
    const auto searching = make_search(search, parameters);
    Population population = initial_population(task.shape, parameters.neat, seed);
    std::int64_t evaluations = 0;
    double examined = 0; // fitness of the last that was
    for (int generation = 1;; ++generation) {
        std::vector<Evaluation> attempts;
        for (const Genome &genome : population.genomes) {
            const Attempt attempt = task.attempt(genome);
            ++evaluations;
            if (attempt.solved) return {true, generation, evaluations};
            attempts.push_back({attempt.fitness, attempt.behaviour, 1});
        }

        // A champion is not examined again.
        const auto best =
            std::max_element(attempts.begin(), attempts.end(),
                             [](const Evaluation &a, const Evaluation &b) { return a.fitness < b.fitness; });
        if (task.examine && best->fitness != examined) {
            examined = best->fitness;
            if (task.examine(population.genomes[static_cast<std::size_t>(best - attempts.begin())]))
                return {true, generation, evaluations};
        }
        if (generation == generations) return {false, generation, evaluations};
        const std::vector<double> scores = searching->score(population, attempts);
        population = searching->next(population, scores, task.shape, seed);
    }
}

} // namespace planula::benchmark
