// SPDX-License-Identifier: MIT
#include "language/functions.h"

namespace planula {

namespace {

constexpr SandboxFunction functions[] = {
#define FUNCTION(...) {__VA_ARGS__},
#include "language/functions.inl"
};

} // namespace

std::span<const SandboxFunction> sandbox_functions() { return functions; }

} // namespace planula
