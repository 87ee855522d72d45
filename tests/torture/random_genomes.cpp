// SPDX-License-Identifier: MIT
// random_genomes COUNT: simulates COUNT hostile genomes, each in both worlds, half of them with each actuation.
// Prints how they ended and each result that is not finite; exits 1 if there is one.
#include "base/parallel.h"
#include "base/text.h"
#include "support/hostile.h"

#include <array>
#include <cstdio>
#include <mutex>

using namespace planula;
using namespace planula::specimens;

int main(int argc, char **argv) {
    const auto count = parse_int(argc == 2 ? argv[1] : "");
    if (!count || *count < 1 || *count > 100'000'000) {
        std::fputs("usage: random_genomes COUNT, from 1 to 100000000\n", stderr);
        return 2;
    }

    // The four combinations of actuation and world in turn.
    std::mutex writing;
    std::array<int, outcome_names.size()> ends{};
    int flawed = 0;
    parallel_for(static_cast<int>(*count), hardware_threads(), [&](int number) {
        const Conditions conditions = short_life(number % 4);
        const Genome genome = hostile_genome(conditions.actuation, static_cast<std::uint32_t>(number / 4));
        const Life life = live(genome, conditions);
        const std::string wrong = flaw(life, conditions.parameters);
        const std::lock_guard lock(writing);
        if (wrong.empty()) {
            ++ends[static_cast<std::size_t>(life.outcome)];
        } else {
            ++flawed;
            std::printf("random_genomes: %s genome %d on %s: %s\n", name_of(conditions.actuation), number / 4,
                        conditions.environment.has_ground ? "land" : "water", wrong.c_str());
        }
    });

    std::printf("random_genomes:");
    for (std::size_t i = 0; i < ends.size(); ++i) std::printf(" %d %s,", ends[i], outcome_names[i]);
    std::printf(" %d flawed\n", flawed);
    return flawed != 0;
}
