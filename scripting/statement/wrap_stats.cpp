// SPDX-License-Identifier: MIT
#include "statement/wrap_stats.h"

#include "base/check.h"
#include "base/error.h"
#include "base/text.h"
#include "language/wrap.h"
#include "statement/stats_arguments.h"
#include "statistics/benjamini_hochberg.h"
#include "statistics/counts.h"
#include "statistics/effect_size.h"
#include "statistics/entropy.h"
#include "statistics/equivalence.h"
#include "statistics/holm.h"
#include "statistics/permutation.h"
#include "statistics/rank_correlation.h"
#include "statistics/rank_sum.h"
#include "statistics/signed_rank.h"
#include "statistics/summary.h"

#include <array>

namespace planula {

namespace {

// The work of a rank test: sorting, and counting sums if it is exact.
void spend_on_ranks(lua_State *L, const StatsContext &context) {
    const double m = size(context.a), n = size(context.b);
    spend(L, 20 * (m + n) + (m < exact_below && n < exact_below ? m * m * (m + n) : 0));
}

// ---- Tests ----

RankMethod method_of(lua_State *L, int index) {
    static constexpr std::array<std::string_view, 2> allowed{"method", "continuity"};
    static constexpr std::array<std::string_view, 3> methods{"automatic", "exact", "normal"};
    Options options(L, index, allowed);
    const std::size_t method = options.choice("method", methods);
    const bool continuity = options.boolean("continuity", true);
    if (!continuity && method != 2) throw InputError("continuity = false is of the method 'normal' alone");
    if (!continuity) return RankMethod::normal_without_continuity;
    constexpr std::array kinds{RankMethod::automatic, RankMethod::exact, RankMethod::normal};
    return kinds[method];
}

int call_rank_sum(lua_State *L, StatsContext &context) {
    read_samples(L, context);
    const RankMethod method = method_of(L, 3);
    spend_on_ranks(L, context);
    const RankSum test = rank_sum(context.a, context.b, method);
    return push_result(L, "the result of stats.rank_sum",
                       {{"statistic", test.statistic}, {"p", test.p}, {"least", test.least}},
                       test.exact ? "exact" : "normal");
}

int call_signed_rank(lua_State *L, StatsContext &context) {
    read_samples(L, context);
    const RankMethod method = method_of(L, 3);
    spend_on_ranks(L, context);
    const SignedRank test = signed_rank(context.a, context.b, method);
    return push_result(L, "the result of stats.signed_rank",
                       {{"statistic", test.statistic},
                        {"p", test.p},
                        {"greater", test.greater},
                        {"less", test.less},
                        {"least", test.least},
                        {"differences", static_cast<double>(test.differences)}},
                       test.exact ? "exact" : "normal");
}

int call_permutation(lua_State *L, StatsContext &context) {
    static constexpr std::array<std::string_view, 3> allowed{"draws", "paired", "name"};
    read_samples(L, context);
    Options options(L, 3, allowed);
    const int draws = resamples_of(options, "draws", context);
    const Shuffling shuffling{draws, seed_of(options, context), 0};
    const bool paired = options.boolean("paired", false);
    spend(L, draws * (size(context.a) + size(context.b)));
    const Permutation test = paired ? paired_permutation_test(context.a, context.b, shuffling)
                                    : permutation_test(context.a, context.b, shuffling);
    return push_result(L, "the result of stats.permutation",
                       {{"difference", test.difference}, {"p", test.p}, {"least", test.least}},
                       test.exact ? "exact" : "drawn");
}

int call_equivalence(lua_State *L, StatsContext &context) {
    read_samples(L, context);
    const double bound = number_at(L, 3, "bound");
    spend(L, 20 * size(context.a) * size(context.b));
    const Equivalence test = equivalence(context.a, context.b, bound);
    return push_result(
        L, "the result of stats.equivalence",
        {{"effect", test.effect}, {"deviation", test.deviation}, {"p", test.p}, {"least", test.least}});
}

int call_spearman(lua_State *L, StatsContext &context) {
    read_samples(L, context);
    spend(L, 20 * size(context.a) + (context.a.size() < 10 ? 4e6 : 0));
    const auto test = rank_correlation_test(context.a, context.b);
    if (!test) return lua_pushnil(L), 1;
    return push_result(L, "the result of stats.spearman", {{"rho", test->rho}, {"p", test->p}},
                       test->exact ? "exact" : "t");
}

template <Numbers (*correct)(std::span<const double>)>
int call_correction(lua_State *L, StatsContext &context) {
    read_numbers(L, 1, "p", context.a);
    spend(L, 20 * size(context.a));
    context.values = correct(context.a);
    return push_list(L, context.values);
}

// ---- Effects, counts and summaries ----

// How many things there are at most of which probabilities are computed: each one is counted with each.
constexpr int most_counted = 10000;

int count_at(lua_State *L, int index, const std::string &name) {
    const int count = whole(number_at(L, index, name), name);
    if (count > most_counted)
        throw InputError(name + " = " + to_text(count) + " must be at most " + to_text(most_counted));
    return count;
}

template <double (*effect)(std::span<const double>, std::span<const double>)>
int call_effect(lua_State *L, StatsContext &context) {
    read_samples(L, context);
    spend(L, 20 * (size(context.a) + size(context.b)));
    return push_number(L, effect(context.a, context.b));
}

template <double (*summary)(std::span<const double>)> int call_summary(lua_State *L, StatsContext &context) {
    read_numbers(L, 1, "the sample", context.a);
    spend(L, size(context.a));
    return push_number(L, summary(context.a));
}

int call_quantile(lua_State *L, StatsContext &context) {
    read_numbers(L, 1, "the sample", context.a);
    spend(L, size(context.a));
    return push_number(L, quantile(context.a, number_at(L, 2, "the probability")));
}

int call_entropy(lua_State *L, StatsContext &context) {
    read_numbers(L, 1, "the counts", context.a);
    spend(L, size(context.a));
    std::vector<std::int64_t> counts;
    for (const double count : context.a) counts.push_back(whole(count, "a count"));
    const double found = entropy_of_counts(counts);
    return push_number(L, found);
}

int call_share_ahead(lua_State *L, StatsContext &context) {
    read_curves(L, 1, "a", context.curves_a);
    read_curves(L, 2, "b", context.curves_b);
    const auto share = [&] {
        const auto all = [](const std::vector<Numbers> &curves) {
            return curves_at(curves, places_of(curves.size()));
        };
        return share_ahead(all(context.curves_a), all(context.curves_b));
    };
    return push_number(L, share());
}

int call_hypergeometric(lua_State *L, StatsContext &) {
    const int marked = count_at(L, 1, "marked"), total = count_at(L, 2, "total"),
              all_marked = count_at(L, 3, "all_marked"), drawn = count_at(L, 4, "drawn");
    spend(L, static_cast<double>(drawn) * drawn);
    return push_number(L, hypergeometric_tail(marked, total, all_marked, drawn));
}

int call_binomial(lua_State *L, StatsContext &) {
    const int found = count_at(L, 1, "found"), count = count_at(L, 2, "count");
    const double probability = number_at(L, 3, "probability");
    spend(L, static_cast<double>(count) * count);
    return push_number(L, binomial_lower_tail(found, count, probability));
}

int call_present(lua_State *L, StatsContext &) {
    if (!lua_istable(L, 1)) throw InputError(std::string("takes a list, not ") + luaL_typename(L, 1));
    const int count = static_cast<int>(lua_objlen(L, 1));
    lua_createtable(L, count, 0);
    int kept = 0;
    for (int i = 1; i <= count; ++i) {
        lua_rawgeti(L, 1, i);
        if (lua_toboolean(L, -1))
            lua_rawseti(L, -2, ++kept);
        else
            lua_pop(L, 1);
    }
    return 1;
}

// ---- The list ----

struct Row {
    StatisticFunction described;
    int least, most; // arguments
    int (*function)(lua_State *L, StatsContext &context);
};

constexpr Row rows[] = {
#define STATISTIC(name, signature, least, most, function, meaning)                                           \
    {{#name, "stats." #name signature, meaning}, least, most, function},
#define STATISTIC_NUMBER(name, meaning)
#include "statement/wrap_stats.inl"
};

constexpr StatisticFunction numbers[] = {
#define STATISTIC(...)
#define STATISTIC_NUMBER(name, meaning) {#name, "stats." #name, meaning},
#include "statement/wrap_stats.inl"
};

// Every function of `stats`. Upvalues: the context, and the row.
int dispatch(lua_State *L) {
    auto &context = *static_cast<StatsContext *>(lua_touserdata(L, lua_upvalueindex(1)));
    const Row &row = *static_cast<const Row *>(lua_touserdata(L, lua_upvalueindex(2)));
    const int count = lua_gettop(L);
    if (count < row.least || count > row.most)
        throw InputError("call " + std::string(row.described.signature));
    lua_settop(L, row.most);
    try {
        return row.function(L, context);
    } catch (const InputError &error) {
        throw InputError("stats." + std::string(row.described.name) + ": " + error.what());
    }
}

double number_named(std::string_view name, const Analysis &analysis) {
    if (name == "significance") return analysis.significance;
    if (name == "confidence") return analysis.confidence;
    if (name == "resamples") return analysis.resamples;
    CHECK(name == "interval_runs", name);
    return analysis.interval_runs;
}

} // namespace

std::span<const StatisticFunction> statistic_functions() {
    static const std::vector<StatisticFunction> list = [] {
        std::vector<StatisticFunction> all;
        for (const Row &row : rows) all.push_back(row.described);
        return all;
    }();
    return list;
}

std::span<const StatisticFunction> statistic_numbers() { return numbers; }

const StatisticFunction *function_of_stats(lua_State *L, int index) {
    if (lua_tocfunction(L, index) != gate<dispatch>) return nullptr;
    lua_getupvalue(L, index, 2);
    const Row *row = static_cast<const Row *>(lua_touserdata(L, -1));
    lua_pop(L, 1);
    return &row->described;
}

void push_stats(lua_State *L, StatsContext &context) {
    lua_newtable(L);
    for (const Row &row : rows) {
        lua_pushlstring(L, row.described.name.data(), row.described.name.size());
        lua_pushlightuserdata(L, &context);
        lua_pushlightuserdata(L, const_cast<Row *>(&row));
        lua_pushcclosure(L, gate<dispatch>, 2);
        lua_rawset(L, -3);
    }
    for (const StatisticFunction &number : numbers) {
        lua_pushlstring(L, number.name.data(), number.name.size());
        lua_pushnumber(L, number_named(number.name, *context.analysis));
        lua_rawset(L, -3);
    }
    freeze(L, "stats");
}

} // namespace planula
