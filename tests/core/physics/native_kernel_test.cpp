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

/// Nodes off their places, most of them moving, twins as their node.
std::vector<native::Record> stirred(const SoftBodyModel &model, const native::Layout &layout) {
    std::vector<native::Record> records;
    for (const int cell : layout.cell_of) {
        const auto wave = [&](double phase) { return static_cast<float>(math::sin(7.1 * cell + phase)); };
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

} // namespace

BOOST_AUTO_TEST_CASE(drag_is_summed_per_node_in_the_order_of_links_to_the_bit) {
    int most = 0;
    for (const Body &body : {bow_tie(), hook(), spiral_body(1), two_arms(3), lattice(2, 1), lattice(9, 8)}) {
        const auto model = embody(body, water(), Parameters{});
        const auto layout = native::lay_out(model);
        const auto now = stirred(model, layout);
        most = std::max(most, layout.links_per_node);
        const int first_group = layout.first_outline_node / native::group_size;
        const native::DragTask task{layout.outline.data(),
                                    static_cast<int>(layout.outline.size()),
                                    layout.links_at.data(),
                                    static_cast<int>(layout.groups.size()) - first_group,
                                    layout.links_per_node,
                                    1,
                                    0.1f,
                                    0.5f,
                                    -0.25f};
        std::vector<Vec2f> expected = plain_sum(task, layout.model, now);
        for (std::size_t twin = layout.nodes; twin < now.size(); ++twin)
            expected[twin] = expected[layout.nodes - 1];

        for (const native::Kernel &kernel : native::kernels()) {
            std::vector<native::Force> half(layout.outline.size() * native::group_size + 1);
            std::vector<float> push_x(now.size()), push_y(now.size());
            const int first = first_group * native::group_size;
            kernel.drag(task, now.data(), half.data(), &push_x[first], &push_y[first]);
            const auto bits = [](float number) { return std::bit_cast<std::uint32_t>(number); };
            for (std::size_t node = 0; node < now.size(); ++node) {
                BOOST_TEST(bits(push_x[node]) == bits(expected[node].x), kernel.name << ", node " << node);
                BOOST_TEST(bits(push_y[node]) == bits(expected[node].y), kernel.name << ", node " << node);
            }
        }
    }
    BOOST_TEST(most == 5);
}
