// SPDX-License-Identifier: MIT
#include "language/sources.h"

#include "support/folder.h"
#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

BOOST_AUTO_TEST_CASE(a_module_is_looked_for_beside_the_script_then_above_then_in_the_library) {
    const test::Folder folder;
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

BOOST_AUTO_TEST_CASE(a_source_is_read_once_even_if_its_file_changes) {
    const test::Folder folder;
    folder.write("script.lua", "return {}");
    folder.write("part.lua", "return { 1 }");
    Sources sources(folder.path / "script.lua", folder.path);
    sources.module("part");
    folder.write("part.lua", "return { 2 }");
    BOOST_TEST(sources.module("part").text == "return { 1 }");
    BOOST_TEST(sources.all().size() == 2u);
}

BOOST_AUTO_TEST_CASE(sources_with_functions_on_lines_have_the_same_words) {
    const auto sources =
        test::script("local f, g = function() return 'function' end, function() -- function\nend");
    sources->module("descriptors");
    const auto by_line = sources->with_functions_on_lines();
    BOOST_REQUIRE_EQUAL(by_line->all().size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto &words = sources->all()[i].tokens, &same = by_line->all()[i].tokens;
        BOOST_REQUIRE_EQUAL(words.size(), same.size());
        for (std::size_t word = 0; word < words.size(); ++word)
            BOOST_TEST(words[word].word == same[word].word);
    }
    BOOST_TEST(by_line->script().text ==
               "local f, g = \nfunction() return 'function' end, \nfunction() -- function\nend");
    BOOST_TEST(by_line->script().name == "0");
    BOOST_TEST(by_line->module("descriptors").name == "1");
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

BOOST_AUTO_TEST_CASE(files_that_are_not_scripts_are_refused_by_name) {
    const test::Folder folder;
    folder.write("deep/file.lua", "");
    folder.write("large.lua", std::string((1 << 20) + 1, ' '));
    const auto refused = [&](const std::string &name) {
        return test::refusal([&] { Sources(folder.path / name, folder.path); });
    };
    BOOST_TEST(test::contains(refused("none.lua"), "none.lua: cannot be read"));
    BOOST_TEST(test::contains(refused("deep"), "deep: is a folder, not a script"));
    BOOST_TEST(test::contains(refused("large.lua"), "large.lua: is larger than 1 MiB"));
}
