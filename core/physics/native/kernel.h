// SPDX-License-Identifier: MIT
// The native engine's inner loops, one text (kernel_text.h) built for several instruction sets, of which the
// widest that the processor has is taken at run time. Bits do not depend on which: only time does.
#pragma once

#include "physics/laws/ground.h"
#include "physics/native/layout.h"

#include <span>
#include <string_view>
#include <vector>

namespace planula::native {

/// A piece of ground, from this x on to the right.
struct Slope {
    float from;
    GroundPlane<float> plane;
};

/// One step of all nodes: their state, what acts on them, and the numbers of the laws.
struct StepTask {
    const Group *groups;
    int group_count;
    const Slot *slots;
    const float *push_x, *push_y;   // per node: forces other than of springs and pressure
    float knot_steps;               // since the last knot, this one included
    float stiffness, damping;       // of springs
    float time_step, slowing, fall; // v ← (v + F·time_step)·slowing, v_y ← v_y − fall
    const Slope *ground;            // left to right; the first reaches to the left for ever
    int slopes;                     // 0: no ground
    float friction;
    float squared_limit; // of speed
};

struct StepResult {
    float squared_speed = 0; // of the fastest node
    bool beyond = false;     // some node is beyond the limit, or not finite
};

/// The fluid's pull on the outline.
struct DragTask {
    const OutlineGroup *outline;
    int group_count;
    float normal, tangential, flow_x, flow_y;
};

/// The muscles' way from one knot to the next in `steps` steps.
struct KnotTask {
    int group_count;
    const Group *groups;
    const float *elongation; // per node, at the next knot
    float steps;
};

struct Kernel {
    const char *name; // "scalar", "sse2", "avx2"
    /// Moves all nodes from `now` to `next`.
    StepResult (*step)(const StepTask &task, const Record *now, Record *next);
    /// Half the drag on each outline link.
    void (*drag)(const DragTask &task, const Record *now, float *half_x, float *half_y);
    /// Leaves the last knot for the next.
    void (*reach_knot)(const KnotTask &task, Slot *slots);
};

/// Those that this build has and this processor runs, narrowest first; "scalar" is always there.
std::span<const Kernel> kernels();

/// The one that engines made from now on use: the widest, unless chosen otherwise.
const Kernel &chosen_kernel();
/// Throws InputError with the nearest name if there is no such kernel here.
void choose_kernel(std::string_view name);

} // namespace planula::native
