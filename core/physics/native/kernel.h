// SPDX-License-Identifier: MIT
// The native engine's inner loops, one text (kernel_text.h) built for several instruction sets, of which one is
// chosen at run time (base/lane_sets.h).
#pragma once

#include "base/lane_sets.h"
#include "physics/environment.h"
#include "physics/laws/ground.h"
#include "physics/laws/region.h"
#include "physics/laws/wall.h"
#include "physics/native/layout.h"

#include <cstdint>
#include <span>
#include <vector>

namespace planula::native {

/// Gravity in a step: v ← v + (x, y)·share at the height of the node.
struct Gravity {
    float x, y;
    const Layer<float> *layers;
    int layer_count;
};
/// For StepTask::pieces.
inline constexpr int walls = -1;

/// One step of all nodes: their state, what acts on them, and the numbers of the laws.
struct StepTask {
    const GroupPair *pairs = nullptr;
    int groups = 0; // one or two of each pair
    const Slot *slots = nullptr;
    const float *push_x = nullptr, *push_y = nullptr; // per node: forces other than of springs and pressure
    float knot_steps = 0;                             // since the last knot, this one included
    float stiffness = 0, damping = 0;                 // of springs
    float time_step = 0, slowing = 1, fall = 0; // v ← (v + F·time_step)·slowing, v_y ← v_y − fall
    const Gravity *gravity = nullptr;           // instead of `fall`, if it is not null
    const Piece<float> *ground = nullptr;       // left to right
    int pieces = 0;                             // 0: no ground, 1: level; walls: walls in its place
    int *below = nullptr;                       // per node, the piece below it when last looked for
    float friction = 0;
    float squared_limit = 0; // of speed
    WallsView<float> wall_grid;
};

/// The numbers of the laws in one step; no arrays, and gravity straight down.
StepTask step_task(const SoftBodyModel &model, const Environment &environment);

struct StepResult {
    float squared_speed = 0; // of the fastest node
    bool beyond = false;     // some node is beyond the limit, or not finite
};

/// The drag of the fluid on the outline.
struct DragTask {
    const OutlineGroup *outline = nullptr;
    int group_count = 0;
    const LinkGroup *links_at = nullptr; // of groups of nodes, `links_per_node` each
    int node_groups = 0, links_per_node = 0;
    float normal = 0, tangential = 0, flow_x = 0, flow_y = 0;
    const FluidRegion<float> *regions = nullptr;
    int region_count = 0;
};

/// The numbers of the fluid outside of all regions; no arrays.
DragTask drag_task(const Environment &environment);

/// A force in an array of records.
struct Force {
    float x, y, unused[2];
};

/// A node's extension by its muscles, in an array of records: the first number counts.
struct Extension {
    float own[4];
};

/// The muscles' way from one knot to the next in `steps` steps.
struct KnotTask {
    const GroupPair *pairs;
    int pair_count;
    const Extension *extension; // per node, at the next knot
    float steps;
};

/// Eight pairs of a contact cell and an outline link.
struct PairGroup {
    Place cell[group_size] = {}, a[group_size] = {}, b[group_size] = {};
};

/// Circles around outline links, `group_size` to a group: nothing outside comes near the link.
struct Circles {
    const float *x, *y, *squared_radius;
    int group_count;
};

/// Sets of outline links: a bit for each.
using Word = std::uint64_t;
inline constexpr int word_size = 64, groups_per_word = word_size / group_size;
inline int words_for(int group_count) { return (group_count + groups_per_word - 1) / groups_per_word; }

struct Kernel {
    const char *name; // as of its LaneSet
    /// Moves all nodes from `now` to `next`, where gravity is `fall` and there are no walls.
    StepResult (*step)(const StepTask &task, const Record *now, Record *next);
    /// The same with any gravity, and with walls.
    StepResult (*step_anywhere)(const StepTask &task, const Record *now, Record *next);
    /// Half the drag on each outline link, the record after them left as it is, and per node the sum of what its
    /// links have there, in their order from 0 on.
    void (*drag)(const DragTask &task, const Record *now, Force *half, float *push_x, float *push_y);
    /// The same, each link in the fluid at its middle.
    void (*drag_in_regions)(const DragTask &task, const Record *now, Force *half, float *push_x,
                            float *push_y);
    /// Leaves the last knot for the next.
    void (*reach_knot)(const KnotTask &task, Slot *slots);

    /// By how much `count` nodes, a multiple of 8, have moved against each other since `then`: the squared
    /// diagonal of the box around all displacements.
    float (*squared_motion)(const Record *then, const Record *now, int count);
    /// The circles of all points nearer to a link than `reach`, or a little more.
    void (*circle_links)(const OutlineGroup *links, int group_count, const Record *now, float reach, float *x,
                         float *y, float *squared_radius);
    /// The circles that hold each of some nodes: words_for(group_count) words for each, bit i % 64 of the (i / 64)-th
    /// for circle i.
    void (*find_circles)(const Circles &circles, const Record *now, const Place *nodes, int node_count,
                         Word *inside);
    /// The pairs nearer than a distance: bit i of near[group] for the i-th of the group. Returns the least of all
    /// squared distances.
    float (*measure_pairs)(const PairGroup *pairs, int group_count, const Record *now, float squared_distance,
                           unsigned char *near);
};

/// One for each of lane_sets(), in that order.
std::span<const Kernel> kernels();

/// The one that engines made from now on use: that of chosen_lanes().
const Kernel &chosen_kernel();

} // namespace planula::native
