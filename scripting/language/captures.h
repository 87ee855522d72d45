// SPDX-License-Identifier: MIT
// Checks that functions of a Lua state do not change what they close over. All values that the functions reach are
// listed once; to check them is then a walk along that list, which calls no function of the script and takes no memory.
#pragma once

#include "language/lua_state.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace planula {

class Captures {
  public:
    /// Lists what these functions (references of the state) reach, with all modules if they may require them.
    /// Throws InputError if the list takes more memory than is allowed. The state must outlive this.
    Captures(LuaState &lua, std::span<const int> functions);

    /// The index in `functions` of the first one that reaches a changed value; their number if only modules do; nothing
    /// if every upvalue and every entry of a table is as it was at first. A table that was replaced by an equal one
    /// counts as changed.
    std::optional<std::size_t> changed();
    /// How many values changed() looks at.
    int values() const { return values_; }

  private:
    // A table or function of a script.
    struct Object {
        std::size_t root; // which function reaches it first
        std::uint64_t digest;
    };

    static int list(lua_State *L);
    void list_parts(lua_State *L, std::size_t root);
    void add(lua_State *L, std::size_t root);

    LuaState &lua_;
    std::span<const int> functions_; // during the constructor
    int list_ = 0; // a reference to the list of the objects themselves, which holds all texts, too
    std::vector<Object> objects_;
    int values_ = 0;
};

} // namespace planula
