// SPDX-License-Identifier: MIT
// math: the core's elementary functions, with the same bits everywhere, and the exact ones of IEEE 754.
#include "base/math.h"
#include "language/wrap.h"

#include <cmath>
#include <limits>

namespace planula {

namespace {

// Zeros have no sign, neither those that come in nor those that go out.
double argument(lua_State *L, int index) { return unsigned_zero(luaL_checknumber(L, index)); }

template <double (*function)(double)> int unary(lua_State *L) {
    lua_pushnumber(L, unsigned_zero(function(argument(L, 1))));
    return 1;
}

template <double (*function)(double, double)> int binary(lua_State *L) {
    lua_pushnumber(L, unsigned_zero(function(argument(L, 1), argument(L, 2))));
    return 1;
}

double absolute(double x) { return std::abs(x); }
double ceiling(double x) { return std::ceil(x); }
double floor(double x) { return std::floor(x); }
double square_root(double x) { return std::sqrt(x); }
double degrees(double x) { return x * (180 / math::pi); }
double radians(double x) { return x * (math::pi / 180); }
double tangent(double x) { return math::sin(x) / math::cos(x); }
double remainder(double x, double y) { return std::fmod(x, y); }

// The extreme of all arguments; NaN if one of them is.
template <bool largest> int extreme(lua_State *L) {
    double result = argument(L, 1);
    for (int i = 2; i <= lua_gettop(L); ++i) {
        const double x = argument(L, i);
        if (std::isnan(x) || (largest ? x > result : x < result)) result = x;
    }
    lua_pushnumber(L, result);
    return 1;
}

int no_random(lua_State *L) {
    return luaL_error(
        L, "random numbers are not allowed in scripts: the same life must always have the same result");
}

} // namespace

void wrap_math(lua_State *L) {
    const luaL_Reg functions[] = {{"abs", gate<unary<absolute>>},
                                  {"atan", gate<unary<math::atan>>},
                                  {"atan2", gate<binary<math::atan2>>},
                                  {"ceil", gate<unary<ceiling>>},
                                  {"cos", gate<unary<math::cos>>},
                                  {"deg", gate<unary<degrees>>},
                                  {"exp", gate<unary<math::exp>>},
                                  {"floor", gate<unary<floor>>},
                                  {"fmod", gate<binary<remainder>>},
                                  {"log", gate<unary<math::log>>},
                                  {"max", gate<extreme<true>>},
                                  {"min", gate<extreme<false>>},
                                  {"pow", gate<binary<math::pow>>},
                                  {"rad", gate<unary<radians>>},
                                  {"random", gate<no_random>},
                                  {"randomseed", gate<no_random>},
                                  {"sin", gate<unary<math::sin>>},
                                  {"sqrt", gate<unary<square_root>>},
                                  {"tan", gate<unary<tangent>>},
                                  {"tanh", gate<unary<math::tanh>>},
                                  {nullptr, nullptr}};
    lua_newtable(L);
    luaL_register(L, nullptr, functions);
    lua_pushnumber(L, math::pi);
    lua_setfield(L, -2, "pi");
    lua_pushnumber(L, std::numeric_limits<double>::infinity());
    lua_setfield(L, -2, "huge");
}

} // namespace planula
