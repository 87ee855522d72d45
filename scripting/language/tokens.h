// SPDX-License-Identifier: MIT
// The words of a Lua source, each with its line: enough to refuse what depends on the machine before a script runs, and
// to find the line that states a key of a table constructor, the text of a function, and the modules that it requires.
// LuaJIT alone parses Lua.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

struct Token {
    enum class Kind { name, number, text, symbol };
    Kind kind = Kind::symbol;
    std::string_view word; // as written; of a short string the part between the quotes
    int line = 0;          // from 1
};

/// The tokens of a source without comments. Words point into `source`. Never fails: an unclosed string ends
/// with the source, and LuaJIT reports it.
std::vector<Token> scan(std::string_view source);

/// Throws InputError "name:line: …" at the first word whose meaning depends on the machine: `^`, whose
/// result comes from the C library, and 64-bit or imaginary number literals, which belong to the FFI.
void refuse_machine_dependent(std::span<const Token> tokens, std::string_view name);

/// A `require` in a source.
struct Requirement {
    std::string module; // as written; empty: computed, or `require` is used as a value
    int line = 0;
    bool in_function = false; // and not at the top level of the source
};
std::vector<Requirement> requirements_of(std::span<const Token> tokens);

/// The source with a line feed before each word `function`, so that no two functions begin on one line.
std::string functions_on_lines(std::string_view source, std::span<const Token> tokens);

/// The place of the last word `function` on or before `line`; the number of tokens without such a word.
std::size_t function_before(std::span<const Token> tokens, int line);
/// What the function at that place computes: its parameters and its body, without its name. A separator before
/// a closing brace is left out.
std::vector<Token> body_of_function(std::span<const Token> tokens, std::size_t place);
/// The source of the function at that place as it is written, from the parenthesis before its parameters to its last
/// word.
std::string_view text_of_function(std::span<const Token> tokens, std::size_t place);

/// One step into a table constructor: by name, or, if the name is empty, by position from 1.
struct Step {
    std::string key;
    int index = 0;
};

/// The line of the entry that `path` leads to in the first table constructor opened on or after `line`; of
/// the deepest entry that is found, or `line` itself, where the path does not lead to the end.
int line_of_entry(std::span<const Token> tokens, int line, std::span<const Step> path);

/// The line of the last `return` outside all blocks; 1 without such a line.
int line_of_return(std::span<const Token> tokens);

} // namespace planula
