// SPDX-License-Identifier: MIT
// stats: the arithmetic of core/statistics as scripts see it (decision 0023). statistic_functions() describes every
// function. A sample is a list of numbers; a broken rule, such as a sample without a value, with a value that is missing
// or not finite, or pairs of unequal number, is an error with its line.
//
// Chance comes from streams with names: that of the claim or of the table, and behind it the `name` of the call's
// options. Two calls of one name draw the same, on every machine.
#pragma once

#include "analysis/analysis.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <lua.hpp>

namespace planula {

/// What the functions of `stats` need of the call that they belong to, and the memory in which they compute, because a
/// Lua error may leave them.
struct StatsContext {
    const Analysis *analysis = nullptr;
    std::string stream{};   // names its random streams: "claim S1"
    int most_resamples = 0; // whatever is asked for

    std::vector<double> a{}, b{}, values{};
    std::vector<std::vector<double>> curves_a{}, curves_b{};
    std::vector<std::uint32_t> drawn{}; // places in resamples
};

/// A function of `stats`, described.
struct StatisticFunction {
    std::string_view name, signature, meaning;
};
std::span<const StatisticFunction> statistic_functions();
/// The numbers of `stats`, described.
std::span<const StatisticFunction> statistic_numbers();

/// Pushes `stats`, whose functions use `context`, and whose numbers are those of its analysis. Both must outlive the
/// state. May raise.
void push_stats(lua_State *L, StatsContext &context);

} // namespace planula
