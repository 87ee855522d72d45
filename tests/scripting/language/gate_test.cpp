// SPDX-License-Identifier: MIT
#include "language/gate.h"

#include "language/lua_state.h"
#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

#include <stdexcept>

using namespace planula;

namespace {

int throws(lua_State *) { throw std::runtime_error("thrown in C++"); }
int raises(lua_State *L) { return luaL_error(L, "raised in Lua"); }
int works(lua_State *L) {
    *static_cast<int *>(lua_touserdata(L, 1)) = 7;
    return 0;
}

// Lua that calls what throws: "caught" if its pcall catches the message with the line.
int catches(lua_State *L) {
    luaL_loadstring(L, "local throws = ... ; local ok, why = pcall(throws)\n"
                       "return not ok and why == 'thrown in C++' and 'caught'");
    lua_pushcfunction(L, luaopen_base);
    lua_call(L, 0, 0);
    lua_pushcfunction(L, gate<throws>);
    lua_call(L, 1, 1);
    throw std::runtime_error(lua_tostring(L, -1) ? lua_tostring(L, -1) : "not caught");
}

} // namespace

BOOST_AUTO_TEST_CASE(an_exception_becomes_an_error_of_lua_and_an_error_of_lua_a_message) {
    const auto sources = test::script("return {}");
    LuaState lua(sources, sources->script());
    int result = 0;
    BOOST_TEST(!lua.inspect(gate<works>, &result, {}));
    BOOST_TEST(result == 7);
    BOOST_TEST(lua.inspect(gate<throws>, nullptr, {}).value_or("") == "thrown in C++");
    BOOST_TEST(lua.inspect(gate<raises>, nullptr, {}).value_or("") == "raised in Lua");
    BOOST_TEST(lua.inspect(gate<catches>, nullptr, {}).value_or("") == "caught");
}
