// SPDX-License-Identifier: MIT
#include "benchmarks/maze.h"

#include "base/math.h"
#include "benchmarks/solve.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace planula;
using namespace planula::benchmark;

namespace {

/// A square of side `size` with a corner at the origin.
Maze room(double size, Vec2d start, Vec2d goal) {
    return {"room",
            start,
            goal,
            {{{0, 0}, {size, 0}}, {{size, 0}, {size, size}}, {{size, size}, {0, size}}, {{0, size}, {0, 0}}}};
}

void check_ranges(const std::array<double, 6> &seen, const std::array<double, 6> &expected) {
    for (std::size_t i = 0; i < seen.size(); ++i) BOOST_TEST(std::abs(seen[i] - expected[i]) < 1e-9);
}

/// Turns towards `bearing`, slowly enough to stop there, and goes fast only straight ahead.
void steer(const Robot &robot, double bearing, std::span<double> out) {
    double error = std::fmod(bearing - robot.heading, 360);
    if (error > 180) error -= 360;
    if (error < -180) error += 360;
    const double turn = std::copysign(std::min(3.0, std::sqrt(std::abs(error))), error);
    const double speed = std::abs(error) < 20 ? 3 : 0.3;
    out[0] = std::clamp(2 * (turn - robot.turn), -1.0, 1.0);
    out[1] = std::clamp(2 * (speed - robot.speed), -1.0, 1.0);
}

/// A guide who knows the maze and where the robot must be by now.
Policy guide(const Maze &maze, std::vector<Vec2d> way) {
    way.push_back(maze.goal);
    return [&maze, way, next = std::size_t{0}, robot = Robot{maze.start}](std::span<const double>,
                                                                          std::span<double> out) mutable {
        if (length(way[next] - robot.place) < 7 && next + 1 < way.size()) ++next;
        const Vec2d towards = way[next] - robot.place;
        steer(robot, math::atan2(towards.y, towards.x) * 180 / math::pi, out);
        robot = moved(maze, robot, out[0] / 2, out[1] / 2);
    };
}

/// Always towards the quarter of the goal, which is what nearness rewards.
Policy compass_follower() {
    return [now = Robot{}](std::span<const double> in, std::span<double> out) mutable {
        const double turn = 3 * (in[7] - in[9] + in[8]), speed = in[6] == 1 ? 3 : 0;
        out[0] = std::clamp(2 * (turn - now.turn), -1.0, 1.0);
        out[1] = std::clamp(2 * (speed - now.speed), -1.0, 1.0);
        now.turn += out[0] / 2;
        now.speed += out[1] / 2;
    };
}

} // namespace

BOOST_AUTO_TEST_CASE(range_finders_measure_the_nearest_wall_in_six_directions) {
    const Maze square = room(100, {30, 40}, {50, 50});
    const double diagonal = std::sqrt(2.0);
    check_ranges(ranges(square, {{30, 40}, 0}), {40, 40 * diagonal, 70, 60 * diagonal, 60, 30});
    check_ranges(ranges(square, {{30, 40}, 90}), {70, 60 * diagonal, 60, 30 * diagonal, 30, 40});
    check_ranges(ranges(square, {{30, 40}, 180}), {60, 30 * diagonal, 30, 30 * diagonal, 40, 70});
    // Heading along the diagonal, the oblique range finders look along the axes.
    check_ranges(ranges(square, {{30, 40}, 45}),
                 {40 * diagonal, 70, 60 * diagonal, 60, 30 * diagonal, 30 * diagonal});
    // The nearer of two walls counts, and a wall beside the ray does not.
    Maze parted = square;
    parted.walls.push_back({{60, 35}, {60, 45}});
    parted.walls.push_back({{45, 41}, {45, 60}});
    check_ranges(ranges(parted, {{30, 40}, 0}), {40, 40 * diagonal, 30, 15 * diagonal, 60, 30});
    // What is too far away is not seen.
    check_ranges(ranges(room(1000, {}, {}), {{500, 50}, 0}), {50, 50 * diagonal, 100, 100, 100, 100});
}

BOOST_AUTO_TEST_CASE(the_compass_tells_the_quarter_of_the_goal) {
    const Maze square = room(100, {}, {50, 50});
    using Quarters = std::array<double, 4>;
    const Quarters ahead{1, 0, 0, 0}, left{0, 1, 0, 0}, behind{0, 0, 1, 0}, right{0, 0, 0, 1};
    const auto quarter = [&](Vec2d place, double heading) { return compass(square, {place, heading}); };
    BOOST_TEST((quarter({20, 50}, 0) == ahead));
    BOOST_TEST((quarter({20, 50}, 90) == right));
    BOOST_TEST((quarter({20, 50}, 180) == behind));
    BOOST_TEST((quarter({20, 50}, 270) == left));
    BOOST_TEST((quarter({50, 20}, 0) == left));
    BOOST_TEST((quarter({80, 50}, 0) == behind));
    BOOST_TEST((quarter({50, 80}, 0) == right));
    // A quarter begins at −45 degrees and ends before 45.
    BOOST_TEST((quarter({40, 60}, 0) == ahead));
    BOOST_TEST((quarter({40, 40}, 0) == left));
    BOOST_TEST((quarter({60, 40}, 0) == behind));
    BOOST_TEST((quarter({60, 60}, 0) == right));
}

BOOST_AUTO_TEST_CASE(speed_and_turn_change_by_the_outputs_within_their_limits) {
    const Maze wide = room(1000, {500, 500}, {900, 900});
    Robot robot{wide.start};
    for (int step = 1; step <= 4; ++step) robot = moved(wide, robot, 0, 0.5);
    BOOST_TEST(robot.speed == 2);
    BOOST_TEST(robot.place.x == 505); // 0.5 + 1 + 1.5 + 2
    for (int step = 0; step < 10; ++step) robot = moved(wide, robot, 0, 0.5);
    BOOST_TEST(robot.speed == 3);
    for (int step = 0; step < 30; ++step) robot = moved(wide, robot, -0.5, -0.5);
    BOOST_TEST(robot.speed == -3);
    BOOST_TEST(robot.turn == -3);
    BOOST_TEST(robot.heading == 360 - (0.5 + 1 + 1.5 + 2 + 2.5 + 25 * 3));
}

BOOST_AUTO_TEST_CASE(a_robot_stops_before_a_wall_but_can_turn_away) {
    const Maze square = room(100, {50, 50}, {10, 10});
    Robot robot{square.start};
    for (int step = 0; step < 100; ++step) robot = moved(square, robot, 0, 0.5);
    // 0.5 + 1 + … + 2.5, then steps of 3: the next after 90.5 would end at 93.5, nearer than 8 to the wall.
    BOOST_TEST(robot.place.x == 90.5);
    BOOST_TEST(robot.place.y == 50);
    for (int step = 0; step < 60; ++step) robot = moved(square, robot, 0.5, 0);
    BOOST_TEST(robot.place.x < 80);

    // It may come as near as its radius.
    const Robot near = moved(square, {{91.5, 50}}, 0, 0.5);
    BOOST_TEST(near.place.x == 92);
    BOOST_TEST(moved(square, {{91.75, 50}}, 0, 0.5).place.x == 91.75);
}

BOOST_AUTO_TEST_CASE(a_journey_ends_at_the_goal_or_after_four_hundred_steps) {
    const Maze square = room(100, {20, 50}, {70, 50});
    int steps = 0;
    const auto forward = [&](std::span<const double> in, std::span<double> out) {
        BOOST_TEST(in.size() == 11u);
        BOOST_TEST(in[10] == 1);
        if (steps++ == 0) {
            BOOST_TEST(in[2] == 0.8); // 80 to the wall ahead
            BOOST_TEST(in[6] == 1);
        }
        out[1] = 1;
    };
    const Journey there = travel(square, forward);
    BOOST_TEST(there.arrived);
    BOOST_TEST(length(there.end - square.goal) < 5);
    BOOST_TEST(steps == 18); // 7.5 in the first five steps, then 3 each until more than 45

    steps = 0;
    const Journey nowhere = travel(square, [&](auto, std::span<double>) { ++steps; });
    BOOST_TEST(!nowhere.arrived);
    BOOST_TEST((nowhere.end == square.start));
    BOOST_TEST(steps == 400);
}

BOOST_AUTO_TEST_CASE(a_robot_that_follows_a_known_way_reaches_both_goals_in_time) {
    // clang-format off
    const std::vector<Vec2d> through_hard{
        {70, 172}, {105, 148}, {140, 170}, {172, 172}, {170, 150}, {120, 124},
        {72, 97}, {70, 72}, {100, 58}, {150, 40}, {146, 20}, {120, 20}};
    const std::vector<Vec2d> through_medium{
        {60, 48}, {78, 54}, {92, 40}, {104, 31}, {118, 33}, {126, 52}, {134, 66},
        {155, 72}, {178, 46}, {191, 48}, {202, 68}, {212, 80}, {228, 80}, {240, 72}, {262, 90}};
    // clang-format on
    const Journey hard = travel(hard_maze(), guide(hard_maze(), through_hard));
    BOOST_TEST(hard.arrived);
    const Journey medium = travel(medium_maze(), guide(medium_maze(), through_medium));
    BOOST_TEST(medium.arrived);
}

BOOST_AUTO_TEST_CASE(a_robot_that_follows_the_compass_ends_in_a_dead_end) {
    for (const Maze *maze : {&hard_maze(), &medium_maze()}) {
        const Journey journey = travel(*maze, compass_follower());
        BOOST_TEST(!journey.arrived);
        BOOST_TEST(length(journey.end - maze->goal) < length(maze->start - maze->goal)); // though nearer
    }
    const Maze open = room(200, {20, 20}, {150, 120});
    BOOST_TEST(travel(open, compass_follower()).arrived);
}

BOOST_AUTO_TEST_CASE(a_genome_is_judged_by_where_its_robot_ends) {
    const Task task = maze_task(hard_maze());
    Genome still;
    still.inputs = 11, still.outputs = 2;
    for (int id = 0; id < 13; ++id)
        still.nodes.push_back({id,
                               id < 10   ? NodeKind::input
                               : id < 11 ? NodeKind::bias
                                         : NodeKind::output,
                               id < 11 ? 0.0 : 1.0});
    const Attempt attempt = task.attempt(still);
    BOOST_TEST(attempt.behaviour == (std::vector<double>{36, 184}), boost::test_tools::per_element());
    BOOST_TEST(attempt.fitness == 300 - std::sqrt(25.0 + 164 * 164));
    BOOST_TEST(!attempt.solved);
}

BOOST_AUTO_TEST_CASE(novelty_search_leaves_a_local_optimum_long_before_fitness_search) {
    // The pocket below the goal opens away from it: the way out leads back.
    Maze trap = room(160, {60, 80}, {140, 80});
    trap.walls.push_back({{120, 30}, {120, 160}});
    trap.walls.push_back({{40, 30}, {120, 30}});
    const Task task = maze_task(trap);
    Parameters parameters;
    parameters.neat.population = 60;
    std::int64_t by_fitness = 0, by_novelty = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        by_fitness += solve(task, "neat", parameters, seed, 20).evaluations;
        const Solution found = solve(task, "novelty", parameters, seed, 20);
        BOOST_TEST(found.solved);
        by_novelty += found.evaluations;
    }
    BOOST_TEST(2 * by_novelty < by_fitness);
}
