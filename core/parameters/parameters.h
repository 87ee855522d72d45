// SPDX-License-Identifier: MIT
// The numbers of the model as one constant value, and the ledger that describes each of them. parameters.inl
// is the only place of a number; this room does not know what the numbers are used for. Each section of the ledger is a
// struct, so that a model or a law holds the numbers that it reads and no others. Water, land and judgement are read by
// experiments alone (by name, in Lua); the core is given environments and evaluations.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

#define SECTION(...)
#define SECTION_END(...)
#define PARAMETER(...)
#define CHOICE(type, name, value, origin, meaning, ...) enum class type { __VA_ARGS__ };
#include "parameters/parameters.inl"

// struct DevelopmentParameters, struct NetworkParameters …: a section each.
#define SECTION(Type, member, title) struct Type {
#define SECTION_END(member)                                                                                  \
    }                                                                                                        \
    ;
#define PARAMETER(type, name, value, lowest, highest, unit, origin, meaning) type name = value;
#define CHOICE(type, name, value, origin, meaning, ...) type name = type::value;
#include "parameters/parameters.inl"

/// All of them: development, network, body …
struct Parameters {
#define SECTION(Type, member, title) Type member;
#define SECTION_END(member)
#define PARAMETER(...)
#define CHOICE(...)
#include "parameters/parameters.inl"
};

/// One row of the ledger: what a parameter is called, where its value comes from, and what it may be.
struct ParameterRow {
    std::string_view section, name, unit, origin, meaning;
    bool whole; // an integer
    double standard, lowest, highest;
    std::vector<std::string_view> names = {}; // of a choice, whose value is an index into them; else none

    bool is_choice() const { return !names.empty(); }
};

/// All rows in the order of parameters.inl.
std::span<const ParameterRow> parameter_rows();

/// The row of a parameter. Throws InputError, with the nearest name, if no parameter has that name.
const ParameterRow &parameter_row(std::string_view name);

/// The value of a parameter by name. Throws InputError, with the nearest name, if no parameter has that name.
double parameter(const Parameters &parameters, std::string_view name);

/// A value as people write it: the name of a choice, or the shortest number that reads back equal.
std::string value_text(const ParameterRow &row, double value);

/// The value that a word states, as value_text() writes it. Throws InputError that states the rule if it states none.
double value_of(const ParameterRow &row, std::string_view word);

/// Changes one parameter. Throws InputError that states the rule, the value and the nearest name if the name
/// is unknown, the value is outside its range or not finite, or a whole number is asked for and not given.
void set_parameter(Parameters &parameters, std::string_view name, double value);

/// Rules between parameters (a shortest period above the longest, say). Throws InputError naming the first
/// broken.
void check_consistency(const Parameters &parameters);

} // namespace planula
