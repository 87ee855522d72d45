// SPDX-License-Identifier: MIT
// The text of a kernel, as a template on the lanes that it works on: links outside, cells inside. Each lane is a cell
// of its own, whose sums run over its links in their order, so the width changes no bit. Files that include this may be
// built for instruction sets that not every processor has: all of it is internal to the file, and nothing of the
// standard library is called, for the linker may keep one copy of such a function for the whole program.
#pragma once

#include "base/exponential.h"
#include "base/lanes.h"
#include "network/kernel.h"

namespace planula::neural {

namespace {

/// The new activations of one group's targets, from its present ones: of `cells` cells from lane `lane` on.
template <class T, int cells = group_size>
PORTABLE void find_next(const Task &task, const double *group, int lane = 0) {
    constexpr int parts = cells / T::width;
    for (int target = 0; target < task.targets; ++target) {
        T sums[parts];
        for (T &sum : sums) sum = T(0);
        const Network::Source *const end = task.sources + task.first_source[target + 1];
        for (const Network::Source *link = task.sources + task.first_source[target]; link != end; ++link) {
            const T weight(link->weight);
            const double *source = group + link->node * group_size + lane;
            for (int i = 0; i < parts; ++i) sums[i] = sums[i] + weight * load<T>(source + i * T::width);
        }
        double *next = task.next + target * group_size + lane;
        for (int i = 0; i < parts; ++i) store(math::tanh_of(sums[i]), next + i * T::width);
    }
}

/// Moves those of some cells, from lane `lane` on, to the targets' rows. Returns in which all are numbers: bit i for
/// the i-th cell.
template <class T> PORTABLE unsigned take_next(const Task &task, double *targets, int lane) {
    auto within = T(0) <= T(0);
    for (int place = lane; place < task.targets * group_size; place += group_size) {
        const T next = load<T>(task.next + place);
        within = within & (abs(next) <= T(1));
        store(next, targets + place);
    }
    return bits_of<T>(within);
}

template <class T> [[gnu::flatten]] bool advance(const Task &task, double *activations) {
    bool sound = true;
    for (int cell = 0; cell < task.cells; cell += group_size) {
        double *group = activations + cell * (task.inputs + task.targets);
        unsigned numbers = 0;
        for (int step = 0; step < task.steps; ++step) {
            find_next<T>(task, group);
            numbers = 0;
            for (int lane = 0; lane < group_size; lane += T::width)
                numbers |= take_next<T>(task, group + task.inputs * group_size, lane) << lane;
        }
        // Lanes beyond the last cell do not count.
        const int cells = task.cells - cell;
        const unsigned all = cells < group_size ? (1u << cells) - 1 : (1u << group_size) - 1;
        sound = sound && (task.steps == 0 || (numbers & all) == all);
    }
    return sound;
}

} // namespace

} // namespace planula::neural
