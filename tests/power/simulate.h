// SPDX-License-Identifier: MIT
// How often the tests of the paper's claims (experiments/paper/tests.lua) say what, on runs whose truth is known,
// because they are drawn and not evolved. Without a difference that is the size of a test, with one its power. And how
// often an interval that is said to cover the truth in 95 of 100 cases does.
//
// Everything is drawn from streams (number of the case; repetition, 0, sampling): the same table on any machine.
#pragma once

#include <string>
#include <vector>

namespace planula::power {

/// The runs of one case: which claim is judged on what truth.
struct Outcome {
    std::string test, truth;
    int runs = 0; // of each setting
    int repetitions = 0;
    double reproduced = 0, contradicted = 0; // shares of the repetitions
    // The same with `family` times p below the significance: Holm's correction if no other p of the table is small.
    double reproduced_corrected = 0, contradicted_corrected = 0;
};

struct Coverage {
    std::string interval, values;
    int runs = 0, repetitions = 0;
    double covered = 0; // share of the intervals that hold the truth
};

/// The p-values in the paper's table of claims: 34 of a difference and 11 of equivalence.
inline constexpr int family = 45;

/// Every test with and without a difference, 20 runs of each setting.
std::vector<Outcome> outcomes(int repetitions);

/// Bootstrap intervals of the mean and of A12 for few and for many runs.
std::vector<Coverage> coverages(int repetitions);

} // namespace planula::power
