// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "program/progress_file.h"
#include "support/commands.h"
#include "tables/csv.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::test;

namespace {

namespace fs = std::filesystem;

/// Reads JSON (RFC 8259) and keeps the values of objects' keys, the last of each.
class Json {
  public:
    explicit Json(std::string text) : text_(std::move(text)) {
        value("");
        space();
        is_valid = is_valid && at_ == text_.size();
    }
    bool is_valid = true;
    std::map<std::string, std::string> values; // by the key of the object that has it

  private:
    void space() { at_ = std::min(text_.find_first_not_of(" \n\r\t", at_), text_.size()); }
    bool take(char letter) {
        space();
        if (at_ >= text_.size() || text_[at_] != letter) return false;
        return ++at_, true;
    }
    void need(char letter) { is_valid = is_valid && take(letter); }
    std::string word() {
        need('"');
        std::string result;
        while (is_valid && at_ < text_.size() && text_[at_] != '"') {
            is_valid = static_cast<unsigned char>(text_[at_]) >= 0x20;
            if (text_[at_] == '\\') {
                ++at_;
                is_valid = is_valid && at_ < text_.size() && contains("\"\\u", std::string(1, text_[at_]));
            }
            result += text_[at_++];
        }
        need('"');
        return result;
    }
    template <class Item> void list(char end, Item item) {
        if (take(end)) return;
        do item();
        while (is_valid && take(','));
        need(end);
    }
    void value(const std::string &key) {
        space();
        const std::size_t begin = at_;
        if (take('{'))
            list('}', [&] {
                const std::string name = word();
                need(':');
                value(name);
            });
        else if (take('['))
            list(']', [&] { value(key); });
        else if (at_ < text_.size() && text_[at_] == '"')
            word();
        else {
            at_ = std::min(text_.find_first_not_of("-+.0123456789eEnul", at_), text_.size());
            const std::string number = text_.substr(begin, at_ - begin);
            is_valid = is_valid && (number == "null" || parse_double(number));
        }
        values[key] = text_.substr(begin, at_ - begin);
    }

    std::string text_;
    std::size_t at_ = 0;
};

} // namespace

BOOST_AUTO_TEST_CASE(the_json_reader_of_this_test_is_strict) {
    for (const char *good : {"{}", "[]", "{ \"a\": [1, -2.5e3, null, \"x\\\"\\u00e4\"] }\n"})
        BOOST_TEST(Json(good).is_valid, good);
    for (const char *bad :
         {"", "{", "{\"a\" 1}", "[1,]", "[1] 2", "{\"a\": nil}", "[\"a\nb\"]", "{\"a\": 1,}", "[01x]"})
        BOOST_TEST(!Json(bad).is_valid, bad);
}

BOOST_AUTO_TEST_CASE(status_reports_how_far_the_runs_are) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1:2"}).code == 0);
    BOOST_REQUIRE(place.run_says({"--seeds", "2", "--generations", "3"}).code == 0);
    fs::create_directories(place.run(3));
    fs::create_directories(place.run(4));
    test::write(place.run(4) / "manifest.csv", "key,value\n");
    const Said said = planula_says({"status", place.runs()});
    BOOST_TEST(said.code == 0);
    BOOST_TEST(contains(said.out, "4 runs, "), said.out);
    BOOST_TEST(contains(said.out, " MB, 30 evaluations\n"), said.out);
    for (const char *line : {"\n  1 with 2 generations complete\n", "\n  1 with 3 generations complete\n",
                             "\n  1 without a saved generation\n", "\n  1 that cannot be read\n",
                             "\nno process is working on them\n"})
        BOOST_TEST(contains(said.out, line), said.out);
    BOOST_TEST(!contains(said.out, "unfinished"), said.out);
    BOOST_TEST(contains(said.out, place.run(4).string() + ": "), said.out);
    BOOST_TEST(!contains(said.out, place.run(1).string()), said.out);
    const Said each = planula_says({"status", place.runs(), "--runs"});
    BOOST_TEST(contains(each.out, place.run(1).string() + ": 2 generations complete, "), each.out);
    BOOST_TEST(contains(each.out, place.run(3).string() + ": no generations complete, "), each.out);
    BOOST_TEST(planula_says({"status", place.path / "nowhere"}).code == 65);
}

BOOST_AUTO_TEST_CASE(status_finds_runs_at_any_depth) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1:2"}).code == 0);
    const auto begins = [](const fs::path &folder, const std::string &with) {
        const Said said = planula_says({"status", folder});
        BOOST_TEST(said.out.starts_with(with), folder.string() + ": " + said.out);
    };
    begins(place.runs(), "2 runs, ");
    begins(fs::path(place.runs()) / "", "2 runs, "); // a slash at its end
    begins(place.path, "2 runs, ");
    begins(fs::path(place.run(1)).parent_path(), "2 runs, ");
    begins(place.run(1), "1 run, ");
    BOOST_TEST(contains(planula_says({"status", place.run(1), "--runs"}).out, place.run(1).string() + ": "));
    fs::create_directories(place.path / "empty");
    begins(place.path / "empty", "no run (<setting>/seed-NNN) in this folder or below it\n0 runs, ");
}

BOOST_AUTO_TEST_CASE(status_in_json_says_the_same) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1:2"}).code == 0);
    fs::rename(place.runs(), place.path / "a \"name\" \\ with\ttab");
    const fs::path runs = place.path / "a \"name\" \\ with\ttab";
    fs::create_directories(runs / "small/seed-003");
    test::write(runs / "small/seed-003/checkpoint", "x");
    const Said said = planula_says({"status", runs, "--json"});
    BOOST_TEST(said.code == 0);
    Json json(said.out);
    BOOST_TEST(json.is_valid, said.out);
    BOOST_TEST(json.values["evaluations"] == "24");
    BOOST_TEST(json.values["under_way"] == "0");
    BOOST_TEST(json.values["processes"] == "[]");
    BOOST_TEST(json.values["rate"] == "0");
    BOOST_TEST(json.values["seconds_left"] == "null");
    BOOST_TEST(contains(json.values["trouble"], "holds checkpoint and no identity.csv"), said.out);
    BOOST_TEST(
        contains(said.out,
                 "\"complete\": [{\"generations\": 0, \"runs\": 1}, {\"generations\": 2, \"runs\": 2}]"),
        said.out);
    BOOST_TEST(Json(planula_says({"status", place.path, "--json"}).out).is_valid);
}

BOOST_AUTO_TEST_CASE(a_process_is_reported_until_it_ends_or_is_killed) {
    const Workplace place;
    for (const int signal : {SIGTERM, SIGKILL}) {
        const pid_t child =
            start(place.path / "said", {"run", place.script(), "--seeds", "1:2", "--levels", "100000",
                                        "--checkpoint", "1", "--threads", "1", "--out", place.runs()});
        BOOST_TEST(wait_until(
            [&] { return fs::exists(place.run(1) / "checkpoint") && !read_progress(place.runs()).empty(); }));
        const Said text = planula_says({"status", place.runs()});
        BOOST_TEST(contains(text.out, "\n  1 unfinished, with "), text.out);
        BOOST_TEST(!contains(text.out, "\n  1 without"), text.out); // its generations are saved
        BOOST_TEST(contains(text.out, "\na process runs 2 runs to generation 100000; 0 are done\n"),
                   text.out);
        Json json(planula_says({"status", place.runs(), "--json"}).out);
        BOOST_TEST(json.is_valid);
        BOOST_TEST(json.values["level"] == "100000");
        BOOST_TEST(json.values["runs_done"] == "0");
        kill(child, signal);
        BOOST_TEST(end_of(child) != 0);
        BOOST_TEST(contains(planula_says({"status", place.runs()}).out, "\nno process is working on them\n"));
        // The next process removes the file of a killed one.
        BOOST_TEST(fs::exists(fs::path(place.runs()) / "progress") == (signal == SIGKILL));
    }
    BOOST_TEST(place.run_says({"--seeds", "1:2"}).code == 0);
    BOOST_TEST(!fs::exists(fs::path(place.runs()) / "progress"));
}

BOOST_AUTO_TEST_CASE(processes_of_other_machines_are_reported_for_ten_minutes) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1"}).code == 0);
    const fs::path folder = fs::path(place.runs()) / "progress";
    fs::create_directories(folder);
    const auto says = [&](const std::string &name, std::int64_t seconds_ago, double rate) {
        const ProgressRow row{.written = static_cast<std::int64_t>(std::time(nullptr)) - seconds_ago,
                              .level = 50,
                              .runs = 4,
                              .runs_done = 1,
                              .rate = rate,
                              .seconds_left_level = 100,
                              .seconds_left = 200};
        test::write(folder / name, header_line<ProgressRow>() + line_of(row));
    };
    says("far.cluster-12.csv", 5, 2.5);
    says("further.cluster-12.csv", 5, 3.5);
    says("gone.cluster-12.csv", 7200, 100);
    test::write(folder / "torn.cluster-12.csv", "written,le");
    test::write(folder / "far.cluster-13.csv.tmp", "written,le");
    BOOST_TEST(read_progress(place.runs()).size() == 2u);
    const Said said = planula_says({"status", place.runs()});
    BOOST_TEST(contains(said.out,
                        "\n6.0 evaluations/s, 1 min 40 s left for this level, 3 min 20 s for all levels\n"),
               said.out);
    Json json(planula_says({"status", place.runs(), "--json"}).out);
    BOOST_TEST(json.values["rate"] == "6");
    BOOST_TEST(json.values["seconds_left"] == "200");
    // The files of other machines stay.
    BOOST_TEST(place.run_says({"--seeds", "1"}).code == 0);
    BOOST_TEST(read_progress(place.runs()).size() == 2u);
}

BOOST_AUTO_TEST_CASE(the_page_shows_every_run_and_refers_to_nothing_outside) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1:2"}).code == 0);
    const fs::path page = place.path / "page.html";
    const Said said = planula_says({"status", place.runs(), "--page", page, "--every", "5"});
    BOOST_TEST(said.code == 0);
    BOOST_TEST(said.out == page.string() + "\n");
    const std::string text = content(page);
    for (const char *part : {"No process is working on them", "small seed-001</td><td>complete</td>",
                             "small seed-002</td><td>complete</td>", "2 of 2", "<polyline points=\"0.0 "})
        BOOST_TEST(contains(text, part), text);
    BOOST_TEST(!contains(text, "http-equiv")); // it has ended: nothing to load again
    BOOST_TEST(!contains(text, "://"));
    BOOST_TEST(planula_says({"status", place.runs(), "--every", "5"}).code == 2);
}

BOOST_AUTO_TEST_CASE(the_page_shows_what_a_longer_run_has_written_so_far) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1", "--generations", "4"}).code == 0);
    const std::string all = content(place.run(1) / "generations.csv");
    BOOST_REQUIRE(place.run_says({"--seeds", "2"}).code == 0); // two generations
    test::write(place.run(2) / "generations.csv.part", all);
    const fs::path folder = fs::path(place.runs()) / "progress", page = place.path / "page.html";
    fs::create_directories(folder);
    const ProgressRow row{.written = static_cast<std::int64_t>(std::time(nullptr)),
                          .level = 50,
                          .levels_left = 1,
                          .runs = 160,
                          .runs_done = 37,
                          .rate = 8,
                          .seconds_left_level = 100,
                          .seconds_left = 200};
    test::write(folder / "far.cluster-12.csv", header_line<ProgressRow>() + line_of(row));
    BOOST_REQUIRE(planula_says({"status", place.runs(), "--page", page}).code == 0);
    const std::string text = content(page);
    BOOST_TEST(contains(text, "37 of 160 runs done, level 50"), text);
    BOOST_TEST(contains(text, "1 min 40 s left for this level, 3 min 20 s for all"), text);
    BOOST_TEST(contains(text, "small seed-002</td><td>complete</td><td>4</td>"), text);
}
