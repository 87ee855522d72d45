// SPDX-License-Identifier: MIT
// Self-collision of whole bodies: the list misses nothing, the forces are internal, and arms do not pass
// through each other.
#include "physics/self_contact.h"

#include "base/math.h"
#include "physics/embody.h"
#include "physics/forces.h"
#include "physics/laws/contact.h"
#include "physics/laws/ground.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using namespace planula;
using namespace planula::specimens;

namespace {

/// The native engine's step, in double, on a body that starts with velocities of its own.
struct Collision {
    Collision(const SoftBodyModel &body, const Environment &world) : model(body), environment(world) {
        forces.load(model, environment);
        position = model.positions;
        velocity.resize(position.size());
        force.resize(position.size());
    }
    void step(double damping = 0) {
        const double dt = model.time_step;
        forces.compute(model.rest_lengths, position, velocity, force);
        for (std::size_t i = 0; i < position.size(); ++i) {
            Vec2d v = (velocity[i] + force[i] * dt) * (1 - damping * dt);
            v.y -= environment.gravity * dt;
            if (environment.has_ground)
                v = ground_contact(position[i], v, GroundPlane<double>{}, environment.friction, dt);
            velocity[i] = v;
            position[i] += v * dt;
        }
    }
    /// Its left and its right half approach each other at this speed.
    void close(double speed) {
        for (std::size_t i = 0; i < position.size(); ++i)
            velocity[i].x = (model.positions[i].x < 0 ? 0.5 : -0.5) * speed;
    }
    double fastest() const {
        double most = 0;
        for (const Vec2d v : velocity) most = std::max(most, length(v));
        return most;
    }

    const SoftBodyModel &model;
    const Environment &environment;
    Forces<double> forces;
    std::vector<Vec2d> position, velocity, force;
};

/// Whether two segments cross in their interiors.
bool cross_each_other(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
    const auto side = [](Vec2d p, Vec2d q, Vec2d r) { return cross(q - p, r - p) > 0; };
    return side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
}

/// Pairs of outline links without a common end that cross; those of bare chains may be left out.
int crossings(const SoftBodyModel &model, const std::vector<Vec2d> &x, bool chains_too = false) {
    int count = 0;
    for (const OutlineLink &one : model.outline)
        for (const OutlineLink &two : model.outline) {
            if (!chains_too && !(one.solid && two.solid)) continue;
            if (one.a == two.a || one.a == two.b || one.b == two.a || one.b == two.b) continue;
            count += cross_each_other(x[one.a], x[one.b], x[two.a], x[two.b]);
        }
    return count / 2;
}

/// How deep the deepest contact cell lies inside the body: its distance to the nearest outline link that may
/// push it; 0 if none is inside.
double deepest(const SoftBodyModel &model, const std::vector<Vec2d> &x) {
    double depth = 0;
    for (std::size_t i = 0; i < model.contact_cells.size(); ++i) {
        const int cell = model.contact_cells[i];
        const bool inside =
            std::any_of(model.triangles.begin(), model.triangles.end(), [&](const Triangle &t) {
                const auto left = [&](int p, int q) { return cross(x[q] - x[p], x[cell] - x[p]) > 0; };
                return left(t.a, t.b) && left(t.b, t.c) && left(t.c, t.a);
            });
        if (!inside) continue;
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < model.outline.size(); ++j) {
            if (model.is_masked(i, j)) continue;
            const auto foot = foot_on_segment(x[cell], x[model.outline[j].a], x[model.outline[j].b]);
            nearest = std::min(nearest, length(x[cell] - foot.point));
        }
        depth = std::max(depth, nearest);
    }
    return depth;
}

/// Outline links without a body, and the last node as the only contact cell.
SoftBodyModel loose_links(std::vector<Vec2d> positions, std::vector<OutlineLink> outline) {
    SoftBodyModel model;
    model.contact_cells = {static_cast<int>(positions.size()) - 1};
    model.masked.assign(outline.size(), 0);
    model.positions = std::move(positions), model.outline = std::move(outline);
    return model;
}

std::vector<Vec2d> contact_forces(const SoftBodyModel &model) {
    SelfContact<double> contact;
    contact.load(model);
    std::vector<Vec2d> forces(model.positions.size());
    contact.add_forces(model.positions, forces);
    return forces;
}

struct Passage {
    double deepest = 0; // over the whole time
    int crossed = 0;    // pairs of outline links, at the end
    int contacts = 0;   // steps at which a contact pushes
};

/// What happens in the 10 t.u. after the body's halves run into each other at this speed.
Passage collide(const Body &body, const Environment &environment, double speed,
                const Parameters &parameters = {}) {
    const auto model = soft_body(body, environment, parameters);
    Collision collision(model, environment);
    collision.close(speed);
    SelfContact<double> contact;
    contact.load(model);
    Passage passage;
    for (int t = 0; t < 1000; ++t) {
        collision.step();
        passage.deepest = std::max(passage.deepest, deepest(model, collision.position));
        std::vector<Vec2d> push(model.positions.size());
        contact.add_forces(collision.position, push);
        passage.contacts += std::any_of(push.begin(), push.end(), [](Vec2d f) { return f != Vec2d{}; });
    }
    passage.crossed = crossings(model, collision.position, body.mesh.triangles.empty());
    return passage;
}

} // namespace

BOOST_AUTO_TEST_CASE(listed_contacts_are_those_of_a_search_over_all_pairs_to_the_bit) {
    // A hook whose ends are forced together; a skin larger than the body lists every pair.
    const auto model = soft_body(hook(), water());
    SelfContact<float> listed, exhaustive(1000);
    listed.load(model), exhaustive.load(model);
    int hits = 0;
    for (int t = 0; t < 400; ++t) {
        std::vector<Vec2f> x;
        for (std::size_t i = 0; i < model.positions.size(); ++i) {
            const double squeeze = 0.004 * t, wave = 0.05 * math::sin(0.1 * t + static_cast<double>(i));
            const Vec2d p = model.positions[i];
            x.push_back({static_cast<float>(p.x * (1 - squeeze * 0.3) + wave),
                         static_cast<float>(p.y * (1 - squeeze * 0.6))});
        }
        std::vector<Vec2f> few(x.size()), all(x.size());
        listed.add_forces(x, few);
        exhaustive.add_forces(x, all);
        BOOST_REQUIRE((few == all));
        hits += std::any_of(all.begin(), all.end(), [](Vec2f f) { return f != Vec2f{}; });
    }
    BOOST_TEST(hits > 20);
}

BOOST_AUTO_TEST_CASE(contact_forces_are_internal) {
    const auto model = soft_body(hook(), water());
    SelfContact<float> contact;
    contact.load(model);
    std::vector<Vec2f> x, forces(model.positions.size());
    for (const Vec2d p : model.positions)
        x.push_back({static_cast<float>(0.55 * p.x), static_cast<float>(0.08 * p.y)});
    contact.add_forces(x, forces);
    Vec2f sum;
    float size = 0;
    for (const Vec2f f : forces) sum += f, size += length(f);
    BOOST_TEST(size > 1);
    BOOST_TEST(length(sum) < 1e-5f * size);
}

BOOST_AUTO_TEST_CASE(every_link_in_reach_pushes) {
    const auto model =
        loose_links({{-1, 0.2}, {1, 0.2}, {1, -0.3}, {-1, -0.3}, {0, 0}}, {{0, 1, true}, {2, 3, true}});
    const auto forces = contact_forces(model);
    const auto near = boost::test_tools::tolerance(1e-12);
    BOOST_TEST(forces[0].y == 0.5 * 1600 * 0.15, near);
    BOOST_TEST(forces[2].y == -0.5 * 1600 * 0.05, near);
    BOOST_TEST(forces[4].y == 1600 * (0.05 - 0.15), near);
    BOOST_TEST((forces[0] == forces[1]));
    BOOST_TEST((forces[2] == forces[3]));
}

BOOST_AUTO_TEST_CASE(contact_takes_what_it_gives_whatever_path_a_cell_takes) {
    // A cell is led around the corner of two links, over their ends and through them, on closed paths. One of the
    // links is masked for it, or neither; the law must not tell inside from outside by that.
    for (const bool masked : {false, true}) {
        auto model = loose_links({{-1, 0}, {0, 0}, {0, -1}, {0, 0}}, {{0, 1, true}, {1, 2, true}});
        model.masked[1] = masked;
        SelfContact<double> contact;
        contact.load(model);
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
                std::vector<Vec2d> forces(x.size());
                contact.add_forces(x, forces);
                work += dot(forces[3], to - from), turnover += std::abs(dot(forces[3], to - from));
            }
            BOOST_TEST(turnover > 1, "path " << path);
            BOOST_TEST(std::abs(work) < 2e-3 * turnover, "path " << path << ", masked " << masked);
        }
    }
}

BOOST_AUTO_TEST_CASE(arms_two_cells_wide_do_not_pass_through_each_other) {
    // Two cells are the least width that makes triangles, and from there on the rule holds.
    for (const bool on_land : {false, true})
        for (const double speed : {2.0, 5.0, 10.0, 20.0})
            for (const Body &body : {u_body(2), spiral_body(2), two_arms(2), u_body(3), two_arms(3)}) {
                const Passage passage = collide(body, on_land ? land() : water(), speed);
                BOOST_TEST(passage.deepest == 0, body.cells() << " cells at " << speed);
                BOOST_TEST(passage.crossed == 0, body.cells() << " cells at " << speed);
                BOOST_TEST((passage.contacts > 0 || speed < 5), body.cells() << " cells at " << speed);
            }
}

BOOST_AUTO_TEST_CASE(a_bare_chain_passes) {
    for (const Body &body : {u_body(1), spiral_body(1)}) {
        BOOST_TEST(body.mesh.triangles.empty());
        BOOST_TEST(soft_body(body, land()).contact_cells.empty());
        const Passage passage = collide(body, land(), 5);
        BOOST_TEST(passage.contacts == 0);
        BOOST_TEST(passage.crossed > 0);
    }
}

BOOST_AUTO_TEST_CASE(without_contact_the_same_arms_pass) {
    // The measure of passing can fail.
    Parameters parameters;
    parameters.body.contact_stiffness = 0;
    for (const Body &body : {u_body(2), two_arms(2)}) {
        const Passage passage = collide(body, water(), 10, parameters);
        BOOST_TEST(passage.deepest > 0.3);
    }
}

BOOST_AUTO_TEST_CASE(what_has_collided_comes_to_rest) {
    // Contact itself does not damp, and does not pump: with the damping of settling all motion dies.
    for (const Body &body : {u_body(2), two_arms(2), u_body(3), two_arms(3)}) {
        const Environment environment = land();
        const auto model = soft_body(body, environment);
        Collision collision(model, environment);
        collision.close(10);
        const SettlingParameters settling;
        for (int t = 0; t < settling.settle_limit; ++t) collision.step(settling.settle_damping);
        BOOST_TEST(collision.fastest() < settling.settle_speed, body.cells() << " cells");
    }
}
