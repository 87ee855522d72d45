// SPDX-License-Identifier: MIT
#include "physics/room.h"

#include "physics/walls.h"

#include <algorithm>

namespace planula {

namespace {

bool is_walled_in(Vec2d point, const Environment &environment) {
    if (!environment.ceiling.empty() && !(point.y < height_of(environment.ceiling, point.x))) return true;
    return std::any_of(environment.obstacles.begin(), environment.obstacles.end(),
                       [&](const Obstacle &obstacle) { return is_inside(point, obstacle.points); });
}

bool is_clear_of_walls(const SoftBodyModel &model, std::span<const Vec2d> x, const Environment &environment) {
    const Walls<double> walls(environment, {});
    const WallsView<double> view = walls.view();
    bool clear = true;
    for (const Vec2d place : x) {
        // Nearer, a node's side could change by rounding.
        const double least = rounding_at(place);
        const Vec2d reach{least, least};
        each_wall_near(view, place - reach, place + reach, [&](int i) {
            clear = clear && !(Nearness<double>(view.walls[i], place).distance < least);
        });
    }
    for (const Link &link : model.links) {
        const Vec2d a = x[link.a], b = x[link.b];
        const Vec2d low{std::min(a.x, b.x), std::min(a.y, b.y)}, high{std::max(a.x, b.x), std::max(a.y, b.y)};
        each_wall_near(view, low, high, [&](int i) {
            clear = clear && !(view.walls[i].pierces && crosses(view.walls[i], a, b));
        });
    }
    // Links hold the animat together, and the object: what holds for one node of each holds for all.
    if (model.object_nodes > 0) clear = clear && !is_walled_in(x[model.cells()], environment);
    return clear && !is_walled_in(x.front(), environment);
}

bool holds(const SoftBodyModel &model, const Triangle &triangle, int node) {
    const Vec2d corners[] = {model.positions[triangle.a], model.positions[triangle.b],
                             model.positions[triangle.c]};
    return is_inside(model.positions[node], corners);
}

/// Whether animat and object are farther apart than they push each other.
bool is_apart_from_object(const SoftBodyModel &model) {
    const auto is_own = [&](int node) { return node < model.cells(); };
    for (std::size_t i = 0; i < model.contact_cells.size(); ++i)
        for (std::size_t j = 0; j < model.outline.size(); ++j)
            if (is_own(model.contact_cells[i]) != is_own(model.outline[j].a) && model.outline[j].solid &&
                model.is_masked(i, j))
                return false;
    for (const Triangle &triangle : model.triangles)
        for (int node = 0; node < model.nodes(); ++node)
            if (is_own(node) != is_own(triangle.a) && holds(model, triangle, node)) return false;
    return true;
}

} // namespace

bool has_room(const SoftBodyModel &model, std::span<const Vec2d> positions, const Environment &environment) {
    if (environment.has_walls() && !is_clear_of_walls(model, positions, environment)) return false;
    return model.object_nodes == 0 || is_apart_from_object(model);
}

bool is_inside(Vec2d point, std::span<const Vec2d> polygon) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2d a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        if ((a.y > point.y) == (b.y > point.y)) continue;
        if (point.x < a.x + (b.x - a.x) * ((point.y - a.y) / (b.y - a.y))) inside = !inside;
    }
    return inside;
}

} // namespace planula
