// SPDX-License-Identifier: MIT
#include "statement/overrides.h"

#include "base/text.h"
#include "experiment/deciding.h"
#include "experiment/world_numbers.h"
#include "statement/meaning.h"
#include "statement/schema.h"

#include <algorithm>
#include <optional>

namespace planula {

namespace {

/// The last word of "drag normal": what the number is called in the script.
std::string key_of(const WorldNumber &number) {
    const std::string name(number.name);
    return name.substr(name.find(' ') + 1);
}

/// Why the environment of a setting takes no number from the parameter.
std::string why_not_of_world(std::string_view parameter, const Spec &spec, const Places &stated) {
    const WorldNumber *number = stated_instead_of(parameter, spec);
    if (!number) return "its environment has no number that this parameter stands for";
    const auto place = stated.find(number->name);
    const std::string name(number->name);
    if (place == stated.end()) return "its environment has no " + name;
    return place->second + " states the number, " + to_text(value_of(*number, spec)) +
           "; change it there, or write there: " + key_of(*number) + " = \"" + std::string(parameter) + '"';
}

/// Reasons, and the settings that each holds for.
using Reasons = std::vector<std::pair<std::string, std::vector<std::string>>>;

void add(Reasons &reasons, const std::string &why, const std::string &setting) {
    const auto known =
        std::find_if(reasons.begin(), reasons.end(), [&](const auto &each) { return each.first == why; });
    if (known == reasons.end())
        reasons.push_back({why, {setting}});
    else
        known->second.push_back(setting);
}

std::string text_of(const Reasons &reasons) {
    std::string text;
    for (const auto &[why, settings] : reasons) {
        const bool several = settings.size() > 1 && why.starts_with("its ");
        text += "\n  " + list_of(settings) + ": " + (several ? "their " + why.substr(4) : why);
    }
    return text;
}

} // namespace

std::string why_unread_by(const Experiment &experiment, std::size_t setting, const ParameterRow &row) {
    const Spec &spec = experiment.settings[setting];
    const std::string why = why_unread(row, spec);
    const bool of_world = !why.empty() && is_of_worlds(row.name);
    return of_world ? why_not_of_world(row.name, spec, experiment.world_places[setting]) : why;
}

std::string why_without_effect(const Experiment &experiment, std::string_view parameter) {
    const ParameterRow &row = parameter_row(parameter);
    Reasons reasons;
    for (std::size_t i = 0; i < experiment.settings.size(); ++i) {
        const std::string why = why_unread_by(experiment, i, row);
        if (why.empty()) return "";
        add(reasons, why, experiment.settings[i].name);
    }
    Meanings meanings(*experiment.sources);
    for (std::size_t i = 0; i < experiment.settings.size(); ++i)
        if (meanings.mentions(i, parameter)) return "";
    return text_of(reasons);
}

} // namespace planula
