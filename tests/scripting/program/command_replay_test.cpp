// SPDX-License-Identifier: MIT
// replay: the life of an individual as a page, pictures and films; and the programs that these need.
#include "program/tool.h"
#include "support/commands.h"

#include <boost/test/unit_test.hpp>

#include <cstdlib>

using namespace planula;
using namespace planula::test;

namespace {

namespace fs = std::filesystem;

/// A place with one run.
struct Ran : Workplace {
    Ran() { BOOST_REQUIRE(run_says({"--seeds", "1"}).code == 0); }
};

/// The PATH of this process, for a while.
struct Path {
    explicit Path(const fs::path &folder) { setenv("PATH", folder.c_str(), 1); }
    ~Path() { setenv("PATH", before.c_str(), 1); }
    std::string before = std::getenv("PATH");
};

void write_program(const fs::path &file, const std::string &text) {
    test::write(file, "#!/bin/sh\n" + text);
    fs::permissions(file, fs::perms::owner_all);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_replay_shows_the_champion_or_any_individual) {
    const Ran place;
    const std::string page = place.path / "life.html", other = place.path / "other.html";
    const Said said = planula_says({"replay", place.run(), "--html", page});
    BOOST_REQUIRE_MESSAGE(said.code == 0, said.err);
    BOOST_TEST(said.out == page + "\n");
    BOOST_TEST(content(page).starts_with("<!DOCTYPE html>"));
    BOOST_TEST(contains(content(page), "<title>small, seed 1, generation "));
    // A folder with one run names that run; and every individual can be shown, whatever became of it.
    for (int slot = 0; slot < 6; ++slot) {
        const Said at = planula_says(
            {"replay", place.runs(), "--generation", "1", "--slot", std::to_string(slot), "--html", other});
        BOOST_TEST(at.code == 0, at.err);
    }
    BOOST_TEST(contains(content(other), "<title>small, seed 1, generation 1, genome "));
    // The same individual, the same page.
    const std::string first = content(page);
    BOOST_TEST(planula_says({"replay", place.run(), "--html", page}).code == 0);
    BOOST_TEST(content(page) == first);
}

BOOST_AUTO_TEST_CASE(without_a_file_the_page_is_named_after_the_run) {
    const Ran place;
    const fs::path before = fs::current_path();
    fs::current_path(place.path);
    const Said said = planula_says({"replay", place.run()});
    fs::current_path(before);
    BOOST_REQUIRE_MESSAGE(said.code == 0, said.err);
    BOOST_TEST(said.out.starts_with("small-seed-1-genome-"), said.out);
    BOOST_TEST(said.out.ends_with(".html\n"), said.out);
    BOOST_TEST(fs::exists(place.path / said.out.substr(0, said.out.size() - 1)));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_replayed_is_refused_before_anything_is_simulated) {
    const Ran place;
    const auto refused = [&](std::vector<std::string> words, int code, const std::string &part) {
        words.insert(words.begin(), "replay");
        const Said said = planula_says(words);
        BOOST_TEST(said.code == code, part);
        BOOST_TEST(contains(said.err, part), said.err);
    };
    refused({place.run(), "--generation", "1"}, 2, "--generation and --slot are given together");
    refused({place.run(), "--generation", "7", "--slot", "1"}, 65, ": no generation 7; they are 0 to 1");
    refused({place.run(), "--genome", "999"}, 65, "is not a champion");
    refused({place.run(), "--svg", place.path / "strip.png"}, 2, "write --png ");
    refused({"/nowhere"}, 65, "/nowhere is not a folder");
    refused({place.run(), "--html", place.path}, 73, "exists and is not a file; it is not replaced");
    refused({place.run(), "--svg", "/nowhere/strip.svg"}, 73, "/nowhere/strip.svg");
    BOOST_REQUIRE(place.run_says({"--seeds", "2"}).code == 0);
    refused({place.runs()}, 65, place.runs() + " holds 2 runs; name one of them: " + place.run(1).string());
}

BOOST_AUTO_TEST_CASE(of_an_edited_record_nothing_is_shown) {
    const Ran place;
    const fs::path file = place.run() / "champions.csv", page = place.path / "life.html";
    test::write(file, content(file) + "0");
    BOOST_TEST(planula_says({"replay", place.run(), "--html", page}).code == 65);
    BOOST_TEST(!fs::exists(page));
}

BOOST_AUTO_TEST_CASE(pictures_and_films_need_programs_that_are_named_when_they_are_missing) {
    const Ran place;
    const fs::path tools = place.path / "tools", svg = place.path / "a.svg", png = place.path / "a.png",
                   gif = place.path / "a.gif", mp4 = place.path / "a.mp4";
    fs::create_directories(tools);
    const Path path(tools);
    BOOST_TEST(planula_says({"replay", place.run(), "--svg", svg}).code == 0);
    BOOST_TEST(content(svg).starts_with("<svg "));
    Said said = planula_says({"replay", place.run(), "--png", png});
    BOOST_TEST(said.code == 73);
    BOOST_TEST(contains(said.err, "--png needs the program rsvg-convert, which is not installed; on Debian: "
                                  "apt-get install librsvg2-bin"),
               said.err);
    write_program(tools / "rsvg-convert", "echo picture > \"$4\"\n");
    BOOST_TEST(planula_says({"replay", place.run(), "--png", png}).code == 0);
    BOOST_TEST(content(png) == "picture\n");
    said = planula_says({"replay", place.run(), "--gif", gif});
    BOOST_TEST(said.code == 73);
    BOOST_TEST(contains(said.err, "--gif needs the program ffmpeg"), said.err);
    write_program(tools / "ffmpeg", "for word; do last=$word; done; echo film > \"$last\"\n");
    said = planula_says({"replay", place.run(), "--gif", gif, "--mp4", mp4});
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(said.out == gif.string() + "\n" + mp4.string() + "\n");
    BOOST_TEST((content(gif) == "film\n" && content(mp4) == "film\n"));
    write_program(tools / "ffmpeg", "echo no codec >&2; exit 3\n");
    said = planula_says({"replay", place.run(), "--mp4", mp4});
    BOOST_TEST(said.code == 74);
    BOOST_TEST(contains(said.err, "ffmpeg failed with exit code 3:\nno codec"), said.err);
    BOOST_TEST(content(mp4) == "film\n"); // of before
}

BOOST_AUTO_TEST_CASE(a_workshop_leaves_nothing_behind) {
    fs::path file;
    {
        const Workshop workshop;
        file = workshop.file("a");
        test::write(file, "a");
        BOOST_TEST(fs::exists(file));
    }
    BOOST_TEST(!fs::exists(file.parent_path()));
}
