// SPDX-License-Identifier: MIT
// reduce, witness and frames: which runs they read, and where they write.
#include "record/run_reader.h"
#include "support/commands.h"
#include "tables/csv.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace planula;
using namespace planula::test;

namespace {

namespace fs = std::filesystem;

// Enough individuals that one is viable.
const std::string thirty = replaced(small, "population = 6", "population = 30");

/// A command that reads runs of the script and writes tables into `out`.
Said tables_of(const Workplace &place, const std::string &command, const std::string &out,
               std::vector<std::string> words = {}) {
    words.insert(words.begin(), {command, place.script(), "--runs", place.runs(), "--out", out});
    return planula_says(words);
}

std::int64_t lines(const std::string &text) { return std::count(text.begin(), text.end(), '\n'); }

} // namespace

BOOST_AUTO_TEST_CASE(longer_runs_are_shown_as_they_were_after_fewer_generations) {
    const Workplace place;
    const std::string longer = place.path / "longer", then = place.path / "then";
    BOOST_REQUIRE(place.run_says({"--seeds", "1:2", "--generations", "3"}).code == 0);
    BOOST_REQUIRE(tables_of(place, "reduce", then, {"--generations", "3"}).code == 0);
    BOOST_REQUIRE(place.run_says({"--seeds", "1:2", "--generations", "7"}).code == 0);
    const Said said = tables_of(place, "reduce", longer, {"--generations", "3"});
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(said.out == longer + '\n');
    BOOST_TEST(said.err == "");
    BOOST_TEST(difference(then, longer) == "");
    BOOST_TEST(tables_of(place, "reduce", place.path / "all", {"--generations", "7"}).code == 0);
    BOOST_TEST(difference(then, place.path / "all") != "");
}

BOOST_AUTO_TEST_CASE(seeds_asked_for_are_read_alone_and_missing_ones_reported) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1:3"}).code == 0);
    const std::string out = place.path / "data";
    const Said said = tables_of(place, "reduce", out, {"--seeds", "3:4"});
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(said.err == "missing: " + place.run(4).string() + '\n');
    const std::string runs = content(fs::path(out) / "runs.csv");
    BOOST_TEST(lines(runs) == 2);
    BOOST_TEST(contains(runs, "\nsmall,3,"), runs);
}

BOOST_AUTO_TEST_CASE(runs_of_another_identity_or_too_few_generations_are_left_out_by_name) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1:4"}).code == 0);
    const std::string expected = place.path / "expected", out = place.path / "data";
    BOOST_REQUIRE(tables_of(place, "reduce", expected, {"--seeds", "1"}).code == 0);

    // Of seed 2 there is a run of other physics, of seed 3 a shorter one, of seed 4 one of another seed, and more.
    fs::remove_all(place.run(2)), fs::remove_all(place.run(3));
    BOOST_REQUIRE(
        place.run_says({"--seeds", "2", "--set", "spring_damping=7", "--set", "drag_normal=2"}).code == 0);
    BOOST_REQUIRE(place.run_says({"--seeds", "3", "--generations", "1"}).code == 0);
    fs::rename(place.run(4), place.run(5));
    fs::create_directories(place.run(6));
    fs::create_directories(place.run(7));
    test::write(place.run(7) / "manifest.csv", "key,value\n");
    const Said said = tables_of(place, "reduce", out);
    BOOST_TEST(said.code == 0, said.err);
    for (const std::string &line :
         {place.run(2).string() +
              ": another run: environment drag normal: recorded with 2, asked for with 1 (and 2 more)",
          place.run(3).string() + ": 1 generations, where 2 are asked for",
          place.run(5).string() + ": it is a run of seed 4, which does not belong there",
          place.run(6).string() + ": no run has begun there",
          place.run(7).string() + ": not a run of this planula"})
        BOOST_TEST(contains(said.err, "left out: " + line + '\n'), said.err);
    BOOST_TEST(lines(said.err) == 5, said.err);
    BOOST_TEST(difference(expected, out) == "");

    // A changed fitness makes another experiment, even under the same name of the setting.
    test::write(place.script(), replaced(small, "name = 'small'",
                                         "name = 'small', fitness = function(l) return l.cells end"));
    for (const char *command : {"reduce", "witness", "sensitivity"}) {
        const Said other = tables_of(place, command, place.path / "other");
        BOOST_TEST(other.code == 65, command);
        BOOST_TEST(
            contains(other.err, "another run: function fitness: recorded with that of paper/judgement.lua:"),
            other.err);
        BOOST_TEST(contains(other.err, "there is no run of this experiment below " + place.runs()),
                   other.err);
        BOOST_TEST((!fs::exists(place.path / "other") || fs::is_empty(place.path / "other")), command);
    }
}

BOOST_AUTO_TEST_CASE(an_altered_run_is_not_read) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1"}).code == 0);
    const fs::path file = place.run() / "generations.csv", manifest = place.run() / "manifest.csv";
    const std::string text = content(file), rows = content(manifest);
    test::write(file, replaced(text, "\n1,", "\n1,1"));
    const Said table = tables_of(place, "reduce", place.path / "data");
    BOOST_TEST(table.code == 65);
    BOOST_TEST(contains(table.err, file.string() + ": its content is not what the run's manifest says"),
               table.err);
    test::write(file, text);
    test::write(manifest, replaced(rows, "\ngenerations,2\n", "\ngenerations,3\n"));
    const Said edited = tables_of(place, "reduce", place.path / "data");
    BOOST_TEST(edited.code == 65);
    BOOST_TEST(contains(edited.err, manifest.string() + ": it is not as it was written"), edited.err);
    BOOST_TEST(fs::is_empty(place.path / "data"));
}

BOOST_AUTO_TEST_CASE(tables_are_not_written_into_the_folder_of_a_run) {
    const Workplace place(thirty);
    BOOST_REQUIRE(place.run_says({"--seeds", "1"}).code == 0);
    BOOST_REQUIRE(tables_of(place, "reduce", place.path / "data").code == 0);
    const auto before = all_files(place.runs());
    for (const char *command : {"reduce", "witness", "sensitivity"}) {
        const Said said = tables_of(place, command, place.run());
        BOOST_TEST(said.code == 73, command);
        BOOST_TEST(contains(said.err,
                            place.run().string() + " is the folder of a run, whose files would be replaced"),
                   said.err);
    }
    BOOST_TEST(
        planula_says({"frames", place.script(), "--data", place.path / "data", "--out", place.run()}).code ==
        73);
    BOOST_TEST((all_files(place.runs()) == before));
}

BOOST_AUTO_TEST_CASE(a_folder_of_tables_that_another_process_writes_into_is_refused) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1"}).code == 0);
    const fs::path out = place.path / "data";
    fs::create_directories(out);
    {
        const FolderLock held(out);
        for (const char *command : {"reduce", "witness", "sensitivity"}) {
            const Said said = tables_of(place, command, out);
            BOOST_TEST(said.code == 73, command);
            BOOST_TEST(contains(said.err, out.string() + " is in use by another process"), said.err);
        }
    }
    BOOST_TEST(fs::is_empty(out));
    BOOST_TEST(tables_of(place, "reduce", out).code == 0);
}

BOOST_AUTO_TEST_CASE(frames_are_made_only_if_the_best_moves_as_recorded) {
    const Workplace place(thirty);
    BOOST_REQUIRE(place.run_says({"--seeds", "1"}).code == 0);
    const std::string data = place.path / "data", out = place.path / "frames";
    BOOST_REQUIRE(tables_of(place, "reduce", data).code == 0);
    const std::vector<std::string> words{"frames", place.script(), "--data", data, "--out", out};
    const Said said = planula_says(words);
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(lines(content(fs::path(out) / "frames.csv")) == 19);

    const fs::path best = fs::path(data) / "best_genomes.csv";
    const std::string text = content(best);
    BestGenomeRow row;
    TableReader<BestGenomeRow>(data).next(row);
    test::write(best, replaced(text, to_field(row.fitness) + ",", to_field(row.fitness * 2) + ","));
    fs::remove_all(out);
    const Said edited = planula_says(words);
    BOOST_TEST(edited.code == 65);
    BOOST_TEST(contains(edited.err, best.string()), edited.err);
    BOOST_TEST(!fs::exists(fs::path(out) / "frames.csv"));
}

BOOST_AUTO_TEST_CASE(witness_has_a_row_for_each_run_and_one_for_their_setting) {
    const Workplace place(thirty);
    BOOST_REQUIRE(place.run_says({"--seeds", "1:2", "--generations", "1"}).code == 0);
    const std::string data = place.path / "data";
    const Said said =
        tables_of(place, "witness", data, {"--seeds", "2:3", "--threads", "2", "--generations", "1"});
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(said.out == data + '\n');
    BOOST_TEST(said.err == "missing: " + place.run(3).string() + '\n');
    const std::string champions = content(fs::path(data) / "witness.csv");
    BOOST_TEST(lines(champions) == 2);
    BOOST_TEST(contains(champions, "\nsmall,2,"), champions);
    BOOST_TEST(contains(content(fs::path(data) / "engines.csv"), "\nsmall,1,"));
    // With softer springs the individuals move otherwise: the runs do not belong to such an experiment.
    const Said other =
        tables_of(place, "witness", data, {"--generations", "1", "--set", "spring_stiffness=50"});
    BOOST_TEST(other.code == 65);
    BOOST_TEST(
        contains(other.err, "another run: parameter spring_stiffness: recorded with 400, asked for with 50"),
        other.err);
}

BOOST_AUTO_TEST_CASE(claims_and_tables_of_the_script_are_made_of_the_runs) {
    const std::string statistics =
        "statistics = planula.fill({ claims = { { id = 'H1', statement = 'it moves', a = 'small', generation "
        "= 2,\n"
        "  judge = function(runs, stats, claim)\n"
        "    local best = runs[claim.a].best_fitness[claim.at_generation]\n"
        "    return { verdict = 'reproduced', effect_name = 'mean', effect = stats.mean(best) }\n  end } },\n"
        "tables = { best = function(runs)\n"
        "  local rows = {}\n"
        "  for _, run in ipairs(runs.small) do rows[#rows + 1] = { seed = run.seed, best = "
        "run.best_fitness[2],\n"
        "    links = run.champion.links[2], points = #run.endpoints } end\n"
        "  return rows\nend } }, require 'paper.summary'), search =";
    const Workplace place(replaced(small, "search =", statistics));
    BOOST_REQUIRE(place.run_says({"--seeds", "1:2"}).code == 0);
    const fs::path out = place.path / "data";
    const Said said = tables_of(place, "reduce", out.string(), {"--generations", "2"});
    BOOST_TEST(said.code == 0, said.err);
    const auto rows = read_table<GenerationRow>(place.run(1));
    const std::string table = content(out / "best.csv");
    BOOST_TEST(table.starts_with("best,links,points,seed\n"), table);
    BOOST_TEST(contains(table, "\n" + to_field(rows.at(1).best_fitness) + ","), table);
    BOOST_TEST(lines(table) == 3);
    BOOST_TEST(contains(content(out / "claims.csv"), "H1,it moves,,,,small,"));
    BOOST_TEST(contains(content(out / "manifest.csv"), "best_sha256,"));
}
