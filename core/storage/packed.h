// SPDX-License-Identifier: MIT
// Bytes in a compressed form (xz, as liblzma writes it) whose size bounds what reading them may allocate: at most 16
// times as much, and some megabytes of the decoder. Content that would shrink further is stored as it is. It is meant
// for words of eight bytes (base/state.h), most of them weights of links.
#pragma once

#include <string>
#include <string_view>

namespace planula {

std::string pack(std::string_view content);

/// Throws InputError if the bytes are not what pack() returns.
std::string unpack(std::string_view bytes);

} // namespace planula
