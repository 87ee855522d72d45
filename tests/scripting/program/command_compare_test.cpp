// SPDX-License-Identifier: MIT
#include "support/commands.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace planula;
using namespace planula::test;

namespace {

/// Two scripts with a setting each, and recorded runs of both.
struct Two : Workplace {
    Two() {
        test::write(path / "other.lua", replaced(replaced(small, "novelty", "neat"), "'small'", "'other'"));
        for (const std::string name : {"small", "other"}) run_of(name, {"--seeds", "1:6"});
    }
    std::string script_of(const std::string &name) const { return path / (name + ".lua"); }
    std::string runs_of(const std::string &name) const { return path / ("runs-" + name); }
    void run_of(const std::string &name, std::vector<std::string> words) const {
        words.insert(words.begin(), {"run", script_of(name), "--out", runs_of(name), "--threads", "1"});
        BOOST_REQUIRE(planula_says(words).code == 0);
    }
    Said says(std::vector<std::string> words = {}) const {
        words.insert(words.begin(), {"compare", script_of("small"), script_of("other"), "--runs",
                                     runs_of("small"), "--runs", runs_of("other")});
        return planula_says(words);
    }
};

} // namespace

BOOST_AUTO_TEST_CASE(two_scripts_are_compared_from_their_runs) {
    const Two two;
    const std::string out = two.path / "compared";
    const Said said = two.says({"--measure", "species", "--measure", "mean_fitness", "--out", out});
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(said.out.starts_with("small against other: species after 2 generations\n"), said.out);
    BOOST_TEST(contains(said.out, "6 pairs of the same seed"));
    BOOST_TEST(
        contains(said.out, "\nOver 6 paired seeds, small and other had the same species in every pair "),
        said.out);
    BOOST_TEST(contains(said.out, "\nOver 6 paired seeds, small had a median mean fitness of "), said.out);
    for (const char *file :
         {"comparisons.csv", "compared_runs.csv", "compared_settings.csv", "species.svg", "mean_fitness.svg"})
        BOOST_TEST(std::filesystem::exists(std::filesystem::path(out) / file), file);

    // Equal bytes another time, and unpaired as another test.
    const std::string again = two.path / "again";
    BOOST_TEST(two.says({"--measure", "species", "--measure", "mean_fitness", "--out", again}).code == 0);
    BOOST_TEST(difference(out, again) == "");
    BOOST_TEST(contains(two.says({"--unpaired"}).out, "6 against 6, not paired"));
    BOOST_TEST(contains(two.says({"--seeds", "2:4"}).out, "  runs        3 pairs of the same seed\n"));
}

BOOST_AUTO_TEST_CASE(settings_of_one_script_are_named_and_equal_names_told_apart) {
    const Two two;
    const Said twice = planula_says({"compare", two.script_of("small"), two.script_of("small")});
    BOOST_TEST(twice.code == 2);
    BOOST_TEST(contains(twice.err, "is named twice"), twice.err);

    test::write(two.path / "twin.lua", replaced(content(two.script_of("other")), "'other'", "'small'"));
    two.run_of("twin", {"--seeds", "1:2"});
    const Said twin = planula_says({"compare", two.script_of("small"), two.script_of("twin"), "--runs",
                                    two.runs_of("small"), "--runs", two.runs_of("twin")});
    BOOST_TEST(twin.code == 0, twin.err);
    BOOST_TEST(contains(twin.out, "small.lua:small against "), twin.out);
    BOOST_TEST(contains(twin.out, "4 runs without a partner of the same seed left out"), twin.out);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_compared_is_a_usage_error_with_the_nearest_name) {
    const Two two;
    const auto refuses = [](const Said &said, const std::string &message) {
        BOOST_TEST(said.code == 2);
        BOOST_TEST(contains(said.err, message), said.err);
    };
    const std::string script = two.script_of("small");
    refuses(planula_says({"compare", script}), "needs two settings or more; " + script + " has one, small");
    refuses(planula_says({"compare", script + ":smal", script}),
            "has no setting 'smal'; did you mean 'small'?\nits settings are small");
    refuses(two.says({"--measure", "fitness_median_"}),
            "--measure: there is no measure 'fitness_median_'; did you "
            "mean 'fitness_median'?");
    refuses(two.says({"--measure", "valid", "--measure", "valid"}), "--measure valid is given twice");
    refuses(two.says({"--against", "othr"}),
            "--against othr: no such setting is compared; did you mean 'other'?\n"
            "these are: small, other");
    refuses(two.says({"--runs", "third"}), "--runs is given once, or once for each of the 2 scripts");
    refuses(two.says({"--log"}), "--log is about the pictures that --out writes");
    const Said missing =
        planula_says({"compare", script, two.script_of("other"), "--runs", two.runs_of("small")});
    BOOST_TEST(missing.code == 65);
    BOOST_TEST(contains(missing.err, "there is no run of other below " + two.runs_of("small")), missing.err);
}
