// SPDX-License-Identifier: MIT
#include "language/lua_state.h"

#include "base/math.h"
#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <csignal>
#include <ctime>
#include <utility>

#include <sys/time.h>
#include <time.h>

using namespace planula;

namespace {

// What a script that returns {value = …} computed.
Value value_of(const std::string &expression) {
    const auto sources = test::script("return { value = " + expression + " }");
    const LuaState state(sources, sources->script());
    const Value *value = state.result().find("value");
    return value ? *value : Value{};
}

double number_of(const std::string &expression) { return value_of(expression).number; }
std::string text_of(const std::string &expression) { return value_of(expression).text; }

std::string failure(const std::string &text) {
    return test::refusal([&] {
        const auto sources = test::script(text);
        LuaState(sources, sources->script());
    });
}

// As if the process were stopped for a while.
void stand_still(int) {
    const timespec time{.tv_sec = 0, .tv_nsec = 400'000'000};
    ::nanosleep(&time, nullptr);
}

} // namespace

BOOST_AUTO_TEST_CASE(nothing_reaches_out_of_the_sandbox) {
    for (const char *name : {"os",           "io",
                             "debug",        "ffi",
                             "jit",          "bit",
                             "package",      "load",
                             "loadstring",   "loadfile",
                             "dofile",       "module",
                             "getfenv",      "setfenv",
                             "getmetatable", "setmetatable",
                             "rawget",       "rawset",
                             "rawequal",     "next",
                             "newproxy",     "collectgarbage",
                             "coroutine",    "print",
                             "xpcall",       "gcinfo",
                             "_G",           "_VERSION"})
        BOOST_TEST(failure("local x = " + std::string(name))
                       .starts_with("test.lua:1: nothing is called '" + std::string(name) + "'"),
                   name);
    for (const char *name : {"dump", "gsub", "gmatch", "match", "gfind"})
        BOOST_TEST(
            test::contains(failure("local x = string." + std::string(name)), "test.lua:1: string has no"),
            name);
    BOOST_TEST(test::contains(failure("local x = ('x'):dump()"), "test.lua:1: "));
}

BOOST_AUTO_TEST_CASE(every_hostile_script_ends_soon_with_a_line) {
    const char *scripts[] = {
        "while true do end",
        "repeat until false",
        "while true do pcall(function() while true do end end) end",
        "local function f() return pcall(f) end while true do f() end",
        "local function f() local done, why = pcall(f) if not done then error(why) end end f()",
        "local function f() table.sort({ 2, 1 }, f) return false end f()",
        "local function f() pcall(table.sort, { 2, 1 }, f) f() end f()",
        "for i = 1, math.huge do local t = {} end",
        "local s = 'x' while true do s = s .. s end",
        "pcall(function() local s = 'x' while true do s = s .. s end end) error('reached')",
        "local t = {} for i = 1, 1e9 do t[i] = i end",
        "while true do local s = ('x'):rep(1e6) end",
        "local s = ('x'):rep(1e9)",
        "local s = ('x'):rep(-1) .. ('x'):rep(1e300)",
        "local s = ('a'):rep(1e7) while true do s:find(('a'):rep(1e6) .. 'b') end",
        "local s = ('x'):rep(9e6) while true do s = s:upper() s = s:lower() end",
        "local t = {} for i = 1, 1e6 do t[i] = i end while true do table.sort(t) end",
        "local t = {} for i = 1, 1e6 do t[i] = i end while true do for k in pairs(t) do break end end",
        "local t = {} for i = 1, 1e6 do t[i] = i end while true do table.insert(t, 1, 0) table.remove(t, 1) "
        "end",
        "local t = {} for i = 1, 1e5 do t[i] = 'x' end while true do table.concat(t) end",
        "local function f() return 1 + f() end f()",
        "local function f(...) return f(1, ...) end f()",
        "error({})",
        "error('x', 0)",
        "error(nil)",
        "local t = {} t[1] = t return t",
        "return { [1.5] = 1 }",
        "return { [true] = 1 }",
        "return 5",
        "return",
        "return math.sqrt",
        "local x = nil + 1",
        "local x = ({}).a.b",
        "(",
        "goto nowhere",
        "x = 1",
        "math.pi = 3",
        "math = nil",
        "string.rep = nil",
        "planula.parameters.gravity = 1",
        "table.insert(math, 1)",
        "table.insert(planula.parameters, 1)",
        "table.remove(string)",
        "table.sort(table)",
        "('x').y = 1",
        "planula.extra = 1",
        "local x = planula.parameters.gravitation",
        "local x = math.squirt(2)",
        "math.random()",
        "math.randomseed(1)",
        "string.format('%p', 'x')",
        "string.format('%s', {})",
        "string.format('%-10p', 'x')",
        "string.format('\\0%p', 'x')",
        "string.format('%s\\0%%%5.3p', 'x', 'x')",
        "string.format('%5%p', 'x')",
        "require 'paper\\0'",
        "require '../../secret'",
        "require '/etc/passwd'",
        "require 'nowhere'",
        "require ''",
        "require 'a..b'",
        "require {}",
        "pairs(5)",
        "for k in pairs({ [{}] = 1 }) do end",
        "for k in pairs({ [true] = 1 }) do end",
        "ipairs('x')",
        "planula.experiment(5)",
        "planula.change(5, {})",
        "planula.fill({}, nil)",
        "unpack({}, 1, 1e9)",
        "('x'):rep(2, {})",
        "table.sort({ 3, 2, 1, 5, 4 }, function() return true end) error('x')",
        "table.sort({ 1, 'x' })",
        "local a = 2 ^ 0.5",
        "local a = 1ULL",
    };
    static_assert(std::size(scripts) >= 60);
    for (const char *text : scripts) {
        // Of the process, so that a busy machine changes nothing; ten times what they take.
        const std::clock_t start = std::clock();
        const std::string message = failure(text);
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        BOOST_TEST(test::contains(message, "test.lua:1: "), text << " => " << message);
        BOOST_TEST(seconds < 20, text << " took " << seconds << " s");
    }
}

BOOST_AUTO_TEST_CASE(pcall_catches_errors_but_not_exceeded_limits) {
    BOOST_TEST(text_of("select(2, pcall(error, 'caught'))") == "caught");
    BOOST_TEST(value_of("pcall(error)").boolean == false);
    const char *spin = "pcall(function() pcall(function() while true do end end) end) return { value = 1 }";
    BOOST_TEST(test::contains(failure(spin), "executes too many instructions (limit: 20000000)"));
    const char *hoard =
        "pcall(function() local s = 'x' while true do s = s .. s end end) return { value = 1 }";
    BOOST_TEST(test::contains(failure(hoard), "uses too much memory (limit: 64 MB)"));
}

BOOST_AUTO_TEST_CASE(a_caught_error_shows_no_place) {
    const auto caught = [](const std::string &call) { return text_of("select(2, pcall(" + call + "))"); };
    BOOST_TEST(caught("function() error('x') end") == "x");
    BOOST_TEST(caught("function() error('test.lua') end") == "test.lua");
    BOOST_TEST(caught("function() local x = nil + 1 end") == "attempt to perform arithmetic on a nil value");
    BOOST_TEST(caught("planula.fill, 5") == "planula.fill takes a table, got number");
    BOOST_TEST(caught("function() error(select(2, pcall(error, 'test.lua:5: test.lua:6: x'))) end") == "x");
    BOOST_TEST(caught("require, 'nowhere'") == "no module 'nowhere'");
    BOOST_TEST(value_of("select(2, pcall(error))").is(Value::Kind::nil));
}

BOOST_AUTO_TEST_CASE(an_error_outside_lua_functions_has_the_line_of_the_call) {
    BOOST_TEST(test::contains(failure("\nreturn math.sqrt('x')"), "test.lua:2: bad argument"));
    BOOST_TEST(test::contains(failure("\nreturn unpack({}, 1, 1e7)"), "test.lua:2: too many results"));
    BOOST_TEST(
        test::contains(failure("local f = function(...) return f(unpack({}, 1, 7000), ...) end return f()"),
                       "test.lua:1: "));
    const auto sources = test::script("\nreturn { f = function(x)\nreturn math.sqrt(x) end }");
    LuaState state(sources, sources->script());
    for (const double good : {1.0, 0.0}) {
        lua_rawgeti(state.raw(), LUA_REGISTRYINDEX, state.result().find("f")->function);
        if (good > 0)
            lua_pushnumber(state.raw(), good);
        else
            lua_pushnil(state.raw());
        const std::string message = state.call(1, {}).value_or("none");
        BOOST_TEST(message.substr(0, 25) == (good > 0 ? "none" : "test.lua:2: bad argument "));
        BOOST_TEST(lua_gettop(state.raw()) == (good > 0 ? 1 : 0));
        lua_settop(state.raw(), 0);
    }
}

BOOST_AUTO_TEST_CASE(memory_is_limited_and_can_be_used_up_to_the_limit) {
    BOOST_TEST(number_of("#('x'):rep(20e6)") == 20e6);
    BOOST_TEST(test::contains(failure("local t = {} for i = 1, 7 do t[i] = (tostring(i)):rep(10e6) end"),
                              "uses too much memory"));
}

BOOST_AUTO_TEST_CASE(pairs_walks_numbers_then_names_in_ascending_order) {
    BOOST_TEST(text_of("(function() local s = '' for k, v in pairs { b = 1, [10] = 2, a = 3, [2] = 4, B = 5, "
                       "[-1] = 6 } do "
                       "s = s .. k .. '=' .. v .. ' ' end return s end)()") == "-1=6 2=4 10=2 B=5 a=3 b=1 ");
    BOOST_TEST(text_of("(function() local s = '' for k in pairs(planula.change({ y = 1 }, { x = 2 })) do "
                       "s = s .. k end return s end)()") == "xy");
}

BOOST_AUTO_TEST_CASE(math_has_the_bits_of_the_core) {
    BOOST_TEST(number_of("math.sin(1.25)") == math::sin(1.25));
    BOOST_TEST(number_of("math.exp(1.25)") == math::exp(1.25));
    BOOST_TEST(number_of("math.pow(1.25, 3.5)") == math::pow(1.25, 3.5));
    BOOST_TEST(number_of("math.atan2(1, -2)") == math::atan2(1, -2));
    BOOST_TEST(number_of("math.tanh(0.3) + math.log(7)") == math::tanh(0.3) + math::log(7));
    BOOST_TEST(number_of("math.max(1, 3, 2) - math.min(4, 2, 3)") == 1);
    BOOST_TEST(number_of("math.floor(-1.5) * 10 + math.ceil(1.2)") == -18);
    BOOST_TEST(test::contains(failure("math.random(3)"), "random numbers are not allowed in scripts"));
}

BOOST_AUTO_TEST_CASE(texts_show_no_address) {
    BOOST_TEST(
        text_of("tostring({}) .. tostring(pairs) .. tostring(nil) .. tostring(true) .. tostring(0.5)") ==
        "tablefunctionniltrue0.5");
    BOOST_TEST(text_of("string.format('%s %d %5.2f', true, 3, 1/3)") == "true 3  0.33");
    BOOST_TEST(text_of("string.format('%%p %d%%', 3)") == "%p 3%");
    for (const char *pattern : {"%p", "\\0%p", "%%%p", "%d\\0%%\\0%-5p"})
        BOOST_TEST(test::contains(failure("string.format('" + std::string(pattern) + "', 'x', 'x')"),
                                  "test.lua:1: string.format: %p shows an address"),
                   pattern);
}

BOOST_AUTO_TEST_CASE(string_find_takes_plain_text) {
    BOOST_TEST(number_of("('a.b.c'):find('.', 3)") == 4);
    BOOST_TEST(value_of("('abc'):find('a.c')").is(Value::Kind::nil));
    BOOST_TEST(text_of("('Abc'):upper() .. ('x'):rep(3) .. ('abc'):sub(2, 2) .. ('ab'):reverse()") ==
               "ABCxxxbba");
}

BOOST_AUTO_TEST_CASE(bytecode_is_refused) {
    BOOST_TEST(test::refusal([] { test::script("\x1bLJ\x02"); }) == "test.lua: is bytecode, not a text");
}

BOOST_AUTO_TEST_CASE(a_module_runs_once_and_must_return_a_table) {
    BOOST_TEST(value_of("require 'paper' == require 'paper.init'").boolean == false);
    BOOST_TEST(value_of("require 'paper' == require 'paper'").boolean);
    BOOST_TEST(value_of("require 'paper.judgement' == require 'paper/judgement'").boolean);
}

BOOST_AUTO_TEST_CASE(modules_that_functions_require_are_loaded_before_any_call) {
    const auto sources = test::script("return { f = function(x) return require 'descriptors'.shape(x) end,\n"
                                      "g = function(name) local m = require(name) return m end }");
    LuaState state(sources, sources->script());
    BOOST_TEST(sources->all().size() == 2u);
    BOOST_TEST(state.requires_in_functions());
    const auto called = [&](const char *name) {
        lua_rawgeti(state.raw(), LUA_REGISTRYINDEX, state.result().find("g")->function);
        lua_pushstring(state.raw(), name);
        return state.call(1, {}).value_or("");
    };
    BOOST_TEST(called("descriptors") == "");
    BOOST_TEST(called("paper") ==
               "test.lua:2: module 'paper' is not loaded; write outside all functions: require 'paper'");
    BOOST_TEST(test::contains(failure("local f = function()\nreturn require 'nowhere' end return {}"),
                              "test.lua:2: no module 'nowhere'"));
    const auto plain = test::script("local paper = require 'paper' return {}");
    BOOST_TEST(!LuaState(plain, plain->script()).requires_in_functions());
}

BOOST_AUTO_TEST_CASE(a_table_has_the_line_of_the_script_that_made_it) {
    const auto sources = test::script("local p = require 'paper'\n"
                                      "local world =\n"
                                      "  p.aquatic { gravity = 0 }\n"
                                      "local all = planula.experiment { environment = world }\n"
                                      "return all\n");
    const LuaState state(sources, sources->script());
    BOOST_TEST(state.result().site.line == 4);
    BOOST_TEST(state.result().find("environment")->site.line == 3);
    BOOST_TEST(state.result().find("environment")->site.source == "test.lua");
}

BOOST_AUTO_TEST_CASE(processor_time_is_limited_and_not_elapsed_time) {
    const Limits limits{.instructions = 1'000'000'000'000, .seconds = 0.3};
    const auto spin = test::script("while true do end");
    const std::string said = test::refusal([&] { LuaState(spin, spin->script(), limits); });
    BOOST_TEST(test::contains(said, "the script takes too long (limit: 0.3 s)"), said);

    std::signal(SIGALRM, stand_still);
    const itimerval soon{.it_interval = {}, .it_value = {.tv_sec = 0, .tv_usec = 5'000}};
    ::setitimer(ITIMER_REAL, &soon, nullptr);
    const auto start = std::chrono::steady_clock::now();
    const auto work = test::script("local n = 0 for i = 1, 4000000 do n = n + i end return { value = n }");
    BOOST_CHECK_NO_THROW(LuaState(work, work->script(), limits));
    BOOST_TEST((std::chrono::steady_clock::now() - start > std::chrono::milliseconds(400)));
}
