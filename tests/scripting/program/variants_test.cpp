// SPDX-License-Identifier: MIT
// Each file of experiments/variants/ answers a question that its first comment asks, and runs.
#include "support/commands.h"

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

BOOST_AUTO_TEST_CASE(every_variant_runs) {
    const test::Folder folder;
    for (const fs::path &file : variants()) {
        const std::string out = (folder.path / file.stem()).string();
        const test::Said said = test::planula_says({"run", file.string(), "--seeds", "1:1", "--generations",
                                                    "2", "--population", "6", "--out", out});
        BOOST_TEST(said.code == 0, file.filename().string() << ": " << said.err);
    }
}
