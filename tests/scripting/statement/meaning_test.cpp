// SPDX-License-Identifier: MIT
#include "statement/meaning.h"

#include "base/hash.h"
#include "statement/schema.h"
#include "support/folder.h"
#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <set>

using namespace planula;

namespace {

using ByName = std::map<std::string, std::string>;

// The hashes of one setting of a script.
ByName meanings(const std::string &script, std::size_t setting = 0) {
    ByName hashes;
    const Experiment experiment = load_experiment(test::script(script));
    for (const FunctionMeaning &function : experiment.settings.at(setting).judgement)
        hashes[function.name] = function.sha256;
    return hashes;
}

// Of the fitness of a setting whose other functions are the paper's; `before` stands above the statement.
std::string fitness(const std::string &function, const std::string &before = "",
                    const std::string &rest = "") {
    return meanings("local paper = require 'paper'\n" + before +
                    "\nreturn paper.experiment { name = 'x', fitness = " + function + rest + " }")["fitness"];
}

std::string refused(const std::string &before, const std::string &function) {
    return test::refusal([&] { fitness(function, before); });
}

const std::string distance = "function(life, parameters, p) return (life.finish.x - life.rest.x) * 2 * p end";

// All these hashes differ.
void check_all_differ(const std::vector<std::string> &hashes) {
    BOOST_TEST(std::set<std::string>(hashes.begin(), hashes.end()).size() == hashes.size());
}

} // namespace

BOOST_AUTO_TEST_CASE(a_setting_has_a_meaning_of_each_function_with_its_place) {
    const Experiment e = load_experiment(
        test::script("local paper = require 'paper'\nreturn paper.experiment { name = 'x',\n"
                     "fitness = function(life)\n  return life.cells\nend,\n"
                     "start = { generations = 2, behaviour = function(life) return { life.cells } end } }"));
    const auto &judgement = e.settings[0].judgement;
    BOOST_REQUIRE_EQUAL(judgement.size(), 4u);
    BOOST_TEST(judgement[0].name == "fitness");
    BOOST_TEST(judgement[0].place == "test.lua:3");
    BOOST_TEST(judgement[1].name == "penalty");
    BOOST_TEST(judgement[1].place.ends_with("experiments/paper/judgement.lua:8"), judgement[1].place);
    BOOST_TEST(judgement[2].name == "behaviour");
    BOOST_TEST(judgement[3].name == "start.behaviour");
    BOOST_TEST(judgement[3].place == "test.lua:6");
    for (const FunctionMeaning &function : judgement) BOOST_TEST(function.sha256.size() == 64u);
}

BOOST_AUTO_TEST_CASE(comments_layout_names_and_the_rest_of_the_script_do_not_count) {
    const std::string hash = fitness(distance);
    BOOST_TEST(
        fitness("function ( life,parameters , p ) -- distance\n\n return(life.finish.x-life.rest.x)\n*2*p "
                "--[[ twice ]] end") == hash);
    BOOST_TEST(fitness("far", "\n\n-- how far\nlocal function far" + distance.substr(8)) == hash);
    BOOST_TEST(fitness("t.far", "local t = {}\nfunction t.far" + distance.substr(8)) == hash);
    BOOST_TEST(fitness(distance, "local unused = 5", ", title = 'Far', search = 'novelty'") == hash);
    BOOST_TEST(fitness(distance, "", ", penalty = function() return 0.5 end") == hash);
    BOOST_TEST(fitness(distance, "",
                       ", statistics = planula.fill({ significance = 0.01 }, require 'paper.summary')") ==
               hash);
    BOOST_TEST(fitness(distance, "", ", parameters = { population = 10 }") == hash);
    const std::string design =
        "local paper = require 'paper'\nreturn paper.design { name = 'other', settings = {\n"
        "{ name = 'a', fitness = function() return 1 end }, { name = 'b', fitness = " +
        distance + " } } }";
    BOOST_TEST(meanings(design, 1)["fitness"] == hash);
    BOOST_TEST(meanings(design, 0)["fitness"] != hash);
    BOOST_TEST(meanings(design, 0)["penalty"] == meanings(design, 1)["penalty"]);
}

BOOST_AUTO_TEST_CASE(quotes_and_separators_before_a_brace_do_not_count) {
    const auto table = [](const std::string &entries) {
        return fitness("function(life) local t = { " + entries + " } return #t end");
    };
    BOOST_TEST(table("'a', \"b\"") == table("\"a\", 'b',"));
    BOOST_TEST(table("1, 2") == table("1, 2;"));
    BOOST_TEST(table("'a'") != table("'b'"));
    BOOST_TEST(table("a = 1") != table("'a', 1"));
    BOOST_TEST(fitness("function() local x x = pi return 1 end", "local pi") !=
               fitness("function() local x x = 'pi' return 1 end", "local pi"));
}

BOOST_AUTO_TEST_CASE(the_meaning_depends_on_the_words_of_the_function) {
    check_all_differ({
        fitness(distance),
        fitness("function(life, parameters, p) return (life.finish.x - life.rest.x) * 3 * p end"),
        fitness("function(life, parameters, p) return (life.finish.x + life.rest.x) * 2 * p end"),
        fitness("function(life, parameters, p) return (life.finish.y - life.rest.x) * 2 * p end"),
        fitness("function(life, p, q) return (life.finish.x - life.rest.x) * 2 * q end"),
        fitness("function(life) return life.outcome == 'viable' and 1 or 0 end"),
        fitness("function(life) return life.outcome == 'exploded' and 1 or 0 end"),
        fitness("function(life) return life.outcome ~= 'exploded' and 1 or 0 end"),
    });
}

BOOST_AUTO_TEST_CASE(the_meaning_depends_on_the_values_that_a_function_closes_over) {
    const auto with = [](const std::string &before) {
        return fitness("function() return k and 1 or 2 end", before);
    };
    check_all_differ({with("local k = 1"),
                      with("local k = 2"),
                      with("local k = -0"),
                      with("local k = 0"),
                      with("local k = '1'"),
                      with("local k = true"),
                      with("local k = false"),
                      with("local k"),
                      with("local k = {}"),
                      with("local k = { 1 }"),
                      with("local k = { a = 1 }"),
                      with("local k = { [true] = 1 }"),
                      with("local k = { [1.5] = 1 }"),
                      with("local k = { { 1 } }"),
                      with("local k = math.sin"),
                      with("local k = math.cos"),
                      with("local k = math"),
                      with("local k = string"),
                      with("local k = planula.parameters"),
                      with("local k = pairs"),
                      with("local k = pairs {}"),
                      with("local k = ipairs {}"),
                      with("local k = pairs { 1 }"),
                      with("local k = planula.fill"),
                      with("local function k() end"),
                      with("local function k(x) end")});
    // Lists with holes that are equal entry by entry, and not in their length.
    BOOST_TEST(with("local k = { 1, 1, 1, 4 } k[1], k[2], k[3] = nil") != with("local k = {} k[4] = 4"));
    BOOST_TEST(with("local k = 0/0") == with("local k = -(0/0)"));
    BOOST_TEST(with("local k = 3") == with("local k = 1 + 2"));
    BOOST_TEST(with("local k = { 1, a = 2, b = 3 }") == with("local k = { b = 3, a = 2 } k[1] = 1"));
}

BOOST_AUTO_TEST_CASE(swapped_upvalues_count) {
    const auto with = [](const std::string &values) {
        return fitness("function() return a - b end", "local a, b = " + values);
    };
    BOOST_TEST(with("1, 2") != with("2, 1"));
    const auto order = [](const std::string &names) {
        return fitness("function() return a - b end", "local " + names);
    };
    BOOST_TEST(order("a, b = 1, 2") == order("b, a = 2, 1"));
}

BOOST_AUTO_TEST_CASE(functions_that_a_function_calls_count) {
    const auto with = [](const std::string &innermost) {
        return fitness("function(life) return f(life) end",
                       "local function h(life) return " + innermost +
                           " end\nlocal t = { inner = { h = h } }\n"
                           "local function g(life) return t.inner.h(life) end\nlocal function f(life) return "
                           "g(life) end");
    };
    BOOST_TEST(with("life.cells") == with("life.cells -- their number\n"));
    BOOST_TEST(with("life.cells") != with("life.springs"));
    // So does what a function in a function closes over.
    const auto inner = [](const std::string &value) {
        return fitness("function(life) return (function() return k end)() end", "local k = " + value);
    };
    BOOST_TEST(inner("1") != inner("2"));
}

BOOST_AUTO_TEST_CASE(functions_on_one_line_are_distinguished) {
    const std::string two = "local a, b = function() return 1 end, function() return 2 end ";
    const std::string a = fitness("a", two), b = fitness("b", two);
    BOOST_TEST(a != b);
    BOOST_TEST(a == fitness("function() return 1 end"));
    BOOST_TEST(b == fitness("function() return 2 end"));
    // Also one in another, with the bracket on a line of its own, or of several statements.
    BOOST_TEST(fitness("(function() return function() return 2 end end)()") == b);
    BOOST_TEST(fitness("function\n\n(\n)\nreturn 2\nend") == b);
    BOOST_TEST(
        fitness("g", "local function f() end local function\n\ng() return 2 end local function h() end") ==
        b);
    BOOST_TEST(fitness("t.x.g", "local t = { x = {} } function t.x.g() return 2 end") == b);
    BOOST_TEST(
        fitness(
            "function() if true then for i = 1, 2 do repeat until true end while false do end end return 2 "
            "end") != b);
    // A method has one parameter more.
    BOOST_TEST(fitness("t.g", "local t = {} function t:g() return 2 end") != b);
}

// Functions side by side and in each other, with line feeds at random places, all kept in `t`.
BOOST_AUTO_TEST_CASE(functions_in_random_layout_are_distinguished) {
    std::uint64_t state = 1;
    const auto draw = [&](std::uint64_t below) { return mix(++state) % below; };
    const auto gap = [&] { return draw(3) == 0 ? std::string("\n") : std::string(" "); };
    int count = 0;
    const std::function<std::string(int)> functions = [&](int depth) {
        std::string text;
        for (std::uint64_t i = 0; i <= draw(3); ++i) {
            const std::string number = std::to_string(++count);
            text += "t[" + number + "] =" + gap() + "function" + gap() + "(" + gap() + ")" + gap() +
                    "return" + gap() + number + gap() + "end" + gap();
            if (depth > 0)
                text += "local" + gap() + "function" + gap() + "f" + gap() + "(" + gap() + ")" + gap() +
                        functions(depth - 1) + "end" + gap() + "f()" + gap();
        }
        return text;
    };
    const std::string before = "local t = {} " + functions(3);
    BOOST_REQUIRE(count > 10);
    for (int i = 1; i <= count; i += 1 + count / 12) {
        const std::string number = std::to_string(i);
        BOOST_TEST(fitness("t[" + number + "]", before) == fitness("function() return " + number + " end"),
                   before);
    }
}

BOOST_AUTO_TEST_CASE(cycles_end_and_sharing_counts) {
    const auto with = [](const std::string &before) { return fitness("function() return #k end", before); };
    const std::string cycle = with("local k = {} k.self = k");
    BOOST_TEST(cycle == with("local k = {} local other = k other.self = k"));
    BOOST_TEST(cycle != with("local k = {} k.self = { self = k }"));
    BOOST_TEST(with("local t = {} local k = { t, t }") != with("local k = { {}, {} }"));
    BOOST_TEST(with("local k = {} for i = 1, 5000 do k = { k } end").size() == 64u);
    BOOST_TEST(fitness("f", "local f function f(life) return life.cells > 0 and 1 or f(life) end").size() ==
               64u);
}

BOOST_AUTO_TEST_CASE(values_too_large_or_without_an_order_are_refused_with_their_place) {
    const std::string f = "function(life)\nreturn #k end";
    const std::string many = refused("local k = {} for i = 1, 200000 do k[i] = i end", f);
    BOOST_TEST(test::contains(many, "test.lua:3: fitness closes over more than 200000 values"), many);
    const std::string long_text =
        refused("local s = ('x'):rep(1e6) local k = {} for i = 1, 100 do k[i] = s end", f);
    BOOST_TEST(test::contains(long_text, "test.lua:3: fitness closes over more than 64 MB of text"),
               long_text);
    const std::string key = refused("local k = { [{}] = 1 }", f);
    BOOST_TEST(test::contains(key, "test.lua:3: fitness closes over a table with a key of type table"), key);
}

BOOST_AUTO_TEST_CASE(a_function_of_the_library_cannot_judge) {
    for (const char *function : {"math.abs", "planula.fill", "pairs {}"})
        BOOST_TEST(test::contains(refused("", function), "test.lua:3: fitness is a function of the library"),
                   function);
}

BOOST_AUTO_TEST_CASE(modules_that_a_function_requires_count) {
    const test::Folder folder;
    const auto with = [&](const std::string &script, const std::string &value, const std::string &deeper) {
        folder.write("part.lua", "local deep = require 'deep' -- a comment " + deeper + "\nreturn { k = " +
                                     value + ", deep = deep, f = function() return 1 end }");
        folder.write("deep.lua", "return { k = " + deeper + " }");
        folder.write("paper.lua", "return {}");
        folder.write("script.lua",
                     "return { name = 'x', fitness = function() return " + script +
                         " end, penalty = function() return 1 end, behaviour = function() return { 1 } end,"
                         "actuation = 'grn', search = 'neat', environment = { actuation_range = 0.1 },"
                         "statistics = { confidence = 0.9, resamples = 10, significance = 0.05, "
                         "sample_share = 0.5 } }");
        return load_experiment(folder.path / "script.lua", folder.path).settings[0].judgement.at(0).sha256;
    };
    for (const char *script :
         {"require 'part'.k", "require('part').k", "require \"part\".f()",
          "(function(name) require 'part' return require(name).k end)('part')",
          "(function() require 'part' return select(2, pcall(require, 'part')).k end)()"}) {
        const std::string hash = with(script, "1", "2");
        BOOST_TEST(hash == with(script, "1 + 0", "2"), script);
        BOOST_TEST(hash != with(script, "3", "2"), script);
        BOOST_TEST(hash != with(script, "1", "3"), script);
    }
    BOOST_TEST(with("1", "1", "2") == with("1", "3", "3"));
}

BOOST_AUTO_TEST_CASE(the_papers_functions_mean_the_same_in_every_script) {
    const ByName paper = meanings("return require('paper').experiment { name = 'a' }");
    BOOST_TEST(paper.size() == 3u);
    BOOST_TEST(
        (meanings("local paper = require 'paper'\n\nlocal k = 5\nreturn paper.experiment { name = 'b', "
                  "search = 'novelty', environment = paper.terrestrial() }") == paper));
    const Experiment replication =
        load_experiment(test::experiments_folder() / "paper" / "replication.lua", test::experiments_folder());
    for (const Spec &setting : replication.settings)
        for (const FunctionMeaning &function : setting.judgement)
            BOOST_TEST(function.sha256 == paper.at(function.name), setting.name);
    BOOST_TEST((meanings("local paper = require 'paper'\nreturn paper.experiment { name = 'b', fitness = "
                         "paper.judgement.fitness }") == paper));
}

// The hash of a known function, in every process, on every machine: another program's runs are known by it.
BOOST_AUTO_TEST_CASE(the_hash_is_the_same_everywhere) {
    const std::string before =
        "local t = { 1.5, 'x', z = true, y = { -1 } } local function f(x) return x + t[1] end";
    BOOST_TEST(fitness("function(life) return f(life.cells) * math.sqrt(2) end", before) ==
               "610b456277d4b415045c43146f54576c1dc53a9a97947298ca2ce044ba7ae559");
}
