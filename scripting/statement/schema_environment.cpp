// SPDX-License-Identifier: MIT
#include "statement/schema_environment.h"

#include "base/error.h"
#include "base/text.h"
#include "statement/schema_fields.h"

#include <cmath>
#include <vector>

namespace planula {

namespace {

constexpr double most_points = 100000;

std::optional<Vec2d> read_point(const Value &value) {
    if (!value.is(Value::Kind::table) || !value.fields.empty() || value.list.size() != 2) return std::nullopt;
    for (const Value &coordinate : value.list)
        if (!coordinate.is(Value::Kind::number)) return std::nullopt;
    return Vec2d{value.list[0].number, value.list[1].number};
}

void read_polyline(const Value &table, const Place &place, Environment &environment, Problems &problems) {
    for (std::size_t i = 0; i < table.list.size(); ++i) {
        if (const auto point = read_point(table.list[i]))
            environment.ground.push_back(*point);
        else
            problems.add(place.at(static_cast<int>(i + 1)), "a point of the ground is {x, y}, two numbers");
    }
    if (table.list.size() < 2) problems.add(place, place.words + " needs two points or more");
}

// from, from + step and so on below `to`, and `to`; empty if these are fewer than two or too many. A place that
// differs from `to` by rounding only is left out.
std::vector<double> sample_places(double from, double to, double step) {
    constexpr double rounding = 1e-6; // of a step
    const double steps = std::ceil((to - from) / step - rounding);
    if (!(step > 0 && from < to && steps < most_points)) return {};
    std::vector<double> places{from};
    for (int i = 1; i < static_cast<int>(steps); ++i) places.push_back(from + i * step);
    places.push_back(to);
    return places;
}

void sample_ground(const Value &table, const Place &place, LuaState &lua, Environment &environment,
                   Problems &problems) {
    Reader reader(table, place, keys_of("environment.ground"), problems);
    const Value *height = reader.field("height", Value::Kind::function, true);
    const auto from = reader.number("from", true), to = reader.number("to", true);
    const auto step = reader.number("step", true);
    if (!height || !from || !to || !step) return;
    const auto places = sample_places(*from, *to, *step);
    if (places.empty())
        return problems.add(place, place.words + ": from, to and step must give 2 … 100000 points");
    for (const double x : places) {
        const auto y = sample_at(lua, height->function, x, reader.at("height"), problems);
        if (!y) return;
        environment.ground.push_back({x, *y});
    }
}

void read_ground(Reader &reader, LuaState &lua, Environment &environment, Problems &problems) {
    const Value *ground = reader.table().find("ground");
    if (!ground) return;
    const Place place = reader.at("ground");
    environment.has_ground = true;
    if (ground->is(Value::Kind::text) && ground->text == "flat") return;
    if (ground->is(Value::Kind::text) && ground->text == "none")
        environment.has_ground = false;
    else if (ground->is(Value::Kind::table) && ground->fields.empty())
        read_polyline(*ground, place, environment, problems);
    else if (ground->is(Value::Kind::table))
        sample_ground(*ground, place, lua, environment, problems);
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
    check_at(place, problems, [&] { check_environment(environment); });
    return world;
}

} // namespace planula
