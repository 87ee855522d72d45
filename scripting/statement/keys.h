// SPDX-License-Identifier: MIT
// The keys that an experiment file may state, described: rows of keys.inl. What readers allow, what messages say about a
// key in the wrong place, and REFERENCE.md come from here.
#pragma once

#include "language/value.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

/// One line of keys.inl, which explains the columns.
struct Key {
    std::string_view name, kind, unit, standard, origin, meaning, example;

    bool needed() const { return standard == "needed"; }
};

struct KeyTable {
    std::string_view path; // "experiment", "setting", or where it stands in them: "environment.drag"
    std::string_view meaning;
    std::span<const Key> keys;
};

/// All tables in the order of keys.inl.
std::span<const KeyTable> key_tables();

/// The keys that one table of a script may have.
struct Keys {
    std::string_view path = ""; // of their KeyTable; "single" of an experiment with one setting
    std::vector<const Key *> rows{};

    const Key *find(std::string_view name) const;
    std::vector<std::string_view> names() const;
};

/// The keys of the table at a path of key_tables(); of "single", those of an experiment and of its setting.
Keys keys_of(std::string_view path);

/// What to write instead of `name` = `stated`, which the table of these keys does not have, if that is a key of another
/// table or a parameter: "write: environment = { drag = … }"; else "". Of the path "parameters", whose names are those
/// of all parameters, the same.
std::string where_it_belongs(std::string_view name, const Value &stated, const Keys &here);

} // namespace planula
