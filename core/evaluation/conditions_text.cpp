// SPDX-License-Identifier: MIT
// Every struct is taken apart by name, so that one with a further field does not compile until that is written, too.
#include "evaluation/conditions_text.h"

#include "base/named_lines.h"
#include "physics/object.h"

#include <algorithm>
#include <array>

namespace planula {

namespace {

const std::array<std::string_view, 2> actuations{name_of(Actuation::oscillator), name_of(Actuation::grn)};

template <class Lines> void pass(std::string_view name, std::vector<Vec2d> &points, Lines &lines) {
    lines.list(name, points, [&](Vec2d &point) { lines.line("point", point); });
}

template <class Lines> void pass(Box &box, Lines &lines) {
    auto &[left, right, bottom, top] = box;
    lines.line("box", left, right, bottom, top);
}

template <class Lines> void pass(Region &region, Lines &lines) {
    auto &[box, drag_normal, drag_tangential, flow, buoyancy] = region;
    pass(box, lines);
    lines.line("drag_normal", drag_normal);
    lines.line("drag_tangential", drag_tangential);
    lines.line("flow", flow);
    lines.line("buoyancy", buoyancy);
}

template <class Lines> void pass(Obstacle &obstacle, Lines &lines) {
    auto &[points, friction] = obstacle;
    lines.line("friction", friction);
    pass("points", points, lines);
}

template <class Lines> void pass(Current &current, Lines &lines) {
    auto &[samples, step, repeats] = current;
    lines.line("current", step, repeats);
    pass("samples", samples, lines);
}

/// A loose object follows from its cells.
template <class Lines> void pass(Body &object, Lines &lines) {
    std::vector<Vec2d> cells = object.positions;
    pass("object", cells, lines);
    if constexpr (Lines::reads)
        if (!cells.empty()) object = make_object(cells);
}

template <class Lines> void pass(Environment &environment, Lines &lines) {
    auto &[gravity, has_ground, ground, friction, drag_normal, drag_tangential, flow, gravity_direction,
           current, regions, obstacles, ceiling, friction_patches, object] = environment;
    lines.line("gravity", gravity);
    lines.line("gravity_direction", gravity_direction);
    lines.line("friction", friction);
    lines.line("drag_normal", drag_normal);
    lines.line("drag_tangential", drag_tangential);
    lines.line("flow", flow);
    lines.line("has_ground", has_ground);
    pass("ground", ground, lines);
    pass(current, lines);
    lines.list("regions", regions, [&](Region &region) { pass(region, lines); });
    lines.list("obstacles", obstacles, [&](Obstacle &obstacle) { pass(obstacle, lines); });
    pass("ceiling", ceiling, lines);
    lines.list("friction_patches", friction_patches,
               [&](FrictionPatch &patch) { lines.line("patch", patch.from, patch.to, patch.friction); });
    pass(object, lines);
}

template <class Lines> void pass(Phase &phase, Lines &lines) {
    auto &[at, environment, actuation_range, settles] = phase;
    lines.line("at", at);
    lines.line("settles", settles);
    lines.line("actuation_range", actuation_range);
    pass(environment, lines);
}

template <class Lines> void pass(Damage &damage, Lines &lines) {
    auto &[at, share, side, within] = damage;
    lines.line("at", at);
    lines.line("share", share);
    lines.line("side", named(side, side_names));
    lines.maybe("within", within, [&](Box &box) { pass(box, lines); });
}

/// Those that live() reads.
template <class Lines> void pass(Parameters &parameters, Lines &lines) {
    constexpr std::array<std::string_view, 5> sections{"Development", "Control network", "Body", "Settling",
                                                       "Gait"};
    for (const ParameterRow &row : parameter_rows()) {
        if (std::find(sections.begin(), sections.end(), row.section) == sections.end()) continue;
        std::string word = value_text(row, parameter(parameters, row.name));
        lines.line(row.name, word);
        if constexpr (Lines::reads) set_parameter(parameters, row.name, value_of(row, word));
    }
}

template <class Lines> void pass(Conditions &conditions, Lines &lines) {
    auto &[actuation, actuation_range, environment, phases, damage, engine, refinement, nudge, held_from,
           observed, parameters] = conditions;
    static_cast<void>(observed);
    lines.line("actuation", named(actuation, actuations));
    lines.line("actuation_range", actuation_range);
    pass(environment, lines);
    lines.list("phases", phases, [&](Phase &phase) { pass(phase, lines); });
    lines.maybe("damage", damage, [&](Damage &each) { pass(each, lines); });
    lines.line("engine", engine);
    lines.line("refinement", refinement);
    lines.line("nudge", nudge.reach, nudge.number);
    lines.line("held_from", held_from);
    pass(parameters, lines);
}

} // namespace

std::string write_conditions(const Conditions &conditions) {
    Conditions copy = conditions;
    LineWriter lines;
    pass(copy, lines);
    return lines.text();
}

Conditions read_conditions(std::string_view text) {
    Conditions conditions;
    LineReader lines(text);
    pass(conditions, lines);
    lines.done();
    check_consistency(conditions.parameters);
    check_environment(conditions.environment);
    check_course(conditions);
    return conditions;
}

} // namespace planula
