// SPDX-License-Identifier: MIT
// The native engine's inner loops, one text (kernel_text.h) built for several instruction sets, of which one is
// chosen at run time (base/lane_sets.h).
#pragma once

#include "base/lane_sets.h"
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
    const GroupPair *pairs;
    int groups; // one or two of each pair
    const Slot *slots;
    const float *push_x, *push_y;   // per node: forces other than of springs and pressure
    float knot_steps;               // since the last knot, this one included
    float stiffness, damping;       // of springs
    float time_step, slowing, fall; // v ← (v + F·time_step)·slowing, v_y ← v_y − fall
    const Gravity *gravity;         // instead of `fall`, if it is not null
    const Piece<float> *ground;     // left to right
    int pieces;                     // 0: no ground, 1: level; walls: walls in its place
    int *below;                     // per node, the piece below it when last looked for
    float friction;
    float squared_limit; // of speed
    WallsView<float> wall_grid;
};

struct StepResult {
    float squared_speed = 0; // of the fastest node
    bool beyond = false;     // some node is beyond the limit, or not finite
};

/// The drag of the fluid on the outline.
struct DragTask {
    const OutlineGroup *outline;
    int group_count;
    const LinkGroup *links_at; // of groups of nodes, `links_per_node` each
    int node_groups, links_per_node;
    float normal, tangential, flow_x, flow_y;
    const FluidRegion<float> *regions = nullptr;
    int region_count = 0;
};

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
