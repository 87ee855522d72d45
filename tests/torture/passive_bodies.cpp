// SPDX-License-Identifier: MIT
// passive_bodies COUNT: drops the bodies of COUNT random genomes and gives them ten times as long as an evaluation
// does to come to rest. Prints how many there are and how many are late or never rest; exits 1 if
// more than 0.2 % keep moving.
#include "base/parallel.h"
#include "base/text.h"
#include "support/passive.h"

#include <cstdio>
#include <mutex>

using namespace planula;
using namespace planula::specimens;

int main(int argc, char **argv) {
    const auto count = parse_int(argc == 2 ? argv[1] : "");
    if (!count || *count < 1 || *count > 100'000'000) {
        std::fputs("usage: passive_bodies COUNT, from 1 to 100000000\n", stderr);
        return 2;
    }

    constexpr double most_moving = 0.002;
    const int in_time = Parameters{}.settling.settle_limit, patience = 10 * in_time;
    std::mutex writing;
    int bodies = 0, late = 0, moving = 0;
    parallel_for(static_cast<int>(*count), hardware_threads(), [&](int number) {
        const Actuation actuation = number % 2 == 0 ? Actuation::oscillator : Actuation::grn;
        const auto rest = drop(actuation, static_cast<std::uint64_t>(number / 2), patience);
        if (!rest) return;
        const std::lock_guard lock(writing);
        ++bodies;
        moving += rest->moving;
        late += !rest->moving && rest->steps > in_time;
    });
    const double share = bodies > 0 ? static_cast<double>(moving) / bodies : 0;
    std::printf("passive_bodies: %d bodies, %d came to rest late, %d keep moving (%s %%)\n", bodies, late,
                moving, to_fixed(100 * share, 3).c_str());
    return share > most_moving;
}
