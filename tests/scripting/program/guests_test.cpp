// SPDX-License-Identifier: MIT
// Hostile and mistaken scripts: tests/scripting/guests/*.lua. The second line of each says what `planula check` must do:
// "refused: " and a part of the message, or "accepted".
#include "support/commands.h"

#include <iterator>
#include <string>
#include <vector>

#include <boost/test/unit_test.hpp>
#include <sys/resource.h>

namespace {

using namespace planula;
namespace fs = std::filesystem;

const fs::path folder = fs::path(PLANULA_SOURCE_DIR) / "tests" / "scripting" / "guests";

std::vector<fs::path> guests(const std::string &beginning) {
    std::vector<fs::path> files;
    for (const auto &entry : fs::directory_iterator(folder))
        if (entry.path().filename().string().starts_with(beginning + "-")) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::string expectation(const fs::path &file) {
    const std::string text = test::content(file);
    const std::size_t begin = text.find("\n-- ") + 4;
    return text.substr(begin, text.find('\n', begin) - begin);
}

/// The memory of this process at its most so far, in MB.
double megabytes() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    return static_cast<double>(used.ru_maxrss) / 1024;
}

double seconds() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
           static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec) * 1e-6;
}

/// Whether the first line of a message begins with a place in a script.
bool has_place(const std::string &message) {
    const std::size_t end = message.find(".lua:");
    return end != message.npos && message.find('\n') > end && message[end + 5] >= '1' &&
           message[end + 5] <= '9';
}

/// Checks every script whose name begins so.
void check_guests(const std::string &beginning) {
    const auto files = guests(beginning);
    BOOST_TEST(!files.empty(), beginning);
    for (const fs::path &file : files) {
        const std::string expected = expectation(file), name = file.stem().string();
        const double began = seconds();
        const test::Said said = test::planula_says({"check", file.string()});
        // The machine's speed decides about the time: the limit lies far above the second that these take.
        constexpr double longest = 20, most = 300;
        BOOST_TEST(seconds() - began < longest, name);
        BOOST_TEST(megabytes() < most, name);
        if (expected == "accepted") {
            BOOST_TEST(said.code == 0, name << ": " << said.err);
            continue;
        }
        BOOST_REQUIRE(expected.starts_with("refused: "));
        BOOST_TEST(said.code == 65, name << ": " << said.code << said.out);
        BOOST_TEST(test::contains(said.err, expected.substr(9)), name << ": " << said.err.substr(0, 500));
        BOOST_TEST(has_place(said.err), name << ": " << said.err.substr(0, 500));
        BOOST_TEST(said.err.size() < 100'000u, name);
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(scripts_that_take_too_much_are_refused) { check_guests("top"); }
BOOST_AUTO_TEST_CASE(nothing_outside_the_sandbox_can_be_reached) { check_guests("reach"); }
BOOST_AUTO_TEST_CASE(modules_are_held_to_the_same_rules) { check_guests("module"); }
BOOST_AUTO_TEST_CASE(grounds_that_cannot_be_sampled_are_refused) { check_guests("ground"); }
BOOST_AUTO_TEST_CASE(a_bad_fitness_is_refused) { check_guests("fitness"); }
BOOST_AUTO_TEST_CASE(a_bad_penalty_is_refused) { check_guests("penalty"); }
BOOST_AUTO_TEST_CASE(a_bad_behaviour_is_refused) { check_guests("behaviour"); }
BOOST_AUTO_TEST_CASE(a_bad_start_is_refused) { check_guests("start"); }
BOOST_AUTO_TEST_CASE(bad_objectives_are_refused) { check_guests("objective"); }
BOOST_AUTO_TEST_CASE(bad_statistics_are_refused) { check_guests("statistics"); }
BOOST_AUTO_TEST_CASE(functions_that_remember_are_refused) { check_guests("memory"); }
BOOST_AUTO_TEST_CASE(what_differs_between_processors_is_refused) { check_guests("processor"); }
BOOST_AUTO_TEST_CASE(names_stay_inside_the_output_folder) { check_guests("name"); }
BOOST_AUTO_TEST_CASE(texts_are_one_line) { check_guests("text"); }
BOOST_AUTO_TEST_CASE(a_key_of_another_level_says_where_it_belongs) { check_guests("level"); }

BOOST_AUTO_TEST_CASE(every_guest_belongs_to_a_case) {
    const std::string text = test::content(folder.parent_path() / "program" / "guests_test.cpp");
    for (const auto &entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (entry.is_regular_file())
            BOOST_TEST(test::contains(text, "check_guests(\"" + name.substr(0, name.find('-')) + "\")"),
                       name);
    }
}
