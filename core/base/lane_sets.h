// SPDX-License-Identifier: MIT
// The instruction sets that kernels are built for, each from a text of its own (base/lanes.h), and which of them this
// process uses. Bits do not depend on it: only time does.
#pragma once

#include <span>
#include <string_view>

namespace planula {

/// Numbers one by one, and in vectors of 16, of 32 and of 64 bytes.
enum class LaneSet { scalar, sse2, avx2, avx512 };

/// "scalar", "sse2", "avx2", "avx512".
std::string_view name_of(LaneSet lanes);

/// Those that this build has and this processor runs, narrowest first; scalar is always there.
std::span<const LaneSet> lane_sets();

/// The one to use from now on: the widest, unless chosen otherwise.
LaneSet chosen_lanes();
/// Throws InputError with the nearest name if there are no such lanes here.
void choose_lanes(std::string_view name);

} // namespace planula
