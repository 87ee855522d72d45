// SPDX-License-Identifier: MIT
// Bytes that show whether they are whole: a magic word, the version of the form, the length, the content,
// and the SHA-256 of all that. Bytes that were cut short, lengthened or changed in any bit are recognised.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace planula {

std::string seal(std::string_view content);

/// The content, which lies within `bytes`; nothing if they are not as seal() left them.
std::optional<std::string_view> unseal(std::string_view bytes);

} // namespace planula
