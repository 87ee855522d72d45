// SPDX-License-Identifier: MIT
#include "physics/native/kernel.h"

#include "physics/native/kernel_list.h"

namespace planula::native {

namespace {

Kernel kernel_for(LaneSet lanes) {
#if defined(__x86_64__)
    constexpr Kernel (*makers[])() = {scalar_kernel, sse2_kernel, avx2_kernel, avx512_kernel};
#else
    constexpr Kernel (*makers[])() = {scalar_kernel};
#endif
    return makers[static_cast<std::size_t>(lanes)]();
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

StepTask step_task(const SoftBodyModel &model, const Environment &environment) {
    const BodyParameters &p = model.body;
    const auto dt = static_cast<float>(model.time_step);
    const auto limit = static_cast<float>(p.node_speed_limit / model.time_step);
    return {.stiffness = static_cast<float>(p.spring_stiffness),
            .damping = static_cast<float>(p.spring_damping),
            .time_step = dt,
            .fall = static_cast<float>(environment.gravity) * dt,
            .friction = static_cast<float>(environment.friction),
            .squared_limit = limit * limit};
}

DragTask drag_task(const Environment &environment) {
    return {.normal = static_cast<float>(environment.drag_normal),
            .tangential = static_cast<float>(environment.drag_tangential)};
}

} // namespace planula::native
