// SPDX-License-Identifier: MIT
// The networks' inner loop, one text (kernel_text.h) built for several instruction sets, of which one is taken at run
// time (base/lane_sets.h).
#pragma once

#include "base/lane_sets.h"
#include "network/activations.h"
#include "network/network.h"

namespace planula::neural {

constexpr int group_size = Activations::group_size;

/// Synchronous steps of one network in the cells of all groups.
struct Task {
    int inputs, targets; // nodes: first the inputs, then those that are computed
    const Network::Source *sources;
    const int *first_source; // of each target; one more than there are
    int steps, cells;
    double *next; // targets × group_size numbers, for the kernel's use
};

/// Takes these steps; returns whether each cell's targets are numbers then.
using Kernel = bool (*)(const Task &task, double *activations);

/// The one for this set, which must be one of lane_sets().
Kernel kernel_for(LaneSet lanes);

} // namespace planula::neural
