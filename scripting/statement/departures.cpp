// SPDX-License-Identifier: MIT
#include "statement/departures.h"

#include "base/text.h"
#include "experiment/identity.h"
#include "experiment/world_numbers.h"
#include "statement/line_diff.h"
#include "statement/overrides.h"

#include <algorithm>

namespace planula {

namespace {

/// Whether an item of an identity is of the environment, or of what happens to bodies in it: whether it is nothing else.
bool is_of_environment(std::string_view key) {
    constexpr std::string_view whole[] = {"model", "seed", "actuation", "search", "engine", "start"};
    constexpr std::string_view first[] = {"function ", "parameter ", "objective ", "descriptor "};
    return std::find(std::begin(whole), std::end(whole), key) == std::end(whole) &&
           std::none_of(std::begin(first), std::end(first),
                        [&](std::string_view each) { return key.starts_with(each); });
}

/// The key of an identity as people read it.
std::string name_of_part(const std::string &key) {
    constexpr std::string_view before = "environment ";
    return key.starts_with(before) ? key.substr(before.size()) : key;
}

std::string with_unit(const std::string &value, std::string_view unit) {
    const bool has_unit = !unit.empty() && unit != "1" && parse_double(value);
    return has_unit ? value + " " + std::string(unit) : value;
}

/// The number of that name, which may stand in another world: "phase 1 gravity".
const WorldNumber *number_called(std::string_view name) {
    for (const WorldNumber &number : world_numbers())
        if (name == number.name || name.ends_with(" " + std::string(number.name))) return &number;
    return nullptr;
}

bool is_zero(const IdentityItem &item) { return item.value == "0" && number_called(item.key); }

std::string range_text(double low, double high) { return to_fixed(low, 2) + " to " + to_fixed(high, 2); }

std::string ground_text(const std::vector<Vec2d> &points) {
    const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                 [](const Vec2d &a, const Vec2d &b) { return a.y < b.y; });
    return to_text(static_cast<std::int64_t>(points.size())) + " points, x from " +
           range_text(points.front().x, points.back().x) + ", height from " + range_text(low->y, high->y);
}

/// The text without the hashes that stand in it behind a number of things.
std::string without_hashes(const std::string &text) {
    constexpr std::size_t digits = 64;
    std::string left;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find_first_not_of("0123456789abcdef", at);
        if (at > 0 && text[at - 1] == ' ' && std::min(end, text.size()) - at == digits) {
            left.pop_back();
            at += digits;
        } else
            left += text[at++];
    }
    return left;
}

/// A part of the environment as people read it.
std::string part_text(const Spec &spec, const std::string &name, const std::string &value) {
    if (const WorldNumber *number = number_called(name)) return with_unit(value, number->unit);
    if (name == "ground" && !spec.environment.ground.empty()) return ground_text(spec.environment.ground);
    return without_hashes(value);
}

std::vector<IdentityItem> environment_items(const Spec &spec) {
    std::vector<IdentityItem> items;
    for (IdentityItem &item : identity_of(spec, 0).items)
        if (is_of_environment(item.key)) items.push_back(std::move(item));
    return items;
}

/// The item of that key, or one with the value of environments without it.
IdentityItem item_of(const std::vector<IdentityItem> &items, const IdentityItem &like) {
    for (const IdentityItem &item : items)
        if (item.key == like.key) return item;
    return {like.key, like.standard.empty() ? "none" : like.standard, "", like.standard};
}

std::string start_text(const Spec &spec) {
    if (!spec.start) return "generation 0 is random";
    const int generations = spec.start->generations;
    return to_text(generations) + (generations == 1 ? " generation" : " generations") +
           " of novelty search on growth alone";
}

const FunctionText *find(const std::vector<FunctionText> &texts, const std::string &name) {
    for (const FunctionText &text : texts)
        if (text.name == name) return &text;
    return nullptr;
}

std::string uses_text(const FunctionText &text) {
    std::vector<std::string> uses;
    for (const auto &[name, value] : text.upvalues) uses.push_back(name + " = " + value);
    return uses.empty() ? "" : "uses " + list_of(uses);
}

} // namespace

Comparison::Comparison(const Experiment &experiment, const std::filesystem::path &library)
    : experiment_(experiment), paper_(load_experiment(library / "paper" / "replication.lua", library)),
      meanings_(*experiment.sources), paper_meanings_(*paper_.sources) {}

std::size_t Comparison::counterpart_index(std::size_t index) const {
    const Spec &spec = experiment_.settings[index];
    std::size_t best = 0;
    int most = -1;
    for (std::size_t i = 0; i < paper_.settings.size(); ++i) {
        const Spec &candidate = paper_.settings[i];
        const int alike = 4 * (candidate.actuation == spec.actuation) +
                          2 * (candidate.environment.has_ground == spec.environment.has_ground) +
                          (candidate.search == spec.search);
        if (alike > most) most = alike, best = i;
    }
    return best;
}

std::vector<Departure> Comparison::of_setting(std::size_t index) {
    std::vector<Departure> found;
    add_environment(index, found);
    add_evolution(index, found);
    add_functions(index, found);
    add_parameters(index, found);
    return found;
}

std::string Comparison::source_note(std::size_t index, const std::string &name) const {
    const std::string source(source_of(name, experiment_.settings[index]));
    if (!source.empty()) return "from the parameter " + source;
    const Places &numbers = experiment_.world_places[index], &keys = experiment_.places[index];
    const auto number = numbers.find(name);
    if (number != numbers.end()) return number->second;
    const auto environment = keys.find("environment");
    return environment == keys.end() ? "" : environment->second;
}

void Comparison::add_environment(std::size_t index, std::vector<Departure> &found) const {
    const Spec &spec = experiment_.settings[index], &paper = counterpart(index);
    const std::vector<IdentityItem> ours = environment_items(spec), theirs = environment_items(paper);
    const auto compare = [&](const IdentityItem &own, const IdentityItem &other) {
        if (own.value == other.value || (is_zero(own) && other.value == "none")) return;
        const std::string name = name_of_part(own.key);
        found.push_back({"environment",
                         name,
                         part_text(spec, name, own.value),
                         part_text(paper, name, other.value),
                         "",
                         source_note(index, name),
                         {}});
    };
    for (const IdentityItem &item : ours) compare(item, item_of(theirs, item));
    for (const IdentityItem &item : theirs)
        if (std::none_of(ours.begin(), ours.end(),
                         [&](const IdentityItem &own) { return own.key == item.key; }))
            compare(item_of(ours, item), item);
}

void Comparison::add_evolution(std::size_t index, std::vector<Departure> &found) const {
    const Spec &spec = experiment_.settings[index], &paper = counterpart(index);
    std::vector<std::string> searches;
    for (const Spec &setting : paper_.settings)
        if (std::find(searches.begin(), searches.end(), setting.search) == searches.end())
            searches.push_back(setting.search);
    if (std::find(searches.begin(), searches.end(), spec.search) == searches.end())
        found.push_back({"search", "search", spec.search, list_of(searches), "", "", {}});
    for (const IdentityItem &item : identity_of(spec, 0).items)
        if (item.key.starts_with("objective ") || item.key.starts_with("descriptor "))
            found.push_back({"search", item.key, item.value, "none", "", "", {}});
    if (spec.engine != paper.engine)
        found.push_back({"engine", "engine", spec.engine, paper.engine, "", "", {}});
    if (start_text(spec) != start_text(paper))
        found.push_back({"start", "start", start_text(spec), start_text(paper), "", "", {}});
}

void Comparison::add_functions(std::size_t index, std::vector<Departure> &found) {
    const Spec &spec = experiment_.settings[index], &paper = counterpart(index);
    const std::vector<FunctionText> ours = meanings_.texts_of_setting(index),
                                    theirs = paper_meanings_.texts_of_setting(counterpart_index(index));
    for (const FunctionMeaning &function : spec.judgement) {
        const auto known =
            std::find_if(paper.judgement.begin(), paper.judgement.end(),
                         [&](const FunctionMeaning &each) { return each.name == function.name; });
        if (known != paper.judgement.end() && known->sha256 == function.sha256) continue;
        const FunctionText *own = find(ours, function.name), *other = find(theirs, function.name);
        Departure departure{"function", function.name, function.place, other ? other->place : "none", "", "",
                            {}};
        if (own) departure.lines = line_diff(other ? other->lines : std::vector<std::string>(), own->lines);
        if (own) departure.note = uses_text(*own);
        if (own && other && own->lines == other->lines)
            departure.note = "the text is the paper's, what it uses is not: it " + departure.note;
        found.push_back(std::move(departure));
    }
}

void Comparison::add_parameters(std::size_t index, std::vector<Departure> &found) {
    const Spec &spec = experiment_.settings[index], &paper = counterpart(index);
    for (const ParameterRow &row : parameter_rows()) {
        const double value = parameter(spec.parameters, row.name),
                     standard = parameter(paper.parameters, row.name);
        if (value == standard || makes_world(row.name, spec)) continue;
        const std::string why =
            meanings_.mentions(index, row.name) ? "" : why_unread_by(experiment_, index, row);
        found.push_back({"parameter",
                         std::string(row.name),
                         with_unit(value_text(row, value), row.is_choice() ? "" : row.unit),
                         value_text(row, standard),
                         std::string(row.origin),
                         std::string(row.meaning) + (why.empty() ? "" : "; changes nothing: " + why),
                         {}});
    }
}

std::string environment_text(const Spec &spec) {
    std::vector<std::string> parts;
    for (const IdentityItem &item : environment_items(spec)) {
        const std::string name = name_of_part(item.key);
        if (is_zero(item)) continue;
        const std::string text = part_text(spec, name, item.value);
        parts.push_back(text.ends_with(" " + name) ? text : name + " " + text);
    }
    return list_of(parts);
}

} // namespace planula
