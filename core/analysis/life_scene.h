// SPDX-License-Identifier: MIT
// One moment of a recorded life as a part of a picture: the body in its world. Colours are those of the viewer
// (scripting/page/viewer.css, in the light).
#pragma once

#include "physics/environment.h"
#include "recording/recording.h"

#include <string>
#include <vector>

namespace planula {

/// What is seen: the place in the middle, pixels per cell, and the size in pixels.
struct View {
    Vec2d centre;
    double scale = 1, width = 0, height = 0;

    Vec2d pixel(Vec2d place) const {
        return {width / 2 + (place.x - centre.x) * scale, height / 2 - (place.y - centre.y) * scale};
    }
};

/// What is drawn of a body: its nodes, the first `colours.size()` of them cells, and its links.
struct Moment {
    std::vector<Vec2d> nodes;
    std::vector<Link> links; // pairs of nodes
    std::vector<std::string> colours;
};

/// Frames of growth and of locomotion. Cells of an embryo are coloured by the order of birth, those of a moving body by
/// their signals.
Moment moment_of(const GrowthFrame &frame, const LifeRecording &recording);
Moment moment_of(const GaitFrame &frame, const LifeRecording &recording);

/// The world that the body is in at a step of locomotion.
const Environment &world_at(int step, const LifeRecording &recording);

/// Background and walls, as SVG; `world` may be null: empty space.
std::string draw_world(const Environment *world, const View &view);
std::string draw_path(const std::vector<Vec2d> &path, const View &view);
std::string draw_body(const Moment &moment, double cell_radius, const View &view);
/// A bar of a round number of cells in the lower left corner.
std::string draw_scale(const View &view);

} // namespace planula
