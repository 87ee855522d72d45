// SPDX-License-Identifier: MIT
// A soft body laid out for computing several nodes at once (§2.5; decisions 0006 to 0010). Nodes lie in
// groups of 8, whatever the width of the instructions. Each node walks round the fan of its neighbours,
// counter-clockwise, and sums its own force: every spring is computed at both of its ends, with forces
// equal and opposite to the bit, and every triangle at its three corners. The order of these sums follows
// from links and triangles alone: not from coordinates, so that a turned body has the same.
#pragma once

#include "base/portable.h"
#include "physics/soft_body.h"

#include <vector>

namespace planula::native {

inline constexpr int group_size = 8;
/// Two groups lie side by side, for instructions that hold both.
inline constexpr int pair_size = 2 * group_size;

/// One node's state.
struct Record {
    float x, y, vx, vy;
};

/// Where a node's record begins in an array of them, in floats.
using Place = unsigned;
PORTABLE inline Place place_of(int node) { return static_cast<Place>(4 * node); }
PORTABLE inline int node_at(Place place) { return static_cast<int>(place / 4); }

/// One neighbour of each node of two groups, the spring to it, and the triangle between the neighbour before and
/// this one. Where a node has no such neighbour it is its own, with constants 0: its force is exactly 0.
struct alignas(64) Slot {
    Place neighbour[pair_size];
    float pull[pair_size];                                  // k·L at the last knot
    float pull_change[pair_size];                           // and its change in a step
    float twice_area[pair_size], pressure_slope[pair_size]; // of the triangle's pressure
    float natural_pull[pair_size];                          // k·L without muscles
    float next_pull[pair_size];                             // k·L at the coming knot
};

struct GroupPair {
    Place last[pair_size]; // each node's last neighbour, which closes the fan before its first
    int first_slot;
    int slots[2]; // that each of the groups needs; there are as many as the more demanding needs
};

/// Eight links of the outline; past the last of them from node 0 to itself.
struct OutlineGroup {
    Place a[group_size] = {}, b[group_size] = {};
};

/// One outline link of each of eight nodes: where its record begins in an array with one for each link, in floats.
/// A node without any more has the place after those of all groups of the outline.
struct LinkGroup {
    Place link[group_size];
};

/// After the body's nodes, up to the next multiple of 16, follow copies of the last one. They fill its group, and if
/// need be the other of its pair, which wide lanes move too; all that acts on the last node acts on them.
struct Layout {
    int nodes = 0;            // of the body
    int groups = 0;           // that hold some of them
    std::vector<int> cell_of; // each node's number in the model; also of copies
    int first_outline_node = 0;
    std::vector<GroupPair> pairs;
    std::vector<Slot> slots;
    std::vector<OutlineGroup> outline;
    // The links at each node of the groups from outline_group() on, ascending: as many as the most that a node has.
    int links_per_node = 0;
    std::vector<LinkGroup> links_at;
    SoftBodyModel
        model; // outline, contact cells with masks, by the nodes' numbers, and the numbers of the laws; no more

    /// The first group that holds nodes of the outline (only if the body has an outline), and how many there are from
    /// it on, those of copies included.
    int outline_group() const { return first_outline_node / group_size; }
    int outline_groups() const { return static_cast<int>(cell_of.size()) / group_size - outline_group(); }
};

/// Inner nodes come first, by ascending number of neighbours, and those of the outline after them, by descending
/// number: groups side by side need about the same number of slots.
Layout lay_out(const SoftBodyModel &model);

} // namespace planula::native
