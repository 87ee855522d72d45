// SPDX-License-Identifier: MIT
// The command line as a whole; each command has a test file of its own.
#include "support/commands.h"

#include "experiment/revision.h"
#include "tables/manifest.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstdlib>
#include <sstream>

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

BOOST_AUTO_TEST_CASE(help_is_plain_and_fits_a_terminal) {
    std::vector<std::string> texts{planula_says({"--help"}).out};
    for (const Command *command : all_commands()) {
        texts.push_back(planula_says({"help", std::string(command->name)}).out);
        BOOST_TEST(texts.back() == planula_says({std::string(command->name), "--help"}).out);
    }
    for (const std::string &text : texts) {
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) BOOST_TEST(columns_of(line) <= 80u, line);
    }
}

namespace {

/// What bash completes after these words, the last of which is begun.
std::string completed(const std::string &words) {
    const Workplace place;
    test::write(place.path / "script", planula_says({"completion", "bash"}).out +
                                           "compopt() { :; }\nCOMP_WORDS=(planula " + words +
                                           ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_planula\n"
                                           "echo \"${COMPREPLY[*]}\" > said\n");
    const std::string call = "cd " + place.path.string() + " && bash script";
    if (std::system(call.c_str()) != 0) return "bash failed";
    const std::string said = content(place.path / "said");
    return said.substr(0, said.size() - 1);
}

} // namespace

BOOST_AUTO_TEST_CASE(bash_completes_commands_options_and_values) {
    BOOST_TEST(completed("sta") == "status");
    BOOST_TEST(completed("run --ge") == "--generations");
    BOOST_TEST(completed("run --lanes s") == "scalar sse2");
    BOOST_TEST(completed("run --set frict") == "friction=");
    BOOST_TEST(completed("sensitivity --parameter frict") == "friction");
    BOOST_TEST(completed("genome --genome ''") == "best");
    BOOST_TEST(completed("check ''") == "small.lua");
    BOOST_TEST(completed("compare ''") == "small.lua");
    BOOST_TEST(completed("run --seeds ''") == "");
    BOOST_TEST(completed("nonsense --x") == "");
    BOOST_TEST(planula_says({"completion", "fish"}).code == 2);
}

BOOST_AUTO_TEST_CASE(a_bad_command_line_ends_with_2_and_the_nearest_name) {
    BOOST_TEST(planula_says({}).code == 2);
    BOOST_TEST(planula_says({}).err == planula_says({"--help"}).out);
    const Said misspelt = planula_says({"chek"});
    BOOST_TEST(misspelt.code == 2);
    BOOST_TEST(contains(misspelt.err, "no command 'chek'; did you mean 'check'?"));
    BOOST_TEST(contains(planula_says({"mine.lua"}).err, "as in planula run mine.lua"));
    BOOST_TEST(contains(planula_says({"resume"}).err, "no command 'resume': planula run resumes"));
    const Workplace place;
    const auto refused = [&](std::vector<std::string> words, const std::string &part) {
        words.insert(words.begin(), {"run", place.script(), "--out", place.runs()});
        const Said said = planula_says(words);
        BOOST_TEST(said.code == 2, part);
        BOOST_TEST(contains(said.err, part), said.err);
    };
    refused({"--set", "populaton=5"}, "did you mean 'population'?");
    refused({"--set", "gait_time=hold"}, "must be one of 'held', 'rising'; did you mean 'held'?");
    refused({"--set", "population"}, "--set takes NAME=VALUE, not 'population'");
    refused({"--set", "population=x"}, "--set population takes a number, not 'x'");
    refused({"--generations", "0"}, "generations = 0 is outside");
    refused({"--seeds", "3:1"}, "A:B needs A <= B");
    refused({"--seeds", "a"}, "--seeds takes A:B or N, whole numbers");
    refused({"--seeds", "1:2:3"}, "--seeds takes A:B or N, whole numbers");
    refused({"--threads", "0"}, "--threads takes a whole number of 1 or more");
    refused({"--only", "smal"}, "did you mean 'small'?");
    refused({"--lanes", "skalar"}, "no lanes 'skalar'; did you mean 'scalar'?");
    BOOST_TEST(!fs::exists(place.runs()));
}

namespace {

/// What `planula check` says of a script with these settings and --set `word`.
Said check_with(const std::string &settings, const std::string &word) {
    const Workplace place("local paper = require 'paper'\n"
                          "return paper.design { name = 'small', settings = {\n" +
                          settings + "} }\n");
    Said said = planula_says({"check", place.script(), "--set", word});
    said.err = replaced(said.err + place.script(), place.script(), "small.lua");
    return said;
}

const char *const on_land = "{ name = 'land', environment = paper.terrestrial() },\n";
const char *const in_water = "{ name = 'water' },\n";
const char *const on_the_moon = "{ name = 'moon', environment = paper.terrestrial {\n"
                                "gravity = 0.8 } },\n";

} // namespace

BOOST_AUTO_TEST_CASE(a_value_that_the_script_states_itself_cannot_be_set) {
    const Said moon = check_with(on_the_moon, "gravity=3");
    BOOST_TEST(moon.code == 2);
    BOOST_TEST(contains(moon.err, "--set gravity=3 changes nothing"), moon.err);
    BOOST_TEST(contains(moon.err, "moon: small.lua:4 states the number, 0.8"), moon.err);
    BOOST_TEST(contains(moon.err, "gravity = \"gravity\""), moon.err);
    BOOST_TEST(check_with(std::string(on_the_moon) + on_land, "gravity=3").code == 0);
    const Said water = check_with(std::string(on_the_moon) + in_water, "gravity=3");
    BOOST_TEST(water.code == 2);
    BOOST_TEST(contains(water.err, "water: its environment has no gravity"), water.err);
    const Said drag = check_with("{ name = 'honey', environment = paper.aquatic { drag = {\nnormal = 8 } } }",
                                 "drag_normal=3");
    BOOST_TEST(contains(drag.err, "honey: small.lua:4 states the number, 8"), drag.err);
    BOOST_TEST(contains(drag.err, "normal = \"drag_normal\""), drag.err);
}

BOOST_AUTO_TEST_CASE(a_value_that_no_setting_reads_cannot_be_set) {
    const Said said = check_with(std::string(in_water) + on_land, "novelty_neighbours=5");
    BOOST_TEST(said.code == 2);
    BOOST_TEST(contains(said.err, "water, land: their search is 'neat'"), said.err);
    const std::string novel = "{ name = 'novel', search = 'novelty' },\n";
    BOOST_TEST(check_with(in_water + novel, "novelty_neighbours=5").code == 0);
    BOOST_TEST(check_with(in_water + novel, "niche_width=2").code == 2);
    BOOST_TEST(check_with(in_water, "settle_window=20").code == 2);
    BOOST_TEST(check_with(in_water, "update_interval=100").code == 2);
    // Parameters of statistics and the length of runs can always be set: some command reads them.
    for (const char *word : {"confidence=0.9", "seeds=3", "generations=5", "population=9"})
        BOOST_TEST(check_with(in_water, word).code == 0, word);
}

BOOST_AUTO_TEST_CASE(a_value_that_the_judging_functions_may_read_can_be_set) {
    BOOST_TEST(check_with(in_water, "activity_bonus=0").code == 0);
    BOOST_TEST(check_with("{ name = 'plain', fitness = function(life) return life.displacement end },",
                          "activity_bonus=0")
                   .code == 2);
    BOOST_TEST(
        check_with("{ name = 'heavy', fitness = function(life, p) return p.gravity end },", "gravity=1")
            .code == 0);
}

BOOST_AUTO_TEST_CASE(a_parameter_is_set_once) {
    const Workplace place;
    const auto refused = [&](std::vector<std::string> words) {
        const Said said = place.run_says(words);
        return said.code == 2 && contains(said.err, "is given twice");
    };
    BOOST_TEST(refused({"--set", "population=5", "--set", "population=6"}));
    BOOST_TEST(refused({"--set", "population=5", "--population", "6"}));
    BOOST_TEST(refused({"--set", "generations=5", "--levels", "6"}));
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

BOOST_AUTO_TEST_CASE(parameters_and_columns_have_a_line_for_each) {
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

BOOST_AUTO_TEST_CASE(the_program_prints_the_revision_of_its_model) {
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
