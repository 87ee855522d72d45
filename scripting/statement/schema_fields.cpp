// SPDX-License-Identifier: MIT
#include "statement/schema_fields.h"

#include "base/text.h"
#include "language/wrap.h"

#include <cmath>
#include <cstdint>
#include <utility>

namespace planula {

namespace {

constexpr double most_samples = 100000;

/// How many samples of a flow there are; 0, and a report, if its step and its end say none.
int sample_count(Reader &flow, const Place &place, Current &current, Problems &problems) {
    const auto step = flow.number("step", false), period = flow.number("period", false),
               till = flow.number("till", false);
    const auto refuse = [&](const std::string &rule) { return problems.add(place, place.words + rule), 0; };
    if (!step || !(*step >= 1) || *step != std::trunc(*step))
        return refuse(
            " changes: step = is the number of physics steps between samples, a whole number, 1 or more");
    if (period.has_value() == till.has_value())
        return refuse(
            " changes: state period =, after which it begins again, or till =, from which it stays as it "
            "is, and not both");
    const double end = period.value_or(till.value_or(0)), intervals = end / *step;
    if (!(intervals >= 1 && intervals < most_samples) || intervals != std::trunc(intervals))
        return refuse(": " + std::string(period ? "period" : "till") + " = " + to_text(end) +
                      " must be 1 … 99999 times step = " + to_text(*step));
    current.step = static_cast<int>(*step), current.repeats = period.has_value();
    return static_cast<int>(intervals) + (current.repeats ? 0 : 1);
}

/// A flow of which x, y or both are functions of the step.
void sample_flow(Reader &flow, Vec2d constant, LuaState &lua, Current &current, Problems &problems) {
    const int count = sample_count(flow, flow.place(), current, problems);
    const auto function_of = [&](const char *key) {
        const Value *value = flow.table().find(key);
        return value && value->is(Value::Kind::function) ? value : nullptr;
    };
    const Value *const x = function_of("x"), *const y = function_of("y");
    for (int i = 0; i < count; ++i) {
        Vec2d sample = constant;
        for (const auto &[function, key, at] : {std::tuple(x, "x", &sample.x), {y, "y", &sample.y}}) {
            if (!function) continue;
            const auto value =
                sample_at(lua, function->function, double{1} * i * current.step, flow.at(key), problems);
            if (!value) return current.samples.clear();
            *at = *value;
        }
        current.samples.push_back(sample);
    }
}

Region read_region(Reader &reader, const std::string &name, const ReadQuantity &quantity,
                   const Environment &environment, Problems &problems) {
    Region region{.box = read_box(reader),
                  .drag_normal = environment.drag_normal,
                  .drag_tangential = environment.drag_tangential};
    if (const Value *drag = reader.field("drag", Value::Kind::table, false)) {
        Reader of_drag(*drag, reader.at("drag"), keys_of("environment.drag"), problems);
        region.drag_normal = quantity(of_drag, "normal", name + " drag normal", true);
        region.drag_tangential = quantity(of_drag, "tangential", name + " drag tangential", true);
    }
    if (const Value *flow = reader.field("flow", Value::Kind::table, false)) {
        Reader of_flow(*flow, reader.at("flow"), keys_of("environment.regions[].flow"), problems);
        region.flow = Vec2d{quantity(of_flow, "x", name + " flow x", false),
                            quantity(of_flow, "y", name + " flow y", false)};
    }
    region.buoyancy = reader.number("buoyancy", false);
    const auto states = [&](const char *key) { return reader.table().find(key) != nullptr; };
    if (!states("drag") && !states("flow") && !states("buoyancy"))
        problems.add(reader.place(), reader.place().words + " states no drag, no flow and no buoyancy");
    return region;
}

} // namespace

std::optional<double> sample_at(LuaState &lua, int function, double x, const Place &place,
                                Problems &problems) {
    lua_State *L = lua.raw();
    lua_rawgeti(L, LUA_REGISTRYINDEX, function);
    lua_pushnumber(L, x);
    if (const auto message = lua.call(1, {})) return problems.add(*message), std::nullopt;
    const bool is_number = lua_type(L, -1) == LUA_TNUMBER;
    const double value = unsigned_zero(lua_tonumber(L, -1));
    lua_pop(L, 1);
    if (is_number && std::isfinite(value)) return value;
    problems.add(place, place.words + "(" + to_text(x) + ") must return a finite number");
    return std::nullopt;
}

void read_flow(Reader &environment_table, const ReadQuantity &quantity, LuaState &lua,
               Environment &environment, Problems &problems) {
    const Value *stated = environment_table.field("flow", Value::Kind::table, false);
    if (!stated) return;
    Reader flow(*stated, environment_table.at("flow"), keys_of("environment.flow"), problems);
    bool changes = false;
    const auto part = [&](const char *key, const char *name) {
        const Value *value = stated->find(key);
        const bool is_function = value && value->is(Value::Kind::function);
        changes = changes || is_function;
        return is_function ? 0 : quantity(flow, key, name, false);
    };
    environment.flow.x = part("x", "flow x"), environment.flow.y = part("y", "flow y");
    if (changes) return sample_flow(flow, environment.flow, lua, environment.current, problems);
    for (const char *key : {"step", "period", "till"})
        if (stated->find(key))
            flow.report(key,
                        flow.at(key).words + " is of a flow that changes: x or y is a function of the step");
}

void read_regions(Reader &environment_table, const ReadQuantity &quantity, Environment &environment,
                  Problems &problems) {
    const Value *list = environment_table.field("regions", Value::Kind::table, false);
    if (!list) return;
    const Place place = environment_table.at("regions");
    Reader of_list(*list, place, {}, problems, true);
    for (std::size_t i = 0; i < list->list.size(); ++i) {
        const Value &entry = list->list[i];
        const int number = static_cast<int>(i + 1);
        const Place here = place.at(number, &entry);
        if (!entry.is(Value::Kind::table)) {
            problems.add(here, here.words + " must be a table");
            continue;
        }
        Reader of_entry(entry, here, keys_of("environment.regions[]"), problems);
        environment.regions.push_back(
            read_region(of_entry, "region " + to_text(number), quantity, environment, problems));
    }
}

Box read_box(Reader &reader) {
    Box box;
    for (const auto &[key, side] :
         {std::pair("from", &Box::left), {"to", &Box::right}, {"bottom", &Box::bottom}, {"top", &Box::top}})
        if (const auto value = reader.number(key, false)) box.*side = *value;
    return box;
}

} // namespace planula
