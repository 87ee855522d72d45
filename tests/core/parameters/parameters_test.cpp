// SPDX-License-Identifier: MIT
#include "parameters/parameters.h"

#include "base/error.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <set>

using namespace planula;

namespace {

auto says(const std::string &part) {
    return
        [part](const InputError &error) { return std::string(error.what()).find(part) != std::string::npos; };
}

} // namespace

BOOST_AUTO_TEST_CASE(every_row_is_within_its_own_range_named_once_and_explained) {
    std::set<std::string_view> names;
    for (const ParameterRow &row : parameter_rows()) {
        BOOST_TEST_CONTEXT(row.name) {
            BOOST_TEST((row.lowest <= row.standard && row.standard <= row.highest));
            BOOST_TEST((!row.whole || row.standard == std::trunc(row.standard)));
            BOOST_TEST(names.insert(row.name).second);
            BOOST_TEST(!row.section.empty());
            BOOST_TEST(!row.unit.empty());
            BOOST_TEST(!row.origin.empty());
            BOOST_TEST(row.meaning.size() > 10u);
            BOOST_TEST(parameter(Parameters{}, row.name) == row.standard);
        }
    }
    check_consistency(Parameters{});
}

BOOST_AUTO_TEST_CASE(numbers_that_the_paper_states_are_the_papers) {
    const Parameters p;
    BOOST_TEST(p.development.development_steps == 600);
    BOOST_TEST(p.development.decision_interval == 30);
    BOOST_TEST(p.development.neighbourhood_interval == 10);
    BOOST_TEST(p.development.link_limit == 1.5);
    BOOST_TEST(p.development.cell_limit == 256);
    BOOST_TEST(p.development.birth_limit == 1024);
    BOOST_TEST(p.development.minimum_cells == 8);
    BOOST_TEST(p.settling.settle_window == 800);
    BOOST_TEST(p.gait.ramp_steps == 200);
    BOOST_TEST(p.gait.locomotion_steps == 4000);
    BOOST_TEST(p.gait.update_interval == 50);
    BOOST_TEST(p.water.actuation_range_aquatic == 0.4);
    BOOST_TEST(p.land.actuation_range_terrestrial == 0.3);
    BOOST_TEST(p.novelty.novelty_neighbours == 15);
    BOOST_TEST(p.novelty.archive_run == 8);
    BOOST_TEST(p.novelty.archive_patience == 50);
    BOOST_TEST(p.neat.population == 300);
    BOOST_TEST(p.design.generations == 2000);
    BOOST_TEST(p.design.seeds == 20);
}

BOOST_AUTO_TEST_CASE(setting_a_parameter_changes_that_one) {
    Parameters p;
    set_parameter(p, "spring_stiffness", 123.5);
    set_parameter(p, "population", 40);
    for (const ParameterRow &row : parameter_rows()) {
        const double expected = row.name == "spring_stiffness" ? 123.5
                                : row.name == "population"     ? 40
                                                               : row.standard;
        BOOST_TEST(parameter(p, row.name) == expected, row.name);
    }
}

BOOST_AUTO_TEST_CASE(a_wrong_name_or_value_is_refused_with_the_rule) {
    Parameters p;
    BOOST_CHECK_EXCEPTION(set_parameter(p, "spring_stifness", 1), InputError, says("'spring_stiffness'"));
    BOOST_CHECK_EXCEPTION(set_parameter(p, "population", 1), InputError, says("outside 2"));
    BOOST_CHECK_EXCEPTION(set_parameter(p, "population", 40.5), InputError, says("whole number"));
    BOOST_CHECK_EXCEPTION(set_parameter(p, "gravity", std::nan("")), InputError, says("gravity = nan"));
    BOOST_CHECK_EXCEPTION(set_parameter(p, "gravity", std::numeric_limits<double>::infinity()), InputError,
                          says("outside"));
    p.neat.species_low = 20;
    BOOST_CHECK_EXCEPTION(check_consistency(p), InputError, says("species_low is at most species_high"));
}

BOOST_AUTO_TEST_CASE(a_choice_has_names_and_each_is_a_value) {
    const ParameterRow &row = parameter_row("division_turn");
    BOOST_TEST((row.names == std::vector<std::string_view>{"nobody", "daughter", "both"}));
    Parameters p;
    for (const ParameterRow &each : parameter_rows()) {
        BOOST_TEST(each.is_choice() == (each.names.size() > 1), each.name);
        for (const std::string_view name : each.names) {
            const double value = value_of(each, name);
            set_parameter(p, each.name, value);
            BOOST_TEST(value_text(each, parameter(p, each.name)) == name);
        }
    }
    set_parameter(p, "division_turn", value_of(row, "daughter"));
    BOOST_TEST((p.development.division_turn == DivisionTurn::daughter));
}

BOOST_AUTO_TEST_CASE(a_word_that_states_no_value_is_refused_with_the_rule) {
    const ParameterRow &turn = parameter_row("division_turn"), &gravity = parameter_row("gravity");
    BOOST_TEST(value_of(gravity, "2.5") == 2.5);
    BOOST_TEST(value_text(gravity, 2.5) == "2.5");
    BOOST_CHECK_EXCEPTION(value_of(turn, "nobdy"), InputError,
                          says("must be one of 'nobody', 'daughter', 'both'; did you mean 'nobody'?"));
    BOOST_CHECK_EXCEPTION(value_of(turn, "0"), InputError, says("division_turn = 0 must be one of"));
    BOOST_CHECK_EXCEPTION(value_of(gravity, "high"), InputError, says("gravity = high must be a number"));
    Parameters p;
    BOOST_CHECK_EXCEPTION(set_parameter(p, "division_turn", 3), InputError, says("outside 0"));
}
