// SPDX-License-Identifier: MIT
#include "statement/statistic_state.h"

#include "base/error.h"
#include "scripting/statement/statistics_in_lua.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using test::finding;
using test::refusal_of_table;

namespace {

std::string refusal(const std::string &body) {
    return test::refusal([&] { finding(body); });
}

OwnTable table(const std::string &body) {
    Asked asked;
    return test::table(body, test::FakeRuns(), asked);
}

/// What try_out() says of statistics with these fields.
std::string tried(const std::string &fields, int claims, const std::vector<std::string> &tables = {},
                  int seeds = 6) {
    const StatisticSource source = test::statistics(fields);
    Analysis analysis = fake_analysis();
    analysis.design.design.seeds = seeds;
    for (int i = 1; i <= claims; ++i) {
        analysis.claims.push_back(fake_claim());
        analysis.claims.back().id = "S" + std::to_string(i);
    }
    for (const std::string &name : tables) analysis.tables.push_back({name, nullptr});
    const std::vector<Spec> settings{fake_spec("ns", 4, 10), fake_spec("neat", 4, 10)};
    Problems problems(*source.sources);
    try_out(source, analysis, settings, problems);
    return test::refusal([&] { problems.raise(); });
}

std::string judge(const std::string &body) {
    return "{ judge = function(runs, stats, claim) " + body + " end }";
}

} // namespace

BOOST_AUTO_TEST_CASE(a_judge_returns_a_row) {
    const Finding all =
        finding("return { verdict = 'contradicted', effect_name = 'A12', effect = 0.1, low = 0, high = 0.2, "
                "p = 0.5, method = 'exact', p_equivalence = 0.25, note = 'few' }");
    BOOST_TEST(all.verdict == "contradicted");
    BOOST_TEST(all.effect_name == "A12");
    BOOST_TEST(all.effect.value() == 0.1);
    BOOST_TEST(all.low.value() == 0);
    BOOST_TEST(all.high.value() == 0.2);
    BOOST_TEST(all.p.value() == 0.5);
    BOOST_TEST(all.method == "exact");
    BOOST_TEST(all.p_equivalence.value() == 0.25);
    BOOST_TEST(all.note == "few");
    const Finding least = finding("return { verdict = 'inconclusive' }");
    BOOST_TEST(!least.effect.has_value());
    BOOST_TEST(!least.p.has_value());
}

BOOST_AUTO_TEST_CASE(a_judge_is_given_its_claim) {
    BOOST_TEST(
        finding(
            "return { verdict = 'inconclusive', note = claim.id .. claim.a .. claim.b .. claim.generation .. "
            "' ' .. claim.at_generation }")
            .note == "Snsneat10 8");
    BOOST_TEST(test::contains(refusal("return { verdict = claim.bb }"),
                              "test.lua:2: claim has no 'bb'; did you mean 'b'?"));
    BOOST_TEST(test::contains(refusal("claim.a = 'x'"), "test.lua:2: claim.a cannot be changed"));
}

BOOST_AUTO_TEST_CASE(what_is_no_row_is_an_error_with_place_and_nearest_name) {
    BOOST_TEST(refusal("return") ==
               "test.lua:2: the judge of claim 'S' returned nil, not a table with a verdict");
    BOOST_TEST(refusal("return 'reproduced'") ==
               "test.lua:2: the judge of claim 'S' returned string, not a table with a verdict");
    BOOST_TEST(refusal("return {}") ==
               "test.lua:2: the judge of claim 'S' returned the verdict '', which is not one of "
               "reproduced, contradicted, inconclusive");
    BOOST_TEST(test::contains(refusal("return { verdict = 'reproducd' }"), "; did you mean 'reproduced'?"));
    BOOST_TEST(
        test::contains(refusal("return { verdict = 'open' }"), "the verdict 'open', which is not one of"));
    const auto with = [](const std::string &entry) {
        return refusal("return { verdict = 'inconclusive', " + entry + " }");
    };
    BOOST_TEST(
        test::contains(with("efect = 1"), "returned 'efect'; did you mean 'effect'? (allowed: verdict, "));
    BOOST_TEST(test::contains(with("1"), "returned 'number' (allowed: "));
    BOOST_TEST(test::contains(with("p = 1.5"), "returned a p that must be from 0 to 1, not 1.5"));
    BOOST_TEST(test::contains(with("p_equivalence = -1"),
                              "returned a p_equivalence that must be from 0 to 1, not -1"));
    BOOST_TEST(test::contains(with("effect = 0 / 0"), "returned a effect that must be finite, not nan"));
    BOOST_TEST(test::contains(with("low = math.huge"), "must be finite, not infinite"));
    BOOST_TEST(test::contains(with("effect = '1'"), "must be a number, not string"));
    BOOST_TEST(test::contains(with("effect = false"), "must be a number, not boolean"));
    BOOST_TEST(test::contains(with("note = 3"), "returned a note that must be a text, not number"));
    BOOST_TEST(test::contains(with("note = 'a\\nb'"), "returned a note that must be one line"));
    BOOST_TEST(test::contains(with("note = 'a\\0b'"), "returned a note that must be one line"));
    BOOST_TEST(test::contains(with("effect = claim.x"), "(in the judge of claim 'S')"));
}

BOOST_AUTO_TEST_CASE(a_table_is_a_list_of_rows) {
    const OwnTable by_name = table("return { { b = 1, a = 'x' }, { a = 'y, z' } }");
    BOOST_TEST(by_name.columns == std::vector<std::string>({"a", "b"}), boost::test_tools::per_element());
    BOOST_REQUIRE(by_name.rows.size() == 2u);
    BOOST_TEST(line_of(by_name.rows[0]) == "x,1\n");
    BOOST_TEST(line_of(by_name.rows[1]) == "\"y, z\",\n");
    const OwnTable stated = table("return { columns = { 'b', 'a' }, { a = 'x', b = 0.1 } }");
    BOOST_TEST(line_of(stated.rows.at(0)) == "0.1,x\n");
    BOOST_TEST(table("return { columns = { 'a' } }").rows.empty());
}

BOOST_AUTO_TEST_CASE(what_is_no_table_is_an_error_with_place_and_nearest_name) {
    const auto says = [](const std::string &result, const std::string &words) {
        const std::string said = refusal_of_table("return " + result);
        BOOST_TEST(said.starts_with("test.lua:2: the table 't' "), said);
        BOOST_TEST(test::contains(said, words), said);
    };
    says("nil", "returned nil, not a list of rows");
    says("{}", "has neither rows nor columns; return { columns = { … } } for a table without rows");
    says("{ 1 }", "row 1: must be a table, not number");
    says("{ { 1 } }", "has neither rows nor columns");
    says("{ { a = 1 }, { a = 1, 5 } }", "row 2: a row is {column = value}, and this one has a list");
    says("{ { value = 1 }, { valu = 2 } }",
         "row 2: has 'valu', which is not a column; did you mean 'value'? (columns: value)");
    says("{ columns = { 'a' }, { b = 1 } }", "row 1: has 'b', which is not a column");
    says("{ columns = { 'a', 'a' }, { a = 1 } }", "has the column 'a' twice");
    says("{ columns = { 'a,b' } }", "has the column 'a,b', which must be a name");
    says("{ columns = 'a' }", "returned columns that must be a list of names, not string");
    says("{ columns = { 1 } }", "returned columns that must be a list of names");
    says("{ column = { 'a' }, { a = 1 } }", "returned 'column' beside its rows (allowed: columns)");
    says("{ { a = 0 / 0 } }", "row 1: a must be finite, not nan");
    says("{ { a = true } }", "row 1: a must be a number or a text, not boolean");
    says("{ { a = 'x\\ny' } }", "row 1: a must be one line");
}

BOOST_AUTO_TEST_CASE(nothing_is_kept_between_two_calls_of_the_core) {
    const StatisticSource source =
        test::statistics("claims = { (function() local n = 0 return " +
                         judge("n = n + 1 return { verdict = 'inconclusive', effect = n }") + " end)() }");
    const auto call = judge_of(source, 0);
    const test::FakeRuns runs;
    const Claim claim = fake_claim();
    Asked asked;
    BOOST_TEST(call({runs.data(), claim, 5}, asked).effect.value() == 1);
    BOOST_TEST(call({runs.data(), claim, 5}, asked).effect.value() == 1);
}

BOOST_AUTO_TEST_CASE(missing_data_end_a_call_without_an_error_but_other_errors_do_not) {
    const test::FakeRuns runs;
    const auto call =
        table_of(test::statistics("tables = { t = function(runs) return { { x = runs.other.name } } end, "
                                  "u = function(runs) return { { x = runs.ns.nam } } end }"),
                 "t");
    Asked asked;
    BOOST_TEST(call(runs.data(), asked).columns.empty());
    BOOST_TEST(asked.missing);
    BOOST_TEST(
        refusal_of_table("return { { x = runs.ns.nam } }", Allowance::reduce).starts_with("test.lua:2: "));
}

BOOST_AUTO_TEST_CASE(every_function_is_tried_out_and_all_errors_are_told) {
    const std::string good =
        judge("return { verdict = 'inconclusive', p = stats.rank_sum(runs.ns.best_fitness[4], "
              "runs.neat.best_fitness[4]).p }");
    BOOST_TEST(tried("claims = { " + good + " }", 1) == "");
    const std::string said =
        tried("claims = {\n" + good + ",\n" + judge("return { verdict = runs.ns.x }") + ",\n" +
                  judge("return 1") + " },\ntables = {\nt = function() error('mine') end }",
              3, {"t"});
    BOOST_TEST(test::contains(said, "test.lua:4: a setting has no 'x'"), said);
    BOOST_TEST(test::contains(said, "test.lua:5: the judge of claim 'S3' returned number"), said);
    BOOST_TEST(test::contains(said, "test.lua:7: mine (in the table 't')"), said);
}

BOOST_AUTO_TEST_CASE(examples_are_as_runs_are) {
    // As many generations as the script plans, though these settings have fewer; a value may be missing.
    BOOST_TEST(tried("tables = { t = function(runs) return { { x = runs.ns.best_fitness[10][3] } } end }", 0,
                     {"t"}) == "");
    BOOST_TEST(test::contains(
        tried("tables = { t = function(runs) return { { x = runs.ns.best_fitness[11][1] } } end }", 0, {"t"}),
        "have 10 generations"));
    BOOST_TEST(test::contains(tried("tables = { t = function(runs, stats) return { { x = "
                                    "stats.mean(runs.ns.direction_resultant[10]) } } end }",
                                    0, {"t"}),
                              "is missing (false): leave it out with stats.present"));
    // Intervals are made, whatever interval_runs; endpoints and archives can be read.
    BOOST_TEST(test::contains(tried("tables = { t = function(runs, stats) if #runs.ns >= stats.interval_runs "
                                    "then error('seen') end end }",
                                    0, {"t"}),
                              "seen"));
    BOOST_TEST(tried("tables = { t = function(runs) return { { x = runs.ns[1].endpoints[1].x + "
                     "runs.ns[1].archive[1].behaviour[2] } } end }",
                     0, {"t"}) == "");
    // One run is planned: no test of two values.
    const std::string bca =
        "tables = { t = function(runs, stats) return { { x = stats.bootstrap(runs.ns.best_fitness[4], "
        "stats.mean, { method = 'bca' }).low } } end }";
    BOOST_TEST(test::contains(tried(bca, 0, {"t"}, 1), "needs at least 2 values"));
    BOOST_TEST(tried(bca, 0, {"t"}, 6) == "");
}

BOOST_AUTO_TEST_CASE(hostile_functions_end) {
    for (const char *body :
         {"while true do end", "local s = 'x' while true do s = s .. s end",
          "local t = {} while true do t[#t + 1] = {} end", "local function f() return f() + 1 end return f()",
          "pcall(function() while true do end end) return {}",
          "for i = 1, 1e9 do stats.rank_sum({ 1, 2, 3 }, { 4, 5, 6 }) end", "return setmetatable({}, {})",
          "os.exit(1)", "io.open('/etc/passwd')", "return math.random()", "return loadstring('x')",
          "error({})", "error()", "runs.ns.best_fitness[1] = 1", "local t = {} t.t = t return t"})
        BOOST_TEST(refusal_of_table(body).starts_with("test.lua:2: "),
                   body << ": " << refusal_of_table(body));
    // The first that exceeds a limit is the last that is called.
    const std::string endless =
        "claims = { " + judge("while true do end") + ", " + judge("while true do end") + " }";
    const std::string said = tried(endless, 2);
    BOOST_TEST(test::contains(said, "too many instructions"));
    BOOST_TEST(!test::contains(said, "S2"));
}
