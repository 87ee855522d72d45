// SPDX-License-Identifier: MIT
// The families of forces on whole bodies: those between nodes are internal, drag takes energy, contact returns what
// it took.
#include "physics/reference/forces.h"

#include "base/math.h"
#include "physics/embody.h"
#include "support/motion.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace planula;
using namespace planula::specimens;
using reference::Nodes;

namespace {

/// A family of forces, and whether it acts between the body's own nodes.
struct Family {
    const char *name;
    bool internal;
    std::function<void(std::span<Vec2d> forces)> add;
};

/// Outline links without a body, and the last node as the only contact cell.
SoftBodyModel loose_links(std::vector<Vec2d> positions, std::vector<OutlineLink> outline) {
    SoftBodyModel model;
    model.contact_cells = {static_cast<int>(positions.size()) - 1};
    model.masked.assign(outline.size(), 0);
    model.positions = std::move(positions), model.outline = std::move(outline);
    return model;
}

std::vector<Vec2d> contact_at(const SoftBodyModel &model, std::span<const Vec2d> positions) {
    std::vector<Vec2d> forces(positions.size());
    reference::add_contact(model, positions, forces);
    return forces;
}

std::vector<Vec2d> drag_at(const SoftBodyModel &model, const std::vector<Vec2d> &velocities) {
    std::vector<Vec2d> forces(velocities.size());
    reference::add_drag(model, water(), {model.positions, velocities}, forces);
    return forces;
}

} // namespace

BOOST_AUTO_TEST_CASE(each_family_of_inner_forces_has_no_resultant_and_no_torque) {
    // A ring squeezed until its ends overlap, in wild motion.
    const auto model = soft_body(hook(), water());
    Nodes nodes;
    for (std::size_t i = 0; i < model.positions.size(); ++i) {
        const double phase = static_cast<double>(i);
        nodes.positions.push_back(
            {0.55 * model.positions[i].x, 0.08 * model.positions[i].y + 0.1 * math::sin(phase)});
        nodes.velocities.push_back({3 * math::sin(2 * phase), 2 * math::cos(3 * phase)});
    }
    const auto &x = nodes.positions;
    const std::vector<double> lengths = lengths_under(swinging(model, 5), model);
    const Family families[] = {
        {"springs", true, [&](auto f) { reference::add_springs(model, lengths, nodes, f); }},
        {"pressure", true, [&](auto f) { reference::add_pressure(model, x, f); }},
        {"contact", true, [&](auto f) { reference::add_contact(model, x, f); }},
        {"drag", false, [&](auto f) { reference::add_drag(model, water(), nodes, f); }},
    };
    std::vector<Vec2d> sum(x.size());
    for (const auto &[name, internal, add] : families) {
        std::vector<Vec2d> forces(x.size());
        add(forces);
        Vec2d resultant;
        double torque = 0, scale = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            resultant += forces[i];
            torque += cross(x[i], forces[i]);
            scale += length(forces[i]);
            sum[i] += forces[i];
        }
        BOOST_TEST(scale > 1, name);
        BOOST_TEST((length(resultant) < 1e-12 * scale) == internal, name);
        BOOST_TEST((std::abs(torque) < 1e-12 * scale) == internal, name);
    }
    // All together they are the forces of a step.
    BOOST_TEST(farthest_apart(reference::forces_on(model, water(), lengths, nodes), sum) < 1e-9);
}

BOOST_AUTO_TEST_CASE(drag_only_takes_energy) {
    const auto model = soft_body(hook(), water());
    for (int sample = 0; sample < 50; ++sample) {
        std::vector<Vec2d> v;
        for (std::size_t i = 0; i < model.positions.size(); ++i)
            v.push_back({math::sin(sample + 2.0 * static_cast<double>(i)),
                         math::cos(3.0 * sample + static_cast<double>(i))});
        const auto forces = drag_at(model, v);
        double power = 0;
        for (std::size_t i = 0; i < v.size(); ++i) power += dot(forces[i], v[i]);
        BOOST_TEST(power < 0);
    }
}

BOOST_AUTO_TEST_CASE(the_drag_of_a_towed_chain_is_that_of_its_links) {
    // Across: λ_N L v²; along: λ_T L v², each link once.
    std::vector<Vec2d> line;
    for (int i = 0; i < 9; ++i) line.push_back({1.25 * i, 0}); // 10 long
    const Environment environment = water();
    const auto model = soft_body(make_body(line, 1.5), environment);
    for (const Vec2d v : {Vec2d{3, 0}, Vec2d{0, -2}, Vec2d{1, 2}}) {
        const auto forces = drag_at(model, std::vector<Vec2d>(line.size(), v));
        Vec2d total;
        for (const Vec2d f : forces) total += f;
        BOOST_TEST(total.x == -0.1 * 10 * v.x * std::abs(v.x), boost::test_tools::tolerance(1e-12));
        BOOST_TEST(total.y == -1.0 * 10 * v.y * std::abs(v.y), boost::test_tools::tolerance(1e-12));
        BOOST_TEST(length(forces[0] * 2.0 - forces[4]) < 1e-12); // half to each end
    }

    // Pulled at its head until drag and pull are equal: v = √(F / (λ_T L)), L its length under tension.
    const double pull = 20, dt = 0.01;
    Nodes nodes{model.positions, std::vector<Vec2d>(line.size())};
    auto &[x, v] = nodes;
    for (int t = 0; t < 10000; ++t) {
        auto forces = reference::forces_on(model, environment, model.rest_lengths, nodes);
        forces.back().x += pull;
        for (std::size_t i = 0; i < x.size(); ++i) v[i] += forces[i] * dt, x[i] += v[i] * dt;
    }
    const double expected = std::sqrt(pull / (0.1 * (x.back().x - x.front().x)));
    BOOST_TEST_MESSAGE("towed at " << v.front().x << ", expected " << expected);
    BOOST_TEST(v.front().x == expected, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(every_link_in_reach_pushes) {
    const auto model =
        loose_links({{-1, 0.2}, {1, 0.2}, {1, -0.3}, {-1, -0.3}, {0, 0}}, {{0, 1, true}, {2, 3, true}});
    const auto forces = contact_at(model, model.positions);
    const auto near = boost::test_tools::tolerance(1e-12);
    BOOST_TEST(forces[0].y == 0.5 * 1600 * 0.15, near);
    BOOST_TEST(forces[2].y == -0.5 * 1600 * 0.05, near);
    BOOST_TEST(forces[4].y == 1600 * (0.05 - 0.15), near);
    BOOST_TEST((forces[0] == forces[1]));
    BOOST_TEST((forces[2] == forces[3]));
}

BOOST_AUTO_TEST_CASE(contact_keeps_energy_on_any_closed_path_of_a_cell) {
    // A cell is led around the corner of two links, over their ends and through them, on closed paths. One of the
    // links is masked for it, or neither; the law must not tell inside from outside by that.
    for (const bool masked : {false, true}) {
        auto model = loose_links({{-1, 0}, {0, 0}, {0, -1}, {0, 0}}, {{0, 1, true}, {1, 2, true}});
        model.masked[1] = masked;
        for (int path = 0; path < 40; ++path) {
            const auto at = [&](double t) {
                const double angle = 2 * math::pi * t, size = 0.1 + 0.02 * path;
                return Vec2d{0.03 * path - 0.9 + size * math::cos(angle),
                             0.4 * size * math::sin((1 + path % 3) * angle)};
            };
            constexpr int steps = 20000;
            double work = 0, turnover = 0;
            for (int i = 0; i < steps; ++i) {
                const Vec2d from = at(double(i) / steps), to = at(double(i + 1) / steps);
                auto x = model.positions;
                x[3] = (from + to) * 0.5;
                const Vec2d force = contact_at(model, x)[3];
                work += dot(force, to - from), turnover += std::abs(dot(force, to - from));
            }
            BOOST_TEST(turnover > 1, "path " << path);
            BOOST_TEST(std::abs(work) < 2e-3 * turnover, "path " << path << ", masked " << masked);
        }
    }
}
