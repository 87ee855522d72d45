// SPDX-License-Identifier: MIT
#include "report/report_data.h"
#include "statement/recorded.h"
#include "support/commands.h"
#include "support/json.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::test;

namespace {

/// An experiment with a name and titles that mean something to HTML, JSON and CSV.
const char *const hostile =
    "local paper = require 'paper'\n"
    "return paper.experiment { name = 'small', title = [[</script><script>x=\"1\" & 'b', {{data}}]],\n"
    "search = 'novelty', parameters = { population = 6, generations = 2, seeds = 2, development_steps = "
    "200,\n"
    "locomotion_steps = 100 } }\n";

/// A folder with the runs of the experiment and a bundle of scripts.
struct Reported : Workplace {
    explicit Reported(const std::string &text = small) : Workplace(text) {
        for (const char *name : {"report.js", "report.css", "licences.txt"})
            Folder::write(std::string("bundle/") + name, std::string("bundled ") + name + " {{x}} ");
        BOOST_REQUIRE(run_says({"--seeds", "1:2"}).code == 0);
    }
    Said report(const std::string &folder, std::vector<std::string> words = {},
                bool has_bundle = true) const {
        words.insert(words.begin(), {"report", folder, "--out", out().string(), "--threads", "1"});
        std::ostringstream said, err;
        Console console{said, err, false, experiments_folder(), has_bundle ? path / "bundle" : path / "none"};
        const int code = run_program(words, console);
        return {code, said.str(), err.str()};
    }
    std::filesystem::path out() const { return path / "report"; }
    std::string page() const { return content(out() / "report.html"); }
};

std::size_t count_of(const std::string &text, const std::string &part) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != text.npos; at += part.size()) ++count;
    return count;
}

/// The data of the page that the command would make of these runs.
std::string data_of(const Reported &place) {
    const ReportRuns runs = report_runs(place.runs());
    Experiment experiment = recorded_experiment(runs.runs.front().folder);
    ask_common_generations(experiment, runs.runs);
    return report_data({experiment, runs, place.out(), experiments_folder(), {"a \"line\"\n"}});
}

} // namespace

BOOST_AUTO_TEST_CASE(a_report_shows_every_run_and_has_its_tables_beside_it) {
    const Reported place;
    const Said said = place.report(place.runs());
    BOOST_REQUIRE(said.code == 0);
    BOOST_TEST(said.out == (place.out() / "report.html").string() + "\n");
    BOOST_TEST(count_of(place.page(), "data-run=") == 2u);
    BOOST_TEST(contains(place.page(), "2 runs of 1 setting"));
    BOOST_TEST(std::filesystem::exists(place.out() / "curves.csv"));
    BOOST_TEST(is_json(data_of(place)));
}

BOOST_AUTO_TEST_CASE(titles_cannot_end_a_script_or_a_text) {
    const Reported place(hostile);
    BOOST_REQUIRE(place.report(place.runs()).code == 0);
    const std::string page = place.page();
    BOOST_TEST(!contains(page, "<script>x"));
    BOOST_TEST(contains(page, "&lt;/script>&lt;script>"));
    BOOST_TEST(count_of(page, "<script") == count_of(page, "</script>"));
    BOOST_TEST(contains(page, "bundled report.js {{x}}"));
    const std::string data = data_of(place);
    BOOST_TEST(is_json(data));
    BOOST_TEST(contains(data, R"("title":"</script><script>x=\"1\" & 'b', {{data}}")"));
    BOOST_TEST(contains(data, R"("a \"line\"\u000a")"));
}

BOOST_AUTO_TEST_CASE(a_report_of_one_run_is_about_that_run_alone) {
    const Reported place;
    BOOST_REQUIRE(place.report(place.run(2)).code == 0);
    BOOST_TEST(count_of(place.page(), "data-run=") == 1u);
    BOOST_TEST(contains(place.page(), "1 run of 1 setting"));
    BOOST_REQUIRE(place.report(place.run(2).parent_path()).code == 0);
    BOOST_TEST(count_of(place.page(), "data-run=") == 2u);
}

BOOST_AUTO_TEST_CASE(a_page_holds_the_module_that_it_is_given_and_may_run_it) {
    const Reported place;
    const auto holds = [&](const std::vector<std::string> &words) {
        BOOST_REQUIRE(place.report(place.run(1), words).code == 0);
        const std::string page = place.page();
        BOOST_TEST(contains(page, "'wasm-unsafe-eval'") == contains(page, "id=\"module\""));
        return contains(page, "id=\"module\"");
    };
    place.write("module.js", "var planulaModule = 1;\n");
    BOOST_TEST(holds({"--module", (place.path / "module.js").string()}));
    BOOST_TEST(!holds({}));
    place.write("other.js", "var another = 1;\n");
    const Said other = place.report(place.run(1), {"--module", (place.path / "other.js").string()});
    BOOST_TEST(other.code == 65);
    BOOST_TEST(contains(other.err, "is not the module that `make wasm` builds"), other.err);
}

BOOST_AUTO_TEST_CASE(what_a_report_lacks_is_said) {
    const Reported place;
    const Said bare = place.report(place.runs(), {}, false);
    BOOST_TEST(bare.code == 65);
    BOOST_TEST(contains(bare.err, "run `make report` once"), bare.err);

    const Said shorter = place.report(place.runs(), {"--seeds", "1:3", "--generations", "1"});
    BOOST_TEST(shorter.code == 0);
    BOOST_TEST(contains(shorter.err, "missing: " + place.run(3).string()), shorter.err);

    std::filesystem::create_directories(place.path / "empty");
    const Said empty = place.report((place.path / "empty").string());
    BOOST_TEST(empty.code == 65);
    BOOST_TEST(contains(empty.err, "there is no complete run"), empty.err);

    copy_folder(place.runs(), place.path / "both/a");
    copy_folder(place.runs(), place.path / "both/b");
    const Said both = place.report((place.path / "both").string());
    BOOST_TEST(both.code == 65);
    BOOST_TEST(contains(both.err, "name one of"), both.err);
}
