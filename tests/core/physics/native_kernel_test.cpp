// SPDX-License-Identifier: MIT
// The inner loops of the native engine against plain ones.
#include "physics/native/kernel.h"

#include "base/math.h"
#include "physics/embody.h"
#include "physics/laws/drag.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>

using namespace planula;
using namespace planula::specimens;

namespace {

/// Two triangles that share a corner, from which a lone link goes upward: a node on five outline links.
Body bow_tie() { return make_body({{0, 0}, {-1, 0.3}, {-1, -0.3}, {1, 0.3}, {1, -0.3}, {0, 1.2}}, 1.3); }

/// Nodes off their places, most of them moving, copies as their node.
std::vector<native::Record> stirred(const SoftBodyModel &model, const native::Layout &layout, int sample) {
    std::vector<native::Record> records;
    for (const int cell : layout.cell_of) {
        const auto wave = [&](double phase) {
            return static_cast<float>(math::sin(7.1 * cell + 0.3 * sample + phase));
        };
        const Vec2d p = model.positions[cell];
        const bool moves = cell % 4 != 3;
        records.push_back({static_cast<float>(p.x) + 0.1f * wave(0), static_cast<float>(p.y) + 0.1f * wave(1),
                           moves ? wave(2) : 0, moves ? wave(3) : 0});
    }
    return records;
}

/// Link after link, half of its drag to either end.
std::vector<Vec2f> plain_sum(const native::DragTask &task, const SoftBodyModel &model,
                             const std::vector<native::Record> &now) {
    std::vector<Vec2f> result(now.size());
    for (const OutlineLink &link : model.outline) {
        const native::Record &a = now[link.a], &b = now[link.b];
        const Vec2f edge{b.x - a.x, b.y - a.y};
        const Vec2f through = Vec2f{a.vx + b.vx, a.vy + b.vy} * 0.5f - Vec2f{task.flow_x, task.flow_y};
        const Vec2f half = drag_force(edge, through, task.normal, task.tangential) * 0.5f;
        result[link.a] += half, result[link.b] += half;
    }
    return result;
}

/// A current across the outline of a body.
native::DragTask drag_on(const native::Layout &layout) {
    return {.outline = layout.outline.data(),
            .group_count = static_cast<int>(layout.outline.size()),
            .links_at = layout.links_at.data(),
            .node_groups = layout.outline_groups(),
            .links_per_node = layout.links_per_node,
            .normal = 1,
            .tangential = 0.1f,
            .flow_x = 0.5f,
            .flow_y = -0.25f};
}

/// What the kernel pushes each node with.
std::vector<Vec2f> pushes(const native::Kernel &kernel, const native::DragTask &task,
                          const native::Layout &layout, const std::vector<native::Record> &now) {
    std::vector<native::Force> half(layout.outline.size() * native::group_size + 1);
    std::vector<float> x(now.size()), y(now.size());
    const int first = layout.outline_group() * native::group_size;
    kernel.drag(task, now.data(), half.data(), &x[first], &y[first]);
    std::vector<Vec2f> result;
    for (std::size_t node = 0; node < now.size(); ++node) result.push_back({x[node], y[node]});
    return result;
}

bool same_bits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

} // namespace

BOOST_AUTO_TEST_CASE(drag_is_summed_per_node_in_the_order_of_links_to_the_bit) {
    int most = 0;
    for (const Body &body : {bow_tie(), hook(), spiral_body(1), two_arms(3), lattice(2, 1), lattice(9, 8)}) {
        const auto model = soft_body(body, water());
        const auto layout = native::lay_out(model);
        const native::DragTask task = drag_on(layout);
        most = std::max(most, task.links_per_node);
        for (int sample = 0; sample < 20; ++sample) {
            const auto now = stirred(model, layout, sample);
            std::vector<Vec2f> expected = plain_sum(task, layout.model, now);
            for (std::size_t copy = layout.nodes; copy < now.size(); ++copy)
                expected[copy] = expected[layout.nodes - 1];
            for (const native::Kernel &kernel : native::kernels()) {
                const std::vector<Vec2f> found = pushes(kernel, task, layout, now);
                BOOST_TEST(std::ranges::equal(
                               found, expected,
                               [](Vec2f a, Vec2f b) { return same_bits(a.x, b.x) && same_bits(a.y, b.y); }),
                           kernel.name << ", sample " << sample);
            }
        }
    }
    BOOST_TEST(most == 5);
}
