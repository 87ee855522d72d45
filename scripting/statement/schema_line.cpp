// SPDX-License-Identifier: MIT
#include "statement/schema_line.h"

#include "statement/schema_fields.h"

#include <cmath>

namespace planula {

namespace {

constexpr double most_points = 100000;

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

std::vector<Vec2d> sample_heights(const Value &table, const Place &place, const Keys &keys, LuaState &lua,
                                  Problems &problems) {
    std::vector<Vec2d> line;
    Reader reader(table, place, keys, problems);
    const Value *height = reader.field("height", Value::Kind::function, true);
    const auto from = reader.number("from", true), to = reader.number("to", true);
    const auto step = reader.number("step", true);
    if (!height || !from || !to || !step) return line;
    const auto places = sample_places(*from, *to, *step);
    if (places.empty()) problems.add(place, place.words + ": from, to and step must give 2 … 100000 points");
    for (const double x : places) {
        const auto y = sample_at(lua, height->function, x, reader.at("height"), problems);
        if (!y) return line;
        line.push_back({x, *y});
    }
    return line;
}

} // namespace

std::optional<Vec2d> read_point(const Value &value) {
    if (!value.is(Value::Kind::table) || !value.fields.empty() || value.list.size() != 2) return std::nullopt;
    for (const Value &coordinate : value.list)
        if (!coordinate.is(Value::Kind::number)) return std::nullopt;
    return Vec2d{value.list[0].number, value.list[1].number};
}

std::vector<Vec2d> read_points(const Value &list, const Place &place, Problems &problems) {
    std::vector<Vec2d> points;
    if (!list.fields.empty()) problems.add(place, place.words + " must be a list of points {x, y}");
    for (std::size_t i = 0; i < list.list.size(); ++i) {
        if (const auto point = read_point(list.list[i]))
            points.push_back(*point);
        else
            problems.add(place.at(static_cast<int>(i + 1)),
                         "a point of " + place.words + " is {x, y}, two numbers");
    }
    return points;
}

std::vector<Vec2d> read_line(const Value &table, const Place &place, const Keys &keys, LuaState &lua,
                             Problems &problems) {
    if (!table.fields.empty()) return sample_heights(table, place, keys, lua, problems);
    if (table.list.size() < 2) problems.add(place, place.words + " needs two points or more");
    return read_points(table, place, problems);
}

} // namespace planula
