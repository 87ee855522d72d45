// SPDX-License-Identifier: MIT
// stats.bootstrap: the intervals of core/statistics for a statistic of the core, of curves, or of the script.
#include "base/error.h"
#include "base/text.h"
#include "language/wrap.h"
#include "statement/stats_arguments.h"
#include "statistics/bootstrap.h"
#include "statistics/effect_size.h"
#include "statistics/summary.h"

#include <algorithm>
#include <array>
#include <utility>

namespace planula {

namespace {

constexpr double most_drawn = 1e7; // values, for a function of the script

// What is resampled, and how.
struct Bootstrap {
    int samples;   // one or two
    int statistic; // its place on the stack
    bool paired;
    Resampling resampling;
};

Bootstrap bootstrap_of(lua_State *L, const StatsContext &context) {
    static constexpr std::array<std::string_view, 5> allowed{"confidence", "resamples", "method", "paired",
                                                             "name"};
    static constexpr std::array<std::string_view, 2> methods{"percentile", "bca"};
    const int statistic = lua_isfunction(L, 2) ? 2 : 3;
    if (!lua_isfunction(L, statistic))
        throw InputError("the statistic must be a function: stats.bootstrap(sample, statistic) or "
                         "stats.bootstrap(a, b, statistic)");
    Options options(L, statistic + 1, allowed);
    Bootstrap asked{statistic - 1, statistic, options.boolean("paired", false), {}};
    if (asked.paired && asked.samples == 1) throw InputError("paired = true takes two samples");
    asked.resampling.confidence = options.number("confidence", context.analysis->confidence);
    asked.resampling.resamples = resamples_of(options, "resamples", context);
    asked.resampling.seed = seed_of(options, context);
    asked.resampling.kind =
        options.choice("method", methods) == 1 ? IntervalKind::bca : IntervalKind::percentile;
    return asked;
}

Interval run_bootstrap(const Bootstrap &asked, const Numbers &a, const Numbers &b,
                       const TwoSampleStatistic &statistic) {
    if (asked.samples == 1)
        return bootstrap(
            a, [&](std::span<const double> sample) { return statistic(sample, {}); }, asked.resampling);
    return asked.paired ? bootstrap_pairs(a, b, statistic, asked.resampling)
                        : bootstrap(a, b, statistic, asked.resampling);
}

// The statistics of the core: no function of the script is called.
const TwoSampleStatistic *core_statistic(std::string_view name, int samples) {
    static const std::pair<std::string_view, TwoSampleStatistic> of_one[] =
        {{"mean", [](auto a, auto) { return mean(a); }}, {"median", [](auto a, auto) { return median(a); }}},
                                                                 of_two[] = {{"a12", a12},
                                                                             {"cliff_delta", cliff_delta}};
    for (const auto &[known, statistic] : std::span(samples == 1 ? of_one : of_two))
        if (known == name) return &statistic;
    return nullptr;
}

Interval bootstrap_numbers(lua_State *L, const Bootstrap &asked, const TwoSampleStatistic &statistic,
                           StatsContext &context) {
    read_numbers(L, 1, asked.samples == 1 ? "the sample" : "a", context.a);
    context.b.clear();
    if (asked.samples == 2) read_numbers(L, 2, "b", context.b);
    spend(L, 3 * asked.resampling.resamples * (size(context.a) + size(context.b)));
    return run_bootstrap(asked, context.a, context.b, statistic);
}

// Whole curves are drawn, by their places.
Interval bootstrap_curves(lua_State *L, const Bootstrap &asked, StatsContext &context) {
    read_curves(L, 1, "a", context.curves_a);
    read_curves(L, 2, "b", context.curves_b);
    context.a = places_of(context.curves_a.size()), context.b = places_of(context.curves_b.size());
    check_sample(context.a);
    check_sample(context.b);
    spend(L, asked.resampling.resamples * (size(context.a) + size(context.b)) *
                 static_cast<double>(context.curves_a.front().size()));
    return run_bootstrap(asked, context.a, context.b, [&](auto a, auto b) {
        return share_ahead(curves_at(context.curves_a, a), curves_at(context.curves_b, b));
    });
}

// Reads the places of a sample from the block at `next`, pushes a list of what the argument has there, and returns what
// follows in the block.
const std::uint32_t *push_chosen(lua_State *L, int argument, const std::uint32_t *next) {
    const int count = static_cast<int>(*next++);
    lua_createtable(L, count, 0);
    for (int i = 1; i <= count; ++i) {
        lua_rawgeti(L, argument, static_cast<int>(*next++) + 1);
        lua_rawseti(L, -2, i);
    }
    return next;
}

// Notes every sample that the bootstrap draws: how many places, and these. Returns the number of resamples.
std::size_t note_resamples(const Bootstrap &asked, std::size_t size_a, std::size_t size_b,
                           std::vector<std::uint32_t> &drawn) {
    const auto note = [&](std::span<const double> places) {
        drawn.push_back(static_cast<std::uint32_t>(places.size()));
        for (const double place : places) drawn.push_back(static_cast<std::uint32_t>(place));
    };
    std::size_t count = 0;
    drawn.clear();
    run_bootstrap(asked, places_of(size_a), places_of(size_b), [&](auto a, auto b) {
        note(a);
        if (asked.samples == 2) note(b);
        return ++count, 0.0;
    });
    return count;
}

// Calls the script's statistic for every resample in the block. Lua errors may leave this.
void call_statistic(lua_State *L, const Bootstrap &asked, std::size_t count, const std::uint32_t *block,
                    double *replicates) {
    Host &host = host_of(L);
    const int depth = host.depth;
    host.go_deeper(L);
    for (std::size_t i = 0; i < count; ++i) {
        lua_pushvalue(L, asked.statistic);
        for (int sample = 1; sample <= asked.samples; ++sample) block = push_chosen(L, sample, block);
        lua_call(L, asked.samples, 1);
        if (lua_type(L, -1) != LUA_TNUMBER)
            throw InputError(std::string("the statistic returned ") + luaL_typename(L, -1) +
                             ", not a number");
        replicates[i] = lua_tonumber(L, -1);
        lua_pop(L, 1);
    }
    host.depth = depth;
}

// A Lua error must not pass through the core. So its bootstrap runs twice: the first time it notes which samples it
// draws; then the script's function is called for each of them; and the second time the values are there. What is kept
// in between belongs to Lua.
Interval bootstrap_of_function(lua_State *L, const Bootstrap &asked, StatsContext &context) {
    for (int i = 1; i <= asked.samples; ++i)
        if (!lua_istable(L, i))
            throw InputError(std::string("a sample must be a list, not ") + luaL_typename(L, i));
    const std::size_t size_a = lua_objlen(L, 1), size_b = asked.samples == 2 ? lua_objlen(L, 2) : 0;
    const double drawn = asked.resampling.resamples * static_cast<double>(size_a + size_b);
    if (drawn > most_drawn)
        throw InputError("draws " + to_text(drawn) + " values, and may draw " + to_text(most_drawn) +
                         " for a statistic of the script; state fewer resamples");
    spend(L, drawn);
    const std::size_t count = note_resamples(asked, size_a, size_b, context.drawn);
    const std::size_t bytes = context.drawn.size() * sizeof(std::uint32_t);
    auto *block = static_cast<std::uint32_t *>(lua_newuserdata(L, bytes));
    std::copy(context.drawn.begin(), context.drawn.end(), block);
    auto *replicates = static_cast<double *>(lua_newuserdata(L, count * sizeof(double)));
    call_statistic(L, asked, count, block, replicates);
    const double *next = replicates;
    return run_bootstrap(asked, places_of(size_a), places_of(size_b), [&](auto, auto) { return *next++; });
}

} // namespace

int call_bootstrap(lua_State *L, StatsContext &context) {
    const Bootstrap asked = bootstrap_of(L, context);
    const StatisticFunction *known = function_of_stats(L, asked.statistic);
    const TwoSampleStatistic *of_core = known ? core_statistic(known->name, asked.samples) : nullptr;
    Interval interval{};
    if (known && known->name == "share_ahead" && asked.samples == 2)
        interval = bootstrap_curves(L, asked, context);
    else if (of_core)
        interval = bootstrap_numbers(L, asked, *of_core, context);
    else
        interval = bootstrap_of_function(L, asked, context);
    return push_result(L, "the result of stats.bootstrap", {{"low", interval.low}, {"high", interval.high}});
}

} // namespace planula
