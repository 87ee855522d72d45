// SPDX-License-Identifier: MIT
#include "support/commands.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::test;

namespace {

namespace fs = std::filesystem;

} // namespace

BOOST_AUTO_TEST_CASE(a_forecast_reports_time_disk_and_memory_and_writes_nothing) {
    const Workplace place;
    const Said said = place.run_says({"--forecast", "--generations", "30", "--cores", "8"});
    BOOST_TEST(said.code == 0, said.err);
    for (const char *part :
         {"forecast of small: 2 runs, 360 evaluations\n",
          "measured here: generations 1 to 10 of each setting, seed 1\n", "evaluations/core-s",
          "core-hours a run", "\nsmall ", "\ntime:   ", " core-hours; ",
          " on the 1 threads of this command; ", " on 8 cores of a cluster, one run on each\n",
          "\ndisk:   ", " when all is complete, and up to ", "\nmemory: ", " MB\n",
          "This assumes that later generations cost as much as those measured."})
        BOOST_TEST(contains(said.out, part), said.out);
    BOOST_TEST(!contains(said.out, "inf"), said.out);
    BOOST_TEST(!contains(said.out, "nan"), said.out);
    BOOST_TEST(!fs::exists(place.runs()));
    // Existing runs stay as they are, even those of another identity.
    BOOST_REQUIRE(place.run_says().code == 0);
    const auto before = all_files(place.runs());
    BOOST_TEST(place.run_says({"--forecast", "--population", "9"}).code == 0);
    BOOST_TEST((all_files(place.runs()) == before));
}

BOOST_AUTO_TEST_CASE(a_forecast_covers_the_runs_that_are_asked_for) {
    const Workplace place;
    const auto says = [&](std::vector<std::string> words, const std::string &part) {
        words.push_back("--forecast");
        const Said said = place.run_says(words);
        BOOST_TEST(said.code == 0, said.err);
        BOOST_TEST(contains(said.out, part), said.out);
        BOOST_TEST(!contains(said.out, "inf"), said.out);
    };
    says({"--seeds", "1:100", "--generations", "100000"}, "100 runs, 60.00 million evaluations");
    says({"--seeds", "1:100", "--part", "2:4", "--generations", "100000"},
         "25 runs, 15.00 million evaluations");
    says({"--seeds", "1:100", "--levels", "25,100000"}, "100 runs, 60.00 million evaluations");
    says({"--generations", "1"}, "measured here: generation 0 of each setting");
    says({"--generations", "4"}, "measured here: generations 1 to 3 of each setting");
    BOOST_TEST(place.run_says({"--forecast", "--cores", "0"}).code == 2);
    BOOST_TEST(place.run_says({"--forecast", "--part", "3:2"}).code == 2);
}
