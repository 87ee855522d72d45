// SPDX-License-Identifier: MIT
// Self-collision of whole bodies: arms do not pass through each other (rule B5; decision 0007).
#include "physics/reference/reference_engine.h"

#include "physics/embody.h"
#include "physics/laws/contact.h"
#include "support/motion.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <limits>
#include <utility>

using namespace planula;
using namespace planula::specimens;

namespace {

/// A body whose left and right halves approach each other at this speed, in the reference engine.
struct Collision {
    Collision(const SoftBodyModel &body, const Environment &environment, double speed) : model(body) {
        engine.load(model, environment);
        reference::Nodes nodes{model.positions, std::vector<Vec2d>(model.positions.size())};
        for (std::size_t i = 0; i < nodes.positions.size(); ++i)
            nodes.velocities[i].x = (model.positions[i].x < 0 ? 0.5 : -0.5) * speed;
        engine.set_nodes(std::move(nodes));
    }
    const SoftBodyModel &model;
    ReferenceEngine engine;
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

struct Passage {
    double deepest = 0;   // over the whole time
    int crossed = 0;      // pairs of outline links, at the end
    bool touched = false; // whether a contact ever pushed
};

/// What happens in the 10 t.u. after the body's halves run into each other at this speed.
Passage collide(const Body &body, const Environment &environment, double speed,
                const Parameters &parameters = {}) {
    const auto model = soft_body(body, environment, parameters);
    Collision collision(model, environment, speed);
    Passage passage;
    for (int t = 0; t < 1000; ++t) {
        collision.engine.step(0);
        const auto positions = collision.engine.positions();
        passage.deepest = std::max(passage.deepest, deepest(model, positions));
        passage.touched = passage.touched || is_touching(model, positions);
    }
    passage.crossed = crossings(model, collision.engine.positions(), body.mesh.triangles.empty());
    return passage;
}

} // namespace

BOOST_AUTO_TEST_CASE(arms_two_cells_wide_do_not_pass_through_each_other) {
    // Two cells are the least width that makes triangles, and from there on the rule holds.
    for (const bool on_land : {false, true})
        for (const double speed : {2.0, 5.0, 10.0, 20.0})
            for (const Body &body : {u_body(2), spiral_body(2), two_arms(2), u_body(3), two_arms(3)}) {
                const Passage passage = collide(body, on_land ? land() : water(), speed);
                BOOST_TEST(passage.deepest == 0, body.cells() << " cells at " << speed);
                BOOST_TEST(passage.crossed == 0, body.cells() << " cells at " << speed);
                BOOST_TEST((passage.touched || speed < 5), body.cells() << " cells at " << speed);
            }
}

BOOST_AUTO_TEST_CASE(a_bare_chain_passes) {
    for (const Body &body : {u_body(1), spiral_body(1)}) {
        BOOST_TEST(body.mesh.triangles.empty());
        BOOST_TEST(soft_body(body, land()).contact_cells.empty());
        const Passage passage = collide(body, land(), 5);
        BOOST_TEST(!passage.touched);
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

BOOST_AUTO_TEST_CASE(bodies_that_collided_with_themselves_come_to_rest) {
    // Contact itself neither damps nor gives energy: with the damping of settling all motion ends.
    for (const Body &body : {u_body(2), two_arms(2), u_body(3), two_arms(3)}) {
        const Environment environment = land();
        const auto model = soft_body(body, environment);
        Collision collision(model, environment, 10);
        double fastest = 0;
        const SettlingParameters settling;
        for (int t = 0; t < settling.settle_limit; ++t)
            fastest = collision.engine.step(settling.settle_damping).fastest;
        BOOST_TEST(fastest < settling.settle_speed, body.cells() << " cells");
    }
}
