// SPDX-License-Identifier: MIT
// A function of a script as its source states it, for people; statement/meaning.h says what it means.
#pragma once

#include "language/lua_state.h"
#include "language/tokens.h"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace planula {

struct FunctionText {
    std::string name, place;        // as of its meaning
    std::vector<std::string> lines; // from "function(" to "end", without its name and common indentation
    std::vector<std::pair<std::string, std::string>> upvalues; // what it closes over, by name, ascending
};

/// The lines of the function at that place of a source: from "function(" to "end", all but the first moved left by the
/// blanks that they have in common.
std::vector<std::string> lines_of_function(std::span<const Token> tokens, std::size_t place);

/// The value at the top of the stack: a number or text as a script writes it, of a long text its beginning and length, of
/// a table only that it is one, of a function its `place`.
std::string shown_value(lua_State *L, const std::string &place);

} // namespace planula
