// SPDX-License-Identifier: MIT
// CHECK(condition, values…): a condition that the program itself guarantees. If it does not hold, throws InternalError
// with the place, the condition and the values; it is never compiled out.
#pragma once

#include "base/error.h"

#include <sstream>
#include <string>

namespace planula {

template <class... Values>
[[noreturn]] void check_failed(const char *file, int line, const char *condition, const Values &...values) {
    std::ostringstream text;
    text << file << ':' << line << ": check failed: " << condition;
    ((text << ' ' << values), ...);
    throw InternalError(text.str());
}

} // namespace planula

#define CHECK(condition, ...)                                                                                \
    ((condition) ? void()                                                                                    \
                 : ::planula::check_failed(__FILE__, __LINE__, #condition __VA_OPT__(, ) __VA_ARGS__))
