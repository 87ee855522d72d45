// SPDX-License-Identifier: MIT
// The command line as a whole; each command has a test file of its own.
#include "support/commands.h"

#include "experiment/revision.h"
#include "record/manifest.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace planula;
using namespace planula::test;

namespace {

namespace fs = std::filesystem;

} // namespace

BOOST_AUTO_TEST_CASE(help_names_every_command_and_each_has_its_own) {
    const Said help = planula_says({"--help"});
    BOOST_TEST(help.code == 0);
    for (const Command *command : all_commands()) {
        BOOST_TEST(contains(help.out, "\n  " + std::string(command->name) + " "), command->name);
        const Said own = planula_says({std::string(command->name), "--help"});
        BOOST_TEST(own.code == 0, command->name);
        BOOST_TEST(contains(own.out, "usage: planula " + std::string(command->name)), command->name);
    }
}

BOOST_AUTO_TEST_CASE(a_bad_command_line_ends_with_2_and_the_nearest_name) {
    BOOST_TEST(planula_says({}).code == 2);
    const Said misspelt = planula_says({"chek"});
    BOOST_TEST(misspelt.code == 2);
    BOOST_TEST(contains(misspelt.err, "no command 'chek'; did you mean 'check'?"));
    const Workplace place;
    const auto refused = [&](std::vector<std::string> words, const std::string &part) {
        words.insert(words.begin(), {"run", place.script(), "--out", place.runs()});
        const Said said = planula_says(words);
        BOOST_TEST(said.code == 2, part);
        BOOST_TEST(contains(said.err, part), said.err);
    };
    refused({"--set", "populaton=5"}, "did you mean 'population'?");
    refused({"--set", "gait_time=hold"}, "must be one of 'held', 'rising'; did you mean 'held'?");
    refused({"--set", "population"}, "--set takes name=value, not 'population'");
    refused({"--set", "population=x"}, "--set population takes a number, not 'x'");
    refused({"--generations", "0"}, "generations = 0 is outside");
    refused({"--seeds", "3:1"}, "A:B needs A <= B");
    refused({"--seeds", "a"}, "--seeds takes A:B or N");
    refused({"--seeds", "1:2:3"}, "--seeds takes A:B or N");
    refused({"--threads", "0"}, "--threads takes a whole number of 1 or more");
    refused({"--only", "smal"}, "did you mean 'small'?");
    refused({"--lanes", "skalar"}, "no lanes 'skalar'; did you mean 'scalar'?");
    BOOST_TEST(!fs::exists(place.runs()));
}

BOOST_AUTO_TEST_CASE(a_bad_script_ends_with_65) {
    const Workplace place("return { name = 5 }");
    for (const char *command : {"check", "run", "describe", "reduce", "frames", "witness", "sensitivity"}) {
        const Said said = planula_says({command, place.script()});
        BOOST_TEST(said.code == 65, command);
        BOOST_TEST(contains(said.err, "small.lua:1: name must be a text, not a number"), said.err);
    }
    BOOST_TEST(planula_says({"check", "nowhere.lua"}).code == 65);
}

BOOST_AUTO_TEST_CASE(check_and_describe_tell_what_is_there) {
    const Workplace place;
    const Said check = planula_says({"check", place.script()});
    BOOST_TEST(check.code == 0);
    BOOST_TEST(check.out == "ok: " + place.script() + ": small, 1 setting: small\n");
    const Said describe = planula_says({"describe", place.script(), "--set", "gravity=2"});
    BOOST_TEST(describe.code == 0);
    BOOST_TEST(contains(describe.out, "population = 6 genomes (standard 300, §2.7.2)"), describe.out);
    const Said choice = planula_says({"describe", place.script(), "--set", "gait_time=rising"});
    BOOST_TEST(contains(choice.out, "\n  gait_time = rising (standard held, ours): "), choice.out);
    BOOST_TEST(contains(describe.out, "gravity = 2 cell/t.u.² (standard 5, ours)"), describe.out);
}

BOOST_AUTO_TEST_CASE(the_ledger_and_the_dictionary_have_a_line_for_everything) {
    const Said plain = planula_says({"parameters"}), csv = planula_says({"parameters", "--csv"});
    for (const ParameterRow &row : parameter_rows()) {
        BOOST_TEST(contains(plain.out, "  " + std::string(row.name) + " = "), row.name);
        BOOST_TEST(contains(csv.out, "," + std::string(row.name) + ","), row.name);
    }
    BOOST_TEST(csv.out.starts_with("section,name,value,standard,unit,origin,meaning\n"));
    BOOST_TEST(planula_says({"columns"}).out.starts_with("file,column,unit,meaning\n"));
}

BOOST_AUTO_TEST_CASE(pace_has_a_row_for_the_first_generation_and_for_ten_at_a_time) {
    const Workplace place;
    const Said said = planula_says({"pace", place.script(), "--until", "12"});
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(std::count(said.out.begin(), said.out.end(), '\n') == 4);
    BOOST_TEST(contains(said.out, "\nsmall,0,0,6,0,"), said.out);
    BOOST_TEST(contains(said.out, "\nsmall,1,10,60,"), said.out);
    BOOST_TEST(contains(said.out, "\nsmall,11,12,12,"), said.out);
    // The script's own design: two seeds of two generations of six.
    BOOST_TEST(contains(said.err, "the whole design of small, 0.0 million individuals"), said.err);
    BOOST_TEST(planula_says({"pace", place.script(), "--until", "-1"}).code == 2);
}

BOOST_AUTO_TEST_CASE(the_signature_is_one_hash_that_threads_do_not_change) {
    const Workplace place;
    const auto signature = [&](const char *threads) {
        return planula_says({"signature", "--script", place.script(), "--threads", threads});
    };
    const Said one = signature("1");
    BOOST_TEST(one.code == 0, one.err);
    BOOST_TEST(one.out.size() == 65u);
    BOOST_TEST(signature("3").out == one.out);
    test::write(place.script(), replaced(small, "population = 6", "population = 7"));
    BOOST_TEST(signature("1").out != one.out);
}

BOOST_AUTO_TEST_CASE(the_program_says_which_model_it_is) {
    const std::string revision(model_revision());
    BOOST_TEST(planula_says({"signature", "--compiled"}).out == revision + '\n');
    BOOST_TEST(planula_says({"--version"}).out ==
               "planula " + std::string(version()) + ", model " + revision.substr(0, 12) + '\n');
}

BOOST_AUTO_TEST_CASE(an_output_that_cannot_be_written_is_an_error) {
    std::ofstream full("/dev/full");
    std::ostringstream err;
    Console console{full, err, false, test::experiments_folder()};
    BOOST_TEST(run_program({"parameters"}, console) == 74);
    BOOST_TEST(contains(err.str(), "the standard output cannot be written"));
}
