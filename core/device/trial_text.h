// SPDX-License-Identifier: MIT
// A trial as a device runs it: settle, ramp and move (locomotion/trial.h), all of it in one piece, by a crew of threads
// of which each has a node, a cell, an outline link or a pair of its own at a time. The laws are those of the native
// engine, one lane wide (physics/native/kernel_text.h), and of the networks (network/kernel_text.h); this text only
// says in what order they are asked, so its results are those of locomote() to the bit.
//
// It consists of phases. crew.each(count, act) calls act(0) … act(count − 1) in any order or at once, and ends when all
// are done: what one call writes, no other call of that phase reads or writes. What lies between the phases is computed
// by every thread, from values that all of them have: constants, and what crew.most(), least(), total() and all() tell.
// It never reads memory that phases write, so that no thread can be ahead of another's reading. A crew also has mark(),
// which sets bits, and copy(), which moves bytes. On a graphics processor a crew is a block of threads
// (device/cuda/block.cuh); in tests it is a loop, in several orders.
#pragma once

#include "cell/senses.h"
#include "device/task.h"
#include "network/kernel_text.h"
#include "physics/native/contact_watch.h"
#include "physics/native/kernel_text.h"

#include <bit>
#include <cmath>
#include <span>

namespace planula::device {

namespace {

using One = Lanes<1>;

/// The trial's memories.
struct Memory {
    const std::byte *input;
    std::byte *fast, *scratch, *result;
};

/// Self-collision between the steps: as native::Contact, but its list is made by all threads. Lists may differ, the
/// forces do not.
struct Touching {
    native::ContactWatch watch;
    bool has_list = false;
    int pairs = 0;        // that are listed
    bool touches = false; // whether some of them do
};

/// What changes from step to step and all threads know.
struct Now {
    native::Record *now, *next;
    float squared_speed = 0; // of the fastest node in the last step
    Touching touching;
};

/// How far nodes of the outline can have moved against each other since the list was made: the diagonal of the box
/// around all displacements.
template <class Crew>
PORTABLE float motion_since_list(Crew &crew, const Task &task, const Memory &memory,
                                 const native::Record *now) {
    const native::Record *then = task.listed_at.in(memory.scratch);
    const int first = task.first_linked, count = task.nodes - first;
    const auto x = [=](int i) { return now[first + i].x - then[i].x; };
    const auto y = [=](int i) { return now[first + i].y - then[i].y; };
    const float left = crew.least(count, x), low = crew.least(count, y);
    const float right = -crew.least(count, [=](int i) { return -x(i); });
    const float high = -crew.least(count, [=](int i) { return -y(i); });
    return root_of((right - left) * (right - left) + (high - low) * (high - low));
}

/// Lists the pairs that may touch soon, ordered by cell, then by link.
template <class Crew>
PORTABLE int list_pairs(Crew &crew, const Task &task, const Memory &memory, const native::Record *now,
                        float within) {
    native::Record *then = task.listed_at.in(memory.scratch);
    float *x = task.circle_x.in(memory.scratch), *y = task.circle_y.in(memory.scratch),
          *squared_radius = task.squared_radius.in(memory.scratch);
    const native::OutlineGroup *outline = task.outline.in(memory.fast);
    const int first = task.first_linked, linked = task.nodes - first, links = task.outline_links;
    crew.each(linked < links ? links : linked, [=](int i) {
        if (i < linked) then[i] = now[first + i];
        if (i >= links) return;
        const auto circle =
            native::circle_around<One>(outline[i / native::group_size], i % native::group_size, now, within);
        x[i] = circle.middle.x.value, y[i] = circle.middle.y.value;
        squared_radius[i] = circle.squared_radius.value;
    });

    const native::Place *cells = task.touching_cells.in(memory.input);
    const Word *unmasked = task.unmasked.in(memory.input);
    Word *inside = task.inside.in(memory.scratch);
    const int row = task.words * word_size, words = task.contact_cells * task.words;
    crew.mark(
        words * word_size,
        [=](int i) {
            const int link = i % row;
            if (link >= links || !(unmasked[i / word_size] >> i % word_size & 1)) return false;
            const native::Record &at = now[native::node_at(cells[i / row])];
            return squared_length(Vec2f{at.x, at.y} - Vec2f{x[link], y[link]}) < squared_radius[link];
        },
        inside);

    native::PairGroup *listed = task.listed.in(memory.scratch);
    const int words_of_cell = task.words;
    const auto count = [=](int i) { return std::popcount(inside[i]); };
    crew.each(words, [=](int i) {
        int pair = 0;
        for (int before = 0; before < i; ++before) pair += count(before);
        for (Word bits = inside[i]; bits != 0; bits &= bits - 1, ++pair) {
            const int link = i % words_of_cell * word_size + std::countr_zero(bits);
            const native::OutlineGroup &ends = outline[link / native::group_size];
            native::PairGroup &group = listed[pair / native::group_size];
            const int lane = pair % native::group_size, end = link % native::group_size;
            group.cell[lane] = cells[i / words_of_cell], group.a[lane] = ends.a[end],
            group.b[lane] = ends.b[end];
        }
    });
    return crew.total(words, count);
}

/// Finds the pairs that touch and their forces.
template <class Crew>
PORTABLE void measure_pairs(Crew &crew, const Task &task, const Memory &memory, const native::Record *now,
                            Touching &touching) {
    const native::PairGroup *listed = task.listed.in(memory.scratch);
    float *squared_distances = task.squared_distances.in(memory.scratch);
    ContactForces<float> *touches = task.touches.in(memory.scratch);
    const float stiffness = task.contact_stiffness, reach = task.contact_reach;
    const float least = crew.least(touching.pairs, [=](int i) {
        const native::PairGroup &group = listed[i / native::group_size];
        const int lane = i % native::group_size;
        const float squared = native::squared_distances<One>(group, lane, now).value;
        squared_distances[i] = squared;
        if (squared < reach * reach) {
            const auto at = [=](native::Place place) {
                const native::Record &record = now[native::node_at(place)];
                return Vec2f{record.x, record.y};
            };
            touches[i] =
                contact_forces(at(group.cell[lane]), at(group.a[lane]), at(group.b[lane]), stiffness, reach);
        }
        return squared;
    });
    touching.touches = least < reach * reach;
    if (touching.touches)
        crew.mark(
            touching.pairs, [=](int i) { return squared_distances[i] < reach * reach; },
            task.near.in(memory.scratch));
    touching.watch.measured(root_of(least), reach);
}

template <class Crew>
PORTABLE void find_touches(Crew &crew, const Task &task, const Memory &memory, Now &state) {
    Touching &touching = state.touching;
    touching.touches = false;
    if (task.contact_cells == 0 ||
        touching.watch.sees_none(root_of(state.squared_speed) * task.step.time_step))
        return;
    if (touching.has_list && !touching.watch.keeps_list())
        touching.watch.moved = motion_since_list(crew, task, memory, state.now);
    if (!touching.has_list || !touching.watch.keeps_list()) {
        touching.pairs =
            list_pairs(crew, task, memory, state.now, touching.watch.listed_within(task.contact_reach));
        touching.has_list = true, touching.watch.moved = 0;
    }
    measure_pairs(crew, task, memory, state.now, touching);
}

/// Adds what touches a node to the force on it, pair after pair.
PORTABLE inline Vec2<One> add_touches(const Task &task, const Memory &memory, int pairs, int node,
                                      Vec2<One> push) {
    const Word *near = task.near.in(memory.scratch);
    const native::PairGroup *listed = task.listed.in(memory.scratch);
    const native::Place place = native::place_of(node);
    for (int first = 0; first < pairs; first += word_size)
        for (Word bits = near[first / word_size]; bits != 0; bits &= bits - 1) {
            const int pair = first + std::countr_zero(bits), lane = pair % native::group_size;
            const native::PairGroup &group = listed[pair / native::group_size];
            const ContactForces<float> &forces = task.touches.in(memory.scratch)[pair];
            const auto add = [&](native::Place pushed, Vec2f force) {
                if (pushed == place) push += Vec2<One>{force.x, force.y};
            };
            add(group.cell[lane], forces.on_cell), add(group.a[lane], forces.on_a),
                add(group.b[lane], forces.on_b);
        }
    return push;
}

/// One step of all nodes; false if one of them is beyond the limit, or not finite.
template <class Crew>
PORTABLE bool step(Crew &crew, const Task &task, const Memory &memory, native::StepTask laws, Now &state) {
    find_touches(crew, task, memory, state);
    const native::Record *now = state.now;
    native::Record *next = state.next;
    native::Force *half = task.half_drag.in(memory.fast);
    if (task.has_fluid) {
        const native::OutlineGroup *outline = task.outline.in(memory.fast);
        const native::DragTask &drag = task.drag;
        const Fluid<One> fluid{drag.normal, drag.tangential, {drag.flow_x, drag.flow_y}};
        crew.each(task.outline_links, [=](int i) {
            native::drag_on_links(outline[i / native::group_size], i % native::group_size, now, fluid,
                                  half + i);
        });
    }

    const native::LinkGroup *links_at = task.links_at.in(memory.fast);
    const int links_per_node = task.drag.links_per_node, first_linked = task.first_linked;
    const bool drags = task.has_fluid, touches = state.touching.touches;
    const int pairs = state.touching.pairs;
    state.squared_speed = crew.most(task.nodes, [=, &task](int node) {
        const auto self = native::load_nodes<One>(now + node);
        Vec2<One> push{0, 0};
        if (drags && node >= first_linked) {
            const native::LinkGroup *link =
                links_at + (node - first_linked) / native::group_size * links_per_node;
            for (int k = 0; k < links_per_node; ++k)
                push += native::drag_of_link<One>(link[k], node % native::group_size, half);
        }
        if (touches) push = add_touches(task, memory, pairs, node, push);
        const Vec2<One> force = native::add_fan<One>(laws, laws.pairs[node / native::pair_size],
                                                     node % native::pair_size, now, self, push);
        return squared_length(native::advance<One, false>(laws, {self, force, node}, next)).value;
    });
    state.now = next, state.next = const_cast<native::Record *>(now);
    return state.squared_speed <= laws.squared_limit;
}

/// Muscles off until all nodes have been slow for a while. Returns how that ended, and the steps in `steps`.
template <class Crew>
PORTABLE Outcome settle(Crew &crew, const Task &task, const Memory &memory, native::StepTask laws, Now &state,
                        int &steps) {
    laws.slowing = task.settle_slowing, laws.knot_steps = 0;
    int calm = 0;
    for (steps = 0; steps < task.settle_limit && calm < task.settle_window; ++steps) {
        if (!step(crew, task, memory, laws, state)) return Outcome::exploded;
        calm = state.squared_speed <= task.squared_calm ? calm + 1 : 0;
    }
    return calm < task.settle_window ? Outcome::never_settled : Outcome::viable;
}

/// One update of all cells' networks (GrnMuscles::update()); false if some activation is not a number.
template <class Crew>
PORTABLE bool update_networks(Crew &crew, const Task &task, const Memory &memory, int updates) {
    double *activations = task.activations.in(memory.scratch),
           *morphogens = task.morphogens.in(memory.scratch), *previous = task.previous.in(memory.scratch),
           *newest = task.newest.in(memory.scratch), *next = task.network_next.in(memory.scratch);
    const int *first_neighbour = task.first_neighbour.in(memory.input),
              *neighbours = task.neighbours.in(memory.input);
    neural::Task network = task.network;
    network.sources = task.sources.in(memory.input),
    network.first_source = task.first_source.in(memory.input);
    const int rows = network.inputs + network.targets;
    const int nodes = task.nodes;
    const auto group_of = [=](int node) { return node / neural::group_size * neural::group_size; };

    const bool sound = crew.all(task.nodes, [=](int node) {
        double *group = activations + group_of(node) * rows;
        neural::Task of_group = network;
        of_group.next = next + group_of(node) * network.targets;
        const int lane = node % neural::group_size, first = first_neighbour[node];
        const std::span mine(neighbours + first, static_cast<std::size_t>(first_neighbour[node + 1] - first));
        group[input::morphogen * neural::group_size + lane] =
            mean_morphogen(mine, {morphogens, static_cast<std::size_t>(nodes)});
        neural::find_next<DoubleLanes<1>, 1>(of_group, group, lane);
        return neural::take_next<DoubleLanes<1>>(of_group, group + network.inputs * neural::group_size,
                                                 lane) != 0;
    });
    const int morphogen_row = task.morphogen_row, spring_row = task.spring_row;
    crew.each(task.nodes, [=](int node) {
        const double *group = activations + group_of(node) * rows + node % neural::group_size;
        morphogens[node] = group[morphogen_row * neural::group_size];
        previous[node] = newest[node];
        newest[node] = group[spring_row * neural::group_size];
    });
    if (updates == 0) return sound;
    // Eq. (5): summed over cells in their order.
    Result *result = reinterpret_cast<Result *>(memory.result);
    const int *node_of = task.node_of.in(memory.input);
    crew.each(1, [=](int) {
        for (int cell = 0; cell < nodes; ++cell)
            result->network_change += std::abs(newest[node_of[cell]] - previous[node_of[cell]]);
    });
    return sound;
}

/// What all threads know of the gait.
struct Signals {
    int updates = 0;
    bool sound = true;
};

/// The signals at step t, a knot, to the nodes' `to`.
template <class Crew>
PORTABLE void read_signals(Crew &crew, const Task &task, const Memory &memory, int t, Signals &signals) {
    double *to = task.to.in(memory.scratch);
    if (task.actuation == Actuation::oscillator) {
        Phasor *phasors = task.phasors.in(memory.scratch);
        crew.each(task.nodes, [=](int node) {
            if (t > 0) phasors[node].turn();
            to[node] = phasors[node].sine;
        });
        return;
    }
    const int interval = task.update_interval;
    if (t % interval == 0 && t < task.locomotion_steps)
        signals.sound = update_networks(crew, task, memory, signals.updates++) && signals.sound;
    const int since = t - last_update(t, interval, task.locomotion_steps);
    const double *previous = task.previous.in(memory.scratch), *newest = task.newest.in(memory.scratch);
    crew.each(task.nodes,
              [=](int node) { to[node] = signal_between(previous[node], newest[node], since, interval); });
}

/// On the way to the knot at t (Muscles::reach()).
template <class Crew>
PORTABLE void reach(Crew &crew, const Task &task, const Memory &memory, int t, Signals &signals) {
    double *from = task.from.in(memory.scratch), *to = task.to.in(memory.scratch),
           *changes = task.changes.in(memory.scratch);
    crew.each(task.nodes, [=](int node) { from[node] = to[node]; });
    read_signals(crew, task, memory, t, signals);
    native::Extension *extensions = task.extension.in(memory.fast);
    const double range = task.range, share = ramp(t, task.ramp_steps);
    crew.each(task.nodes, [=](int node) {
        extensions[node].own[0] = static_cast<float>(extension(range, share, to[node]));
        changes[node] += std::abs(to[node] - from[node]);
    });
    const One per_step = One(1) / One(static_cast<float>(task.knot_interval));
    const native::GroupPair *pairs = task.pairs.in(memory.fast);
    native::Slot *slots = task.slots.in(memory.fast);
    crew.each(task.nodes, [=](int node) {
        const native::GroupPair &pair = pairs[node / native::pair_size];
        const int lane = node % native::pair_size;
        native::Slot *slot = slots + pair.first_slot;
        for (native::Slot *const end = slot + native::slots_of<One>(pair, lane); slot != end; ++slot)
            native::reach_knot_in(*slot, lane, One(extensions[node].own[0]), extensions, per_step);
    });
}

/// A further point of the path: the centre of mass, summed over cells in their order.
template <class Crew>
PORTABLE void add_to_path(Crew &crew, const Task &task, const Memory &memory, const Now &state, int point) {
    const native::Record *now = state.now;
    const int *node_of = task.node_of.in(memory.input);
    const int nodes = task.nodes;
    const Vec2d origin = task.origin;
    Vec2d *path = path_after_result().in(memory.result);
    crew.each(2, [=](int axis) {
        double sum = 0;
        for (int cell = 0; cell < nodes; ++cell) {
            const native::Record &at = now[node_of[cell]];
            sum += axis == 0 ? origin.x + static_cast<double>(at.x) : origin.y + static_cast<double>(at.y);
        }
        (axis == 0 ? path[point].x : path[point].y) = sum / static_cast<double>(nodes);
    });
}

/// The changes of all cells' signals so far, in the order of cells.
template <class Crew>
PORTABLE void add_changes(Crew &crew, const Task &task, const Memory &memory, double Result::*sum) {
    const double *changes = task.changes.in(memory.scratch);
    const int *node_of = task.node_of.in(memory.input);
    Result *result = reinterpret_cast<Result *>(memory.result);
    const int nodes = task.nodes;
    crew.each(1, [=](int) {
        for (int cell = 0; cell < nodes; ++cell) result->*sum += changes[node_of[cell]];
    });
}

/// Sets all that is worked on to how it begins; the resident bytes are in place.
template <class Crew> PORTABLE void prepare(Crew &crew, const Task &task, const Memory &memory) {
    native::Force *half = task.half_drag.in(memory.fast);
    const int links = task.outline_links, nodes = task.nodes;
    int *below = task.below.in(memory.scratch);
    double *to = task.to.in(memory.scratch), *changes = task.changes.in(memory.scratch);
    Result *result = reinterpret_cast<Result *>(memory.result);
    crew.each(nodes, [=](int i) {
        if (i == 0) half[links] = {}, *result = Result{};
        below[i] = 0, to[i] = 0, changes[i] = 0;
    });
    if (task.actuation == Actuation::oscillator) {
        Phasor *phasors = task.phasors.in(memory.scratch);
        const Phasor *start = task.start_phasors.in(memory.input);
        crew.each(nodes, [=](int i) { phasors[i] = start[i]; });
        return;
    }
    const int groups = (nodes + neural::group_size - 1) / neural::group_size;
    const int numbers = groups * neural::group_size * (task.network.inputs + task.network.targets);
    double *activations = task.activations.in(memory.scratch),
           *morphogens = task.morphogens.in(memory.scratch), *newest = task.newest.in(memory.scratch);
    const double *start_activations = task.start_activations.in(memory.input),
                 *start_morphogens = task.start_morphogens.in(memory.input);
    crew.each(numbers, [=](int i) {
        activations[i] = start_activations[i];
        if (i < nodes) morphogens[i] = start_morphogens[i], newest[i] = 0;
    });
}

/// Locomotion: from rest to the end, or until the body explodes.
template <class Crew>
PORTABLE Outcome move(Crew &crew, const Task &task, const Memory &memory, native::StepTask laws, Now &state,
                      int &path_points, int &updates) {
    laws.slowing = 1;
    add_to_path(crew, task, memory, state, path_points++);
    Signals signals;
    read_signals(crew, task, memory, 0, signals);
    for (int start = 0; start < task.locomotion_steps; start += task.knot_interval) {
        if (start == task.late) add_changes(crew, task, memory, &Result::early_change);
        reach(crew, task, memory, start + task.knot_interval, signals);
        for (int j = 1; j <= task.knot_interval; ++j) {
            laws.knot_steps = static_cast<float>(j);
            if (!step(crew, task, memory, laws, state) || !signals.sound) return Outcome::exploded;
            if ((start + j) % task.path_interval == 0) add_to_path(crew, task, memory, state, path_points++);
        }
    }
    add_changes(crew, task, memory, &Result::change);
    // After the last step, for the place where it ended.
    add_to_path(crew, task, memory, state, path_points);
    updates = signals.updates;
    return Outcome::viable;
}

/// The whole trial.
template <class Crew> PORTABLE void run_trial(Crew &crew, const Memory &memory) {
    crew.copy(memory.input, reinterpret_cast<const Task *>(memory.input)->resident_bytes, memory.fast);
    const Task &task = *reinterpret_cast<const Task *>(memory.fast);
    prepare(crew, task, memory);
    native::StepTask laws = task.step;
    laws.pairs = task.pairs.in(memory.fast), laws.slots = task.slots.in(memory.fast);
    laws.ground = task.ground.in(memory.input), laws.pieces = task.pieces;
    laws.below = task.below.in(memory.scratch);
    Now state{task.now.in(memory.fast), task.next.in(memory.fast)};
    int settle_steps = 0, path_points = 0, updates = 0;
    Outcome outcome = Outcome::viable;
    if (task.settles) outcome = settle(crew, task, memory, laws, state, settle_steps);
    if (outcome == Outcome::viable) outcome = move(crew, task, memory, laws, state, path_points, updates);
    Result *result = reinterpret_cast<Result *>(memory.result);
    crew.each(1, [=](int) {
        result->outcome = outcome, result->settle_steps = settle_steps;
        result->path_points = path_points, result->updates = updates;
    });
}

} // namespace

} // namespace planula::device
