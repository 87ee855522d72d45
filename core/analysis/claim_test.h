// SPDX-License-Identifier: MIT
// The tests by which claims are judged: claim_tests() in analysis/analysis.h says what each of them does. A
// test looks at the histories of one or two settings after a number of generations and does not know what may
// be missing in them.
#pragma once

#include "analysis/analysis.h"
#include "analysis/survey.h"

#include <string>
#include <string_view>

namespace planula {

/// The input of a test: two samples of runs after the same number of generations.
struct Case {
    const Claim &claim;
    const Analysis &analysis;
    const SettingRuns *a, *b; // b: null for tests of one setting
    int generations;
};

/// What a test says.
struct Finding {
    std::string effect_name;
    Maybe effect, low, high; // low and high: of the bootstrap interval, none with too few runs
    Maybe p;                 // of a difference, or of a count
    std::string method;      // how p was computed: exact, normal or drawn
    Maybe p_equivalence;     // of no difference beyond the claim's bound
    std::string verdict, note;
};

struct ClaimTest {
    std::string_view name;
    /// What of a claim the test uses: `expect`, of no difference also `bound`, and two settings; `level` and two;
    /// `count` and two; or `level`, `count`, `bound` and setting a alone.
    enum Needs { ranks, level_of_two, count_of_two, count_of_one } needs;
    Finding (*judge)(const Case &);

    bool compares_two() const { return needs != count_of_one; }
};

/// The test of that name, or null.
const ClaimTest *find_test(std::string_view name);

/// The verdict of a rank-sum test, from its p and its effect A12; expecting no difference, from both of its p.
std::string rank_verdict(std::string_view expect, const Finding &finding, double significance);

/// The verdict on `count` runs that were all expected, of which at least `least` and at most `most` are there.
std::string top_verdict(int least, int most, int count, double p, double significance);

} // namespace planula
