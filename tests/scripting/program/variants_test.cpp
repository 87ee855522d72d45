// SPDX-License-Identifier: MIT
// Each file of experiments/variants/ answers a question that its first comment asks, and gives the recorded result:
// tests/golden/variants holds a hash over the chains of its runs. The signature covers the paper's worlds; this covers
// what only variants use.
#include "support/commands.h"

#include "base/hash.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> variants() {
    std::vector<fs::path> files;
    for (const auto &entry : fs::directory_iterator(test::experiments_folder() / "variants"))
        if (entry.path().extension() == ".lua") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace

BOOST_AUTO_TEST_CASE(every_variant_begins_with_a_question) {
    for (const fs::path &file : variants()) {
        const std::string text = test::content(file);
        const std::size_t begin = text.find('\n') + 1, end = text.find("\nlocal ", begin);
        const std::string comment = text.substr(begin, end - begin);
        BOOST_TEST(comment.starts_with("-- "), file.filename().string());
        BOOST_TEST(test::contains(comment, "?"), file.filename().string());
    }
}

// Where results change on purpose, the new file is what this prints.
BOOST_AUTO_TEST_CASE(every_variant_gives_its_recorded_result) {
    const test::Folder folder;
    std::string results;
    for (const fs::path &file : variants()) {
        const fs::path out = folder.path / file.stem();
        const test::Said said = test::planula_says({"run", file.string(), "--seeds", "1:1", "--generations",
                                                    "2", "--population", "6", "--out", out.string()});
        BOOST_TEST(said.code == 0, file.filename().string() << ": " << said.err);
        std::vector<fs::path> chains;
        if (fs::exists(out))
            for (const auto &entry : fs::recursive_directory_iterator(out))
                if (entry.path().filename() == "chain.csv") chains.push_back(entry.path());
        std::sort(chains.begin(), chains.end());
        Hash hash;
        for (const fs::path &chain : chains) hash.text(test::content(chain));
        results += file.stem().string() + " " + hash.hex() + "\n";
    }
    BOOST_TEST(results == test::content(fs::path(PLANULA_SOURCE_DIR) / "tests" / "golden" / "variants"),
               "tests/golden/variants must be\n"
                   << results);
}
