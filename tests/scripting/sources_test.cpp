// SPDX-License-Identifier: MIT
#include "scripting/sources.h"

#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

#include <fstream>

#include <unistd.h>

using namespace planula;

namespace {

struct Folder {
    Folder() { std::filesystem::remove_all(path), std::filesystem::create_directories(path / "deep" / "er"); }
    ~Folder() { std::filesystem::remove_all(path); }
    void write(const std::string &name, const std::string &text) const {
        std::filesystem::create_directories((path / name).parent_path());
        std::ofstream(path / name) << text;
    }
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("planula-sources-" + std::to_string(getpid()));
};

} // namespace

BOOST_AUTO_TEST_CASE(a_module_is_looked_for_beside_the_script_then_above_then_in_the_library) {
    const Folder folder;
    folder.write("deep/er/script.lua", "return {}");
    folder.write("library/thing.lua", "return { 3 }");
    Sources first(folder.path / "deep/er/script.lua", folder.path / "library");
    BOOST_TEST(first.module("thing").text == "return { 3 }");
    folder.write("deep/thing/init.lua", "return { 2 }");
    Sources second(folder.path / "deep/er/script.lua", folder.path / "library");
    BOOST_TEST(second.module("thing").text == "return { 2 }");
    folder.write("deep/er/thing.lua", "return { 1 }");
    Sources third(folder.path / "deep/er/script.lua", folder.path / "library");
    BOOST_TEST(third.module("thing").text == "return { 1 }");
}

BOOST_AUTO_TEST_CASE(a_source_is_read_once_whatever_happens_to_the_file) {
    const Folder folder;
    folder.write("script.lua", "return {}");
    folder.write("part.lua", "return { 1 }");
    Sources sources(folder.path / "script.lua", folder.path);
    sources.module("part");
    folder.write("part.lua", "return { 2 }");
    BOOST_TEST(sources.module("part").text == "return { 1 }");
    BOOST_TEST(sources.all().size() == 2u);
}

BOOST_AUTO_TEST_CASE(only_safe_names_are_looked_for) {
    const auto sources = test::script("return {}");
    for (const char *name :
         {"", ".", "..", "../x", "a..b", "/a", "a/", "a//b", "A", "a b", "a\\b", "a.", "é", "a-b"})
        BOOST_TEST(
            test::contains(test::refusal([&] { sources->module(name); }), "a module's name consists of"),
            name);
    BOOST_TEST(test::contains(test::refusal([&] { sources->module("no.such"); }),
                              "no module 'no.such'; looked for no/such.lua and no/such/init.lua in:"));
}

BOOST_AUTO_TEST_CASE(what_is_no_script_is_refused_by_name) {
    const Folder folder;
    folder.write("large.lua", std::string((1 << 20) + 1, ' '));
    const auto refused = [&](const std::string &name) {
        return test::refusal([&] { Sources(folder.path / name, folder.path); });
    };
    BOOST_TEST(test::contains(refused("none.lua"), "none.lua: cannot be read"));
    BOOST_TEST(test::contains(refused("deep"), "deep: is a folder, not a script"));
    BOOST_TEST(test::contains(refused("large.lua"), "large.lua: is larger than 1 MiB"));
}
