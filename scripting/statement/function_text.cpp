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

namespace {

/// The beginning of a text, in quotes; of one with several lines or more than 60 bytes with its length.
std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 60;
    std::size_t end = std::min(text.find_first_of("\r\n"), longest);
    if (text.size() <= end) return '"' + std::string(text) + '"';
    while (end > 0 && (text[end] & 0xC0) == 0x80) --end; // a whole character in UTF-8
    return '"' + std::string(text.substr(0, end)) + "…\", a text of " +
           to_text(static_cast<std::int64_t>(text.size())) + " bytes";
}

} // namespace

std::string shown_value(lua_State *L, const std::string &place) {
    const int type = lua_type(L, -1);
    if (type == LUA_TNUMBER) return to_text(lua_tonumber(L, -1));
    if (type == LUA_TBOOLEAN) return lua_toboolean(L, -1) ? "true" : "false";
    if (type == LUA_TSTRING) {
        std::size_t size = 0;
        const char *text = lua_tolstring(L, -1, &size);
        return quoted({text, size});
    }
    if (type != LUA_TFUNCTION) return std::string("a ") + lua_typename(L, type);
    return lua_iscfunction(L, -1) ? "a function of the library" : "the function of " + place;
}

} // namespace planula
