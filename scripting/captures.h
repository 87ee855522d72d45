// SPDX-License-Identifier: MIT
// What the functions of a Lua state close over, watched: a function that judges must leave it as it is. All values
// that the functions reach are listed once; whether one of them has changed is then a walk along that list, which
// calls no function of the script and takes no memory.
#pragma once

#include "scripting/lua_state.h"

#include <cstdint>
#include <span>

namespace planula {

class Captures {
  public:
    /// Lists what these functions (references of the state) reach, with all modules if they may require them.
    /// Throws InputError if the list takes more memory than there is. The state must outlive this.
    Captures(LuaState &lua, std::span<const int> functions);

    /// True if an upvalue or an entry of a table is not what it was when this was made. A table that was replaced by an
    /// equal one has changed, too.
    bool changed();
    /// How many values changed() looks at.
    int values() const { return values_; }

  private:
    static int list(lua_State *L);
    void list_parts(lua_State *L);
    void add(lua_State *L);
    std::uint64_t digest();

    LuaState &lua_;
    std::span<const int> functions_; // during the constructor
    int objects_ = 0; // a reference to the list of tables and functions, which holds all texts, too
    int count_ = 0;   // of tables and functions
    int values_ = 0;
    std::uint64_t digest_ = 0;
};

} // namespace planula
