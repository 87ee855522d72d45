// SPDX-License-Identifier: MIT
// Texts inside HTML and XML.
#pragma once

#include <string>
#include <string_view>

namespace planula {

/// The text with '<' and '&' escaped.
std::string markup_text(std::string_view text);

} // namespace planula
