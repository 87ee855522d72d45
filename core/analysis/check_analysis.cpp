// SPDX-License-Identifier: MIT
#include "analysis/claim_test.h"
#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace planula {

namespace {

constexpr std::array<std::string_view, 3> expectations{"greater", "less", "no_difference"};

std::string unknown_name(const std::string &name, const std::string &nearest) {
    return "'" + name + "'" + (nearest.empty() ? "" : "; did you mean '" + nearest + "'?");
}

void require_setting(const std::string &name, const std::string &where, std::span<const Spec> settings) {
    std::vector<std::string> names;
    for (const Spec &spec : settings) names.push_back(spec.name);
    if (std::find(names.begin(), names.end(), name) == names.end())
        throw InputError(where + ": there is no setting " + unknown_name(name, nearest_name(name, names)));
}

/// A claim that nothing differs states what is still as good as no difference; no other claim has a use for that.
void check_bound(const Claim &claim, const ClaimTest &test, const std::string &where) {
    const bool of_ranks = test.needs == ClaimTest::ranks && claim.expect == "no_difference";
    const bool of_runs = test.needs == ClaimTest::count_of_one;
    const double highest = of_ranks ? 0.5 : 1;
    if (!of_ranks && !of_runs && claim.bound != 0)
        throw InputError(where + ": bound = " + to_text(claim.bound) +
                         " is of no use: only no_difference and cyclic have one");
    if ((of_ranks || of_runs) && !(claim.bound > 0 && claim.bound < highest))
        throw InputError(
            where + ": bound = " + to_text(claim.bound) + " must be above 0 and below " + to_text(highest) +
            (of_ranks ? ", how far A12 may be from 1/2" : ", the share of runs without a lasting gait"));
}

void check_claim(const Claim &claim, std::span<const Spec> settings) {
    const std::string where = "claim '" + claim.id + "'";
    const ClaimTest *test = find_test(claim.test);
    if (test == nullptr)
        throw InputError(where + ": there is no test " +
                         unknown_name(claim.test, nearest_name(claim.test, claim_tests())));
    require_setting(claim.a, where, settings);
    if (test->compares_two()) require_setting(claim.b, where, settings);
    if (claim.generation < 0)
        throw InputError(where + ": generation = " + to_text(claim.generation) + " must be at least 0");
    if (test->needs == ClaimTest::ranks &&
        std::find(expectations.begin(), expectations.end(), claim.expect) == expectations.end())
        throw InputError(where + ": expect must be greater, less or no_difference, and is " +
                         unknown_name(claim.expect, nearest_name(claim.expect, expectations)));
    check_bound(claim, *test, where);
    if (test->needs == ClaimTest::count_of_two && claim.count < 1)
        throw InputError(where + ": count = " + to_text(claim.count) + " must be at least 1");
    if (test->needs == ClaimTest::level_of_two && !(claim.level > 0 && claim.level <= 1))
        throw InputError(where + ": level = " + to_text(claim.level) + " must be above 0 and at most 1");
    if (test->needs == ClaimTest::count_of_one && !(claim.level > 0 && claim.count >= 0))
        throw InputError(where + ": level = " + to_text(claim.level) +
                         " must be above 0, count = " + to_text(claim.count) + " at least 0");
}

void require_share(double value, const char *name) {
    if (!(value > 0 && value <= 1))
        throw InputError(std::string("statistics: ") + name + " = " + to_text(value) +
                         " must be above 0 and at most 1");
}

} // namespace

void check_analysis(const Analysis &analysis, std::span<const Spec> settings) {
    require_share(analysis.sample_share, "sample_share");
    require_share(analysis.significance, "significance");
    require_share(analysis.confidence, "confidence");
    if (analysis.confidence == 1) throw InputError("statistics: confidence = 1 must be below 1");
    if (analysis.resamples < 1)
        throw InputError("statistics: resamples = " + to_text(analysis.resamples) + " must be at least 1");
    if (analysis.interval_runs < 1)
        throw InputError("statistics: interval_runs = " + to_text(analysis.interval_runs) +
                         " must be at least 1");
    if (!(analysis.direction_distance >= 0) || std::isinf(analysis.direction_distance))
        throw InputError("statistics: direction_distance = " + to_text(analysis.direction_distance) +
                         " must be finite and at least 0");
    if (analysis.sample_least < 0)
        throw InputError("statistics: sample_least = " + to_text(analysis.sample_least) +
                         " must be at least 0");
    if (analysis.fitness_classes < 1 || 100 % analysis.fitness_classes != 0)
        throw InputError("statistics: fitness_classes = " + to_text(analysis.fitness_classes) +
                         " must divide 100: 1, 2, 4, 5, 10, 20, 25, 50 or 100");
    for (const std::string &name : analysis.endpoint_settings) require_setting(name, "endpoints", settings);
    for (const Claim &claim : analysis.claims) check_claim(claim, settings);
}

} // namespace planula
