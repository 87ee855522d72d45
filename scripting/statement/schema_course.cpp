// SPDX-License-Identifier: MIT
#include "statement/schema_course.h"

#include "experiment/world_numbers.h"
#include "statement/schema_fields.h"

#include <algorithm>
#include <iterator>

namespace planula {

namespace {

void read_phase(Reader &reader, LuaState &lua, Spec &spec, Places &places, Problems &problems) {
    const std::size_t index = spec.phases.size();
    Phase &phase = spec.phases.emplace_back();
    phase.at = reader.whole("at", true);
    if (const Value *settle = reader.field("settle", Value::Kind::boolean, false))
        phase.settles = settle->boolean;
    const Value *environment = reader.field("environment", Value::Kind::table, true);
    if (!environment) return;
    World world = read_environment(*environment, reader.at("environment"), spec.parameters, lua, problems);
    phase.environment = std::move(world.environment);
    phase.actuation_range = world.actuation_range;
    for (const auto &[name, source] : world.sources) spec.world_sources[name_in_phase(index, name)] = source;
    for (const auto &[name, place] : world.places) places[name_in_phase(index, name)] = place;
}

} // namespace

void read_phases(Reader &setting, LuaState &lua, Spec &spec, Places &places, Problems &problems) {
    const Value *list = setting.field("phases", Value::Kind::table, false);
    if (!list) return;
    const Place place = setting.at("phases");
    Reader of_list(*list, place, {}, problems, true);
    for (std::size_t i = 0; i < list->list.size(); ++i) {
        const Value &entry = list->list[i];
        const Place here = place.at(static_cast<int>(i + 1), &entry);
        if (!entry.is(Value::Kind::table)) {
            problems.add(here, here.words + " must be a table");
            continue;
        }
        Reader of_entry(entry, here, keys_of("phases[]"), problems);
        read_phase(of_entry, lua, spec, places, problems);
    }
}

void read_damage(Reader &setting, Spec &spec, Problems &problems) {
    const Value *table = setting.field("damage", Value::Kind::table, false);
    if (!table) return;
    Reader reader(*table, setting.at("damage"), keys_of("damage"), problems);
    Damage &damage = spec.damage.emplace();
    damage.at = reader.whole("at");
    const auto states = [&](const char *key) { return table->find(key) != nullptr; };
    if (states("share") != states("side") || states("share") == states("within"))
        problems.add(reader.place(),
                     reader.place().words + " states share = and side =, or within =: which cells are lost");
    if (const Value *within = reader.field("within", Value::Kind::table, false)) {
        Reader of_box(*within, reader.at("within"), keys_of("damage.within"), problems);
        damage.within = read_box(of_box);
    }
    damage.share = reader.number("share").value_or(0);
    const std::string side = reader.text("side");
    const auto found = std::find(side_names.begin(), side_names.end(), side);
    if (found != side_names.end())
        damage.side = static_cast<Side>(std::distance(side_names.begin(), found));
    else if (!side.empty())
        reader.report("side", reader.at("side").words + ": " + not_one_of(side, side_names));
}

} // namespace planula
