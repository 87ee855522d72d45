// SPDX-License-Identifier: MIT
#include "statement/schema_obstacles.h"

#include "physics/object.h"
#include "statement/schema_line.h"

namespace planula {

namespace {

using Kind = Value::Kind;

/// Calls read(entry, its place) for each entry of a list of tables.
void each_table(Reader &reader, const char *key, const std::string &what, Problems &problems,
                const auto &read) {
    const Value *list = reader.field(key, Kind::table, false);
    if (!list) return;
    const Place place = reader.at(key);
    if (!list->fields.empty() || list->list.empty())
        return problems.add(place, place.words + " must be a list of " + what);
    for (std::size_t i = 0; i < list->list.size(); ++i) {
        const Value &entry = list->list[i];
        const Place at = place.at(static_cast<int>(i + 1), &entry);
        if (entry.is(Kind::table))
            read(entry, at);
        else
            problems.add(at, at.words + " must be a table, one of a list of " + what);
    }
}

Obstacle read_obstacle(const Value &table, const Place &place, const Parameters &parameters,
                       Problems &problems) {
    if (table.fields.empty()) return {read_points(table, place, problems), std::nullopt};
    Obstacle obstacle;
    Reader reader(table, place, keys_of("environment.obstacles[]"), problems);
    if (const Value *points = reader.field("points", Kind::table, true))
        obstacle.points = read_points(*points, reader.at("points"), problems);
    obstacle.friction = reader.quantity("friction", parameters);
    return obstacle;
}

FrictionPatch read_patch(const Value &table, const Place &place, const Parameters &parameters,
                         Problems &problems) {
    Reader reader(table, place, keys_of("environment.friction_patches[]"), problems);
    const auto from = reader.number("from", true), to = reader.number("to", true);
    const auto friction = reader.quantity("friction", parameters, true);
    return {from.value_or(0), to.value_or(0), friction.value_or(0)};
}

Body read_object(const Value &table, const Place &place, Problems &problems) {
    Reader reader(table, place, keys_of("environment.object"), problems);
    const Value *at = reader.field("at", Kind::table, true),
                *shape = reader.field("shape", Kind::table, false);
    const auto radius = reader.number("radius");
    const auto middle = at ? read_point(*at) : std::nullopt;
    if (at && !middle) reader.report("at", reader.at("at").words + " must be {x, y}, two numbers");
    if (table.find("shape") && table.find("radius"))
        problems.add(place, place.words + " has a shape or a radius, not both");
    if (!table.find("shape") && !table.find("radius"))
        problems.add(place, place.words + " needs a shape, a list of points relative to `at`, or a radius");
    if (!middle || (!shape && !radius)) return {};
    Body object;
    if (shape) {
        const auto points = read_points(*shape, reader.at("shape"), problems);
        check_at(reader.at("shape"), problems, [&] { object = make_object(*middle, points); });
    } else {
        check_at(reader.at("radius"), problems, [&] { object = make_object(*middle, *radius); });
    }
    return object;
}

} // namespace

void read_obstacles(Reader &reader, const Parameters &parameters, LuaState &lua, Environment &environment,
                    Problems &problems) {
    each_table(reader, "obstacles", "polygons, each a list of points {x, y} or {points =, friction =}",
               problems, [&](const Value &table, const Place &place) {
                   environment.obstacles.push_back(read_obstacle(table, place, parameters, problems));
               });
    each_table(reader, "friction_patches", "patches {from =, to =, friction =}", problems,
               [&](const Value &table, const Place &place) {
                   environment.friction_patches.push_back(read_patch(table, place, parameters, problems));
               });
    if (const Value *ceiling = reader.field("ceiling", Kind::table, false))
        environment.ceiling =
            read_line(*ceiling, reader.at("ceiling"), keys_of("environment.ceiling"), lua, problems);
    if (const Value *object = reader.field("object", Kind::table, false))
        environment.object = read_object(*object, reader.at("object"), problems);
}

} // namespace planula
