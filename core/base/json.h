// SPDX-License-Identifier: MIT
// Texts in JSON. Numbers are written as everywhere (base/text.h); there is no reader.
#pragma once

#include <string>
#include <string_view>

namespace planula {

/// The text as a string of JSON, in quotes. Control characters are escaped; all other bytes stay, so that valid UTF-8
/// gives valid JSON.
std::string json_text(std::string_view text);

} // namespace planula
