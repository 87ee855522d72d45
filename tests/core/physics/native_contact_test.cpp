// SPDX-License-Identifier: MIT
// The native engine's search for contacts against one over all pairs.
#include "physics/native/contact.h"

#include "base/math.h"
#include "physics/embody.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

using namespace planula;
using namespace planula::specimens;

namespace {

/// A body squeezed more and more while it waves, turns a little and drifts: its nodes at time t.
std::vector<native::Record> squeezed(const SoftBodyModel &model, const native::Layout &layout, int t) {
    std::vector<native::Record> records;
    const double squeeze = 0.004 * (t < 200 ? t : 400 - t), turn = 0.002 * t;
    for (const int cell : layout.cell_of) {
        const double wave = 0.05 * math::sin(0.1 * t + cell);
        const Vec2d p{model.positions[cell].x * (1 - 0.8 * squeeze) + wave,
                      model.positions[cell].y * (1 - squeeze)};
        const double c = math::cos(turn), s = math::sin(turn);
        records.push_back(
            {static_cast<float>(c * p.x - s * p.y + 0.04 * t), static_cast<float>(s * p.x + c * p.y), 0, 0});
    }
    return records;
}

/// How far the farthest node has gone.
float farthest(const std::vector<native::Record> &from, const std::vector<native::Record> &to) {
    float result = 0;
    for (std::size_t i = 0; i < from.size(); ++i)
        result = std::max(result, length(Vec2f{to[i].x, to[i].y} - Vec2f{from[i].x, from[i].y}));
    return result;
}

constexpr float anywhere = std::numeric_limits<float>::infinity();

std::vector<Vec2f> summed(std::span<const native::Touch> touches, std::size_t nodes) {
    std::vector<Vec2f> forces(nodes);
    for (const auto &[cell, a, b, each] : touches)
        forces[cell] += each.on_cell, forces[a] += each.on_a, forces[b] += each.on_b;
    return forces;
}

/// The forces of all pairs, each measured.
std::vector<Vec2f> over_all_pairs(const SoftBodyModel &model, const std::vector<native::Record> &records) {
    const auto stiffness = static_cast<float>(model.body.contact_stiffness);
    const auto radius = static_cast<float>(model.body.contact_radius);
    const auto at = [&](int node) { return Vec2f{records[node].x, records[node].y}; };
    std::vector<Vec2f> forces(records.size());
    for (std::size_t i = 0; i < model.contact_cells.size(); ++i)
        for (std::size_t j = 0; j < model.outline.size(); ++j) {
            if (model.is_masked(i, j)) continue;
            const int cell = model.contact_cells[i], a = model.outline[j].a, b = model.outline[j].b;
            const auto each = contact_forces(at(cell), at(a), at(b), stiffness, radius);
            forces[cell] += each.on_cell, forces[a] += each.on_a, forces[b] += each.on_b;
        }
    return forces;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_touches_found_are_those_of_a_search_over_all_pairs_to_the_bit) {
    for (const native::Kernel &kernel : native::kernels()) {
        int hits = 0, quiet = 0;
        for (const Body &body : {hook(), two_arms(2), spiral_body(2)}) {
            const auto model = soft_body(body, water());
            const native::Layout layout = native::lay_out(model);
            native::Contact contact;
            contact.load(layout, kernel);
            std::vector<native::Record> records = squeezed(model, layout, 0);
            for (int t = 0; t < 400; ++t) {
                const auto before = std::exchange(records, squeezed(model, layout, t));
                const auto touches = contact.touches(records.data(), farthest(before, records));
                BOOST_REQUIRE((summed(touches, records.size()) == over_all_pairs(layout.model, records)));
                (touches.empty() ? quiet : hits) += 1;
            }
        }
        BOOST_TEST(hits > 40, kernel.name << ": " << hits);
        BOOST_TEST(quiet > 100, kernel.name << ": " << quiet);
    }
}

BOOST_AUTO_TEST_CASE(a_body_starts_without_the_list_of_the_one_before) {
    // The same search works on another body, and then on the first one again.
    const auto model = soft_body(hook(), water());
    const auto other = soft_body(two_arms(2), water());
    const native::Layout layout = native::lay_out(model), other_layout = native::lay_out(other);
    const auto records = squeezed(model, layout, 200);
    native::Contact contact;
    contact.load(layout, native::chosen_kernel());
    const auto first = contact.touches(records.data(), anywhere);
    const std::vector<native::Touch> expected(first.begin(), first.end());
    BOOST_TEST(!expected.empty());
    contact.load(other_layout, native::chosen_kernel());
    contact.touches(squeezed(other, other_layout, 0).data(), anywhere);
    contact.load(layout, native::chosen_kernel());
    const auto again = contact.touches(records.data(), anywhere);
    BOOST_TEST(std::equal(
        again.begin(), again.end(), expected.begin(), expected.end(), [](const auto &p, const auto &q) {
            return p.cell == q.cell && p.a == q.a && p.b == q.b && p.forces.on_cell == q.forces.on_cell;
        }));
}

BOOST_AUTO_TEST_CASE(parts_that_near_each_other_from_both_sides_are_found_when_they_touch) {
    // Two arms that lean against each other: their tips are the fastest nodes.
    const auto model = soft_body(two_arms(2), water());
    const native::Layout layout = native::lay_out(model);
    Vec2d low = model.positions[0], high = low;
    for (const Vec2d p : model.positions)
        low = {std::min(low.x, p.x), std::min(low.y, p.y)},
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    std::size_t found = 0;
    for (const double step : {0.013, 0.031, 0.07, 0.11}) {
        native::Contact contact;
        contact.load(layout, native::chosen_kernel());
        for (int t = 0; t * step < 1.8; ++t) {
            std::vector<native::Record> records;
            for (const int cell : layout.cell_of) {
                const Vec2d p = model.positions[cell];
                const double lean = std::max(0.0, (p.y - low.y - 3) / (high.y - low.y - 3)) *
                                    (2 * p.x < low.x + high.x ? 1 : -1);
                records.push_back({static_cast<float>(p.x + lean * step * t), static_cast<float>(p.y), 0, 0});
            }
            native::Contact fresh;
            fresh.load(layout, native::chosen_kernel());
            const auto touches = contact.touches(records.data(), static_cast<float>(step));
            BOOST_TEST(touches.size() == fresh.touches(records.data(), anywhere).size(), step << ", " << t);
            found += touches.size();
        }
    }
    BOOST_TEST(found > 100);
}
