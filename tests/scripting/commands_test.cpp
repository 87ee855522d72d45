// SPDX-License-Identifier: MIT
#include "scripting/commands.h"

#include "base/lane_sets.h"
#include "experiment/revision.h"
#include "record/manifest.h"
#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <map>
#include <sstream>

#include <sys/wait.h>
#include <unistd.h>

using namespace planula;

namespace {

namespace fs = std::filesystem;

struct Said {
    int code;
    std::string out, err;
};

Said planula_says(const std::vector<std::string> &words) {
    std::ostringstream out, err;
    Console console{out, err, false, test::experiments_folder()};
    const int code = run_program(words, console);
    return {code, out.str(), err.str()};
}

// A folder with one small experiment, removed afterwards.
struct Workplace {
    explicit Workplace(const std::string &text) {
        fs::remove_all(path);
        fs::create_directories(path);
        std::ofstream(path / "small.lua") << text;
    }
    ~Workplace() { fs::remove_all(path); }
    std::string script() const { return (path / "small.lua").string(); }
    std::string runs() const { return (path / "runs").string(); }
    fs::path path = fs::temp_directory_path() / ("planula-commands-" + std::to_string(getpid()));
};

const char *const small =
    "local paper = require 'paper'\n"
    "return paper.experiment { name = 'small', parameters = { population = 6, generations = 2, "
    "seeds = 2 } }\n";

std::string content(const fs::path &path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

BOOST_AUTO_TEST_CASE(help_names_every_command_and_each_has_its_own) {
    const Said help = planula_says({"--help"});
    BOOST_TEST(help.code == 0);
    for (const Command *command : all_commands()) {
        BOOST_TEST(test::contains(help.out, "\n  " + std::string(command->name) + " "), command->name);
        const Said own = planula_says({std::string(command->name), "--help"});
        BOOST_TEST(own.code == 0, command->name);
        BOOST_TEST(test::contains(own.out, "usage: planula " + std::string(command->name)), command->name);
    }
}

BOOST_AUTO_TEST_CASE(a_bad_command_line_ends_with_2_and_the_nearest_name) {
    BOOST_TEST(planula_says({}).code == 2);
    const Said misspelt = planula_says({"chek"});
    BOOST_TEST(misspelt.code == 2);
    BOOST_TEST(test::contains(misspelt.err, "no command 'chek'; did you mean 'check'?"));
    const Workplace place(small);
    const auto refused = [&](std::vector<std::string> words, const std::string &part) {
        words.insert(words.begin(), {"run", place.script(), "--out", place.runs()});
        const Said said = planula_says(words);
        BOOST_TEST(said.code == 2, part);
        BOOST_TEST(test::contains(said.err, part), said.err);
    };
    refused({"--set", "populaton=5"}, "did you mean 'population'?");
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
        BOOST_TEST(test::contains(said.err, "small.lua:1: name must be a text, not a number"), said.err);
    }
    BOOST_TEST(planula_says({"check", "nowhere.lua"}).code == 65);
}

BOOST_AUTO_TEST_CASE(check_and_describe_tell_what_is_there) {
    const Workplace place(small);
    const Said check = planula_says({"check", place.script()});
    BOOST_TEST(check.code == 0);
    BOOST_TEST(check.out == "ok: " + place.script() + ": small, 1 setting: small\n");
    const Said describe = planula_says({"describe", place.script(), "--set", "gravity=2"});
    BOOST_TEST(describe.code == 0);
    BOOST_TEST(test::contains(describe.out, "population = 6 genomes (standard 300, §2.7.2)"), describe.out);
    BOOST_TEST(test::contains(describe.out, "gravity = 2 cell/t.u.² (standard 5, ours)"), describe.out);
}

BOOST_AUTO_TEST_CASE(the_ledger_and_the_dictionary_have_a_line_for_everything) {
    const Said plain = planula_says({"parameters"}), csv = planula_says({"parameters", "--csv"});
    for (const ParameterRow &row : parameter_rows()) {
        BOOST_TEST(test::contains(plain.out, "  " + std::string(row.name) + " = "), row.name);
        BOOST_TEST(test::contains(csv.out, "," + std::string(row.name) + ","), row.name);
    }
    BOOST_TEST(csv.out.starts_with("section,name,value,standard,unit,origin,meaning\n"));
    BOOST_TEST(planula_says({"columns"}).out.starts_with("file,column,unit,meaning\n"));
}

BOOST_AUTO_TEST_CASE(pace_has_a_row_for_the_first_generation_and_for_ten_at_a_time) {
    const Workplace place(small);
    const Said said = planula_says({"pace", place.script(), "--until", "12"});
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(std::count(said.out.begin(), said.out.end(), '\n') == 4);
    BOOST_TEST(test::contains(said.out, "\nsmall,0,0,6,0,"), said.out);
    BOOST_TEST(test::contains(said.out, "\nsmall,1,10,60,"), said.out);
    BOOST_TEST(test::contains(said.out, "\nsmall,11,12,12,"), said.out);
    // The script's own design: two seeds of two generations of six.
    BOOST_TEST(test::contains(said.err, "the whole design of small, 0.0 million individuals"), said.err);
    BOOST_TEST(planula_says({"pace", place.script(), "--until", "-1"}).code == 2);
}

BOOST_AUTO_TEST_CASE(a_run_is_written_skipped_when_complete_and_redone_when_anything_changed) {
    const Workplace place(small);
    const Said first = planula_says({"run", place.script(), "--seeds", "7", "--out", place.runs()});
    BOOST_TEST(first.code == 0, first.err);
    const fs::path folder = fs::path(place.runs()) / "small" / "seed-007";
    const std::string individuals = content(folder / "individuals.csv.gz");
    BOOST_TEST(!individuals.empty());
    BOOST_TEST(test::contains(content(folder / "resolved.lua"), "population = 6"));
    BOOST_TEST(content(folder / "experiment.lua") == small);

    const Said again = planula_says({"run", place.script(), "--seeds", "7", "--out", place.runs()});
    BOOST_TEST(again.code == 0);
    BOOST_TEST(test::contains(again.err, "complete already, skipped"), again.err);
    const Said changed =
        planula_says({"run", place.script(), "--seeds", "7", "--out", place.runs(), "--population", "7"});
    BOOST_TEST(changed.code == 0);
    BOOST_TEST(!test::contains(changed.err, "skipped"), changed.err);
    BOOST_TEST(content(folder / "individuals.csv.gz") != individuals);
}

BOOST_AUTO_TEST_CASE(threads_lanes_and_the_folder_of_the_script_change_no_byte) {
    const Workplace place(small);
    const std::string other = place.path / "other", widest(name_of(chosen_lanes()));
    planula_says({"run", place.script(), "--seeds", "1", "--out", place.runs(), "--threads", "1"});
    planula_says(
        {"run", place.script(), "--seeds", "1", "--out", other, "--threads", "3", "--lanes", "scalar"});
    BOOST_TEST((chosen_lanes() == LaneSet::scalar));
    choose_lanes(widest);
    for (const char *file :
         {"individuals.csv.gz", "generations.csv", "best_genome.csv", "manifest.csv", "resolved.lua"}) {
        const std::string bytes = content(fs::path(place.runs()) / "small/seed-001" / file);
        BOOST_TEST(!bytes.empty(), file);
        BOOST_TEST(bytes == content(fs::path(other) / "small/seed-001" / file), file);
    }
}

BOOST_AUTO_TEST_CASE(witness_has_a_row_for_each_run_and_one_for_their_setting) {
    const Workplace place(
        "local paper = require 'paper'\n"
        "return paper.experiment { name = 'small', parameters = { population = 30, generations = 1 } }\n");
    planula_says({"run", place.script(), "--seeds", "1:2", "--out", place.runs()});
    const std::string data = place.path / "data";
    const Said said = planula_says({"witness", place.script(), "--runs", place.runs(), "--out", data,
                                    "--seeds", "2:3", "--threads", "2"});
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(said.out == data + '\n');
    BOOST_TEST(test::contains(said.err, "seed-003: no complete run of this experiment"), said.err);
    BOOST_TEST(!test::contains(said.err, "seed-002"), said.err);
    const std::string champions = content(fs::path(data) / "witness.csv");
    BOOST_TEST(std::count(champions.begin(), champions.end(), '\n') == 3);
    BOOST_TEST(test::contains(champions, "\nsmall,1,"));
    BOOST_TEST(test::contains(content(fs::path(data) / "engines.csv"), "\nsmall,2,,"));
    // Softer springs, other lives: the runs are not of such an experiment.
    const Said other = planula_says(
        {"witness", place.script(), "--runs", place.runs(), "--out", data, "--set", "spring_stiffness=50"});
    BOOST_TEST(other.code == 65);
    BOOST_TEST(test::contains(other.err, "the data are of another experiment or version"), other.err);
}

BOOST_AUTO_TEST_CASE(sensitivity_has_a_row_for_each_parameter_and_factor_that_concern_the_setting) {
    const Workplace place(
        "local paper = require 'paper'\n"
        "return paper.experiment { name = 'small', parameters = { population = 30, generations = 1 },\n"
        "sensitivity = { sample = 20, factors = { 0.5, 2 },\n"
        "parameters = { 'drag_normal', 'gravity', 'minimum_cells', 'knot_interval' } } }\n");
    planula_says({"run", place.script(), "--seeds", "1:2", "--out", place.runs()});
    const std::string data = place.path / "data";
    const Said said = planula_says(
        {"sensitivity", place.script(), "--runs", place.runs(), "--out", data, "--threads", "2"});
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(said.out == data + '\n');
    BOOST_TEST(test::contains(said.err, "sensitivity: drag_normal, 1 of 4\n"), said.err);
    BOOST_TEST(test::contains(said.err, "knot_interval = 20 is passed over: parameters break the rule: "
                                        "update_interval is a multiple of knot_interval\n"),
               said.err);
    const std::string table = content(fs::path(data) / "sensitivity.csv");
    for (const char *row : {"\nsmall,drag_normal,1,0.5,30,1,20,", "\nsmall,drag_normal,1,2,30,1,20,",
                            "\nsmall,minimum_cells,8,4,30,1,20,", "\nsmall,minimum_cells,8,16,30,1,20,"})
        BOOST_TEST(test::contains(table, row), table);
    BOOST_TEST(test::contains(table, "\nsmall,knot_interval,10,5,"), table);
    BOOST_TEST(!test::contains(table, "\nsmall,knot_interval,10,20,"), table);
    BOOST_TEST(!test::contains(table, "gravity"), table);
}

BOOST_AUTO_TEST_CASE(invalid_individuals_are_reported_at_the_end_of_a_run) {
    const Workplace place(
        "local paper = require 'paper'\n"
        "return paper.experiment { name = 'small', parameters = { population = 12, generations = 1 },\n"
        "penalty = function() return 1 end,\n"
        "fitness = function(life) return life.births > 1.5 and life.rest.x ~= 0 and 0/0 or 0/0 end }\n");
    const Said said = planula_says({"run", place.script(), "--seeds", "1", "--out", place.runs()});
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(test::contains(said.err, "12 individuals count as not valid, the first because: "), said.err);
}

BOOST_AUTO_TEST_CASE(a_signal_stops_the_run_with_75_and_says_how_to_go_on) {
    const Workplace place(small);
    const pid_t child = fork();
    if (child == 0) {
        std::ofstream silent(place.path / "said");
        Console console{silent, silent, false, test::experiments_folder()};
        const int code = run_program(
            {"run", place.script(), "--seeds", "1", "--generations", "100000", "--out", place.runs()},
            console);
        silent.flush();
        _exit(code);
    }
    // Wait until the run has begun.
    const fs::path folder = fs::path(place.runs()) / "small" / "seed-001";
    for (int i = 0; i < 500 && !fs::exists(folder); ++i) usleep(10000);
    usleep(200000);
    kill(child, SIGTERM);
    int status = 0;
    waitpid(child, &status, 0);
    BOOST_TEST(WIFEXITED(status));
    BOOST_TEST(WEXITSTATUS(status) == 75);
    BOOST_TEST(test::contains(content(place.path / "said"), "the same command goes on"));
    BOOST_TEST(!fs::exists(folder / "manifest.csv"));
}

namespace {

/// Starts `planula run` in a process of its own; what it says goes to a file.
pid_t start_run(const Workplace &place, const std::string &out, int generations,
                const std::string &seeds = "1") {
    const pid_t child = fork();
    if (child != 0) return child;
    std::ofstream silent(place.path / "said");
    Console console{silent, silent, false, test::experiments_folder()};
    const int code = run_program({"run", place.script(), "--seeds", seeds, "--threads", "3", "--checkpoint",
                                  "1", "--out", out, "--generations", std::to_string(generations)},
                                 console);
    silent.flush();
    _exit(code);
}

/// Waits for the end of a process; its exit code, or the negative of the signal that killed it.
int end_of(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

/// Every file below a folder, name and bytes.
std::string all_bytes(const fs::path &folder) {
    std::map<std::string, std::string> files;
    for (const auto &entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            files[fs::relative(entry.path(), folder).string()] = content(entry.path());
    std::string bytes;
    for (const auto &[name, text] : files) bytes += name + '\n' + text;
    return bytes;
}

bool has_checkpoint(const fs::path &runs) {
    if (!fs::exists(runs)) return false;
    for (const auto &entry : fs::recursive_directory_iterator(runs))
        if (entry.path().filename() == "checkpoint") return true;
    return false;
}

/// Gives one command again and again and ends it early, after a part of the time that it takes when left alone
/// (so on a machine of any speed), until that has left a checkpoint to go on from `often` times; then leaves it
/// alone. One that was too fast for its signal is compared with the undisturbed one and begun anew.
struct Disturbance {
    Disturbance(const Workplace &place, int generations, const std::string &seeds, int often,
                const std::vector<int> &signals) {
        const std::string whole = place.path / "whole";
        const auto began = std::chrono::steady_clock::now();
        BOOST_REQUIRE(end_of(start_run(place, whole, generations, seeds)) == 0);
        const std::chrono::duration<double, std::micro> alone = std::chrono::steady_clock::now() - began;
        const std::string expected = all_bytes(whole);
        for (int start = 0; ended_early < often && start < 100 * often; ++start) {
            const pid_t child = start_run(place, place.runs(), generations, seeds);
            usleep(static_cast<useconds_t>(alone.count() * (20 + start * 37 % 50) / 100));
            kill(child, signals[ended_early % signals.size()]);
            const int end = end_of(child);
            BOOST_TEST((end == 0 || end == 75 || end == -SIGKILL || end == -SIGTERM), end);
            ended_early += end != 0 && has_checkpoint(place.runs());
            if (end != 0) continue;
            as_undisturbed = as_undisturbed && all_bytes(place.runs()) == expected;
            fs::remove_all(place.runs());
        }
        BOOST_TEST(end_of(start_run(place, place.runs(), generations, seeds)) == 0);
        as_undisturbed = as_undisturbed && all_bytes(place.runs()) == expected;
    }
    int ended_early = 0;
    bool as_undisturbed = true;
};

} // namespace

BOOST_AUTO_TEST_CASE(a_run_killed_and_stopped_again_and_again_ends_with_the_same_bytes) {
    const Workplace place(small);
    const Disturbance done(place, 6, "1", 6, {SIGKILL, SIGKILL, SIGTERM});
    BOOST_TEST(done.ended_early == 6);
    BOOST_TEST(done.as_undisturbed);
}

BOOST_AUTO_TEST_CASE(runs_that_go_on_at_once_and_are_stopped_are_those_that_go_on_alone) {
    const Workplace place(small);
    const Disturbance done(place, 5, "1:3", 4, {SIGTERM});
    BOOST_TEST(done.ended_early == 4);
    BOOST_TEST(done.as_undisturbed);
    // Alone: one seed and one thread at a time.
    const std::string alone = place.path / "alone";
    for (const char *seed : {"1", "2", "3"})
        planula_says(
            {"run", place.script(), "--seeds", seed, "--threads", "1", "--generations", "5", "--out", alone});
    BOOST_TEST((all_bytes(alone) == all_bytes(place.runs())));
}

BOOST_AUTO_TEST_CASE(a_run_in_use_ends_the_others_with_their_work_kept) {
    const Workplace place(small);
    const fs::path runs = place.runs();
    const pid_t first = start_run(place, runs, 100000, "2");
    for (int i = 0; i < 1000 && !fs::exists(runs / "small/seed-002/checkpoint"); ++i) usleep(10000);
    const Said second = planula_says({"run", place.script(), "--seeds", "1:2", "--threads", "2", "--out",
                                      place.runs(), "--generations", "100000"});
    BOOST_TEST(second.code == 73, second.err);
    BOOST_TEST(fs::exists(runs / "small/seed-001/checkpoint"));
    kill(first, SIGKILL);
    BOOST_TEST(end_of(first) == -SIGKILL);
}

BOOST_AUTO_TEST_CASE(a_second_process_on_one_run_ends_at_once_with_73) {
    const Workplace place(small);
    const pid_t first = start_run(place, place.runs(), 100000);
    const fs::path checkpoint = fs::path(place.runs()) / "small/seed-001/checkpoint";
    for (int i = 0; i < 1000 && !fs::exists(checkpoint); ++i) usleep(10000);
    const Said second = planula_says(
        {"run", place.script(), "--seeds", "1", "--out", place.runs(), "--generations", "100000"});
    BOOST_TEST(second.code == 73);
    BOOST_TEST(test::contains(second.err, "is in use by another process"), second.err);
    kill(first, SIGKILL);
    BOOST_TEST(end_of(first) == -SIGKILL);

    // The lock died with its holder.
    const Said third = planula_says({"run", place.script(), "--seeds", "1", "--out", place.runs()});
    BOOST_TEST(third.code == 0, third.err);
}

BOOST_AUTO_TEST_CASE(the_history_of_a_run_can_be_read_and_drawn) {
    const Workplace place(small);
    BOOST_REQUIRE(planula_says({"run", place.script(), "--seeds", "1:2", "--out", place.runs()}).code == 0);
    fs::create_directories(fs::path(place.runs()) / "small/seed-003");
    const Said status = planula_says({"status", place.runs()});
    BOOST_TEST(status.code == 0);
    BOOST_TEST(test::contains(status.out, "seed-001: complete, 2 generations\n"), status.out);
    BOOST_TEST(test::contains(status.out, "seed-003: nothing is kept\n"), status.out);
    BOOST_TEST(test::contains(status.out, "\n2 of 3 runs are complete\n"), status.out);

    const std::string run = fs::path(place.runs()) / "small/seed-001";
    const Said lineage = planula_says({"lineage", run, "--copies"});
    BOOST_TEST(lineage.code == 0, lineage.err);
    BOOST_TEST(lineage.out.starts_with("generation,slot,genome,origin,mother,father,"), lineage.out);
    BOOST_TEST(planula_says({"lineage", run, "--genome", "99"}).code == 65);
    BOOST_TEST(planula_says({"lineage", run, "--genome", "bset"}).code == 2);
    BOOST_TEST(planula_says({"lineage", place.runs()}).code == 65);

    const Said genome = planula_says({"genome", run});
    BOOST_TEST(genome.code == 0, genome.err);
    BOOST_TEST(test::contains(genome.out, "\ndivision inhibitor\n"), genome.out);
    BOOST_TEST(
        test::contains(planula_says({"genome", run, "--genome", "99"}).err, "was never the run's best"));
    const std::string svg = place.path / "net.svg", dot = place.path / "net.dot";
    BOOST_TEST(planula_says({"genome", run, "--svg", svg, "--dot", dot}).code == 0);
    BOOST_TEST(content(svg).starts_with("<svg "));
    BOOST_TEST(content(dot).starts_with("digraph "));
    BOOST_TEST(planula_says({"genome", run, "--svg", "/nowhere/net.svg"}).code == 73);
}

BOOST_AUTO_TEST_CASE(the_signature_is_one_hash_that_threads_do_not_change) {
    const Workplace place(small);
    const auto signature = [&](const char *threads) {
        return planula_says({"signature", "--script", place.script(), "--threads", threads});
    };
    const Said one = signature("1");
    BOOST_TEST(one.code == 0, one.err);
    BOOST_TEST(one.out.size() == 65u);
    BOOST_TEST(signature("3").out == one.out);
    std::string other = small;
    other.replace(other.find("population = 6"), 14, "population = 7");
    std::ofstream(place.script()) << other;
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
    BOOST_TEST(test::contains(err.str(), "the standard output cannot be written"));
}
