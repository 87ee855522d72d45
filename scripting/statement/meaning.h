// SPDX-License-Identifier: MIT
// The meaning of the judging functions of a setting, as a hash of each. The hash covers the words of the function
// without comments, layout and name, and everything that it closes over, by the name of the upvalue: numbers by their
// bits, texts, tables by their content in ascending order of keys, other functions in the same way, and functions of
// the library by their name. It covers the modules that a function requires; if the function computes their names, all
// modules that are loaded. Tables and functions are numbered as they are met, so that a cycle ends and sharing counts.
//
// File names, lines, comments and the rest of the script do not count. The names of local variables do.
//
// A line may have several functions. To tell them apart, the script runs once more with each function on a line of its
// own.
#pragma once

#include "experiment/spec.h"
#include "language/lua_state.h"
#include "language/sources.h"
#include "statement/function_text.h"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

class Meanings {
  public:
    /// Runs the script. Throws what LuaState throws, and InputError if a module is missing in `sources`.
    explicit Meanings(const Sources &sources);

    /// The meaning of the functions of setting `index` (from 0), which must be there: fitness, penalty, behaviour,
    /// start.behaviour if it has a start, and those of its objectives, "objective <name>". Throws InputError with the
    /// place of a function that closes over more than 200000 values or 64 MB of text, or over a value that has no order
    /// or content.
    std::vector<FunctionMeaning> of_setting(std::size_t index);

    /// The same functions as texts.
    std::vector<FunctionText> texts_of_setting(std::size_t index);

    /// Whether the functions of this setting may read a parameter: its name is among their words, or in a text that
    /// they reach. Throws as of_setting() does.
    bool mentions(std::size_t index, std::string_view parameter);
    /// The observations that they may read: those whose names follow a full stop in their words, as in life.work, or
    /// are texts that they reach. Throws as of_setting() does.
    ObservationSet observed(std::size_t index);
    /// The first function that reads this field of a life but not this parameter, as "file.lua:12: fitness"; "" if none
    /// does. Throws as of_setting() does.
    std::string reads_without(std::size_t index, std::string_view field, std::string_view parameter);

  private:
    /// A function that was read.
    struct Known {
        FunctionMeaning meaning;
        std::set<std::string_view> parameters; // that it mentions
        std::set<std::string_view> fields;     // of a life: those that it mentions
        FunctionText text;
    };
    using Visit = std::function<void(const std::string &name, const Known &function)>;
    const Known &of_function(int function, const std::string &name);
    void visit_functions(std::size_t index, const Visit &visit);

    const Sources &sources_;
    std::shared_ptr<Sources> by_line_;
    LuaState lua_;
    std::map<const void *, Known> known_; // functions of lua_
};

} // namespace planula
