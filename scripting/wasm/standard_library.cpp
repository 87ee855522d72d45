// SPDX-License-Identifier: MIT
#include "standard_library.h"

#if !defined(__cpp_lib_to_chars)

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <emscripten.h>

// ECMAScript's toExponential() without digits is the shortest decimal that reads back, of these the nearest.
EM_JS(void, shortest_exponential, (double value, char *buffer, int size),
      { stringToUTF8(value.toExponential(), buffer, size); });

namespace {

std::to_chars_result copy_to(const std::string &text, char *first, char *last) {
    if (static_cast<std::size_t>(last - first) < text.size()) return {last, std::errc::value_too_large};
    return {std::copy(text.begin(), text.end(), first), std::errc()};
}

std::string in_fixed(double value, int decimals) {
    std::string text(static_cast<std::size_t>(std::snprintf(nullptr, 0, "%.*f", decimals, value)), ' ');
    std::snprintf(text.data(), text.size() + 1, "%.*f", decimals, value);
    return text;
}

/// "1.25e-7" as the standard writes it, with two digits of the exponent or more, or in fixed notation where that is no
/// longer.
std::string shortest(double value) {
    if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
    if (value == 0) return std::signbit(value) ? "-0" : "0";
    char buffer[40];
    shortest_exponential(value, buffer, sizeof buffer);
    const std::string text = buffer;
    const std::size_t at = text.find('e');
    const std::string mantissa = text.substr(0, at);
    const int exponent = std::atoi(text.c_str() + at + 1);
    const int digits = static_cast<int>(
        std::count_if(mantissa.begin(), mantissa.end(), [](char c) { return '0' <= c && c <= '9'; }));
    const int size = std::abs(exponent);
    const std::string scientific =
        mantissa + (exponent < 0 ? "e-" : "e+") + (size < 10 ? "0" : "") + std::to_string(size);
    const std::string plain = in_fixed(value, std::max(0, digits - 1 - exponent));
    return plain.size() <= scientific.size() ? plain : scientific;
}

} // namespace

namespace std {

to_chars_result to_chars(char *first, char *last, double value) {
    return copy_to(shortest(value), first, last);
}

to_chars_result to_chars(char *first, char *last, double value, chars_format, int precision) {
    return copy_to(in_fixed(value, precision), first, last);
}

from_chars_result from_chars(const char *first, const char *last, double &value) {
    // strtod() also takes blanks, a plus and hexadecimal numbers.
    const string text(first, last);
    if (text.find_first_of(" \t\n\v\f\r+") == 0 || text.find_first_of("xX") != string::npos)
        return {first, errc::invalid_argument};
    char *end = nullptr;
    const double read = strtod(text.c_str(), &end);
    if (end == text.c_str()) return {first, errc::invalid_argument};
    const char *stop = first + (end - text.c_str());
    if (isinf(read) && text.find_first_of("iI") == string::npos) return {stop, errc::result_out_of_range};
    value = read;
    return {stop, errc()};
}

} // namespace std

#endif
