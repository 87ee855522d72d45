// SPDX-License-Identifier: MIT
#include "experiment/deciding.h"

#include "evolution/search.h"
#include "experiment/run.h"
#include "experiment/signature.h"
#include "swimmers.h"

#include <boost/test/unit_test.hpp>

#include <set>
#include <string>

using namespace planula;

BOOST_AUTO_TEST_CASE(all_parameters_decide_lives_but_lengths_and_statistics) {
    std::set<std::string_view> others;
    for (const ParameterRow &row : parameter_rows())
        if (!decides_lives(row)) others.insert(row.name);
    BOOST_TEST((others == std::set<std::string_view>{"seeds", "generations", "confidence",
                                                     "bootstrap_resamples", "exploit_bound", "unrest_bound",
                                                     "witness_nudge", "witness_nudges"}));
}

BOOST_AUTO_TEST_CASE(a_parameter_that_cannot_be_shown_has_a_reason) {
    for (const ParameterRow &row : parameter_rows())
        BOOST_TEST(why_not_shown(row.name).empty() == decides_lives(row), row.name);
    BOOST_TEST(why_not_shown("no_such") == "");
}

namespace {

Spec small(std::string_view search, Actuation actuation, bool on_land, bool with_start) {
    Spec spec = swimmers(search, actuation, 12, 200);
    spec.parameters.settling.settle_window = 20;
    spec.parameters.settling.settle_limit = 400;
    if (on_land) spec.environment = specimens::land();
    if (with_start) spec.start = {2, [](const Life &life) { return Evaluation{0, {life.elongation}, 1.0}; }};
    return spec;
}

std::string signature_of(const Spec &spec) {
    Signature signature;
    run(spec, 1, 1, [&](const Generation &generation) { signature.observe(generation); });
    return signature.hex();
}

/// Another value of the parameter, of those that go with the others.
double other_value(const ParameterRow &row) {
    if (row.is_choice()) return row.standard == 0 ? 1 : 0;
    if (row.name == "period_shortest") return 90;
    const double doubled = row.standard == 0 ? row.highest : 2 * row.standard;
    return doubled <= row.highest ? doubled : row.standard / 2;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_parameter_that_a_setting_does_not_read_changes_no_bit_of_its_runs) {
    for (const std::string_view search : search_names())
        for (const Actuation actuation : {Actuation::oscillator, Actuation::grn})
            for (const bool other : {false, true}) {
                Spec spec = small(search, actuation, other, other);
                const std::string before = signature_of(spec);
                int unread = 0;
                for (const ParameterRow &row : parameter_rows()) {
                    if (why_unread(row, spec).empty()) continue;
                    set_parameter(spec.parameters, row.name, other_value(row));
                    ++unread;
                }
                BOOST_TEST(unread > 0);
                BOOST_TEST(signature_of(spec) == before, search << ", " << name_of(actuation));
            }
}

BOOST_AUTO_TEST_CASE(a_parameter_is_unread_where_its_reader_has_no_part) {
    const auto unread = [](std::string_view name, const Spec &spec) {
        return !why_unread(parameter_row(name), spec).empty();
    };
    const Spec oscillator = small("neat", Actuation::oscillator, false, false);
    const Spec grn = small("novelty", Actuation::grn, true, false);
    for (const char *name : {"novelty_neighbours", "update_interval", "settle_window", "niche_width"})
        BOOST_TEST(unread(name, oscillator), name);
    for (const char *name :
         {"novelty_neighbours", "update_interval", "settle_window", "young_age", "activity_bonus"})
        BOOST_TEST(unread(name, grn) ==
                       (std::string_view(name) == "young_age" || std::string_view(name) == "activity_bonus"),
                   name);
    for (const char *name : {"population", "spring_stiffness", "weight_power", "confidence", "seeds"})
        BOOST_TEST(!unread(name, oscillator), name);
    BOOST_TEST(!unread("novelty_neighbours", small("neat", Actuation::oscillator, false, true)));
    // A search of which nothing is known here may read all that searches read.
    const Spec unknown = small("another", Actuation::grn, true, true);
    for (const ParameterRow &row : parameter_rows())
        if (row.section == "NEAT" || row.section == "Novelty search" || row.section == "MAP-Elites")
            BOOST_TEST(!unread(row.name, unknown), row.name);
}
