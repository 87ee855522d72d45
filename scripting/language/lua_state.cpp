// SPDX-License-Identifier: MIT
#include "language/lua_state.h"

#include "base/check.h"
#include "base/error.h"
#include "language/convert.h"
#include "language/gate.h"
#include "language/wrap.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>

#include <luajit.h>

namespace planula {

namespace {

constexpr int instructions_between_checks = 100;
constexpr int deepest_calls = 150; // from C

// Processor time of this thread, in seconds: it stops while the process is stopped or others use the processor.
double worked_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    constexpr double nanosecond = 1e-9;
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * nanosecond;
}

std::chrono::steady_clock::time_point from_now(double seconds) {
    return std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                                  std::chrono::duration<double>(seconds));
}

// "name:line: " of the innermost running Lua function that is not the prelude's, if there is one.
std::string position(lua_State *L) {
    lua_Debug frame;
    std::string inner;
    for (int level = 0; lua_getstack(L, level, &frame); ++level) {
        if (!lua_getinfo(L, "Sl", &frame) || frame.currentline <= 0) continue;
        const std::string place = std::string(frame.short_src) + ":" + to_text(frame.currentline) + ": ";
        if (frame.source != std::string_view("@planula.lua")) return place;
        if (inner.empty()) inner = place;
    }
    return inner;
}

// A message of a script, cut where it is too long for people: the script may have put texts of megabytes into it.
std::string_view shortened(lua_State *L, int index) {
    constexpr std::size_t longest = 2000;
    std::size_t size = 0;
    const char *said = lua_tolstring(L, index, &size);
    if (!said) return "an error that is not a text";
    std::string_view message(said, std::min(size, longest));
    return message.substr(0, message.find('\0'));
}

// The handler of errors: makes each a text that begins with its place.
int explain(lua_State *L) {
    bool placed = false;
    {
        const std::string message(shortened(L, 1));
        placed = host_of(L).place_in(message) > 0;
        if (!placed) lua_pushstring(L, (position(L) + message).c_str());
    }
    if (placed) lua_settop(L, 1);
    return 1;
}

void *allocate(void *account, void *block, std::size_t old_size, std::size_t size) {
    Host &host = *static_cast<Host *>(account);
    if (size == 0) {
        std::free(block);
        host.held -= old_size;
        return nullptr;
    }
    // Only growth is refused: Lua relies on shrinking.
    if (size > old_size) {
        host.allocated += size - old_size;
        if (host.held - old_size + size > host.limits.memory) return host.exhaust(Exhausted::memory), nullptr;
        if (host.allocated > host.limits.allocated) return host.exhaust(Exhausted::allocated), nullptr;
    }
    void *moved = std::realloc(block, size);
    if (moved) host.held += size - old_size;
    return moved;
}

void count(lua_State *L, lua_Debug *) { host_of(L).spend(L, instructions_between_checks); }

} // namespace

void Host::begin_call(const Limits &allowed) {
    limits = allowed;
    allocated = 0;
    instructions = 0;
    depth = 0;
    exhausted = Exhausted::no;
    where.clear();
    began = worked_seconds();
    deadline = from_now(limits.seconds);
}

void Host::exhaust(Exhausted what) {
    if (exhausted != Exhausted::no) return;
    exhausted = what;
    if (state) where = position(state);
}

void Host::check_seconds() {
    const double left = limits.seconds - (worked_seconds() - began);
    if (left > 0)
        deadline = from_now(left);
    else
        exhaust(Exhausted::seconds);
}

void Host::go_deeper(lua_State *L) {
    if (depth >= deepest_calls)
        luaL_error(L, "calls through pcall and table.sort are nested more than 150 deep");
    ++depth;
}

void Host::spend(lua_State *L, std::int64_t work) {
    instructions += work;
    if (instructions > limits.instructions)
        exhaust(Exhausted::instructions);
    else if (!sources->spend(work))
        exhaust(Exhausted::check);
    else if (work >= instructions_between_checks && std::chrono::steady_clock::now() > deadline)
        check_seconds();
    if (exhausted != Exhausted::no) luaL_error(L, "the script exceeds its limits");
}

std::size_t Host::place_in(std::string_view said) const {
    const auto of = [&](std::string_view name) -> std::size_t {
        if (!said.starts_with(name) || said.substr(name.size(), 1) != ":") return 0;
        const std::size_t end = said.find_first_not_of("0123456789", name.size() + 1);
        const bool is_place = end != said.npos && end > name.size() + 1 && said.substr(end, 2) == ": ";
        return is_place ? end + 2 : 0;
    };
    for (const Source *source : loaded)
        if (const std::size_t length = of(source->name)) return length;
    return of("planula.lua");
}

std::string Host::message() const {
    switch (exhausted) {
    case Exhausted::instructions:
        return where + "the script executes too many instructions (limit: " + to_text(limits.instructions) +
               ")";
    case Exhausted::check:
        return where + "the script executes too many instructions in all until it is checked (limit: " +
               to_text(instructions_of_a_check) + ")";
    case Exhausted::allocated:
        return where + "the script allocates too much memory in one call (limit: " +
               to_text(static_cast<std::int64_t>(limits.allocated >> 20)) + " MB)";
    case Exhausted::memory:
        return where + "the script uses too much memory (limit: " +
               to_text(static_cast<std::int64_t>(limits.memory >> 20)) + " MB)";
    case Exhausted::seconds:
        return where + "the script takes too long (limit: " + to_text(limits.seconds) + " s)";
    case Exhausted::no:
        break;
    }
    return "";
}

Host &host_of(lua_State *L) {
    void *account = nullptr;
    lua_getallocf(L, &account);
    return *static_cast<Host *>(account);
}

LuaState::LuaState(std::shared_ptr<Sources> sources, const Source &main, const Limits &limits)
    : sources_(std::move(sources)) {
    host_.sources = sources_.get();
    host_.main = &main;
    host_.begin_call(limits);
    state_.reset(lua_newstate(allocate, &host_));
    if (!state_) throw InternalError("no memory for a Lua state");
    lua_State *L = host_.state = state_.get();
    luaJIT_setmode(L, 0, LUAJIT_MODE_ENGINE | LUAJIT_MODE_OFF);
    lua_sethook(L, count, LUA_MASKCOUNT, instructions_between_checks);
    if (lua_cpcall(L, gate<start>, this) == 0) return;
    throw InputError(take_message(main.name + ":" + to_text(line_of_return(main.tokens)) + ": "));
}

// All that may raise an error, from the first library to the conversion of the result, in protected mode.
int LuaState::start(lua_State *L) {
    LuaState &self = *static_cast<LuaState *>(lua_touserdata(L, 1));

    // The globals are the base functions and the tables, read-only.
    wrap_base(L);
    const std::pair<const char *, void (*)(lua_State *)> tables[] = {
        {"math", wrap_math}, {"string", wrap_string}, {"table", wrap_table}};
    for (const auto &[name, wrap] : tables) {
        wrap(L);
        freeze(L, name);
        lua_setfield(L, -2, name);
    }
    wrap_planula(L);
    lua_pushvalue(L, -1);
    lua_setfield(L, -3, "planula");
    lua_insert(L, -2);
    freeze(L, "a global");
    lua_setfield(L, LUA_REGISTRYINDEX, "globals");

    // The prelude adds to planula, which is read-only from then on.
    load_source(L, prelude(), "planula.lua");
    lua_call(L, 0, 0);
    freeze(L, "planula");
    lua_getfield(L, LUA_REGISTRYINDEX, "globals");
    lua_getmetatable(L, -1);
    lua_getfield(L, -1, "__index");
    lua_pushvalue(L, -4);
    lua_setfield(L, -2, "planula");

    name_library(L);

    const Source &main = *self.host_.main;
    self.host_.loaded.push_back(&main);
    lua_pushcfunction(L, gate<explain>);
    lua_pushvalue(L, -1);
    self.explain_ = luaL_ref(L, LUA_REGISTRYINDEX);
    load_source(L, main.text, main.name);
    if (lua_pcall(L, 0, 1, -2) != 0) return lua_error(L);
    load_inner_modules(L);
    self.result_ = convert(L, main.name + ":" + to_text(line_of_return(main.tokens)));
    return 0;
}

std::optional<std::string> LuaState::call(int arguments, const Limits &limits) {
    lua_State *L = raw();
    host_.begin_call(limits);
    // The function stays below its call, for its line in a message.
    const int function = lua_gettop(L) - arguments;
    lua_pushvalue(L, function);
    lua_rawgeti(L, LUA_REGISTRYINDEX, explain_);
    lua_insert(L, function);
    lua_insert(L, function);
    const int status = lua_pcall(L, arguments, 1, function + 1);
    lua_remove(L, function + 1);
    lua_insert(L, function);
    if (status == 0) return lua_pop(L, 1), std::nullopt;
    lua_Debug stated;
    lua_getinfo(L, ">S", &stated);
    return take_message(std::string(stated.short_src) + ":" + to_text(stated.linedefined) + ": ");
}

std::optional<std::string> LuaState::inspect(lua_CFunction code, void *argument, const Limits &limits) {
    host_.begin_call(limits);
    if (lua_cpcall(raw(), code, argument) == 0) return std::nullopt;
    return take_message("");
}

bool LuaState::requires_in_functions() const {
    for (const Source *source : host_.loaded)
        for (const Requirement &requirement : source->requirements)
            if (requirement.in_function || requirement.module.empty()) return true;
    return false;
}

// The message of the error on the stack, which it removes; `place` goes in front of one that has none.
std::string LuaState::take_message(const std::string &place) {
    const std::string message =
        host_.exhausted != Exhausted::no ? host_.message() : std::string(shortened(raw(), -1));
    lua_pop(raw(), 1);
    return host_.place_in(message) > 0 ? message : place + message;
}

} // namespace planula
