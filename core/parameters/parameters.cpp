// SPDX-License-Identifier: MIT
#include "parameters/parameters.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

namespace planula {

namespace {

/// The words of a list that commas separate.
std::vector<std::string_view> words_of(std::string_view list) {
    std::vector<std::string_view> words;
    while (!list.empty()) {
        const std::size_t comma = std::min(list.find(','), list.size());
        words.push_back(list.substr(0, comma));
        list.remove_prefix(std::min(list.find_first_not_of(", ", comma), list.size()));
    }
    return words;
}

ParameterRow choice_row(std::string_view section, std::string_view name, int standard,
                        std::string_view origin, std::string_view meaning, std::string_view alternatives) {
    ParameterRow row{section,
                     name,
                     "1",
                     origin,
                     meaning,
                     true,
                     static_cast<double>(standard),
                     0,
                     0,
                     words_of(alternatives)};
    row.highest = static_cast<double>(row.names.size() - 1);
    return row;
}

std::vector<ParameterRow> make_rows() {
    std::vector<ParameterRow> rows;
    std::string_view section;
#define SECTION(Type, member, title) section = title;
#define SECTION_END(member)
#define PARAMETER(type, name, value, lowest, highest, unit, origin, meaning)                                 \
    rows.push_back(                                                                                          \
        {section, #name, unit, origin, meaning, std::is_same_v<type, int>, value, lowest, highest});
#define CHOICE(type, name, value, origin, meaning, ...)                                                      \
    rows.push_back(choice_row(section, #name, static_cast<int>(type::value), origin, meaning, #__VA_ARGS__));
#include "parameters/parameters.inl"
    return rows;
}

/// Calls use(field) with a reference to the field of that name; const or not as `parameters` is.
template <class P, class Use> void with_field(P &parameters, std::string_view name, Use use) {
#define SECTION(Type, member, title)                                                                         \
    {                                                                                                        \
        auto &section = parameters.member;
#define SECTION_END(member) }
#define PARAMETER(type, field, ...)                                                                          \
    if (name == #field) return use(section.field);
#define CHOICE(type, field, ...) PARAMETER(type, field)
#include "parameters/parameters.inl"
}

void require(bool holds, const char *rule) {
    if (!holds) throw InputError(std::string("parameters break the rule: ") + rule);
}

} // namespace

std::span<const ParameterRow> parameter_rows() {
    static const std::vector<ParameterRow> rows = make_rows();
    return rows;
}

const ParameterRow &parameter_row(std::string_view name) {
    std::vector<std::string_view> names;
    for (const auto &row : parameter_rows()) {
        if (row.name == name) return row;
        names.push_back(row.name);
    }
    const std::string nearest = nearest_name(name, names);
    throw InputError("no parameter is called '" + std::string(name) + "'" +
                     (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
}

double parameter(const Parameters &parameters, std::string_view name) {
    double value = 0;
    with_field(parameters, parameter_row(name).name, [&](auto field) { value = static_cast<double>(field); });
    return value;
}

std::string value_text(const ParameterRow &row, double value) {
    return row.is_choice() ? std::string(row.names.at(static_cast<std::size_t>(value))) : to_text(value);
}

double value_of(const ParameterRow &row, std::string_view word) {
    const auto name = std::find(row.names.begin(), row.names.end(), word);
    if (name != row.names.end()) return static_cast<double>(name - row.names.begin());
    const std::optional<double> number = row.is_choice() ? std::nullopt : parse_double(word);
    if (number) return *number;
    const std::string said = std::string(row.name) + " = " + std::string(word);
    if (!row.is_choice()) throw InputError(said + " must be a number");
    std::string known;
    for (const std::string_view each : row.names)
        known.append(known.empty() ? "'" : ", '").append(each).append("'");
    const std::string nearest = nearest_name(word, row.names);
    throw InputError(said + " must be one of " + known +
                     (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
}

void set_parameter(Parameters &parameters, std::string_view name, double value) {
    const ParameterRow &row = parameter_row(name);
    const std::string said = std::string(name) + " = " + to_text(value);
    if (!(value >= row.lowest && value <= row.highest))
        throw InputError(said + " is outside " + to_text(row.lowest) + " … " + to_text(row.highest) + " " +
                         std::string(row.unit) + " (" + std::string(row.meaning) + ")");
    if (row.whole && value != std::trunc(value)) throw InputError(said + " must be a whole number");
    with_field(parameters, name,
               [&](auto &field) { field = static_cast<std::decay_t<decltype(field)>>(value); });
}

void check_consistency(const Parameters &p) {
    require(p.development.decision_interval % p.development.neighbourhood_interval == 0,
            "decision_interval is a multiple of neighbourhood_interval");
    require(p.gait.update_interval % p.gait.knot_interval == 0,
            "update_interval is a multiple of knot_interval");
    require(p.gait.locomotion_steps % p.gait.knot_interval == 0,
            "locomotion_steps is a multiple of knot_interval");
    require(p.gait.period_shortest <= p.gait.period_longest, "period_shortest is at most period_longest");
    require(p.neat.species_low <= p.neat.species_high, "species_low is at most species_high");
    require(p.neat.compatibility_floor <= p.neat.compatibility_threshold,
            "compatibility_floor is at most compatibility_threshold");
    require(p.novelty.archive_floor <= p.novelty.archive_threshold,
            "archive_floor is at most archive_threshold");
    require(p.settling.settle_window <= p.settling.settle_limit, "settle_window is at most settle_limit");
    require(p.neat.add_node_rate + p.neat.add_link_rate + p.neat.remove_link_rate +
                    p.neat.mutate_weights_rate >
                0,
            "at least one mutation operator has a weight above 0");
}

} // namespace planula
