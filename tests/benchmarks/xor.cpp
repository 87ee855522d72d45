// SPDX-License-Identifier: MIT
#include "benchmarks/xor.h"

#include <array>
#include <cmath>

namespace planula::benchmark {

Attempt attempt_xor(Policy policy) {
    Attempt attempt{.solved = true};
    double error = 0;
    for (const int a : {0, 1})
        for (const int b : {0, 1}) {
            const std::array<double, 3> inputs{double(a), double(b), 1};
            double output = 0;
            policy(inputs, {&output, 1});
            output = (output + 1) / 2;
            const int target = a ^ b;
            error += std::abs(output - target);
            attempt.solved = attempt.solved && (target ? output > 0.5 : output < 0.5);
            attempt.behaviour.push_back(output);
        }
    attempt.fitness = (4 - error) * (4 - error);
    return attempt;
}

Task xor_task() {
    return {
        "xor", {3, 1, false}, [](const Genome &genome) { return attempt_xor(Controller(genome, false)); }};
}

} // namespace planula::benchmark
