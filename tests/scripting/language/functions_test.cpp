// SPDX-License-Identifier: MIT
#include "language/functions.h"

#include "language/lua_state.h"
#include "support/scripts.h"

#include <set>
#include <string>

#include <boost/test/unit_test.hpp>

using namespace planula;

BOOST_AUTO_TEST_CASE(the_list_names_what_scripts_see_and_nothing_else) {
    std::set<std::string> described;
    for (const SandboxFunction &function : sandbox_functions()) {
        BOOST_TEST(described.insert(std::string(function.name)).second, function.name);
        BOOST_TEST(!function.meaning.empty(), function.name);
    }
    // What the tables of the library hold, and what the globals are, found out by a script.
    const auto sources = test::script(
        "local names = {}\n"
        "for table_name, t in pairs { math = math, planula = planula, string = string, table = table } do\n"
        "  for name in pairs(t) do names[#names + 1] = table_name .. '.' .. name end\n"
        "end\n"
        "return { names = names }\n");
    const LuaState lua(sources, sources->script());
    for (const Value &name : lua.result().find("names")->list)
        BOOST_TEST(described.erase(name.text) == 1u, name.text);
    for (const std::string &name : described) {
        const auto other = test::script("return { kind = type(" + name + ") }");
        BOOST_TEST(test::refusal([&] { LuaState(other, other->script()); }) == "", name);
        BOOST_TEST(name.find('.') == name.npos, name);
    }
}
