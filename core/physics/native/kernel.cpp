// SPDX-License-Identifier: MIT
#include "physics/native/kernel.h"

#include "physics/native/kernel_list.h"

namespace planula::native {

namespace {

Kernel kernel_for(LaneSet lanes) {
    switch (lanes) {
#if defined(__x86_64__)
    case LaneSet::avx2:
        return avx2_kernel();
    case LaneSet::sse2:
        return sse2_kernel();
#endif
    default:
        return scalar_kernel();
    }
}

} // namespace

std::span<const Kernel> kernels() {
    static const std::vector<Kernel> runnable = [] {
        std::vector<Kernel> result;
        for (const LaneSet lanes : lane_sets()) result.push_back(kernel_for(lanes));
        return result;
    }();
    return runnable;
}

const Kernel &chosen_kernel() { return kernels()[static_cast<std::size_t>(chosen_lanes())]; }

} // namespace planula::native
