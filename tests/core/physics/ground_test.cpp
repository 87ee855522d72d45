// SPDX-License-Identifier: MIT
// What a node meets on its way over ground of any form.
#include "physics/ground.h"

#include "base/math.h"
#include "base/random.h"
#include "support/print.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

using namespace planula;

namespace {

constexpr float far = std::numeric_limits<float>::infinity();

/// Pieces that count how often one is looked at.
struct Line {
    std::vector<Piece<float>> pieces;
    mutable long looks = 0;

    int size() const { return static_cast<int>(pieces.size()); }
    const Piece<float> &operator[](int i) const { return ++looks, pieces.at(static_cast<std::size_t>(i)); }
};

Line line_of(std::vector<Vec2d> points) {
    return {lay_ground<float>({.has_ground = true, .ground = std::move(points)}, {})};
}

int below(const Line &line, Vec2f p) { return piece_below(line, p.x, 0); }

int met(const Line &line, Vec2f start, Vec2f end) { return piece_met(line, below(line, start), start, end); }

/// How high a node is above the plane of the piece below it.
double height(const Line &line, Vec2f p) {
    const auto &plane = line.pieces[static_cast<std::size_t>(below(line, p))].plane;
    return dot(p - plane.point, plane.normal);
}

/// A point that falls and slides.
struct Node {
    Vec2f position, velocity;
    int piece = 0;

    /// One step, with a push beside its weight. Returns the gain of speed by contact.
    float step(const Line &line, Vec2f push, float friction, float dt) {
        const Vec2f before = velocity + (push + Vec2f{0, -5}) * dt;
        piece = piece_below(line, position.x, piece);
        velocity = contact_on_way(line, piece, position, before, friction, dt);
        position = position + velocity * dt;
        return length(velocity) - length(before);
    }
};

/// Random points from -20 to 20, some of them on upright walls or so near that they become equal by rounding.
std::vector<Vec2d> jagged(std::uint64_t seed) {
    Stream stream(seed, 0, 0, Purpose::initial_weights);
    std::vector<Vec2d> points{{-20, 5}};
    while (points.back().x < 20) {
        const double kind = stream.uniform();
        const double width = kind < 0.25 ? 1e-7 : kind < 0.5 ? 1e-3 : stream.uniform() * 2 + 1e-12;
        points.push_back({points.back().x + width, 2 * stream.uniform()});
    }
    points.push_back({points.back().x + 1, 5});
    return points;
}

} // namespace

BOOST_AUTO_TEST_CASE(ground_that_is_level_everywhere_is_one_piece) {
    BOOST_TEST(lay_ground<float>({}, {}).empty());
    for (const std::vector<Vec2d> &points :
         {std::vector<Vec2d>{}, {{-1, 0}, {1, 0}}, {{-20, 0}, {-3, 0}, {2, 0}, {20, 0}}}) {
        const Line line = line_of(points);
        BOOST_REQUIRE(line.size() == 1);
        BOOST_TEST(line[0].from.x == -far);
        BOOST_TEST(line[0].to.x == far);
        BOOST_TEST(line[0].plane.point.y == 0);
        BOOST_TEST((line[0].plane.normal == Vec2f{0, 1}));
    }
    const auto seen = lay_ground<float>({.has_ground = true, .ground = {{-1, 1e4}, {1, 1e4}}}, {0, 1e4 - 2});
    BOOST_TEST(seen.at(0).plane.point.y == 2);
}

BOOST_AUTO_TEST_CASE(pieces_join_their_points_and_go_on_level) {
    const Line line = line_of({{0, 0}, {4, 3}, {4 + 1e-9, 5}, {4 + 2e-9, 5}});
    BOOST_REQUIRE(line.size() == 4);
    for (int i = 1; i < line.size(); ++i) BOOST_TEST((line[i].from == line[i - 1].to));
    BOOST_TEST((line[0].from == Vec2f{-far, 0}));
    BOOST_TEST((line[1].plane.normal == Vec2f{-0.6f, 0.8f}));
    BOOST_TEST((line[1].plane.point == Vec2f{0, 0}));   // the nearest to the origin
    BOOST_TEST((line[2].plane.normal == Vec2f{-1, 0})); // upright in float; the points at its top are equal
    BOOST_TEST((line[3].from == Vec2f{4, 5}));
    BOOST_TEST((line[3].to == Vec2f{far, 5}));
}

BOOST_AUTO_TEST_CASE(the_piece_below_is_the_same_from_every_guess) {
    const Line line = line_of({{0, 0}, {1, 1}, {1 + 1e-9, 2}, {3, 0}});
    const std::pair<float, int> expected[] = {{-5, 0}, {0, 1}, {0.5, 1}, {1, 3}, {2.5, 3}, {3, 4}, {9, 4}};
    for (const auto &[x, piece] : expected)
        for (int guess = 0; guess < line.size(); ++guess)
            BOOST_TEST(piece_below(line, x, guess) == piece, x << " from " << guess);
}

BOOST_AUTO_TEST_CASE(walls_of_any_width_are_met_and_may_be_passed_over_and_left) {
    for (const double width : {0.5, 0.05, 1e-3, 1e-7, 1e-12}) {
        const Line line = line_of({{-9, 0}, {1, 0}, {1 + width, 2}, {9, 2}});
        BOOST_TEST(met(line, {0.9f, 1}, {1.6f, 1}) == 2, width);
        BOOST_TEST(met(line, {0.9f, 2.5f}, {1.6f, 2.3f}) == -1, width);
        BOOST_TEST(met(line, {1.6f, 2.5f}, {0.9f, 2.1f}) == -1, width);
        BOOST_TEST(met(line, {0.5f, 0.1f}, {0.6f, -0.1f}) == 1, width);
        // From the other side it is a cliff.
        const Line mirrored = line_of({{-9, 2}, {-1 - width, 2}, {-1, 0}, {9, 0}});
        BOOST_TEST(met(mirrored, {-0.9f, 1}, {-1.6f, 1}) == 2, width);
        BOOST_TEST(met(mirrored, {-1.05f, 2.3f}, {-0.6f, 1.5f}) == -1, width);
    }
}

BOOST_AUTO_TEST_CASE(a_fence_without_width_is_met_from_both_sides_and_at_its_top) {
    const Line line = line_of({{-9, 0}, {1, 0}, {1 + 1e-12, 2}, {1 + 2e-12, 0}, {9, 0}});
    BOOST_TEST(met(line, {0, 1}, {2, 1}) == 2);
    BOOST_TEST(met(line, {2, 1}, {0, 1}) == 3);
    BOOST_TEST(met(line, {0, 3}, {2, 2.5f}) == -1);
    BOOST_TEST(met(line, {1, 2.5f}, {1, -0.5f}) >= 2); // straight down on its point
}

BOOST_AUTO_TEST_CASE(in_a_valley_and_at_a_point_of_the_ground_a_node_comes_to_rest) {
    const std::vector<Vec2d> valleys[] = {{{-5, 5}, {0, 0}, {5, 5}},
                                          {{-5, 20}, {0, 0}, {5, 20}},
                                          {{-5, 0.5}, {0, 0}, {1e-7, 3}, {5, 3}},
                                          {{-5, 0}, {0, 0}, {5, 5}}};
    for (const auto &points : valleys)
        for (const float x : {0.0f, -0.3f}) {
            const Line line = line_of(points);
            Node node{{x, 3}, {0, 0}};
            for (int i = 0; i < 4000; ++i) BOOST_REQUIRE(node.step(line, {}, 0.1f, 0.01f) < 1e-3f);
            BOOST_TEST(length(node.velocity) < 0.01f);
            BOOST_TEST(height(line, node.position) > 0);
            BOOST_TEST(height(line, node.position) < 1e-3);
        }
}

BOOST_AUTO_TEST_CASE(contact_gives_no_speed_and_lets_no_node_into_the_ground) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Line line = line_of(jagged(seed));
        Stream stream(seed, 1, 0, Purpose::initial_weights);
        const float dt = seed % 2 == 0 ? 0.01f : 0.001f;
        Node node{{static_cast<float>(30 * stream.uniform() - 15), 4}, {0, 0}};
        float gain = 0, depth = 0;
        for (int i = 0; i < 4000; ++i) {
            // Up to two cells a step.
            const Vec2f push{static_cast<float>(stream.uniform() - 0.5),
                             static_cast<float>(stream.uniform() - 0.5)};
            const bool kicked = i % 50 == 0;
            const Vec2f way = push * (kicked ? 4.0f / (dt * dt) : 100.0f);
            gain = std::max(gain, node.step(line, way, 0, dt) * dt);
            if (kicked) node.velocity = node.velocity * 0.01f;
            depth = std::max(depth, static_cast<float>(-height(line, node.position)));
        }
        BOOST_TEST(gain < 1e-4f, "seed " << seed);
        BOOST_TEST(depth <= 0, "seed " << seed);
    }
}

BOOST_AUTO_TEST_CASE(the_cost_of_a_step_hardly_grows_with_the_points_of_the_ground) {
    const auto looks_per_step = [](int points) {
        std::vector<Vec2d> hills;
        for (int i = 0; i < points; ++i) {
            const double x = -20 + 40.0 * i / (points - 1);
            hills.push_back({x, math::sin(x)});
        }
        Line line = line_of(hills);
        Node node{{0, 1}, {2, 0}};
        constexpr int steps = 20000;
        for (int i = 0; i < steps; ++i)
            node.step(line, {20 * static_cast<float>(math::sin(0.002 * i)), 0}, 0.1f, 0.01f);
        return static_cast<double>(line.looks) / steps;
    };
    const double few = looks_per_step(40);
    BOOST_TEST_MESSAGE(few << " " << looks_per_step(400) << " " << looks_per_step(4000) << " "
                           << looks_per_step(100000));
    BOOST_TEST(looks_per_step(4000) < 6 * few);
    // A look-up alone, from anywhere.
    std::vector<Vec2d> saw;
    for (int i = 0; i < 100000; ++i) saw.push_back({0.001 * i, i % 2 * 0.1});
    const Line line = line_of(saw);
    for (int i = 0; i < 1000; ++i) piece_below(line, 0.1f * static_cast<float>(i), 50000 - 7 * i % 1000);
    BOOST_TEST(line.looks <= 1000 * 20);
}
