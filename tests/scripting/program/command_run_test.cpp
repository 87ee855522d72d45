// SPDX-License-Identifier: MIT
// planula run: what makes two runs the same, which folders it accepts, and that stopping and resuming change no byte.
#include "base/lane_sets.h"
#include "record/kept_state.h"
#include "record/run_reader.h"
#include "support/commands.h"
#include "tables/csv.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <chrono>
#include <set>

using namespace planula;
using namespace planula::test;

namespace {

namespace fs = std::filesystem;

/// An experiment that states everything that a run can depend on.
const char *const stated = R"(
local rules = require 'rules'
local half = 0.5
local function scaled(x)
  return x * half
end
return {
  name = 'small', title = 'A title',
  settings = {
    { name = 'small', title = 'Another title', actuation = 'grn', search = 'novelty',
      environment = { gravity = 5, ground = 'flat', friction = 0.8, drag = { normal = 1, tangential = 0.5 },
                      flow = { x = 0.1, y = 0 }, actuation_range = 0.3 },
      parameters = { population = 6, development_steps = 200, locomotion_steps = 100, settle_limit = 1000 },
      fitness = function(life, parameters, p)
        return scaled(life.displacement) * p * rules.weight
      end,
      penalty = function(life)
        return life.outcome == 'viable' and 1 or 0
      end,
      behaviour = function(life)
        return { life.finish.x, life.finish.y }
      end,
      start = { generations = 2, behaviour = function(life)
        return { life.cells }
      end } },
  },
  parameters = { generations = 2, seeds = 1 },
  statistics = { confidence = 0.95, resamples = 100, significance = 0.05, sample_share = 0.5,
                 sample_least = 10, claims = {} },
}
)";
const std::string start_text = R"(start = { generations = 2, behaviour = function(life)
        return { life.cells }
      end })";
const std::string other_setting =
    "{ name = 'other', actuation = 'oscillator', search = 'neat', environment = { actuation_range = 0.3 },\n"
    "fitness = function() return 1 end, penalty = function() return 1 end,\n"
    "behaviour = function() return { 1 } end }";
const char *const rules = "local unread = 3\nreturn { weight = 2 }\n";

/// A change of the script, and options of the command.
struct Change {
    std::string what, from, to;
    std::vector<std::string> options = {};
    std::string file = "small.lua";
};

struct Identities : Workplace {
    Identities() : Workplace(stated) {
        test::write(path / "rules.lua", rules);
        const Said said = run_says();
        BOOST_REQUIRE_MESSAGE(said.code == 0, said.err);
    }
    /// The command with a change, into the folder that holds the run.
    Said says(const Change &change) const {
        const std::string text = change.file == "rules.lua" ? rules : stated;
        test::write(path / change.file, change.from.empty() ? text : replaced(text, change.from, change.to));
        const Said said = run_says(change.options);
        test::write(path / "small.lua", stated);
        test::write(path / "rules.lua", rules);
        return said;
    }
};

} // namespace

BOOST_AUTO_TEST_CASE(changes_without_effect_on_results_keep_the_identity) {
    const Identities place;
    const auto before = all_files(place.runs());
    const std::string setting = "{ name = 'small', title";
    for (const Change &change : std::vector<Change>{
             {"nothing", "", ""},
             {"a comment", "local half = 0.5", "local half = 0.5 -- a half"},
             {"a comment within a function", "return x * half", "return x --[[ times ]] * half"},
             {"white space", "scaled(x)\n  return x * half\nend", "\n\nscaled( x )\nreturn x*half end"},
             {"a number in other words", "half = 0.5", "half = 5e-1"},
             {"the title", "'A title'", "'Words'"},
             {"the setting's title", "'Another title'", "'Words'"},
             {"a setting before", setting, other_setting + ",\n" + setting, {"--only", "small"}},
             {"a setting behind",
              "      end } },\n",
              "      end } },\n" + other_setting,
              {"--only", "small"}},
             {"the order of keys", "gravity = 5, ground = 'flat',", "ground = 'flat', gravity = 5,"},
             {"statistics", "resamples = 100, significance = 0.05", "resamples = 200, significance = 0.01"},
             {"a claim", "claims = {}",
              "claims = { { id = 'S1', statement = 's', a = 'small',\n"
              "judge = function() return { verdict = 'inconclusive' } end } }"},
             {"a value that no function reads", "local half", "local unread = 7 local half"},
             {"a value of a module that no function reads", "unread = 3", "unread = 4", {}, "rules.lua"},
             {"a standard value that is stated", "population = 6", "population = 6, link_limit = 1.5"},
             {"confidence", "", "", {"--set", "confidence=0.9"}},
             {"seeds", "", "", {"--set", "seeds=2", "--seeds", "1"}},
             {"seeds in the script", "seeds = 1", "seeds = 5", {"--seeds", "1"}},
             {"the bound of exploits", "", "", {"--set", "exploit_bound=0.2"}},
             {"fewer generations in the script", "generations = 2, seeds", "generations = 1, seeds"},
             {"fewer generations", "", "", {"--generations", "1"}},
             {"levels", "", "", {"--levels", "1,2"}},
             {"lanes", "", "", {"--lanes", "scalar"}},
             {"the interval of checkpoints", "", "", {"--checkpoint", "1"}},
         }) {
        const std::string widest(name_of(chosen_lanes()));
        const Said said = place.says(change);
        choose_lanes(widest);
        BOOST_TEST(said.code == 0, change.what << ": " << said.err);
        BOOST_TEST(contains(said.err, "1 of 1 runs have "), change.what << ": " << said.err);
        BOOST_TEST((all_files(place.runs()) == before), change.what);
    }
}

BOOST_AUTO_TEST_CASE(the_name_and_folder_of_the_script_do_not_matter) {
    const Identities place;
    const auto before = all_files(place.runs());
    fs::create_directories(place.path / "deep/er");
    for (const char *name : {"deep/er/small.lua", "deep/er/large.lua", "other.lua"}) {
        test::write(place.path / name, stated);
        const Said said = planula_says({"run", place.path / name, "--out", place.runs()});
        BOOST_TEST(said.code == 0, said.err);
        BOOST_TEST(contains(said.err, "1 of 1 runs have 2 generations already"), said.err);
    }
    BOOST_TEST((all_files(place.runs()) == before));
}

BOOST_AUTO_TEST_CASE(changes_with_effect_on_results_make_another_run_which_is_refused_by_name) {
    const Identities place;
    const auto before = all_files(place.runs());
    const auto function = [](const std::string &name, int line) {
        return "function " + name + ": recorded with that of experiment.lua:" + std::to_string(line);
    };
    for (const auto &[change, named] : std::vector<std::pair<Change, std::string>>{
             {{"gravity", "gravity = 5", "gravity = 4"},
              "environment gravity: recorded with 5, asked for with 4"},
             {{"no ground", "gravity = 5, ground = 'flat'", "gravity = 0"},
              "environment ground: recorded with flat, asked for with none"},
             {{"a hill", "ground = 'flat'", "ground = { { -9, 0 }, { 0, 1 }, { 9, 0 } }"},
              "environment ground: recorded with flat, asked for with 3 points"},
             {{"friction", "friction = 0.8", "friction = 0.7"}, "environment friction: "},
             {{"drag across", "normal = 1", "normal = 2"}, "environment drag normal: "},
             {{"drag along", "tangential = 0.5", "tangential = 0.1"}, "environment drag tangential: "},
             {{"flow along", "flow = { x = 0.1, y = 0 }", "flow = { x = 0.2, y = 0 }"},
              "environment flow x: "},
             {{"flow across", "flow = { x = 0.1, y = 0 }", "flow = { x = 0.1, y = 0.1 }"},
              "environment flow y: "},
             {{"the range", "actuation_range = 0.3", "actuation_range = 0.2"},
              "environment actuation_range: "},
             {{"the engine", "search = 'novelty'", "search = 'novelty', engine = 'bullet'"},
              "engine: recorded with native, asked for with bullet"},
             {{"the search", "search = 'novelty'", "search = 'neat'"},
              "search: recorded with novelty, asked for with neat"},
             {{"the actuation", "actuation = 'grn'", "actuation = 'oscillator'"},
              "actuation: recorded with grn, asked for with oscillator"},
             {{"the start's length", "start = { generations = 2", "start = { generations = 3"},
              "start: recorded with 2 generations, asked for with 3 generations"},
             {{"the start's behaviour", "return { life.cells }", "return { life.cells, 1 }"},
              function("start.behaviour", 23)},
             {{"no start", start_text, ""}, "start: recorded with 2 generations, asked for with none"},
             {{"the population", "population = 6", "population = 7"},
              "parameter population: recorded with 6, asked for with 7"},
             {{"the population, outside", "", "", {"--population", "7"}},
              "parameter population: recorded with 6, asked for with 7"},
             {{"a constant in fitness", "* p * rules.weight", "* p * rules.weight * 1.5"},
              function("fitness", 14)},
             {{"a value that a helper reads", "half = 0.5", "half = 0.6"}, function("fitness", 14)},
             {{"a helper", "return x * half", "return x + half"}, function("fitness", 14)},
             {{"a value of a module", "weight = 2", "weight = 4", {}, "rules.lua"}, function("fitness", 14)},
             {{"the penalty", "and 1 or 0", "and 0.5 or 0"}, function("penalty", 17)},
             {{"the behaviour", "{ life.finish.x, life.finish.y }", "{ life.finish.y, life.finish.x }"},
              function("behaviour", 20)},
         }) {
        const Said said = place.says(change);
        BOOST_TEST(said.code == 73, change.what << ": " << said.err);
        BOOST_TEST(contains(said.err, place.run().string() + " holds another run"),
                   change.what << ": " << said.err);
        BOOST_TEST(contains(said.err, "\n    " + named), change.what << ": " << said.err);
        BOOST_TEST(contains(said.err, "Nothing was changed."), said.err);
        BOOST_TEST((all_files(place.runs()) == before), change.what);
    }
    const Said edited = place.says({"", "half = 0.5", "half = 0.6"});
    BOOST_TEST(contains(edited.err, "asked for with that of " + place.script() + ":14"), edited.err);

    // With a start.
    fs::remove_all(place.runs());
    BOOST_TEST(place.says({"", start_text, ""}).code == 0);
    const Said added = place.says({"", "", ""});
    BOOST_TEST(added.code == 73);
    BOOST_TEST(contains(added.err, "\n    start: recorded with none, asked for with 2 generations"),
               added.err);
    BOOST_TEST(contains(added.err, "\n    function start.behaviour: recorded with that of nowhere"),
               added.err);
}

BOOST_AUTO_TEST_CASE(a_choice_from_the_command_line_is_recorded_by_name_and_read_back) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1", "--set", "division_turn=daughter"}).code == 0);
    const std::string kept = test::content(place.run() / "script" / "overrides.csv");
    BOOST_TEST(contains(kept, "division_turn,daughter"), kept);
    const Said verified = planula_says({"verify", place.runs()});
    BOOST_TEST(verified.code == 0, verified.err);
}

BOOST_AUTO_TEST_CASE(exactly_the_parameters_that_evolution_reads_make_another_run) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1"}).code == 0);
    const auto before = all_files(place.runs());
    const Experiment recorded = load_experiment(place.script(), experiments_folder());
    int deciding = 0;
    for (const ParameterRow &row : parameter_rows()) {
        const double value = parameter(recorded.settings[0].parameters, row.name);
        Said said{65, "", ""};
        // The first other value that is allowed.
        for (const double other :
             {value / 2, value * 2, value - 1, value + 1, value + 0.5, row.highest, row.lowest}) {
            if (said.code != 65) break;
            if (row.is_choice() && !(other == std::trunc(other) && other >= 0 && other <= row.highest))
                continue;
            if (other == value) continue;
            const std::string quote = row.is_choice() ? "'" : "";
            const std::string stated = std::string(row.name) + " = " + quote + value_text(row, other) + quote;
            test::write(place.script(),
                        replaced(small, "locomotion_steps = 100", "locomotion_steps = 100, " + stated));
            said = place.run_says({"--seeds", "1"});
        }
        const bool decides = row.section != "Statistics" && row.name != "seeds" && row.name != "generations";
        deciding += decides;
        BOOST_TEST(said.code == (decides ? 73 : 0), row.name << ": " << said.err);
        const std::string named = "parameter " + std::string(row.name) + ": recorded with " +
                                  value_text(row, value) + ", asked for with ";
        BOOST_TEST(contains(said.err, named) == decides, row.name << ": " << said.err);
        BOOST_TEST((all_files(place.runs()) == before), row.name);
    }
    BOOST_TEST(deciding > 80);
}

BOOST_AUTO_TEST_CASE(the_seed_of_a_run_is_that_of_its_record_not_of_its_folder) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1"}).code == 0);
    fs::rename(place.run(1), place.run(2));
    const auto before = all_files(place.runs());
    const Said said = place.run_says({"--seeds", "2"});
    BOOST_TEST(said.code == 73);
    BOOST_TEST(contains(said.err, "\n    seed: recorded with 1, asked for with 2\n"), said.err);
    BOOST_TEST((all_files(place.runs()) == before));
}

BOOST_AUTO_TEST_CASE(how_much_is_recorded_cannot_change_within_a_folder) {
    const std::string sample = replaced(small, "name = 'small'", "name = 'small', record = 'sample'");
    for (const bool full_first : {true, false}) {
        const Workplace place(full_first ? small : sample);
        BOOST_REQUIRE(place.run_says({"--seeds", "1"}).code == 0);
        const auto before = all_files(place.runs());
        test::write(place.script(), full_first ? sample : small);
        const Said said = place.run_says({"--seeds", "1"});
        BOOST_TEST(said.code == 73);
        BOOST_TEST(
            contains(said.err, full_first
                                   ? "holds this run with record = \"full\", and \"sample\" is asked for"
                                   : "holds this run with record = \"sample\", and \"full\" is asked for"),
            said.err);
        BOOST_TEST((all_files(place.runs()) == before));
    }
    const Workplace place(sample);
    BOOST_REQUIRE(place.run_says({"--seeds", "1"}).code == 0);
    test::write(place.script(), replaced(small, "name = 'small'", "name = 'small', record = 300"));
    BOOST_TEST(contains(place.run_says({"--seeds", "1"}).err,
                        "holds this run with record = \"sample\", and \"sample of 300\" is asked for"));
}

BOOST_AUTO_TEST_CASE(every_folder_is_checked_before_anything_is_written) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "2:3"}).code == 0);
    const auto before = all_files(place.runs());
    const Said said = place.run_says({"--seeds", "1:3", "--population", "8"});
    BOOST_TEST(said.code == 73);
    BOOST_TEST(contains(said.err, "Of the 3 runs asked for, 2 have such a folder. Nothing was changed."),
               said.err);
    BOOST_TEST(!fs::exists(place.run(1)));
    BOOST_TEST((all_files(place.runs()) == before));
}

BOOST_AUTO_TEST_CASE(a_folder_without_a_run_of_this_program_is_refused_by_name) {
    const Workplace place;
    const auto refused = [&](const std::string &part) {
        const auto before = all_files(place.runs());
        const Said said = place.run_says({"--seeds", "1"});
        BOOST_TEST(said.code == 73, part);
        BOOST_TEST(contains(said.err, place.run().string() + part), said.err);
        BOOST_TEST((all_files(place.runs()) == before), part);
    };
    // Runs that the program recorded before runs had an identity: complete, and unfinished.
    fs::create_directories(place.run());
    test::write(place.run() / "manifest.csv", "key,value\nversion,0.1.0\n");
    refused(
        " holds manifest.csv and no identity.csv: it is not a run of this planula, and is left as it is.");
    fs::remove(place.run() / "manifest.csv");
    test::write(place.run() / "checkpoint", "whatever");
    refused(" holds checkpoint and no identity.csv");
    fs::remove(place.run() / "checkpoint");
    test::write(place.run() / "individuals.csv.gz.part", "generation,slot\n");
    refused(" holds individuals.csv.gz.part and no identity.csv");
    fs::remove_all(place.run());
    test::write(place.run(), "a file");
    refused(" is not a folder");
    fs::remove(place.run());

    // What a process left that was killed before it had written the identity of its run.
    fs::create_directories(place.run() / "script");
    test::write(place.run() / "identity.csv.tmp", "key,va");
    test::write(place.run() / "script" / "other.lua", "return {}");
    BOOST_TEST(place.run_says({"--seeds", "1"}).code == 0);
    planula_says({"run", place.script(), "--seeds", "1", "--out", place.path / "fresh"});
    BOOST_TEST(difference(place.path / "fresh", place.runs()) == "");
}

BOOST_AUTO_TEST_CASE(a_continued_run_equals_one_that_was_as_long_from_the_start) {
    const Workplace place;
    const auto runs = [&](const std::string &out, const std::string &generations,
                          const std::string &threads) {
        const Said said = planula_says({"run", place.script(), "--out", place.path / out, "--seeds", "1:2",
                                        "--generations", generations, "--threads", threads});
        BOOST_TEST(said.code == 0, said.err);
    };
    for (const char *generations : {"1", "2", "9", "26", "27", "40"}) runs("stages", generations, "2");
    runs("whole", "40", "1");
    BOOST_TEST(difference(place.path / "whole", place.path / "stages") == "");
    // The longest stays.
    runs("stages", "12", "1");
    BOOST_TEST(difference(place.path / "whole", place.path / "stages") == "");
    // The same if the script asks for more.
    test::write(place.script(), replaced(small, "generations = 2", "generations = 41"));
    BOOST_TEST(planula_says({"run", place.script(), "--out", place.path / "stages", "--seeds", "1"}).code ==
               0);
    BOOST_TEST(complete_generations(place.path / "stages/small/seed-001") == 41);
}

BOOST_AUTO_TEST_CASE(threads_lanes_and_folders_change_no_byte) {
    const Workplace place;
    const std::string other = place.path / "other", widest(name_of(chosen_lanes()));
    BOOST_TEST(place.run_says({"--seeds", "1"}).code == 0);
    planula_says(
        {"run", place.script(), "--seeds", "1", "--out", other, "--threads", "3", "--lanes", "scalar"});
    BOOST_TEST((chosen_lanes() == LaneSet::scalar));
    choose_lanes(widest);
    BOOST_TEST(difference(place.runs(), other) == "");
    BOOST_TEST(content(place.run() / "script" / "experiment.lua") == small);
}

BOOST_AUTO_TEST_CASE(a_run_copied_elsewhere_resumes_there) {
    const Workplace place;
    const pid_t child =
        start(place.path / "said", {"run", place.script(), "--seeds", "1", "--generations", "100000",
                                    "--checkpoint", "1", "--out", place.path / "here"});
    BOOST_TEST(kill_once_there(child, place.path / "here/small/seed-001/checkpoint.previous") == -SIGKILL);
    copy_folder(place.path / "here", place.runs());
    fs::remove_all(place.path / "here");
    const Said said = place.run_says({"--seeds", "1", "--generations", "1"});
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(contains(said.err, "small seed 1: resumes with generation "), said.err);
    const std::string generations = std::to_string(complete_generations(place.run()));
    planula_says(
        {"run", place.script(), "--seeds", "1", "--generations", generations, "--out", place.path / "whole"});
    BOOST_TEST(difference(place.path / "whole", place.runs()) == "");
}

namespace {

/// Whether a run equals one of the same generations that was never stopped.
void check_undisturbed(const Workplace &place) {
    const std::string generations = std::to_string(complete_generations(place.run()));
    fs::remove_all(place.path / "whole");
    planula_says(
        {"run", place.script(), "--seeds", "1", "--generations", generations, "--out", place.path / "whole"});
    BOOST_TEST(difference(place.path / "whole" / "small", fs::path(place.runs()) / "small") == "");
}

void damage(const fs::path &file) {
    std::string bytes = content(file);
    bytes.at(bytes.size() / 2) ^= 1;
    test::write(file, bytes);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_stopped_run_may_be_resumed_with_fewer_generations) {
    const Workplace place;
    const pid_t child = start(place.path / "said", {"run", place.script(), "--seeds", "1", "--generations",
                                                    "100000", "--checkpoint", "3", "--out", place.runs()});
    BOOST_TEST(kill_once_there(child, place.run() / "checkpoint", SIGTERM) == 75);
    BOOST_TEST(place.run_says({"--seeds", "1", "--generations", "1"}).code == 0);
    check_undisturbed(place);
}

BOOST_AUTO_TEST_CASE(a_complete_run_that_was_killed_while_continued_resumes) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1", "--generations", "30"}).code == 0);
    const auto shorter = all_files(place.runs());
    // Without checkpoints, so that the newest state is one that is kept permanently.
    const pid_t child =
        start(place.path / "said", {"run", place.script(), "--seeds", "1", "--generations", "100000",
                                    "--checkpoint", "1000000", "--out", place.runs()});
    BOOST_TEST(kill_once_there(child, place.run() / "states/000100.state") == -SIGKILL);
    // Until then the folder has the shorter run.
    for (const auto &[file, bytes] : shorter) BOOST_TEST((all_files(place.runs())[file] == bytes), file);
    BOOST_TEST(complete_generations(place.run()) == 30);

    const Said said = place.run_says({"--seeds", "1", "--generations", "60"});
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(complete_generations(place.run()) > 100);
    check_undisturbed(place);
}

BOOST_AUTO_TEST_CASE(a_damaged_state_is_ignored_and_does_not_stop_later_processes) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1", "--generations", "30"}).code == 0);
    damage(place.run() / "states/000029.state");
    const pid_t child =
        start(place.path / "said", {"run", place.script(), "--seeds", "1", "--generations", "100000",
                                    "--checkpoint", "1000000", "--out", place.runs()});
    BOOST_TEST(kill_once_there(child, place.run() / "chain.csv.part") == -SIGKILL);
    const Said said = place.run_says({"--seeds", "1", "--generations", "31"});
    BOOST_TEST(said.code == 0, said.err);
    check_undisturbed(place);

    // Without any state the run stays as it is.
    damage(place.run() / "states/000025.state");
    const fs::path last = state_path(place.run(), complete_generations(place.run()) - 1);
    damage(last);
    for (const int generation : kept_generations(place.run()))
        if (generation != 25 && state_path(place.run(), generation) != last)
            damage(state_path(place.run(), generation));
    const auto before = all_files(place.runs());
    const Said stuck = place.run_says({"--seeds", "1", "--generations", "100000"});
    BOOST_TEST(stuck.code == 65);
    BOOST_TEST(
        contains(stuck.err, last.string() + " is damaged: it cannot become longer. Nothing was changed."),
        stuck.err);
    BOOST_TEST((all_files(place.runs()) == before));
}

BOOST_AUTO_TEST_CASE(leftovers_of_a_process_killed_at_the_end_of_a_run_are_removed) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1", "--generations", "5"}).code == 0);
    const auto before = all_files(place.runs());
    write_checkpoint(place.run(), read_state(state_path(place.run(), 4)).value());
    test::write(place.run() / "generations.csv.part", content(place.run() / "generations.csv"));
    BOOST_TEST(place.run_says({"--seeds", "1", "--generations", "5"}).code == 0);
    BOOST_TEST((all_files(place.runs()) == before));
}

BOOST_AUTO_TEST_CASE(asking_for_fewer_generations_leaves_a_longer_unfinished_run_alone) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1", "--generations", "5"}).code == 0);
    const pid_t child = start(place.path / "said", {"run", place.script(), "--seeds", "1", "--generations",
                                                    "100000", "--checkpoint", "5", "--out", place.runs()});
    BOOST_TEST(kill_once_there(child, place.run() / "checkpoint.previous") == -SIGKILL);
    fs::remove_all(fs::path(place.runs()) / "progress");
    const auto before = all_files(place.runs());
    const Said said = place.run_says({"--seeds", "1", "--generations", "5"});
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(contains(said.err, "1 of 1 runs have 5 generations already"), said.err);
    BOOST_TEST((all_files(place.runs()) == before));
}

BOOST_AUTO_TEST_CASE(a_run_without_one_of_its_files_is_refused_by_the_name_of_the_file) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1"}).code == 0);
    const auto whole = all_files(place.runs());
    for (const auto &[name, bytes] : whole) {
        const fs::path file = fs::path(place.runs()) / name;
        if (name.ends_with("identity.csv")) continue;
        const bool is_manifest = name.ends_with("manifest.csv");
        fs::remove(file);
        for (const char *generations : {"2", "3"}) {
            const Said said = place.run_says({"--seeds", "1", "--generations", generations});
            BOOST_TEST(said.code == 65, name);
            BOOST_TEST(
                contains(said.err, place.run().string() +
                                       (is_manifest ? " has states of a complete run and no manifest.csv"
                                                    : " lacks " + fs::relative(file, place.run()).string())),
                said.err);
        }
        test::write(file, bytes);
    }
    BOOST_TEST((all_files(place.runs()) == whole));
}

BOOST_AUTO_TEST_CASE(all_runs_reach_a_level_before_any_goes_further) {
    const Workplace place;
    const std::vector<std::string> words{
        "run",      place.script(), "--out",     place.runs(), "--seeds",      "1:4",
        "--levels", "3,6,9,100000", "--threads", "2",          "--checkpoint", "1"};
    const auto beyond = [](const RunStatus &run, int level) {
        return std::max(run.complete, run.kept) > level;
    };
    int interrupted = 0;
    // Killed at each level in turn, once a first run has passed it.
    for (const int level : {3, 6, 9}) {
        const pid_t child = start(place.path / "said", words);
        const auto has_passed = [&] {
            if (!fs::exists(place.runs())) return false;
            const auto runs = statuses(place.runs());
            return std::any_of(runs.begin(), runs.end(),
                               [&](const RunStatus &run) { return beyond(run, level); });
        };
        BOOST_TEST(wait_until(has_passed));
        kill(child, interrupted % 2 == 0 ? SIGKILL : SIGTERM);
        interrupted += end_of(child) != 0;
        const auto runs = statuses(place.runs());
        BOOST_TEST(runs.size() == 4u);
        // A process that was replacing shorter results by longer ones has left a checkpoint of the longer.
        for (const RunStatus &run : runs)
            BOOST_TEST(std::max(run.complete, run.kept) >= level, run.folder.string() << " at " << level);
    }
    BOOST_TEST(interrupted == 3);
    // The levels before the last leave no trace in the results.
    const fs::path whole = place.path / "whole";
    BOOST_TEST(
        planula_says({"run", place.script(), "--out", whole, "--seeds", "1:4", "--generations", "9"}).code ==
        0);
    for (const RunStatus &run : statuses(whole)) {
        const fs::path same = fs::path(place.runs()) / run.folder.lexically_relative(whole);
        if (complete_generations(same) == 9)
            BOOST_TEST(content(same / "chain.csv") == content(run.folder / "chain.csv"));
    }
}

BOOST_AUTO_TEST_CASE(levels_are_ascending_and_replace_generations) {
    const Workplace place;
    for (const char *levels : {"", "5,", "5,5", "9,5", "0", "x", "5 9", "1e2"}) {
        const Said said = place.run_says({"--levels", levels});
        BOOST_TEST(said.code == 2, levels);
        BOOST_TEST(
            contains(said.err, "--levels takes ascending numbers of generations, such as 25,50,100, not '"),
            said.err);
    }
    const Said both = place.run_says({"--levels", "5", "--generations", "5"});
    BOOST_TEST(both.code == 2);
    BOOST_TEST(contains(both.err, "generations is given twice: --levels states it, too"), both.err);
    BOOST_TEST(!fs::exists(place.runs()));
    const Said done = place.run_says({"--levels", "1,3", "--seeds", "1"});
    BOOST_TEST(done.code == 0, done.err);
    BOOST_TEST(complete_generations(place.run()) == 3);
    check_undisturbed(place);
}

BOOST_AUTO_TEST_CASE(each_run_of_a_design_is_in_one_part) {
    const Workplace place(
        "local paper = require 'paper'\n"
        "return paper.design { name = 'two', parameters = { population = 6, generations = 1,\n"
        "development_steps = 200, locomotion_steps = 100 },\n"
        "settings = { { name = 'a' }, { name = 'b', search = 'novelty' } } }\n");
    std::set<std::string> all;
    std::size_t sum = 0;
    for (const char *part : {"1:3", "2:3", "3:3"}) {
        const std::string out = place.path / part;
        BOOST_TEST(
            planula_says({"run", place.script(), "--seeds", "1:4", "--part", part, "--out", out}).code == 0);
        std::size_t runs = 0;
        for (const RunStatus &run : statuses(out)) {
            all.insert(run.folder.lexically_relative(out).string());
            ++runs;
        }
        BOOST_TEST((runs == 2 || runs == 3), runs);
        sum += runs;
    }
    BOOST_TEST(sum == 8u);
    BOOST_TEST(all.size() == 8u);

    const auto refused = [&](const char *part, const std::string &rule) {
        const Said said =
            planula_says({"run", place.script(), "--seeds", "1", "--part", part, "--out", place.runs()});
        BOOST_TEST(said.code == 2, part);
        BOOST_TEST(contains(said.err, rule), said.err);
    };
    for (const char *part : {"0:2", "3:2", "1", "1:", ":2", "x:2", "1:2:3", ""})
        refused(part, "--part takes I:N with 1 <= I <= N, not '" + std::string(part) + "'");
    refused("3:3", "--part 3:3: there are 2 runs, so this part is empty");
    BOOST_TEST(!fs::exists(place.runs()));
}

BOOST_AUTO_TEST_CASE(invalid_individuals_are_reported_at_the_end_of_a_run) {
    const Workplace place(replaced(
        small, "name = 'small'",
        "name = 'small', penalty = function() return 1 end,\n"
        "fitness = function(life) return life.births > 1.5 and life.rest.x ~= 0 and 0/0 or 0/0 end"));
    const Said said = place.run_says({"--seeds", "1", "--generations", "1"});
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(contains(said.err, "6 individuals count as invalid; the first because "), said.err);
}

BOOST_AUTO_TEST_CASE(a_signal_stops_the_run_with_75_and_says_how_to_resume) {
    const Workplace place;
    const pid_t child = start(place.path / "said", {"run", place.script(), "--seeds", "1", "--generations",
                                                    "100000", "--out", place.runs()});
    BOOST_TEST(kill_once_there(child, place.run() / "chain.csv.part", SIGTERM) == 75);
    BOOST_TEST(contains(content(place.path / "said"), "the same command resumes"));
    BOOST_TEST(!fs::exists(place.run() / "manifest.csv"));
    BOOST_TEST(!fs::exists(fs::path(place.runs()) / "progress"));
}

namespace {

/// Starts `planula run` in a process of its own.
pid_t start_run(const Workplace &place, const std::string &out, int generations,
                const std::string &seeds = "1") {
    return start(place.path / "said",
                 {"run", place.script(), "--seeds", seeds, "--threads", "3", "--checkpoint", "1", "--out",
                  out, "--generations", std::to_string(generations)});
}

bool has_checkpoint(const fs::path &runs) {
    const auto all = fs::exists(runs) ? statuses(runs) : std::vector<RunStatus>();
    return std::any_of(all.begin(), all.end(), [](const RunStatus &run) { return run.kept > run.complete; });
}

/// Gives one command again and again and ends it early, after a part of the time that it takes when left alone
/// (so on a machine of any speed), until that has left a checkpoint to resume from `often` times; then leaves it
/// alone. A process that ended before its signal is compared with the undisturbed run, and the run is started again.
struct Disturbance {
    Disturbance(const Workplace &place, int generations, const std::string &seeds, int often,
                const std::vector<int> &signals) {
        const std::string whole = place.path / "whole";
        const auto began = std::chrono::steady_clock::now();
        BOOST_REQUIRE(end_of(start_run(place, whole, generations, seeds)) == 0);
        const std::chrono::duration<double, std::micro> alone = std::chrono::steady_clock::now() - began;
        for (int start = 0; ended_early < often && start < 100 * often; ++start) {
            const pid_t child = start_run(place, place.runs(), generations, seeds);
            usleep(static_cast<useconds_t>(alone.count() * (20 + start * 37 % 50) / 100));
            kill(child, signals[ended_early % signals.size()]);
            const int end = end_of(child);
            BOOST_TEST((end == 0 || end == 75 || end == -SIGKILL || end == -SIGTERM), end);
            ended_early += end != 0 && has_checkpoint(place.runs());
            if (end != 0) continue;
            as_undisturbed = as_undisturbed && difference(whole, place.runs()) == "";
            fs::remove_all(place.runs());
        }
        BOOST_TEST(end_of(start_run(place, place.runs(), generations, seeds)) == 0);
        BOOST_TEST(difference(whole, place.runs()) == "");
    }
    int ended_early = 0;
    bool as_undisturbed = true;
};

} // namespace

BOOST_AUTO_TEST_CASE(a_run_killed_and_stopped_many_times_ends_with_the_same_bytes) {
    const Workplace place;
    const Disturbance done(place, 60, "1", 6, {SIGKILL, SIGKILL, SIGTERM});
    BOOST_TEST(done.ended_early == 6);
    BOOST_TEST(done.as_undisturbed);
}

BOOST_AUTO_TEST_CASE(runs_that_are_stopped_and_resumed_together_equal_those_that_run_alone) {
    const Workplace place;
    const Disturbance done(place, 40, "1:3", 4, {SIGTERM});
    BOOST_TEST(done.ended_early == 4);
    BOOST_TEST(done.as_undisturbed);
    // Alone: one seed and one thread at a time.
    const std::string alone = place.path / "alone";
    for (const char *seed : {"1", "2", "3"})
        planula_says({"run", place.script(), "--seeds", seed, "--threads", "1", "--generations", "40",
                      "--out", alone});
    BOOST_TEST(difference(alone, place.runs()) == "");
}

BOOST_AUTO_TEST_CASE(a_run_in_use_ends_the_command_and_saves_the_other_runs) {
    const Workplace place;
    const pid_t first = start_run(place, place.runs(), 100000, "2");
    BOOST_TEST(wait_until([&] { return fs::exists(place.run(2) / "checkpoint"); }));
    const Said second = place.run_says({"--seeds", "1:2", "--threads", "2", "--generations", "100000"});
    BOOST_TEST(second.code == 73, second.err);
    BOOST_TEST(fs::exists(place.run(1) / "checkpoint"));
    kill(first, SIGKILL);
    BOOST_TEST(end_of(first) == -SIGKILL);
}

BOOST_AUTO_TEST_CASE(a_second_process_on_one_run_ends_at_once_with_73) {
    const Workplace place;
    const pid_t first = start_run(place, place.runs(), 100000);
    BOOST_TEST(wait_until([&] { return fs::exists(place.run() / "checkpoint"); }));
    const Said second = place.run_says({"--seeds", "1", "--generations", "100000"});
    BOOST_TEST(second.code == 73);
    BOOST_TEST(contains(second.err, place.run().string() + " is in use by another process"), second.err);
    kill(first, SIGKILL);
    BOOST_TEST(end_of(first) == -SIGKILL);

    // The lock ended with the process that held it.
    const Said third = place.run_says({"--seeds", "1"});
    BOOST_TEST(third.code == 0, third.err);
}

BOOST_AUTO_TEST_CASE(a_run_that_another_process_completes_is_left_alone) {
    const Workplace place;
    // The second of two runs is completed by another process while the first one runs.
    const pid_t first =
        start(place.path / "said", {"run", place.script(), "--seeds", "1:2", "--threads", "1", "--checkpoint",
                                    "1", "--out", place.runs(), "--levels", "400"});
    BOOST_TEST(wait_until([&] { return fs::exists(place.run(1) / "checkpoint"); }));
    kill(first, SIGSTOP);
    const Said other = place.run_says({"--seeds", "2", "--generations", "400"});
    BOOST_TEST(other.code == 0, other.err);
    const auto before = all_files(place.run(2));
    kill(first, SIGCONT);
    BOOST_TEST(end_of(first) == 0);
    BOOST_TEST((all_files(place.run(2)) == before));
    BOOST_TEST(
        contains(content(place.path / "said"), "small seed 2: completed by another process in the meantime"),
        content(place.path / "said"));
}
