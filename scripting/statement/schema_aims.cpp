// SPDX-License-Identifier: MIT
#include "statement/schema_aims.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace planula {

namespace {

constexpr std::string_view goal_names[] = {"maximise", "minimise"};
constexpr std::string_view known_names[] = {"fitness", "novelty"};

bool is_among(std::span<const std::string_view> names, const std::string &name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

Objective known_objective(const Value &entry, const Place &place, Problems &problems) {
    if (!is_among(known_names, entry.text))
        problems.add(place, place.words + ": " + not_one_of(entry.text, known_names) +
                                "; an objective of your own is a table { name =, value =, goal = }");
    const auto value = entry.text == "fitness" ? Objective::Value::fitness : Objective::Value::novelty;
    return {entry.text, value, Objective::Goal::maximise};
}

Objective stated_objective(const Value &entry, const Place &place, Problems &problems) {
    Reader reader(entry, place, keys_of("objectives[]"), problems);
    Objective objective;
    objective.name = reader.text("name", true);
    reader.field("value", Value::Kind::function, true);
    const std::string goal = reader.text("goal", true);
    if (!goal.empty() && !is_among(goal_names, goal))
        reader.report("goal", reader.at("goal").words + ": " + not_one_of(goal, goal_names));
    objective.goal = goal == "minimise" ? Objective::Goal::minimise : Objective::Goal::maximise;
    return objective;
}

DescriptorNumber descriptor_number(const Value &entry, const Place &place, Problems &problems) {
    Reader reader(entry, place, keys_of("descriptor[]"), problems);
    DescriptorNumber number;
    number.name = reader.text("name", true);
    const auto from = reader.number("from"), to = reader.number("to");
    number.cells = reader.whole("cells");
    const bool any = entry.find("from") || entry.find("to") || entry.find("cells");
    if (any && !(entry.find("from") && entry.find("to") && entry.find("cells")))
        problems.add(place,
                     place.words + ": from, to and cells go together: state all of them, or the name alone");
    else if (any && number.cells == 0)
        problems.add(place, place.words + ": cells is 1 to 10000");
    number.from = from.value_or(0), number.to = to.value_or(0);
    return number;
}

/// Calls read(entry, place) for each entry of a list of the setting.
template <class Read>
void read_list(Reader &setting, const std::string &key, Problems &problems, const Read &read) {
    const Value *list = setting.field(key, Value::Kind::table, false);
    if (!list) return;
    const Place place = setting.at(key);
    Reader(*list, place, {}, problems, true);
    if (list->list.empty())
        problems.add(place, place.words + " is empty: state at least one, or leave it out");
    for (std::size_t i = 0; i < list->list.size(); ++i) {
        const Value &entry = list->list[i];
        read(entry, place.at(static_cast<int>(i + 1), &entry));
    }
}

} // namespace

Aims read_aims(Reader &setting, Problems &problems) {
    Aims aims;
    read_list(setting, "objectives", problems, [&](const Value &entry, const Place &place) {
        if (entry.is(Value::Kind::text))
            aims.objectives.push_back(known_objective(entry, place, problems));
        else if (entry.is(Value::Kind::table))
            aims.objectives.push_back(stated_objective(entry, place, problems));
        else
            problems.add(place, place.words +
                                    " must be a table { name =, value =, goal = }, \"fitness\" or "
                                    "\"novelty\", not " +
                                    name_of(entry.kind));
    });
    read_list(setting, "descriptor", problems, [&](const Value &entry, const Place &place) {
        if (entry.is(Value::Kind::table))
            aims.descriptor.push_back(descriptor_number(entry, place, problems));
        else
            problems.add(place, place.words + " must be a table { name =, from =, to =, cells = }, not " +
                                    name_of(entry.kind));
    });
    return aims;
}

} // namespace planula
