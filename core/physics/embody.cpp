// SPDX-License-Identifier: MIT
#include "physics/embody.h"

#include "physics/laws/contact.h"

#include <algorithm>

namespace planula {

namespace {

/// Cells that end a solid outline link, ascending.
std::vector<int> solid_outline_cells(const std::vector<OutlineLink> &outline) {
    std::vector<int> cells;
    for (const auto &link : outline)
        if (link.solid) cells.push_back(link.a);
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
}

/// Links that never push a cell: those of loose chains, and those that lay near it at the end of development,
/// as its own do.
std::vector<char> contact_masks(const Body &body, const std::vector<int> &cells, double near) {
    std::vector<char> masked;
    for (const int cell : cells)
        for (const auto &link : body.outline) {
            const Vec2d p = body.positions[cell];
            const auto foot = foot_on_segment(p, body.positions[link.a], body.positions[link.b]);
            masked.push_back(!link.solid || squared_length(p - foot.point) < near * near);
        }
    return masked;
}

/// The shift from the development frame to the world frame.
Vec2d placement(const Body &body, const Environment &environment) {
    const Vec2d centre = centre_of_mass(body.positions);
    if (!environment.has_ground) return -centre;
    // Above walls, which a node touches from its own side, by more than rounding.
    const double above = environment.has_walls() ? clearance_of_walls : 0;
    return {-centre.x, above - height_of_lowest(body.positions, -centre.x, environment)};
}

/// A body with the object of its environment behind it, in the frame of the body, which `shift` moves.
Body with_object(Body body, const Body &object, Vec2d shift) {
    const int first = body.cells();
    for (const Vec2d position : object.positions) body.positions.push_back(position - shift);
    for (const auto &[a, b] : object.mesh.links) body.mesh.links.push_back({a + first, b + first});
    for (const auto &[a, b, c] : object.mesh.triangles)
        body.mesh.triangles.push_back({a + first, b + first, c + first});
    body.rest_lengths.insert(body.rest_lengths.end(), object.rest_lengths.begin(), object.rest_lengths.end());
    body.areas.insert(body.areas.end(), object.areas.begin(), object.areas.end());
    for (const auto &[a, b, solid] : object.outline) body.outline.push_back({a + first, b + first, solid});
    return body;
}

SoftBodyModel model_of(const Body &body, Vec2d shift, const BodyParameters &parameters, double time_step) {
    SoftBodyModel model{.positions = body.positions,
                        .links = body.mesh.links,
                        .rest_lengths = body.rest_lengths,
                        .triangles = body.mesh.triangles,
                        .areas = body.areas,
                        .outline = body.outline,
                        .contact_cells = solid_outline_cells(body.outline),
                        .body = parameters,
                        .time_step = time_step};
    model.masked = contact_masks(body, model.contact_cells, parameters.contact_radius);
    for (Vec2d &position : model.positions) position += shift;
    return model;
}

} // namespace

SoftBodyModel embody(const Body &body, const Environment &environment, const BodyParameters &parameters,
                     double time_step) {
    const Vec2d shift = placement(body, environment);
    if (environment.object.positions.empty()) return model_of(body, shift, parameters, time_step);
    SoftBodyModel model =
        model_of(with_object(body, environment.object, shift), shift, parameters, time_step);
    model.object_nodes = environment.object.cells();
    return model;
}

} // namespace planula
