// SPDX-License-Identifier: MIT
// The text of a kernel, as a template on the lanes that it works on. Each lane is a node (or an outline link)
// of its own and no sum goes across lanes, so the width changes no bit. Files that include this may be built
// for instruction sets that not every processor has: all of it is internal to the file, and nothing of the
// standard library is called, for the linker may keep one copy of such a function for the whole program.
#pragma once

#include "base/lanes.h"
#include "physics/laws/contact.h"
#include "physics/laws/drag.h"
#include "physics/laws/ground.h"
#include "physics/laws/pressure.h"
#include "physics/laws/region.h"
#include "physics/laws/spring.h"
#include "physics/native/kernel.h"

namespace planula::native {

namespace {

/// Positions and velocities of as many nodes.
template <class T> struct Nodes { Vec2<T> position, velocity; };

template <class T> PORTABLE Nodes<T> load_nodes(const Record *records, const Place *places) {
    const auto fields = load_fields<T>([&](int lane) { return &records->x + places[lane]; });
    return {{fields.a, fields.b}, {fields.c, fields.d}};
}

template <class T> PORTABLE Nodes<T> load_nodes(const Record *records) {
    const auto fields = load_fields<T>(&records->x);
    return {{fields.a, fields.b}, {fields.c, fields.d}};
}

template <class T> PORTABLE void store_nodes(const Nodes<T> &nodes, Record *records) {
    store_fields(Fields<T>{nodes.position.x, nodes.position.y, nodes.velocity.x, nodes.velocity.y},
                 &records->x);
}

/// The slots that nodes of a pair need, from lane `lane` on.
template <class T> PORTABLE int slots_of(const GroupPair &pair, int lane) {
    if (T::width < pair_size) return pair.slots[lane / group_size];
    return pair.slots[0] < pair.slots[1] ? pair.slots[1] : pair.slots[0];
}

/// The forces of springs and pressure on some nodes of a pair, from lane `lane` on, added to `force`.
template <class T>
PORTABLE Vec2<T> add_fan(const StepTask &task, const GroupPair &pair, int lane, const Record *now,
                         const Nodes<T> &self, Vec2<T> force) {
    const T stiffness(task.stiffness), damping(task.damping), knot_steps(task.knot_steps);
    Vec2<T> before = load_nodes<T>(now, pair.last + lane).position - self.position;
    const auto spring_in = [&](const Slot &slot) {
        const Nodes<T> other = load_nodes<T>(now, slot.neighbour + lane);
        return spring_to(other.position - self.position, other.velocity - self.velocity);
    };
    const auto add = [&](const Spring<T> &spring, const Slot &slot) {
        const T pull = load<T>(slot.pull + lane) + knot_steps * load<T>(slot.pull_change + lane);
        force += spring_force(spring, stiffness, pull, damping);
        const Pressure<T> pressure{load<T>(slot.twice_area + lane), load<T>(slot.pressure_slope + lane)};
        force += pressure_force(before, spring.offset, pressure);
        before = spring.offset;
    };

    // Each root and division is begun a slot before its result is needed.
    const Slot *slot = task.slots + pair.first_slot, *const end = slot + slots_of<T>(pair, lane);
    if (slot == end) return force;
    Spring<T> spring = spring_in(*slot);
    for (; slot + 1 != end; ++slot) {
        const Spring<T> next = spring_in(slot[1]);
        add(spring, *slot);
        spring = next;
    }
    add(spring, *slot);
    return force;
}

/// A ground of several pieces as its laws read it.
struct GroundLine {
    const Piece<float> *pieces;
    int count;

    PORTABLE int size() const { return count; }
    PORTABLE const Piece<float> &operator[](int i) const { return pieces[i]; }
};

/// The velocity after contact with level ground.
template <class T> PORTABLE Vec2<T> contact_with_level(const StepTask &task, Vec2<T> position, Vec2<T> v) {
    const T time_step(task.time_step);
    const auto &[point, normal] = task.ground->plane;
    const GroundPlane<T> ground{{point.x, point.y}, {normal.x, normal.y}};
    // Most nodes are above it together.
    if (any_of<T>(height_above(ground, position, v, time_step) < T(0)))
        v = ground_contact(position, v, ground, T(task.friction), time_step);
    return v;
}

/// The velocity after contact with ground of several pieces, of nodes from `first` on: node after node.
template <class T>
PORTABLE Vec2<T> contact_with_line(const StepTask &task, int first, Vec2<T> position, Vec2<T> v) {
    using One = Lanes<1>;
    const GroundLine line{task.ground, task.pieces};
    const One friction(task.friction), time_step(task.time_step);
    float x[T::width], y[T::width], vx[T::width], vy[T::width];
    store(position.x, x), store(position.y, y), store(v.x, vx), store(v.y, vy);
    for (int lane = 0; lane < T::width; ++lane) {
        const Vec2<One> at{x[lane], y[lane]};
        int &below = task.below[first + lane];
        below = piece_below(line, at.x, below);
        const Vec2<One> after =
            contact_on_way(line, below, at, Vec2<One>{vx[lane], vy[lane]}, friction, time_step);
        vx[lane] = after.x.value, vy[lane] = after.y.value;
    }
    return {load<T>(vx), load<T>(vy)};
}

/// The velocity after contact with walls, node after node.
template <class T> Vec2<T> contact_with_walls(const StepTask &task, Vec2<T> position, Vec2<T> v) {
    using One = Lanes<1>;
    const One time_step(task.time_step);
    float x[T::width], y[T::width], vx[T::width], vy[T::width];
    store(position.x, x), store(position.y, y), store(v.x, vx), store(v.y, vy);
    for (int lane = 0; lane < T::width; ++lane) {
        const Vec2<One> at{x[lane], y[lane]}, velocity{vx[lane], vy[lane]};
        const Vec2<One> after = planula::contact_with_walls(task.wall_grid, at, velocity, time_step);
        vx[lane] = after.x.value, vy[lane] = after.y.value;
    }
    return {load<T>(vx), load<T>(vy)};
}

/// What gravity adds to the velocity of nodes where it is tilted or water carries them.
template <class T> PORTABLE Vec2<T> gravity_in_step(const Gravity &gravity, Vec2<T> position) {
    return Vec2<T>{gravity.x, gravity.y} * gravity_share(position.y, gravity.layers, gravity.layer_count);
}

/// Nodes and the forces on them.
template <class T> struct Forced {
    Nodes<T> nodes;
    Vec2<T> force;
    int first; // node
};

/// Moves nodes by a step: semi-implicit Euler with the ground in between (decision 0008). Returns their velocity.
/// `anywhere`: gravity may be tilted or differ from place to place, and there may be walls.
template <class T, bool anywhere>
PORTABLE Vec2<T> advance(const StepTask &task, const Forced<T> &forced, Record *next) {
    const T time_step(task.time_step), slowing(task.slowing), fall(task.fall);
    const auto &[position, velocity] = forced.nodes;
    Vec2<T> v = (velocity + forced.force * time_step) * slowing;
    if (anywhere && task.gravity)
        v += gravity_in_step(*task.gravity, position);
    else
        v.y = v.y - fall;
    if (task.pieces == 1)
        v = contact_with_level(task, position, v);
    else if (task.pieces > 1)
        v = contact_with_line(task, forced.first, position, v);
    if constexpr (anywhere)
        if (task.pieces == walls) v = contact_with_walls(task, position, v);
    store_nodes<T>({position + v * time_step, v}, next + forced.first);
    return v;
}

template <class T, bool anywhere>
[[gnu::flatten]] StepResult step(const StepTask &task, const Record *now, Record *next) {
    const T limit(task.squared_limit);
    T fastest(0);
    auto within = fastest <= limit;
    const auto finish = [&](const Forced<T> &forced) {
        // The guard (rule B7); NaN counts as over the limit.
        const T squared = squared_length(advance<T, anywhere>(task, forced, next));
        within = within & (squared <= limit);
        fastest = max(fastest, squared);
    };
    const auto forced_at = [&](int first) -> Forced<T> {
        const Nodes<T> self = load_nodes<T>(now + first);
        const Vec2<T> push{load<T>(task.push_x + first), load<T>(task.push_y + first)};
        return {self, add_fan(task, task.pairs[first / pair_size], first % pair_size, now, self, push),
                first};
    };

    // Nodes are moved once the forces on the next ones are summed, so that the two chains of operations overlap.
    const int end = task.groups * group_size;
    if (end == 0) return {};
    Forced<T> forced = forced_at(0);
    for (int first = T::width; first < end; first += T::width) {
        const Forced<T> next_forced = forced_at(first);
        finish(forced);
        forced = next_forced;
    }
    finish(forced);
    return {-least_of(-fastest), !all_of<T>(within)};
}

/// Half the drag of a fluid on some outline links of a group, from lane `lane` on, to their records.
template <class T>
PORTABLE void drag_on_links(const OutlineGroup &links, int lane, const Record *now, Fluid<T> fluid,
                            Force *half) {
    const Nodes<T> a = load_nodes<T>(now, links.a + lane), b = load_nodes<T>(now, links.b + lane);
    const Vec2<T> through = (a.velocity + b.velocity) * T(0.5) - fluid.flow;
    const Vec2<T> own = drag_force(b.position - a.position, through, fluid.normal, fluid.tangential) * T(0.5);
    store_fields(Fields<T>{own.x, own.y, own.x, own.y}, &half->x);
}

/// The middle of some outline links.
template <class T> Vec2<T> middles(const OutlineGroup &links, int lane, const Record *now) {
    const Vec2<T> a = load_nodes<T>(now, links.a + lane).position;
    const Vec2<T> b = load_nodes<T>(now, links.b + lane).position;
    return (a + b) * T(0.5);
}

/// What the k-th link of some nodes has in `half`, from lane `lane` of their group on.
template <class T> PORTABLE Vec2<T> drag_of_link(const LinkGroup &link, int lane, const Force *half) {
    const auto at = load_fields<T>([&](int j) { return &half->x + link.link[lane + j]; });
    return {at.a, at.b};
}

template <class T, bool in_regions>
[[gnu::flatten]] void drag(const DragTask &task, const Record *now, Force *half, float *push_x,
                           float *push_y) {
    const Fluid<T> open{task.normal, task.tangential, {task.flow_x, task.flow_y}};
    for (int i = 0; i < task.group_count; ++i)
        for (int lane = 0; lane < group_size; lane += T::width) {
            const OutlineGroup &links = task.outline[i];
            Fluid<T> fluid = open;
            if constexpr (in_regions)
                fluid = fluid_at(middles<T>(links, lane, now), open, task.regions, task.region_count);
            drag_on_links(links, lane, now, fluid, half + i * group_size + lane);
        }

    const LinkGroup *link = task.links_at;
    for (int i = 0; i < task.node_groups; ++i, link += task.links_per_node)
        for (int lane = 0; lane < group_size; lane += T::width) {
            Vec2<T> sum{0, 0};
            for (int k = 0; k < task.links_per_node; ++k) sum += drag_of_link<T>(link[k], lane, half);
            store(sum.x, push_x + i * group_size + lane), store(sum.y, push_y + i * group_size + lane);
        }
}

/// Leaves the last knot for the next in a slot of some nodes, from lane `lane` on, that lengthen their springs by `own`.
/// `per_step`: the share of the way in a step.
template <class T>
PORTABLE void reach_knot_in(Slot &slot, int lane, T own, const Extension *extension, T per_step) {
    const T other = load_fields<T>([&](int j) { return extension->own + slot.neighbour[lane + j]; }).a;
    const T from = load<T>(slot.next_pull + lane);
    const T to = actuated_length(load<T>(slot.natural_pull + lane), own, other);
    store(from, slot.pull + lane);
    store((to - from) * per_step, slot.pull_change + lane);
    store(to, slot.next_pull + lane);
}

template <class T> [[gnu::flatten]] void reach_knot(const KnotTask &task, Slot *slots) {
    const T per_step = T(1) / T(task.steps);
    for (int first = 0; first < task.pair_count * pair_size; first += T::width) {
        const GroupPair &pair = task.pairs[first / pair_size];
        const int lane = first % pair_size;
        const T own = load_fields<T>([&](int j) { return task.extension[first + j].own; }).a;
        Slot *slot = slots + pair.first_slot;
        for (Slot *const end = slot + slots_of<T>(pair, lane); slot != end; ++slot)
            reach_knot_in(*slot, lane, own, task.extension, per_step);
    }
}

template <class T> [[gnu::flatten]] float squared_motion(const Record *then, const Record *now, int count) {
    // Records as they lie: lanes hold x, y, vx, vy in turn.
    constexpr int vectors = T::width < 4 ? 4 / T::width : 1, floats = vectors * T::width;
    T low[vectors], high[vectors];
    for (int k = 0; k < vectors; ++k) low[k] = T(__builtin_inff()), high[k] = T(-__builtin_inff());
    for (int i = 0; i < 4 * count; i += floats)
        for (int k = 0; k < vectors; ++k) {
            const int place = i + k * T::width;
            const T moved = load<T>(&now->x + place) - load<T>(&then->x + place);
            low[k] = min(low[k], moved), high[k] = max(high[k], moved);
        }

    // Over all records of a vector.
    float lows[floats], highs[floats], range[2];
    for (int k = 0; k < vectors; ++k)
        store(low[k], lows + k * T::width), store(high[k], highs + k * T::width);
    for (int axis = 0; axis < 2; ++axis) {
        for (int i = axis + 4; i < floats; i += 4) {
            if (lows[i] < lows[axis]) lows[axis] = lows[i];
            if (highs[i] > highs[axis]) highs[axis] = highs[i];
        }
        range[axis] = highs[axis] - lows[axis];
    }
    return range[0] * range[0] + range[1] * range[1];
}

/// The circle of all points nearer to a link than `reach`, or a little more.
template <class T> struct Circle {
    Vec2<T> middle;
    T squared_radius;
};
template <class T>
PORTABLE Circle<T> circle_around(const OutlineGroup &links, int lane, const Record *now, float reach) {
    const Vec2<T> a = load_nodes<T>(now, links.a + lane).position;
    const Vec2<T> b = load_nodes<T>(now, links.b + lane).position;
    const T radius = T(0.5) * sqrt(squared_length(b - a)) + T(reach);
    return {(a + b) * T(0.5), radius * radius};
}

template <class T>
[[gnu::flatten]] void circle_links(const OutlineGroup *links, int group_count, const Record *now, float reach,
                                   float *x, float *y, float *squared_radius) {
    for (int i = 0; i < group_count; ++i)
        for (int lane = 0; lane < group_size; lane += T::width) {
            const Circle<T> circle = circle_around<T>(links[i], lane, now, reach);
            const int place = i * group_size + lane;
            store(circle.middle.x, x + place), store(circle.middle.y, y + place);
            store(circle.squared_radius, squared_radius + place);
        }
}

template <class T>
[[gnu::flatten]] void find_circles(const Circles &circles, const Record *now, const Place *nodes,
                                   int node_count, Word *inside) {
    for (const Place *node = nodes; node != nodes + node_count; ++node) {
        const float *record = &now->x + *node;
        const Vec2<T> p{record[0], record[1]};
        for (int first = 0; first < circles.group_count; first += groups_per_word, ++inside) {
            Word bits = 0;
            for (int i = first; i < circles.group_count && i < first + groups_per_word; ++i)
                for (int lane = 0; lane < group_size; lane += T::width) {
                    const int place = i * group_size + lane;
                    const Vec2<T> middle{load<T>(circles.x + place), load<T>(circles.y + place)};
                    const T squared_radius = load<T>(circles.squared_radius + place);
                    const Word some = bits_of<T>(squared_length(p - middle) < squared_radius);
                    bits |= some << ((i - first) * group_size + lane);
                }
            *inside = bits;
        }
    }
}

/// Squared distances of pairs of a group, from lane `lane` on.
template <class T> PORTABLE T squared_distances(const PairGroup &pairs, int lane, const Record *now) {
    const Vec2<T> p = load_nodes<T>(now, pairs.cell + lane).position;
    const Vec2<T> a = load_nodes<T>(now, pairs.a + lane).position;
    const Vec2<T> b = load_nodes<T>(now, pairs.b + lane).position;
    return squared_length(p - foot_on_segment(p, a, b).point);
}

template <class T>
[[gnu::flatten]] float measure_pairs(const PairGroup *pairs, int group_count, const Record *now,
                                     float squared_distance, unsigned char *near) {
    T least(__builtin_inff());
    for (int i = 0; i < group_count; ++i) {
        unsigned bits = 0;
        for (int lane = 0; lane < group_size; lane += T::width) {
            const T squared = squared_distances<T>(pairs[i], lane, now);
            bits |= bits_of<T>(squared < T(squared_distance)) << lane;
            least = min(least, squared);
        }
        near[i] = static_cast<unsigned char>(bits);
    }
    return least_of(least);
}

/// `Pair`: lanes for what works on slots, up to those of a pair; the rest works on groups.
template <class T, class Pair = T> Kernel kernel_of(const char *name) {
    return {name,
            step<Pair, false>,
            step<Pair, true>,
            drag<T, false>,
            drag<T, true>,
            reach_knot<Pair>,
            squared_motion<T>,
            circle_links<T>,
            find_circles<T>,
            measure_pairs<T>};
}

} // namespace

} // namespace planula::native
