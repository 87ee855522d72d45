// SPDX-License-Identifier: MIT
#include "statement/schema_environment.h"

#include "statement/schema_fields.h"
#include "statement/schema_line.h"
#include "statement/schema_obstacles.h"

namespace planula {

namespace {

void read_ground(Reader &reader, LuaState &lua, Environment &environment, Problems &problems) {
    const Value *ground = reader.table().find("ground");
    if (!ground) return;
    const Place place = reader.at("ground");
    environment.has_ground = true;
    if (ground->is(Value::Kind::text) && ground->text == "flat") return;
    if (ground->is(Value::Kind::text) && ground->text == "none")
        environment.has_ground = false;
    else if (ground->is(Value::Kind::table))
        environment.ground = read_line(*ground, place, keys_of("environment.ground"), lua, problems);
    else
        problems.add(place, place.words + " must be \"flat\", \"none\", a list of points {x, y}, or "
                                          "{height = function, from =, to =, step =}");
}

} // namespace

World read_environment(const Value &table, const Place &place, const Parameters &parameters, LuaState &lua,
                       Problems &problems) {
    Reader reader(table, place, keys_of("environment"), problems);
    World world;
    Environment &environment = world.environment;
    const ReadQuantity quantity = [&](Reader &of, const char *key, const std::string &name, bool needed) {
        const Value *value = of.table().find(key);
        if (value && value->is(Value::Kind::text)) world.sources[name] = value->text;
        if (value && value->is(Value::Kind::number)) world.places[name] = problems.line_of(of.at(key));
        return of.quantity(key, parameters, needed).value_or(0);
    };
    environment.gravity = quantity(reader, "gravity", "gravity", false);
    environment.gravity_direction = quantity(reader, "gravity_direction", "gravity direction", false);
    environment.friction = quantity(reader, "friction", "friction", false);
    world.actuation_range = quantity(reader, "actuation_range", "actuation_range", true);
    if (const Value *drag = reader.field("drag", Value::Kind::table, false)) {
        Reader of_drag(*drag, reader.at("drag"), keys_of("environment.drag"), problems);
        environment.drag_normal = quantity(of_drag, "normal", "drag normal", true);
        environment.drag_tangential = quantity(of_drag, "tangential", "drag tangential", true);
    }
    read_flow(reader, quantity, lua, environment, problems);
    read_regions(reader, quantity, environment, problems);
    read_ground(reader, lua, environment, problems);
    read_obstacles(reader, parameters, lua, environment, problems);
    check_at(place, problems, [&] { check_environment(environment); });
    return world;
}

} // namespace planula
