// SPDX-License-Identifier: MIT
#include "base/markup.h"

namespace planula {

std::string markup_text(std::string_view text) {
    std::string safe;
    for (const char letter : text) {
        if (letter == '<')
            safe += "&lt;";
        else if (letter == '&')
            safe += "&amp;";
        else
            safe += letter;
    }
    return safe;
}

} // namespace planula
