// SPDX-License-Identifier: MIT
// A sandbox for scripts: one LuaJIT state with an allow-list of functions, limits on memory, instructions and time that
// pcall cannot catch. It runs one script with its modules and keeps what the script returned.
//
// The just-in-time compiler is off: compiled code is not counted, and rounds differently on some machines. Scripts see
// math (the core's functions), string without patterns, table, ipairs, pairs in ascending order of keys, tostring,
// tonumber, type, select, unpack, error, assert, pcall, require and planula; nothing that reads a clock, a file, an
// address or a random number. Library tables and globals are read-only.
//
// Modules are loaded while the script runs; those that a function requires by name are loaded right after it. From then
// on
// `require` only returns loaded modules, so that calling a function cannot load anything.
#pragma once

#include "language/sources.h"
#include "language/value.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <lua.hpp>

namespace planula {

/// How much a script may use. A call that exceeds `instructions` or `allocated` does so on every machine; `seconds`
/// only catches what these two do not count.
struct Limits {
    std::size_t memory = 64u << 20;         // bytes held at once
    std::size_t allocated = 512u << 20;     // bytes asked for during one call
    std::int64_t instructions = 20'000'000; // during one call
    double seconds = 3;                     // of a processor, during one call
};

/// Which limit a call exceeded; `check`: that of Sources::spend().
enum class Exhausted { no, instructions, check, allocated, memory, seconds };

/// What one Lua state has used and may use; every function of the sandbox reaches it through its lua_State.
struct Host {
    Sources *sources = nullptr;
    const Source *main = nullptr; // the source whose lines planula.locate() looks for
    Limits limits;
    lua_State *state = nullptr;
    std::size_t held = 0, allocated = 0;
    std::int64_t instructions = 0;
    double began = 0;                               // processor time of this thread when the call began
    std::chrono::steady_clock::time_point deadline; // the call cannot have used its seconds before
    Exhausted exhausted = Exhausted::no;
    std::string where; // "name:line: " at which the limit was exceeded
    int depth =
        0; // of calls from the script through C back into the script, which use the stack of the process
    std::vector<const Source *> loaded; // by this state: the script, then its modules
    bool closed = false;                // no further module may be loaded
    std::string thrown;                 // the message of an exception that is passed to Lua (language/gate.h)

    /// Starts counting for a call.
    void begin_call(const Limits &allowed);
    /// Counts `work` instructions; if that is too much, notes where and raises a Lua error.
    void spend(lua_State *L, std::int64_t work);
    void exhaust(Exhausted what);
    /// After the deadline: ends the call, or moves the deadline if the processor did other work in the meantime.
    void check_seconds();
    /// Counts a function of C that calls back into the script, one level deeper. Raises a Lua error if there are too
    /// many levels; code that catches an error restores the depth.
    void go_deeper(lua_State *L);
    std::string message() const;
    /// The length of the "name:line: " that a message begins with; 0 if it names no source of this state.
    std::size_t place_in(std::string_view said) const;
};

Host &host_of(lua_State *L);

class LuaState {
  public:
    /// Runs `main`. Throws InputError with name:line if it cannot be compiled, raises an error, exceeds a
    /// limit, or returns something other than a table of texts, numbers, booleans, functions and tables.
    LuaState(std::shared_ptr<Sources> sources, const Source &main, const Limits &limits = {});

    const Value &result() const { return result_; }
    const Source &main() const { return *host_.main; }
    Sources &sources() { return *sources_; }
    lua_State *raw() { return state_.get(); }

    /// Calls the function below `arguments` values on the stack, which it replaces by one result. Returns the
    /// message if that raises an error, and then leaves nothing. Limits apply.
    std::optional<std::string> call(int arguments, const Limits &limits);
    /// Runs C code that calls no function of the script, with `argument` as its light userdata. Returns the
    /// message if it raises an error. The limits on memory apply.
    std::optional<std::string> inspect(lua_CFunction code, void *argument, const Limits &limits);
    /// Whether the functions of the script may reach modules by `require`, and not only by what they close over.
    bool requires_in_functions() const;
    /// Whether the last call exceeded a limit, and which.
    Exhausted exhausted() const { return host_.exhausted; }

  private:
    struct Close {
        void operator()(lua_State *L) const { lua_close(L); }
    };
    static int start(lua_State *L);
    std::string take_message(const std::string &place);

    std::shared_ptr<Sources> sources_;
    Host host_; // outlives state_, whose memory it counts
    std::unique_ptr<lua_State, Close> state_;
    int explain_ = 0; // a reference to the handler of errors
    Value result_;
};

/// The Lua text loaded before every script.
std::string_view prelude();

} // namespace planula
