// SPDX-License-Identifier: MIT
// REFERENCE.md: everything that an experiment file may state and read, made of the lists that the program itself uses.
#pragma once

#include <string>

namespace planula {

/// The whole document, in Markdown.
std::string reference();

} // namespace planula
