// SPDX-License-Identifier: MIT
// The deceptive mazes of Lehman & Stanley (2011), "Abandoning objectives": a robot with six range finders and a
// compass of four quarters has 400 steps to come within 5 units of the goal. Fitness is 300 minus the distance of
// its end point from the goal; its behaviour is that end point. In the hard maze the straight way to the goal is a
// dead end, so that fitness rewards entering it.
//
// Lengths are the maze's units, angles degrees. Walls, starts and goals are those of the files medium_maze.txt and
// hard_maze.txt that the first author published with his program; so are the robot's radius, range and limits.
#pragma once

#include "base/vec2.h"
#include "benchmarks/task.h"

#include <array>

namespace planula::benchmark {

struct Wall {
    Vec2d from, to;
};

struct Maze {
    std::string_view name;
    Vec2d start, goal;
    std::vector<Wall> walls;
};

const Maze &medium_maze();
const Maze &hard_maze();

struct Robot {
    Vec2d place;
    double heading = 0; // from +x towards +y
    double speed = 0;   // per step, within ±3
    double turn = 0;    // per step, within ±3
};

/// Distances to the nearest wall at −90, −45, 0, 45, 90 and 180 degrees from the heading, at most 100.
std::array<double, 6> ranges(const Maze &maze, const Robot &robot);
/// 1 for the quarter in which the goal lies, else 0: ahead, at +90, behind, at −90 degrees.
std::array<double, 4> compass(const Maze &maze, const Robot &robot);
/// A step: turn and speed change by these, then the robot turns and goes, unless a wall would be nearer than its
/// radius of 8.
Robot moved(const Maze &maze, Robot robot, double turn, double thrust);

struct Journey {
    Vec2d end;
    bool arrived;
};

/// Inputs: the ranges / 100, the compass and the bias; outputs: turn and thrust, each halved.
Journey travel(const Maze &maze, Policy policy);

Task maze_task(const Maze &maze);

} // namespace planula::benchmark
