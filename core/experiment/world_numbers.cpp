// SPDX-License-Identifier: MIT
#include "experiment/world_numbers.h"

#include "base/text.h"

#include <algorithm>
#include <cstdint>

namespace planula {

namespace {

using View = std::string_view;

constexpr View nothing(const Environment &) { return ""; }

constexpr WorldNumber numbers[] = {
    {"gravity", "cell/t.u.²", [](Conditions &c) -> double & { return c.environment.gravity; },
     [](const Environment &) -> View { return "gravity"; }},
    {"gravity direction", "degree", [](Conditions &c) -> double & { return c.environment.gravity_direction; },
     nothing, 0},
    {"friction", "1", [](Conditions &c) -> double & { return c.environment.friction; },
     [](const Environment &) -> View { return "friction"; }},
    {"drag normal", "mass/cell²", [](Conditions &c) -> double & { return c.environment.drag_normal; },
     [](const Environment &) -> View { return "drag_normal"; }},
    {"drag tangential", "mass/cell²", [](Conditions &c) -> double & { return c.environment.drag_tangential; },
     [](const Environment &) -> View { return "drag_tangential"; }},
    {"flow x", "cell/t.u.", [](Conditions &c) -> double & { return c.environment.flow.x; }, nothing},
    {"flow y", "cell/t.u.", [](Conditions &c) -> double & { return c.environment.flow.y; }, nothing},
    {"actuation_range", "rest length", [](Conditions &c) -> double & { return c.actuation_range; },
     [](const Environment &e) -> View {
         return e.has_ground ? "actuation_range_terrestrial" : "actuation_range_aquatic";
     }},
};

} // namespace

std::span<const WorldNumber> world_numbers() { return numbers; }

double value_of(const WorldNumber &number, const Conditions &conditions) {
    return number.in(const_cast<Conditions &>(conditions)); // which is only read here
}

bool is_stated(const WorldNumber &number, const Conditions &conditions) {
    return number.absent != value_of(number, conditions);
}

Conditions conditions_of(const Phase &phase) {
    return {.actuation_range = phase.actuation_range, .environment = phase.environment};
}

std::string name_in_phase(std::size_t phase, std::string_view number) {
    return "phase " + to_text(static_cast<std::int64_t>(phase + 1)) + " " + std::string(number);
}

std::string_view source_of(const WorldNumber &number, const Spec &spec) {
    return source_of(number.name, spec);
}

std::string_view source_of(std::string_view name, const Spec &spec) {
    const auto found = spec.world_sources.find(name);
    return found == spec.world_sources.end() ? View() : View(found->second);
}

bool is_of_worlds(std::string_view parameter) {
    return std::any_of(std::begin(numbers), std::end(numbers), [&](const WorldNumber &number) {
        return number.standard({}) == parameter || number.standard({.has_ground = true}) == parameter;
    });
}

bool makes_world(std::string_view parameter, const Spec &spec) {
    return std::any_of(spec.world_sources.begin(), spec.world_sources.end(),
                       [&](const auto &source) { return source.second == parameter; });
}

const WorldNumber *stated_instead_of(std::string_view parameter, const Spec &spec) {
    if (parameter.empty() || makes_world(parameter, spec)) return nullptr;
    for (const WorldNumber &number : numbers)
        if (number.standard(spec.environment) == parameter && source_of(number, spec).empty()) return &number;
    return nullptr;
}

} // namespace planula
