// SPDX-License-Identifier: MIT
// random_cases COUNT: compares distance, crossover, species and novelty with a simple implementation of the same
// rules, in COUNT random cases each. Prints each case in which they disagree; exits 1 if there is one.
#include "base/text.h"
#include "core/evolution/obvious.h"

#include <cstdio>

using namespace planula;

int main(int argc, char **argv) {
    const auto count = parse_int(argc == 2 ? argv[1] : "");
    if (!count || *count < 1 || *count > 1'000'000'000) {
        std::fputs("usage: random_cases COUNT, from 1 to 1000000000\n", stderr);
        return 2;
    }

    obvious::Coins coins;
    int flawed = 0;
    for (std::uint32_t number = 0; number < static_cast<std::uint32_t>(*count); ++number)
        for (const std::string &wrong :
             {obvious::compare_distance(number), obvious::compare_crossing(number, coins),
              obvious::compare_species(number), obvious::compare_novelty(number)})
            if (!wrong.empty()) {
                ++flawed;
                std::printf("random_cases: case %u disagrees in %s\n", number, wrong.c_str());
            }
    std::printf("random_cases: %d cases of four rules, %d disagree; %d of %d coins and %d of %d genes fell "
                "to the mother\n",
                static_cast<int>(*count), flawed, coins.of_mother, coins.all, coins.gene_of_mother,
                coins.genes);
    return flawed != 0;
}
