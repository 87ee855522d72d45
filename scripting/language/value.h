// SPDX-License-Identifier: MIT
// What a script returned, as a tree outside Lua, which is read without calls into Lua that could fail.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace planula {

/// Where a table was made: a line of one of the script's sources.
struct Site {
    std::string source; // message name; empty: unknown
    int line = 0;
};

struct Value {
    struct Field; // a name and a value
    enum class Kind { nil, boolean, number, text, function, table };
    Kind kind = Kind::nil;
    bool boolean = false;
    double number = 0;
    std::string text;
    int function = 0;          // a reference of the Lua state that the value came from
    std::vector<Value> list;   // of a table: entries 1 … n
    std::vector<Field> fields; // of a table: named entries, ascending by name
    Site site;                 // of a table that was given to planula.locate()

    bool is(Kind k) const { return kind == k; }
    /// The field of that name, or null.
    const Value *find(std::string_view name) const;
};

struct Value::Field {
    std::string name;
    Value value;
};

inline const Value *Value::find(std::string_view name) const {
    for (const Field &field : fields)
        if (field.name == name) return &field.value;
    return nullptr;
}

/// "a number", "a table" …, for messages.
const char *name_of(Value::Kind kind);

} // namespace planula
