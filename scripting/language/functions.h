// SPDX-License-Identifier: MIT
// What scripts see of Lua and of planula, described: rows of functions.inl.
#pragma once

#include <span>
#include <string_view>

namespace planula {

struct SandboxFunction {
    std::string_view name, use, meaning; // use: as a script writes it; empty if every use is an error
};

/// In the order of functions.inl: base functions, planula, math, string, table.
std::span<const SandboxFunction> sandbox_functions();

} // namespace planula
