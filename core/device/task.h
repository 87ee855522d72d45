// SPDX-License-Identifier: MIT
// A trial as bytes, as it travels to a device and back: everything that a body, its world and its gait decide, in the
// order of the native engine's nodes, and what became of it. No pointer is in it: arrays are told by where they begin.
#pragma once

#include "base/portable.h"
#include "body/outcome.h"
#include "cell/channels.h"
#include "locomotion/muscle.h"
#include "network/kernel.h"
#include "physics/native/kernel.h"

#include <cstddef>

namespace planula::device {

inline constexpr unsigned alignment = 64;

/// An array in some memory: where it begins, in bytes, a multiple of `alignment`.
template <class T> struct Array {
    unsigned begin = 0;

    PORTABLE T *in(std::byte *memory) const { return reinterpret_cast<T *>(memory + begin); }
    PORTABLE const T *in(const std::byte *memory) const {
        return reinterpret_cast<const T *>(memory + begin);
    }
};

/// Sets of outline links: a bit for each.
using Word = unsigned;
inline constexpr int word_size = 32;

/// How a trial ended, and what it made.
struct Result {
    Outcome outcome = Outcome::viable;
    int settle_steps = 0;
    int path_points = 0;                 // in the array after this
    int updates = 0;                     // of networks
    double early_change = 0, change = 0; // of signals from knot to knot: before the last quarter, and in all
    double network_change = 0;           // of the networks' outputs from update to update
};

/// The first bytes of a trial. The arrays of its first `resident_bytes`, these numbers among them, are copied to the
/// fast memory of the threads that work together on it.
struct Task {
    int nodes = 0;
    bool settles = false, has_fluid = false;
    Actuation actuation = Actuation::oscillator;
    native::StepTask step; // numbers only
    native::DragTask drag; // the same
    int first_linked = 0;  // the first node of the first group with nodes of the outline
    Vec2d origin;          // that places count from, world frame

    // Fast memory: copied, and after that what is made there.
    Array<native::Record> now, next;
    Array<native::GroupPair> pairs;
    Array<native::Slot> slots;
    Array<native::OutlineGroup> outline;
    Array<native::LinkGroup> links_at;
    Array<native::Force> half_drag;
    Array<native::Extension> extension;
    unsigned resident_bytes = 0, fast_bytes = 0;

    // The rest of what is copied to the device.
    Array<int> node_of; // of each cell
    Array<Piece<float>> ground;
    int pieces = 0;

    // Self-collision.
    int contact_cells = 0, outline_links = 0, words = 0; // of a cell's set of links
    float contact_stiffness = 0, contact_reach = 0;
    Array<native::Place> touching_cells;
    Array<Word> unmasked;

    // Settling: at rest while the squared speed of all nodes is at most `squared_calm`.
    float settle_slowing = 1, squared_calm = 0;
    int settle_window = 0, settle_limit = 0;

    // The gait.
    double range = 0;
    int locomotion_steps = 0, knot_interval = 1, ramp_steps = 1, update_interval = 1, path_interval = 1,
        late = 0;
    Array<Phasor> start_phasors; // of oscillators
    neural::Task network;        // numbers only
    int morphogen_row = 0, spring_row = 0;
    Array<Network::Source> sources;
    Array<int> first_source, first_neighbour, neighbours; // nodes, in ascending order of cells
    Array<double> start_activations, start_morphogens;
    unsigned input_bytes = 0;

    // Memory for the trial's own use, not copied.
    Array<int> below;
    Array<double> from, to, changes; // signals at knots
    Array<Phasor> phasors;
    Array<double> activations, network_next, morphogens; // of networks, groups of cells as in Activations
    Array<double> previous, newest;                      // their outputs
    Array<native::Record> listed_at;
    Array<float> circle_x, circle_y, squared_radius; // per outline link
    Array<Word> inside, near;
    Array<native::PairGroup> listed; // pairs, as many as are not masked
    Array<float> squared_distances;
    Array<ContactForces<float>> touches;
    unsigned scratch_bytes = 0;

    // The path follows the Result.
    unsigned result_bytes = 0;
};

/// The path follows a Result.
static_assert(sizeof(Result) <= alignment);
PORTABLE inline Array<Vec2d> path_after_result() { return {alignment}; }

} // namespace planula::device
