// SPDX-License-Identifier: MIT
// What a body does is the same wherever it is, turned and mirrored (rule R3; decisions 0008 and 0010).
#include "physics/engine.h"

#include "physics/embody.h"
#include "support/motion.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::specimens;

namespace {

/// By how much the centre of mass of a body that starts at `place`, on ground that is as high there, has moved after
/// it came to rest and swung for 500 steps.
Vec2d displacement(std::string_view name, std::vector<Vec2d> ground, Vec2d place) {
    const Environment environment{
        .gravity = 5, .has_ground = true, .ground = std::move(ground), .friction = 0.8};
    auto model = soft_body(lattice(7, 3), environment);
    for (Vec2d &p : model.positions) p.x += place.x;
    const auto engine = loaded(name, model, environment);
    double fastest = 0;
    for (int t = 0; t < 1500; ++t) fastest = engine->step(1).fastest;
    BOOST_TEST(fastest < 0.01, name);
    for (int t = 1; t <= 500; ++t) step_with(swinging(model, 0.01 * t), *engine);
    return centre_of_mass(engine->positions()) - place;
}

/// Where the nodes are after 200 steps of swinging in water.
std::vector<Vec2d> swung(std::string_view name, const SoftBodyModel &model) {
    const Environment environment = water();
    const auto engine = loaded(name, model, environment);
    for (int t = 1; t <= 200; ++t) step_with(swinging(model, 0.01 * t), *engine);
    return engine->positions();
}

} // namespace

BOOST_AUTO_TEST_CASE(motion_is_the_same_at_any_height_and_place) {
    for (const std::string_view name : engine_names()) {
        if (name == "bullet") continue; // Its slabs of ground end, and it does not count from the ground.
        const Vec2d expected = displacement(name, {}, {});
        BOOST_TEST(length(expected) > 0.5, name);
        for (const Vec2d place : {Vec2d{0, 5}, {0, 1e4}, {0, -1e6}, {1e4, 0}, {-3e5, 1e5}}) {
            const std::vector<Vec2d> level{{place.x - 50, place.y}, {place.x + 50, place.y}};
            BOOST_TEST(length(displacement(name, level, place) - expected) < 1e-3, name);
        }
        const Vec2d on_slope = displacement(name, {{-100, -20}, {100, 20}}, {});
        const Vec2d high = displacement(name, {{-100, 1e4 - 20}, {100, 1e4 + 20}}, {0, 1e4});
        BOOST_TEST(length(high - on_slope) < 1e-3, name);
    }
}

BOOST_AUTO_TEST_CASE(a_body_turned_by_quarter_turns_in_water_moves_turned_to_the_bit) {
    // Its ends collide on the way.
    const Environment environment = water();
    const SoftBodyModel model = soft_body(hook(), environment);
    for (const std::string_view name : engine_names()) {
        if (name == "bullet") continue; // It computes in three dimensions.
        int touching = 0;
        const auto moved = [&](const SoftBodyModel &body) {
            const auto engine = loaded(name, body, environment);
            for (int t = 1; t <= 1000; ++t) {
                BOOST_REQUIRE(!step_with(closing(body, 0.01 * t), *engine).exploded);
                touching += is_touching(body, engine->positions());
            }
            return engine->positions();
        };
        std::vector<Vec2d> expected = moved(model);
        BOOST_TEST(touching > 20, name);
        SoftBodyModel turned = model;
        for (int quarter = 1; quarter < 4; ++quarter) {
            for (Vec2d &p : turned.positions) p = {-p.y, p.x};
            for (Vec2d &p : expected) p = {-p.y, p.x};
            BOOST_TEST((moved(turned) == expected), name << ", " << quarter << " quarter turns");
        }
    }
}

BOOST_AUTO_TEST_CASE(a_mirrored_body_moves_mirrored) {
    // Over 200 steps, without self-contact: its sums have another order.
    Body body = lattice(7, 3);
    for (std::size_t i = 0; i < body.positions.size(); ++i) // no two equal cells, no ties
        body.positions[i] +=
            Vec2d{math::sin(static_cast<double>(i)), math::cos(2.0 * static_cast<double>(i))} * 0.05;
    std::vector<Vec2d> reflection = body.positions;
    for (Vec2d &p : reflection) p.x = -p.x;
    SoftBodyModel straight = soft_body(make_body(body.positions, 1.5), water());
    SoftBodyModel mirrored = soft_body(make_body(reflection, 1.5), water());
    BOOST_TEST((straight.links == mirrored.links));
    straight.body.contact_stiffness = mirrored.body.contact_stiffness = 0;
    for (const std::string_view name : engine_names()) {
        std::vector<Vec2d> expected = swung(name, straight);
        BOOST_TEST(farthest_apart(expected, straight.positions) > 0.05, name);
        for (Vec2d &p : expected) p.x = -p.x;
        const double apart = farthest_apart(swung(name, mirrored), expected);
        BOOST_TEST_MESSAGE(name << ": mirrored bodies differ by " << apart);
        BOOST_TEST(apart < (name == "native" ? 1e-4 : 1e-10), name);
    }
}
