// SPDX-License-Identifier: MIT
#include "base/lane_sets.h"

#include "base/error.h"
#include "base/text.h"

#include <array>
#include <atomic>
#include <string>
#include <vector>

namespace planula {

namespace {

constexpr std::array<std::string_view, 4> names{"scalar", "sse2", "avx2", "avx512"};

std::vector<LaneSet> runnable_sets() {
    std::vector<LaneSet> result{LaneSet::scalar};
#if defined(__x86_64__)
    result.push_back(LaneSet::sse2);
    if (__builtin_cpu_supports("avx2")) result.push_back(LaneSet::avx2);
    if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
        result.push_back(LaneSet::avx512);
#endif
    return result;
}

std::atomic<LaneSet> &choice() {
    static std::atomic<LaneSet> chosen = lane_sets().back();
    return chosen;
}

} // namespace

std::string_view name_of(LaneSet lanes) { return names[static_cast<std::size_t>(lanes)]; }

std::span<const LaneSet> lane_sets() {
    static const std::vector<LaneSet> runnable = runnable_sets();
    return runnable;
}

LaneSet chosen_lanes() { return choice(); }

void choose_lanes(std::string_view name) {
    std::vector<std::string_view> known;
    for (const LaneSet lanes : lane_sets()) {
        if (name_of(lanes) == name) {
            choice() = lanes;
            return;
        }
        known.push_back(name_of(lanes));
    }
    const std::string nearest = nearest_name(name, known);
    throw InputError("this processor has no lanes '" + std::string(name) + "'" +
                     (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
}

} // namespace planula
