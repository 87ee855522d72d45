// SPDX-License-Identifier: MIT
#include "experiment/identity.h"

#include "base/hash.h"
#include "base/text.h"
#include "experiment/deciding.h"
#include "experiment/revision.h"
#include "experiment/world_numbers.h"

#include <algorithm>

namespace planula {

namespace {

const std::string parameter_key = "parameter ", function_key = "function ", none = "none";
constexpr std::size_t shown_digits = 12; // of a hash in a message

bool is_hash(std::string_view key) { return key == "model" || key.starts_with(function_key); }

/// A count of things and the hash of their numbers.
std::string counted(std::size_t count, const std::string &things, const Hash &numbers) {
    const std::string number = to_text(static_cast<std::int64_t>(count));
    return number + " " + things + " " + numbers.hex();
}

/// "none" without points.
std::string points_text(const std::vector<Vec2d> &points, const char *what = "points") {
    if (points.empty()) return none;
    Hash numbers;
    for (const Vec2d point : points) numbers.number(point.x).number(point.y);
    return counted(points.size(), what, numbers);
}

std::string ground_text(const Environment &environment) {
    if (!environment.has_ground) return none;
    return environment.ground.empty() ? "flat" : points_text(environment.ground);
}

std::string obstacles_text(const Environment &environment) {
    if (environment.obstacles.empty()) return none;
    Hash content;
    for (const auto &[points, friction] : environment.obstacles) {
        content.number(std::uint64_t{points.size()}).number(friction.value_or(environment.friction));
        for (const Vec2d point : points) content.number(point.x).number(point.y);
    }
    return counted(environment.obstacles.size(), "obstacles", content);
}

std::string patches_text(const Environment &environment) {
    if (environment.friction_patches.empty()) return none;
    Hash content;
    for (const auto &[from, to, friction] : environment.friction_patches)
        content.number(from).number(to).number(friction);
    return counted(environment.friction_patches.size(), "patches", content);
}

std::string regions_text(const std::vector<Region> &regions) {
    if (regions.empty()) return none;
    Hash numbers;
    for (const Region &region : regions) {
        const auto &[box, normal, tangential, flow, buoyancy] = region;
        numbers.number(box.left).number(box.right).number(box.bottom).number(box.top);
        numbers.number(normal).number(tangential).number(flow ? 1 : 0).number(buoyancy ? 1 : 0);
        if (flow) numbers.number(flow->x).number(flow->y);
        if (buoyancy) numbers.number(*buoyancy);
    }
    return counted(regions.size(), regions.size() == 1 ? "region" : "regions", numbers);
}

std::string current_text(const Current &current) {
    if (!current.changes()) return none;
    Hash numbers;
    for (const Vec2d sample : current.samples) numbers.number(sample.x).number(sample.y);
    const std::string repeats = current.repeats ? ", again and again" : "";
    return counted(current.samples.size(), "samples, one every " + to_text(current.step) + " steps" + repeats,
                   numbers);
}

std::string damage_text(const std::optional<Damage> &damage) {
    if (!damage) return none;
    const std::string at = "at step " + to_text(damage->at) + ", ";
    if (!damage->within)
        return at + to_text(damage->share) + " of the cells, " +
               std::string(side_names[static_cast<std::size_t>(damage->side)]);
    const auto &[left, right, bottom, top] = *damage->within;
    return at + "x " + to_text(left) + " to " + to_text(right) + ", y " + to_text(bottom) + " to " +
           to_text(top);
}

/// The items of a world, whose keys begin with `prefix`. Those that came later are there only if they are stated.
void add_environment(const std::string &prefix, const Conditions &conditions, Identity &identity) {
    const auto add = [&](std::string_view name, const std::string &value, const std::string &standard = "") {
        if (value != standard) identity.items.push_back({prefix + std::string(name), value, "", standard});
    };
    for (const WorldNumber &number : world_numbers()) {
        add(number.name, to_text(value_of(number, conditions)), number.absent ? to_text(*number.absent) : "");
        if (&number == &world_numbers().front()) add("ground", ground_text(conditions.environment));
    }
    add("regions", regions_text(conditions.environment.regions), none);
    add("current", current_text(conditions.environment.current), none);
    add("obstacles", obstacles_text(conditions.environment), none);
    add("ceiling", points_text(conditions.environment.ceiling), none);
    add("friction_patches", patches_text(conditions.environment), none);
    add("object", points_text(conditions.environment.object.positions, "cells"), none);
}

/// What happens to a body on its way, only if it is stated.
void add_course(const Spec &spec, Identity &identity) {
    const auto add = [&](const std::string &key, const std::string &value) {
        if (value != none) identity.items.push_back({key, value, "", none});
    };
    for (std::size_t i = 0; i < spec.phases.size(); ++i) {
        const Phase &phase = spec.phases[i];
        add(name_in_phase(i, "begins"), "at step " + to_text(phase.at) + (phase.settles ? ", settles" : ""));
        add_environment(name_in_phase(i, ""), conditions_of(phase), identity);
    }
    add("damage", damage_text(spec.damage));
}

/// Only what is stated: runs of other experiments have no such items.
void add_aims(const Aims &aims, Identity &identity) {
    const auto add = [&](const std::string &what, std::size_t index, const std::string &value) {
        identity.items.push_back({what + " " + to_text(static_cast<std::int64_t>(index + 1)), value, "", ""});
    };
    for (std::size_t i = 0; i < aims.objectives.size(); ++i)
        add("objective", i, std::string(name_of(aims.objectives[i].goal)) + " " + aims.objectives[i].name);
    for (std::size_t i = 0; i < aims.descriptor.size(); ++i) {
        const DescriptorNumber &number = aims.descriptor[i];
        std::string text = number.name;
        if (number.cells > 0) {
            text.append(" ").append(to_text(number.from)).append(" to ").append(to_text(number.to));
            text.append(" in ").append(to_text(number.cells));
        }
        add("descriptor", i, text);
    }
}

std::string shown(std::string_view key, const std::string &value) {
    return is_hash(key) ? value.substr(0, shown_digits) : value;
}

std::string difference(const IdentityItem &recorded, const IdentityItem &asked) {
    if (recorded.key.starts_with(function_key))
        return recorded.key + ": recorded with that of " + recorded.place + ", asked for with that of " +
               asked.place + ", which means something else";
    return recorded.key + ": recorded with " + shown(recorded.key, recorded.value) + ", asked for with " +
           shown(asked.key, asked.value);
}

} // namespace

const std::string *Identity::find(std::string_view key) const {
    for (const IdentityItem &item : items)
        if (item.key == key) return &item.value;
    return nullptr;
}

IdentityItem Identity::item(const std::string &key, const std::string &standard) const {
    for (const IdentityItem &item : items)
        if (item.key == key) return item;
    return {key, standard.empty() ? "nothing" : standard, "nowhere", standard};
}

std::string Identity::sha256() const {
    Hash hash;
    for (const IdentityItem &item : items)
        if (item.value != item.standard) hash.text(item.key).text(item.value);
    return hash.hex();
}

Identity identity_of(const Spec &spec, std::uint64_t seed) {
    Identity identity;
    const auto add = [&](const std::string &key, const std::string &value, const std::string &place = "") {
        identity.items.push_back({key, value, place, ""});
    };
    add("model", std::string(model_revision()));
    add("seed", to_text(static_cast<std::int64_t>(seed)));
    add("actuation", name_of(spec.actuation));
    add("search", spec.search);
    add("engine", spec.engine);
    add("start", spec.start ? to_text(spec.start->generations) + " generations" : "none");
    add_environment("environment ", spec, identity);
    add_course(spec, identity);
    add_aims(spec.aims, identity);
    for (const FunctionMeaning &function : spec.judgement)
        add(function_key + function.name, function.sha256, function.place);
    for (const ParameterRow &row : parameter_rows())
        if (decides_lives(row))
            identity.items.push_back({parameter_key + std::string(row.name),
                                      value_text(row, parameter(spec.parameters, row.name)), "",
                                      value_text(row, row.standard)});
    return identity;
}

std::vector<std::string> differences(const Identity &recorded, const Identity &asked) {
    std::vector<std::string> found;
    const auto compare = [&](const IdentityItem &a, const IdentityItem &b) {
        if (a.value != b.value) found.push_back(difference(a, b));
    };
    for (const IdentityItem &item : recorded.items) compare(item, asked.item(item.key, item.standard));
    for (const IdentityItem &item : asked.items)
        if (!recorded.find(item.key)) compare(recorded.item(item.key, item.standard), item);
    return found;
}

} // namespace planula
