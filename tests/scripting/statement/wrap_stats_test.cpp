// SPDX-License-Identifier: MIT
#include "statement/wrap_stats.h"

#include "analysis/chance.h"
#include "scripting/statement/statistics_in_lua.h"
#include "statistics/bootstrap.h"
#include "statistics/effect_size.h"
#include "statistics/permutation.h"
#include "statistics/summary.h"

#include <boost/test/unit_test.hpp>

#include <set>

using namespace planula;
using test::number;
namespace tt = boost::test_tools;

namespace {

// R 4.2: of these two samples wilcox.test, wilcox.test(paired = TRUE) and more.
const std::string samples = "local a, b = { 1.1, 2.2, 3.3, 4.4, 5.5 }, { 2.1, 3.1, 4.9, 6.2, 7.7 } ";
const std::vector<double> a{1.1, 2.2, 3.3, 4.4, 5.5}, b{2.1, 3.1, 4.9, 6.2, 7.7};

double of_samples(const std::string &expression) { return number(expression, samples); }

std::string refusal(const std::string &expression) {
    return test::refusal_of_table(samples + "return { { x = " + expression + " } }");
}

} // namespace

BOOST_AUTO_TEST_CASE(tests_give_what_r_gives) {
    BOOST_TEST(of_samples("stats.rank_sum(a, b).statistic") == 8);
    BOOST_TEST(of_samples("stats.rank_sum(a, b).p") == 0.42063492063492064, tt::tolerance(1e-12));
    BOOST_TEST(of_samples("stats.rank_sum(a, b, { method = 'normal' }).p") == 0.40339530489262826,
               tt::tolerance(1e-9));
    BOOST_TEST(of_samples("stats.rank_sum(a, b, { method = 'normal', continuity = false }).p") ==
                   0.3472076393494245,
               tt::tolerance(1e-9));
    BOOST_TEST(of_samples("stats.rank_sum(a, b).method == 'exact' and 1 or 0") == 1);
    BOOST_TEST(of_samples("stats.rank_sum(a, b).least") == 2.0 / 252, tt::tolerance(1e-12));
    BOOST_TEST(of_samples("stats.signed_rank(a, b).statistic") == 0);
    BOOST_TEST(of_samples("stats.signed_rank(a, b).p") == 0.0625, tt::tolerance(1e-12));
    BOOST_TEST(of_samples("stats.signed_rank(a, b).less") == 0.03125, tt::tolerance(1e-12));
    BOOST_TEST(of_samples("stats.spearman(a, b).rho") == 1, tt::tolerance(1e-12));
    BOOST_TEST(of_samples("stats.spearman(a, b).p") == 2.0 / 120, tt::tolerance(1e-12));
    BOOST_TEST(of_samples("stats.spearman({ 1, 1 }, { 1, 2 }) == nil and 1 or 0") == 1);
    BOOST_TEST(of_samples("stats.a12(a, b)") == 8.0 / 25, tt::tolerance(1e-12));
    BOOST_TEST(of_samples("stats.cliff_delta(a, b)") == -9.0 / 25, tt::tolerance(1e-12));
    // p.adjust(c(0.01, 0.04, 0.03))
    BOOST_TEST(number("stats.holm({ 0.01, 0.04, 0.03 })[3]") == 0.06, tt::tolerance(1e-12));
    BOOST_TEST(number("stats.benjamini_hochberg({ 0.01, 0.04, 0.03 })[3]") == 0.04, tt::tolerance(1e-12));
    BOOST_TEST(number("#stats.holm({})") == 0);
    // fisher.test(matrix(c(3, 0, 0, 3), 2), alternative = "greater")
    BOOST_TEST(number("stats.hypergeometric(3, 6, 3, 3)") == 0.05, tt::tolerance(1e-12));
    BOOST_TEST(number("stats.binomial(1, 20, 0.25)") == 0.024312624865160615, tt::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(summaries_are_those_of_the_core) {
    BOOST_TEST(of_samples("stats.mean(b)") == mean(b));
    BOOST_TEST(of_samples("stats.median(b)") == 4.9);
    BOOST_TEST(of_samples("stats.quantile(a, 0.9)") == quantile(a, 0.9));
    BOOST_TEST(number("stats.entropy({ 1, 1, 0 })") == 0.69314718055994531, tt::tolerance(1e-12));
    BOOST_TEST(number("stats.equivalence({ 1, 2, 3 }, { 1, 2, 3 }, 0.3).effect") == 0.5);
    BOOST_TEST(number("stats.share_ahead({ { 1, 2, 3 } }, { { 2, 2, 2 }, { 0, 0, 8 } })") == 2.0 / 3,
               tt::tolerance(1e-12));
    BOOST_TEST(number("stats.mean(runs.ns[1].best_fitness)") == 1); // of all its generations
    BOOST_TEST(number("stats.significance") == 0.05);
    BOOST_TEST(number("stats.confidence") == 0.95);
    BOOST_TEST(number("stats.resamples") == 500);
    BOOST_TEST(number("stats.interval_runs") == 3);
}

BOOST_AUTO_TEST_CASE(a_bootstrap_draws_from_the_stream_of_its_name) {
    const auto seed = bootstrap_seed("table t");
    const Interval of_a12 = bootstrap(a, b, a12, {0.95, 500, seed, 0});
    BOOST_TEST(of_samples("stats.bootstrap(a, b, stats.a12).low") == of_a12.low);
    BOOST_TEST(of_samples("stats.bootstrap(a, b, stats.a12).high") == of_a12.high);
    const Interval of_mean = bootstrap_mean(b, {0.9, 200, seed, 0});
    BOOST_TEST(of_samples("stats.bootstrap(b, stats.mean, { confidence = 0.9, resamples = 200 }).low") ==
               of_mean.low);
    const Interval named = bootstrap(a, b, a12, {0.95, 500, bootstrap_seed("table t again"), 0});
    BOOST_TEST(of_samples("stats.bootstrap(a, b, stats.a12, { name = 'again' }).low") == named.low);
    const Interval bca = bootstrap(b, mean, {0.95, 500, seed, 0, IntervalKind::bca});
    BOOST_TEST(of_samples("stats.bootstrap(b, stats.mean, { method = 'bca' }).high") == bca.high);
    const Interval paired = bootstrap_pairs(a, b, a12, {0.95, 500, seed, 0});
    BOOST_TEST(of_samples("stats.bootstrap(a, b, stats.a12, { paired = true }).low") == paired.low);
    const Permutation test = permutation_test(a, b, {50, seed, 0});
    BOOST_TEST(of_samples("stats.permutation(a, b, { draws = 50 }).p") == test.p);
    BOOST_TEST(of_samples("stats.permutation(a, b, { draws = 50 }).method == 'drawn' and 1 or 0") == 1);
}

BOOST_AUTO_TEST_CASE(a_function_of_the_script_gives_the_interval_of_the_core) {
    for (const char *options :
         {"", ", { method = 'bca' }", ", { paired = true }", ", { paired = true, method = 'bca' }"})
        for (const char *end : {"low", "high"}) {
            const std::string call = "stats.bootstrap(a, b, ", rest = std::string(options) + ")." + end;
            BOOST_TEST(of_samples(call + "function(x, y) return stats.a12(x, y) end" + rest) ==
                           of_samples(call + "stats.a12" + rest),
                       options);
        }
    BOOST_TEST(
        of_samples("stats.bootstrap(b, function(x) return stats.mean(x) end, { method = 'bca' }).low") ==
        of_samples("stats.bootstrap(b, stats.mean, { method = 'bca' }).low"));
    // Of curves: whole ones are drawn.
    const std::string curves = "local a, b = { { 1, 5 }, { 2, 2 }, { 9, 1 } }, { { 2, 2 }, { 3, 1 } } ";
    BOOST_TEST(
        number("stats.bootstrap(a, b, stats.share_ahead).low", curves) ==
        number("stats.bootstrap(a, b, function(x, y) return stats.share_ahead(x, y) end).low", curves));
    // A bootstrap in a bootstrap.
    const std::string inner =
        "local function inner(x) return stats.bootstrap(x, function(y) return stats.mean(y) end, "
        "{ resamples = 5 }).low end local function native(x) return stats.bootstrap(x, stats.mean, "
        "{ resamples = 5 }).low end local a = { 1, 2, 4 } ";
    BOOST_TEST(number("stats.bootstrap(a, inner, { resamples = 20 }).high", inner) ==
               number("stats.bootstrap(a, native, { resamples = 20 }).high", inner));
    // What is resampled may be anything.
    BOOST_TEST(number("stats.bootstrap({ 'x', 'x' }, function(list) return #list end).low") == 2);
}

BOOST_AUTO_TEST_CASE(the_same_call_gives_the_same_and_another_claim_something_else) {
    const std::string body =
        "local i = stats.bootstrap({ 1, 2, 3, 9 }, stats.mean) return { verdict = 'inconclusive', "
        "low = i.low, high = i.high }";
    const Finding one = test::finding(body), two = test::finding(body);
    BOOST_TEST(one.low.value() == two.low.value());
    BOOST_TEST(one.high.value() == two.high.value());
    const std::string twice =
        "local x, y = stats.bootstrap({ 1, 2, 3, 9 }, stats.mean), stats.bootstrap({ 1, 2, 3, 9 }, "
        "stats.mean) ";
    BOOST_TEST(number("x.low == y.low and 1 or 0", twice) == 1);
    const std::string means =
        "return { verdict = 'inconclusive', effect = stats.bootstrap({ 1, 2, 3, 9, 11.5, 17 }, "
        "stats.mean).low }";
    BOOST_TEST(test::finding(means, test::FakeRuns(), "S1").effect.value() !=
               test::finding(means, test::FakeRuns(), "S2").effect.value());
}

BOOST_AUTO_TEST_CASE(a_misuse_is_an_error_with_its_line) {
    const auto says = [&](const std::string &expression, const std::string &words) {
        const std::string said = refusal(expression);
        BOOST_TEST(said.starts_with("test.lua:2: "), expression << ": " << said);
        BOOST_TEST(test::contains(said, words), expression << ": " << said);
    };
    says("stats.signed_rank(a, { 1, 2 }).p",
         "stats.signed_rank: pairs need two samples of the same size: these have 5 and 2");
    says("stats.rank_sum(a, {}).p", "stats.rank_sum: a sample has at least one value");
    says("stats.rank_sum(a, { 1, 0 / 0 }).p", "b: value 2 of 2 is nan, and must be finite");
    says("stats.rank_sum(a, { 1, math.huge }).p", "b: value 2 of 2 is infinite, and must be finite");
    says("stats.rank_sum(a, { 1, 'x' }).p", "stats.rank_sum: b: value 2 of 2 is string, not a number");
    says("stats.rank_sum({ 1, false }, a).p",
         "a: value 2 of 2 is missing (false): leave it out with stats.present");
    says("stats.rank_sum(3, a).p", "a must be a list of numbers, not number");
    says("stats.rank_sum(a).p", "call stats.rank_sum(a, b, {");
    says("stats.rank_sum(a, b, {}, 1).p", "call stats.rank_sum(a, b, {");
    says("stats.rank_sum(a, b, { methods = 'exact' }).p",
         "there is no option 'methods'; did you mean 'method'?");
    says("stats.rank_sum(a, b, { method = 'exakt' }).p",
         "method: 'exakt' is not one of automatic, exact, normal");
    says("stats.rank_sum(a, b, { continuity = false }).p",
         "continuity = false is of the method 'normal' alone");
    says("stats.rank_sum(a, b, 'exact').p", "the options must be a table, not string");
    says("stats.ranksum(a, b)", "stats has no 'ranksum'; did you mean 'rank_sum'?");
    says("stats.rank_sum(a, b).q", "the result of stats.rank_sum has no 'q'");
    says("stats.bootstrap({ 1 }, stats.mean, { method = 'bca' }).low",
         "a BCa interval needs at least 2 values");
    says("stats.bootstrap(a, b).low", "the statistic must be a function");
    says("stats.bootstrap(a, stats.mean, { resamples = 0 }).low", "resamples = 0 must be from 1 to 10000000");
    says("stats.bootstrap(a, stats.mean, { resamples = 1.5 }).low", "must be a whole number");
    says("stats.bootstrap(a, stats.mean, { confidence = 1 }).low", "confidence");
    says("stats.bootstrap(a, function() return 'x' end).low", "the statistic returned string, not a number");
    says("stats.bootstrap(a, function() return 0 / 0 end).low", "nan");
    says("stats.bootstrap(a, function() error('mine') end).low", "mine");
    says("stats.bootstrap({}, function() return 1 end).low", "at least one value");
    says("stats.share_ahead({ { 1, 2 } }, { { 1 } })",
         "curves must have the same number of values: these have 2 and 1");
    says("stats.share_ahead({}, { { 1 } })", "needs a curve of each side");
    says("stats.quantile(a, 2)", "from 0 to 1");
    says("stats.holm({ 0.5, 2 })", "stats.holm: ");
    says("stats.entropy({ 1, -1 })", "a count is at least 0");
    says("stats.entropy({ 1.5 })", "whole number");
    says("stats.equivalence(a, b, 0.5).p", "stats.equivalence: ");
    says("stats.hypergeometric(1, 2, 3, 1)", "stats.hypergeometric: ");
    says("stats.hypergeometric(1, 1e9, 3, 1)", "must be at most 10000");
    says("stats.hypergeometric(1, '2', 3, 1)", "total must be a number, not string");
    says("stats.binomial(1, 20, 1.5)", "a probability is from 0 to 1");
    BOOST_TEST(test::contains(test::refusal_of_table("stats.mean = nil"), "stats.mean cannot be changed"));
}

BOOST_AUTO_TEST_CASE(work_of_the_core_counts_for_the_limits) {
    const std::string list = "local x = {} for i = 1, 20000 do x[i] = i end ";
    const auto refused = [&](const std::string &call) {
        return test::refusal_of_table(list + call + " return {}");
    };
    BOOST_TEST(
        test::contains(refused("stats.equivalence(x, x, 0.1)"), "test.lua:2: the script executes too many"));
    BOOST_TEST(test::contains(refused("for i = 1, 1e6 do stats.mean(x) end"), "too many instructions"));
    BOOST_TEST(test::contains(
        test::refusal_of_table(list + "stats.bootstrap(x, function() return 1 end, { resamples "
                                      "= 1e7 }) return {}",
                               Allowance::reduce),
        "draws 2e+11 values, and may draw 1e+07"));
    BOOST_TEST(test::contains(
        test::refusal_of_table("stats.bootstrap({ 1, 2, 3 }, function() while true do end end)"),
        "test.lua:2: the script executes too many"));
}

BOOST_AUTO_TEST_CASE(every_function_and_number_is_described) {
    std::set<std::string_view> names;
    for (const auto &list : {statistic_functions(), statistic_numbers()})
        for (const StatisticFunction &each : list) {
            BOOST_TEST(names.insert(each.name).second, each.name);
            BOOST_TEST(each.signature.starts_with("stats." + std::string(each.name)), each.name);
            BOOST_TEST(!each.meaning.empty(), each.name);
        }
}
