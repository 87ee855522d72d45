// SPDX-License-Identifier: MIT
// Statistics that a test states in Lua, on runs that it makes by hand.
#pragma once

#include "core/analysis/fake_setting.h"
#include "statement/statistic_state.h"
#include "support/scripts.h"

#include <map>
#include <string>
#include <vector>

namespace planula::test {

/// Settings "ns", "neat" and "other", which has no runs; end points and archives as stated.
class FakeRuns {
  public:
    explicit FakeRuns(const std::vector<double> &ns = {1, 2, 3}, const std::vector<double> &neat = {4, 5, 7})
        : settings{fake_setting(specs_[0], ns), fake_setting(specs_[1], neat), fake_setting(specs_[2], {})} {}

    RunData data() const {
        return {analysis, settings,
                [](const SettingRuns &, std::size_t run) {
                    return std::vector<EndpointRow>{{"ns", 1, "", 4, 1.5, static_cast<double>(run)}};
                },
                [](const SettingRuns &, std::size_t) {
                    return std::vector<ArchiveEntry>{{2, 7, {1, 2, 3}, 0.5, 9}, {3, 8, {4}, 0.5, 1}};
                }};
    }

  private:
    std::vector<Spec> specs_{fake_spec("ns", 10, 10), fake_spec("neat", 10, 10), fake_spec("other", 10, 10)};

  public:
    Analysis analysis = fake_analysis();
    std::vector<SettingRuns> settings;
};

inline StatisticSource statistics(const std::string &fields) {
    return {script("return { statistics = {\n" + fields + "\n} }"), ""};
}

/// The table t of a script whose function has this body.
inline OwnTable table(const std::string &body, const FakeRuns &runs, Asked &asked,
                      Allowance allowance = Allowance::reduce) {
    const StatisticSource source = statistics("tables = { t = function(runs, stats) " + body + " end }");
    return StatisticState(source, runs.analysis, allowance).make("t", runs.data(), asked);
}

/// The number that the expression has, after these statements.
inline double number(const std::string &expression, const std::string &statements = "",
                     const FakeRuns &runs = FakeRuns()) {
    Asked asked;
    const OwnTable made = table(statements + " return { { x = " + expression + " } }", runs, asked);
    return std::get<double>(made.rows.at(0).at(0));
}

/// The error of a table's function; "" without one.
inline std::string refusal_of_table(const std::string &body, Allowance allowance = Allowance::trial) {
    return refusal([&] {
        Asked asked;
        table(body, FakeRuns(), asked, allowance);
    });
}

/// What a judge with this body says of claim S about ns and neat.
inline Finding finding(const std::string &body, const FakeRuns &runs = FakeRuns(),
                       const std::string &id = "S") {
    const StatisticSource source =
        statistics("claims = { { judge = function(runs, stats, claim) " + body + " end } }");
    Claim claim = fake_claim();
    claim.id = id;
    Asked asked;
    return StatisticState(source, runs.analysis, Allowance::trial).judge(0, {runs.data(), claim, 8}, asked);
}

} // namespace planula::test
