// SPDX-License-Identifier: MIT
#include "record/run_reader.h"
#include "support/commands.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::test;

namespace {

namespace fs = std::filesystem;

struct Parts : Workplace {
    /// Runs of these seeds and generations in a folder called `part`.
    fs::path part(const std::string &name, const std::string &seeds, const std::string &generations,
                  std::vector<std::string> words = {}) const {
        words.insert(words.begin(), {"run", script(), "--threads", "1", "--out", path / name, "--seeds",
                                     seeds, "--generations", generations});
        const Said said = planula_says(words);
        BOOST_REQUIRE_MESSAGE(said.code == 0, said.err);
        return path / name;
    }
};

} // namespace

BOOST_AUTO_TEST_CASE(merged_parts_equal_the_whole) {
    const Parts place;
    const fs::path whole = place.part("whole", "1:4", "5"), a = place.part("a", "1:2", "5"),
                   b = place.part("b", "3:4", "5");
    const fs::path into = place.path / "into";
    const std::vector<std::string> words{"merge", a, b, "--into", into};
    const Said said = planula_says(words);
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(said.out ==
               into.string() + ": 4 runs copied, 0 replaced by a longer one, 0 there already, 0 refused\n");
    BOOST_TEST(difference(whole, into) == "");
    const Said again = planula_says(words);
    BOOST_TEST(again.code == 0);
    BOOST_TEST(contains(again.out, "0 runs copied, 0 replaced by a longer one, 4 there already, 0 refused"),
               again.out);
    BOOST_TEST(difference(whole, into) == "");
}

BOOST_AUTO_TEST_CASE(the_longer_of_two_lengths_of_a_run_stays) {
    const Parts place;
    const fs::path longer = place.part("longer", "1", "9"), shorter = place.part("shorter", "1", "5"),
                   into = place.part("into", "1", "7");
    BOOST_TEST(contains(planula_says({"merge", shorter, "--into", into}).out, "1 there already"));
    const Said said = planula_says({"merge", longer, "--into", into});
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(contains(said.out, "0 runs copied, 1 replaced by a longer one"), said.out);
    BOOST_TEST(difference(longer, into) == "");
    BOOST_TEST(complete_generations(shorter / "small/seed-001") == 5);
}

BOOST_AUTO_TEST_CASE(an_unfinished_run_is_merged_and_resumes) {
    const Parts place;
    const fs::path into = place.path / "into", from = place.path / "from";
    const pid_t child = start(place.path / "said", {"run", place.script(), "--seeds", "1", "--generations",
                                                    "100000", "--checkpoint", "1", "--out", from});
    BOOST_TEST(kill_once_there(child, from / "small/seed-001/checkpoint.previous") == -SIGKILL);
    BOOST_TEST(contains(planula_says({"merge", from, "--into", into}).out, "1 run copied"));
    const Said said = planula_says({"run", place.script(), "--seeds", "1", "--out", into});
    BOOST_TEST(contains(said.err, "small seed 1: resumes with generation "), said.err);
    const std::string generations = std::to_string(complete_generations(into / "small/seed-001"));
    BOOST_TEST(difference(place.part("whole", "1", generations), into) == "");
}

BOOST_AUTO_TEST_CASE(contradicting_runs_are_refused_by_name_and_the_others_merged) {
    const Parts place;
    const fs::path from = place.part("from", "1:6", "5"),
                   into = place.part("into", "2", "5", {"--set", "drag_normal=2"});
    const auto seed = [](const fs::path &folder, int number) {
        return folder / "small" / ("seed-00" + std::to_string(number));
    };
    // 2 is another run in `into`; in `from` 3 is damaged, 4 is not a run, 5 is in use, 6 was forged from another run.
    test::write(seed(from, 3) / "generations.csv", content(seed(from, 3) / "generations.csv") + "\n");
    fs::remove(seed(from, 4) / "identity.csv");
    const FolderLock held(seed(from, 5));
    place.part("into", "6", "7");
    for (const char *file : {"chain.csv"}) {
        const fs::path chain = seed(into, 6) / file;
        test::write(chain, replaced(content(chain), "\n4,", "\n4,0"));
    }
    const auto before = all_files(from), there = all_files(into);
    const Said said = planula_says({"merge", from, "--into", into});
    BOOST_TEST(said.code == 65);
    BOOST_TEST(contains(said.out, "1 run copied, 0 replaced by a longer one, 0 there already, 5 refused\n"),
               said.out);
    for (const std::string &line :
         {seed(from, 2).string() + " and " + seed(into, 2).string() +
              " contradict each other: they are different runs, environment drag normal: recorded with 2, "
              "asked for with 1. "
              "Nothing was changed.",
          (seed(from, 3) / "generations.csv").string() + ": its content is not what the run's manifest says",
          seed(from, 4).string() + " holds ", seed(from, 5).string() + " is in use by another process",
          (seed(into, 6) / "chain.csv").string() + ": "})
        BOOST_TEST(contains(said.err, "refused: " + line), said.err);
    BOOST_TEST((all_files(from) == before));
    auto now = all_files(into);
    for (const auto &[name, bytes] : there) BOOST_TEST((now[name] == bytes), name);
    BOOST_TEST(difference(seed(from, 1), seed(into, 1)) == "");
}

BOOST_AUTO_TEST_CASE(the_next_merge_completes_one_that_was_killed) {
    const Parts place;
    const fs::path from = place.part("from", "1:2", "5"), into = place.part("into", "1", "3");
    const fs::path setting = into / "small";
    // Killed while it copied seed 2, and between the two renames that exchange seed 1.
    copy_folder(from / "small/seed-002", setting / "seed-002.incoming");
    fs::remove(setting / "seed-002.incoming/manifest.csv");
    fs::rename(setting / "seed-001", setting / "seed-001.replaced");
    const Said said = planula_says({"merge", from, "--into", into});
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(contains(said.out, "1 run copied, 1 replaced by a longer one"), said.out);
    BOOST_TEST(difference(from, into) == "");
}

BOOST_AUTO_TEST_CASE(merge_says_which_folder_it_cannot_use) {
    const Parts place;
    const fs::path from = place.part("from", "1", "2");
    BOOST_TEST(contains(planula_says({"merge", from}).err, "planula merge needs --into DIR"));
    BOOST_TEST(planula_says({"merge", "--into", from}).code == 2);
    const Said same = planula_says({"merge", from, "--into", from});
    BOOST_TEST(same.code == 2);
    BOOST_TEST(contains(same.err, from.string() + " is the folder of --into itself"), same.err);
    const Said nowhere = planula_says({"merge", from, place.path / "nowhere", "--into", place.path / "into"});
    BOOST_TEST(nowhere.code == 65);
    BOOST_TEST(contains(nowhere.err, (place.path / "nowhere").string() + " is not a folder"), nowhere.err);
    const Said above = planula_says({"merge", place.path, "--into", place.path / "into"});
    BOOST_TEST(above.code == 65);
    BOOST_TEST(contains(above.err, "has no runs, <setting>/seed-NNN; give the folder that was --out of " +
                                       (from / "small/seed-001").string()),
               above.err);
    BOOST_TEST(!fs::exists(place.path / "into"));
}
