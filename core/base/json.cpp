// SPDX-License-Identifier: MIT
#include "base/json.h"

#include "base/text.h"

#include <cmath>

namespace planula {

std::string json_text(std::string_view text) {
    std::string result = "\"";
    for (const char letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\')
            result.append("\\").append(1, letter);
        else if (code < 0x20) {
            constexpr const char *digits = "0123456789abcdef";
            result.append("\\u00").append(1, digits[code >> 4]).append(1, digits[code & 15]);
        } else
            result.append(1, letter);
    }
    return result + '"';
}

std::string json_number(double value) { return std::isfinite(value) ? to_text(value) : "null"; }

} // namespace planula
