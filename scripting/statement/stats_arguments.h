// SPDX-License-Identifier: MIT
// How the functions of `stats` (statement/wrap_stats.h) read their arguments and return their results. What they read
// stays in the context, because a Lua error may leave them.
#pragma once

#include "statement/wrap_stats.h"
#include "statistics/share_ahead.h"

#include <cstdint>
#include <initializer_list>

namespace planula {

using Numbers = std::vector<double>;

/// Reads a list of numbers, or a series of a run. Throws InputError with the place of a value that is none.
void read_numbers(lua_State *L, int index, const std::string &name, Numbers &numbers);
/// Reads the first two arguments into the samples a and b.
void read_samples(lua_State *L, StatsContext &context);
/// Reads a list of curves.
void read_curves(lua_State *L, int index, const std::string &name, std::vector<Numbers> &curves);
/// 0, 1, …: the places of `count` things.
Numbers places_of(std::size_t count);
/// The curves at these places.
std::vector<Curve> curves_at(const std::vector<Numbers> &curves, std::span<const double> places);

double number_at(lua_State *L, int index, const std::string &name);
/// A whole number that an int holds.
int whole(double value, const std::string &name);

/// The options of a call, a table that may be absent. Any key that is not allowed is an InputError.
class Options {
  public:
    Options(lua_State *L, int index, std::span<const std::string_view> allowed);
    double number(const char *name, double absent);
    bool boolean(const char *name, bool absent);
    std::string text(const char *name, const std::string &absent);
    /// One of some words, the first if absent: its place among them.
    std::size_t choice(const char *name, std::span<const std::string_view> words);

  private:
    bool push(const char *name, int type);

    lua_State *L_;
    int index_;
};

/// A number of resamples or draws, as many as the context allows.
int resamples_of(Options &options, const char *name, const StatsContext &context);
/// The seed that the name of the stream and the option `name` give.
std::uint64_t seed_of(Options &options, const StatsContext &context);

/// Counts work that the core does as instructions of the script.
void spend(lua_State *L, double work);

inline double size(const Numbers &numbers) { return static_cast<double>(numbers.size()); }

struct Entry {
    const char *name;
    double value;
};
/// Pushes a read-only table of numbers, with `method` if it is not null. Each returns 1.
int push_result(lua_State *L, const char *what, std::initializer_list<Entry> entries,
                const char *method = nullptr);
int push_list(lua_State *L, const Numbers &numbers);
int push_number(lua_State *L, double value);

/// The function of `stats` at that place of the stack; null for any other function.
const StatisticFunction *function_of_stats(lua_State *L, int index);

/// stats.bootstrap.
int call_bootstrap(lua_State *L, StatsContext &context);

} // namespace planula
