// SPDX-License-Identifier: MIT
#include "benchmarks/maze.h"

#include "base/math.h"

#include <algorithm>
#include <cmath>

namespace planula::benchmark {

namespace {

constexpr double range_limit = 100, radius = 8, goal_radius = 5, speed_limit = 3;
constexpr int steps = 400;

Vec2d direction(double heading) {
    const double angle = heading * math::pi / 180;
    return {math::cos(angle), math::sin(angle)};
}

double distance_to(const Wall &wall, Vec2d place) {
    const Vec2d along = wall.to - wall.from, offset = place - wall.from;
    const double share = std::clamp(dot(offset, along) / squared_length(along), 0.0, 1.0);
    return length(offset - along * share);
}

} // namespace

std::array<double, 6> ranges(const Maze &maze, const Robot &robot) {
    double right = range_limit, ahead_right = range_limit, ahead = range_limit, ahead_left = range_limit,
           left = range_limit, behind = range_limit, unused = range_limit;
    const Vec2d nose = direction(robot.heading);
    for (const Wall &wall : maze.walls) {
        // The wall's ends in the robot's frame: forward, and to the left.
        const Vec2d from = wall.from - robot.place, to = wall.to - robot.place;
        const double f1 = dot(nose, from), l1 = cross(nose, from), f2 = dot(nose, to), l2 = cross(nose, to);
        const double area = cross(from, to);

        // A line through the robot meets the wall if its ends lie on different sides, at this distance along it.
        // Without branches, since they cannot be predicted.
        const auto meet = [&](double side1, double side2, double scale, double &onward, double &backward) {
            const double distance = scale * area / (side2 - side1);
            const double met = side1 * side2 <= 0 && side1 != side2 ? distance : range_limit;
            onward = std::min(onward, met >= 0 ? met : range_limit);
            backward = std::min(backward, met <= 0 ? -met : range_limit);
        };
        meet(f1, f2, 1, right, left);
        meet(l1 + f1, l2 + f2, std::sqrt(2.0), ahead_right, unused);
        meet(l1, l2, 1, ahead, behind);
        meet(l1 - f1, l2 - f2, std::sqrt(2.0), ahead_left, unused);
    }
    return {right, ahead_right, ahead, ahead_left, left, behind};
}

std::array<double, 4> compass(const Maze &maze, const Robot &robot) {
    const Vec2d ahead = direction(robot.heading), way = maze.goal - robot.place;
    const double forward = dot(ahead, way), sideways = cross(ahead, way);
    return {double(-forward <= sideways && sideways < forward),
            double(-sideways < forward && forward <= sideways),
            double(forward < sideways && sideways <= -forward),
            double(sideways <= forward && forward < -sideways)};
}

Robot moved(const Maze &maze, Robot robot, double turn, double thrust) {
    robot.turn = std::clamp(robot.turn + turn, -speed_limit, speed_limit);
    robot.speed = std::clamp(robot.speed + thrust, -speed_limit, speed_limit);
    const Vec2d next = robot.place + direction(robot.heading) * robot.speed;
    robot.heading += robot.turn;
    if (robot.heading > 360) robot.heading -= 360;
    if (robot.heading < 0) robot.heading += 360;
    const bool blocked = std::any_of(maze.walls.begin(), maze.walls.end(),
                                     [&](const Wall &wall) { return distance_to(wall, next) < radius; });
    if (!blocked) robot.place = next;
    return robot;
}

Journey travel(const Maze &maze, Policy policy) {
    Robot robot{maze.start};
    for (int step = 0; step < steps; ++step) {
        std::array<double, 11> inputs;
        const auto seen = ranges(maze, robot);
        const auto felt = compass(maze, robot);
        std::transform(seen.begin(), seen.end(), inputs.begin(),
                       [](double range) { return range / range_limit; });
        std::copy(felt.begin(), felt.end(), inputs.begin() + seen.size());
        inputs.back() = 1;

        std::array<double, 2> outputs{};
        policy(inputs, outputs);
        robot = moved(maze, robot, outputs[0] / 2, outputs[1] / 2);
        if (length(robot.place - maze.goal) < goal_radius) return {robot.place, true};
    }
    return {robot.place, false};
}

Task maze_task(const Maze &maze) {
    return {maze.name, {11, 2, true}, [&maze](const Genome &genome) {
                const Journey journey = travel(maze, Controller(genome, true));
                const double fitness = 300 - length(journey.end - maze.goal);
                return Attempt{std::max(0.1, fitness), {journey.end.x, journey.end.y}, journey.arrived};
            }};
}

const Maze &medium_maze() {
    static const Maze maze{"medium-maze",
                           {30, 22},
                           {270, 100},
                           {{{293, 7}, {289, 130}},
                            {{289, 130}, {6, 134}},
                            {{6, 134}, {8, 5}},
                            {{8, 5}, {292, 7}},
                            {{241, 130}, {58, 65}},
                            {{114, 7}, {73, 42}},
                            {{130, 91}, {107, 46}},
                            {{196, 8}, {139, 51}},
                            {{219, 122}, {182, 63}},
                            {{267, 9}, {214, 63}},
                            {{271, 129}, {237, 88}}}};
    return maze;
}

const Maze &hard_maze() {
    static const Maze maze{"hard-maze",
                           {36, 184},
                           {31, 20},
                           {{{41, 5}, {3, 8}},
                            {{3, 8}, {4, 49}},
                            {{4, 49}, {57, 53}},
                            {{4, 49}, {7, 202}},
                            {{7, 202}, {195, 198}},
                            {{195, 198}, {186, 8}},
                            {{186, 8}, {39, 5}},
                            {{56, 54}, {56, 157}},
                            {{57, 106}, {158, 162}},
                            {{77, 201}, {108, 164}},
                            {{6, 80}, {33, 121}},
                            {{192, 146}, {87, 91}},
                            {{56, 55}, {133, 30}}}};
    return maze;
}

} // namespace planula::benchmark
