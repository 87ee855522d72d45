// SPDX-License-Identifier: MIT
#include "statement/function_text.h"

#include "base/text.h"

#include <algorithm>

namespace planula {

std::vector<std::string> lines_of_function(std::span<const Token> tokens, std::size_t place) {
    std::vector<std::string> lines{"function"};
    for (const char letter : text_of_function(tokens, place)) {
        if (letter == '\n')
            lines.emplace_back();
        else if (letter != '\r')
            lines.back() += letter;
    }
    std::size_t common = std::string::npos;
    for (std::size_t i = 1; i < lines.size(); ++i)
        if (const std::size_t first = lines[i].find_first_not_of(" \t"); first != std::string::npos)
            common = std::min(common, first);
    for (std::size_t i = 1; i < lines.size(); ++i) lines[i].erase(0, std::min(common, lines[i].size()));
    return lines;
}

std::string shown_value(lua_State *L, const std::string &place) {
    const int type = lua_type(L, -1);
    if (type == LUA_TNUMBER) return to_text(lua_tonumber(L, -1));
    if (type == LUA_TBOOLEAN) return lua_toboolean(L, -1) ? "true" : "false";
    if (type == LUA_TSTRING) return '"' + std::string(lua_tostring(L, -1)) + '"';
    if (type != LUA_TFUNCTION) return std::string("a ") + lua_typename(L, type);
    return lua_iscfunction(L, -1) ? "a function of the library" : "the function of " + place;
}

} // namespace planula
