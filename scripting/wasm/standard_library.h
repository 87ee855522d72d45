// SPDX-License-Identifier: MIT
// What the C++ library of emscripten 3.1 lacks of C++20 and the core uses; included before every source of the module
// (CMakeLists.txt), and nowhere else.
#pragma once

#include <version>
#if !defined(__cpp_lib_bit_cast) || !defined(__cpp_lib_to_chars)

#include <charconv>

namespace std {

#if !defined(__cpp_lib_bit_cast)
template <class To, class From> constexpr To bit_cast(const From &from) noexcept {
    return __builtin_bit_cast(To, from);
}
#endif

#if !defined(__cpp_lib_to_chars)
/// As in the standard: the shortest text that reads back to the same bits, of equally short ones the nearest.
to_chars_result to_chars(char *first, char *last, double value);
/// Fixed notation with `precision` digits after the point; no other format.
to_chars_result to_chars(char *first, char *last, double value, chars_format format, int precision);
from_chars_result from_chars(const char *first, const char *last, double &value);
#endif

} // namespace std

#endif
