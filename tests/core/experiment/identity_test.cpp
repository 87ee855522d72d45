// SPDX-License-Identifier: MIT
#include "experiment/identity.h"

#include "experiment/deciding.h"
#include "experiment/revision.h"
#include "experiment/world_numbers.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <functional>
#include <set>

using namespace planula;

namespace {

constexpr std::uint64_t seed = 3;
const std::string hash_a(64, 'a'), hash_b(64, 'b');

Spec setting() {
    Spec spec;
    spec.name = "osc";
    spec.title = "Oscillators";
    spec.actuation_range = 0.4;
    spec.environment = specimens::land();
    spec.judgement = {{"fitness", hash_a, "a.lua:3"}, {"behaviour", hash_a, "a.lua:7"}};
    return spec;
}

/// The differences after a change of the setting.
std::vector<std::string> changed(const std::function<void(Spec &)> &change) {
    Spec other = setting();
    change(other);
    const Identity recorded = identity_of(setting(), seed), asked = identity_of(other, seed);
    const auto lines = differences(recorded, asked);
    // The hash is equal if and only if the runs are one.
    BOOST_TEST((recorded.sha256() == asked.sha256()) == lines.empty());
    return lines;
}

/// The one difference.
std::string change_of(const std::function<void(Spec &)> &change) {
    const auto lines = changed(change);
    BOOST_TEST_REQUIRE(lines.size() == 1u);
    return lines.front();
}

} // namespace

BOOST_AUTO_TEST_CASE(a_changed_key_changes_the_identity_and_is_named_with_both_values) {
    BOOST_TEST(change_of([](Spec &s) { s.search = "novelty"; }) ==
               "search: recorded with neat, asked for with novelty");
    BOOST_TEST(change_of([](Spec &s) { s.actuation = Actuation::grn; }) ==
               "actuation: recorded with oscillator, asked for with grn");
    BOOST_TEST(change_of([](Spec &s) { s.engine = "bullet"; }) ==
               "engine: recorded with native, asked for with bullet");
    BOOST_TEST(change_of([](Spec &s) { s.start.emplace(); }) ==
               "start: recorded with none, asked for with 1 generations");
    BOOST_TEST(change_of([](Spec &s) { s.actuation_range = 0.25; }) ==
               "environment actuation_range: recorded with 0.4, asked for with 0.25");
    using Field = double Environment::*;
    const std::pair<const char *, Field> fields[] = {{"gravity", &Environment::gravity},
                                                     {"friction", &Environment::friction},
                                                     {"drag normal", &Environment::drag_normal},
                                                     {"drag tangential", &Environment::drag_tangential}};
    for (const auto &[name, field] : fields) {
        const std::string line = change_of([field = field](Spec &s) { s.environment.*field += 0.125; });
        BOOST_TEST(line.starts_with("environment " + std::string(name) + ": recorded with "), line);
    }
    BOOST_TEST(change_of([](Spec &s) { s.environment.flow.x = 2; }) ==
               "environment flow x: recorded with 0, asked for with 2");
    BOOST_TEST(change_of([](Spec &s) { s.environment.flow.y = -1; }) ==
               "environment flow y: recorded with 0, asked for with -1");
}

BOOST_AUTO_TEST_CASE(fields_phases_and_damage_are_in_the_identity_only_if_they_are_stated) {
    for (const IdentityItem &item : identity_of(setting(), seed).items)
        for (const std::string key : {"direction", "regions", "environment current", "phase", "damage"})
            BOOST_TEST(item.key.find(key) == std::string::npos, item.key);
    BOOST_TEST(change_of([](Spec &s) { s.environment.gravity_direction = -10; }) ==
               "environment gravity direction: recorded with 0, asked for with -10");
    const auto stated = [&](const std::string &key, const std::function<void(Spec &)> &change) {
        const std::string line = change_of(change);
        BOOST_TEST(line.starts_with(key + ": recorded with none, asked for with "), line);
    };
    stated("environment regions", [](Spec &s) { s.environment.regions = {{.drag_normal = 1}}; });
    stated("environment current", [](Spec &s) { s.environment.current = {{{0, 1}, {1, 0}}, 10, true}; });
    BOOST_TEST(change_of([](Spec &s) { s.damage = Damage{.at = 20, .share = 0.25, .side = Side::top}; }) ==
               "damage: recorded with none, asked for with at step 20, 0.25 of the cells, top");

    // Every number of theirs counts.
    Spec whole = setting();
    whole.environment.regions = {{{0, 1, 2, 3}, 1, 2, Vec2d{3, 4}, {}}, {{}, 0, 0, {}, 0.5}};
    whole.environment.current = {{{0, 1}, {1, 0}}, 10, true};
    whole.phases = {{10, specimens::water(), 0.4, false}, {20, specimens::land(), 0.3, true}};
    whole.damage = Damage{.at = 20, .within = Box{.left = 1}};
    const auto counts = [&](const std::function<void(Spec &)> &change) {
        Spec other = whole;
        change(other);
        const Identity a = identity_of(whole, seed), b = identity_of(other, seed);
        BOOST_TEST(differences(a, b).size() == 1u);
        BOOST_TEST(a.sha256() != b.sha256());
    };
    counts([](Spec &s) { s.environment.regions[0].box.top = 4; });
    counts([](Spec &s) { s.environment.regions[0].drag_tangential = 4; });
    counts([](Spec &s) { s.environment.regions[0].flow->y = 0; });
    counts([](Spec &s) { s.environment.regions[0].flow.reset(); });
    counts([](Spec &s) { s.environment.regions[1].buoyancy = 0; });
    counts([](Spec &s) { std::swap(s.environment.regions[0], s.environment.regions[1]); });
    counts([](Spec &s) { s.environment.current.samples[1].y = 1; });
    counts([](Spec &s) { s.environment.current.step = 20; });
    counts([](Spec &s) { s.environment.current.repeats = false; });
    counts([](Spec &s) { s.phases[0].at = 15; });
    counts([](Spec &s) { s.phases[1].settles = false; });
    counts([](Spec &s) { s.phases[0].actuation_range = 0.1; });
    counts([](Spec &s) { s.phases[1].environment.friction = 0.1; });
    counts([](Spec &s) { s.phases[1].environment.ground = {{0, 0}, {1, 1}}; });
    counts([](Spec &s) { s.phases[1].environment.regions = {{.buoyancy = 1}}; });
    counts([](Spec &s) { s.damage->at = 0; });
    counts([](Spec &s) { s.damage->within->left = 2; });
}

BOOST_AUTO_TEST_CASE(grounds_are_told_apart_point_by_point) {
    BOOST_TEST(change_of([](Spec &s) { s.environment.has_ground = false; }) ==
               "environment ground: recorded with flat, asked for with none");
    const auto hilly = [](double height) {
        Spec spec = setting();
        spec.environment.ground = {{0, 0}, {1, height}, {2, 0}};
        return identity_of(spec, seed);
    };
    BOOST_TEST(hilly(1).find("environment ground")->starts_with("3 points "));
    BOOST_TEST(differences(hilly(1), hilly(1)).empty());
    BOOST_TEST(differences(hilly(1), hilly(std::nextafter(1, 2))).size() == 1u);
    BOOST_TEST(differences(hilly(1), identity_of(setting(), seed)).size() == 1u);
}

BOOST_AUTO_TEST_CASE(another_seed_or_model_is_another_run) {
    const Identity one = identity_of(setting(), 3), two = identity_of(setting(), 4);
    BOOST_TEST(
        (differences(one, two) == std::vector<std::string>{"seed: recorded with 3, asked for with 4"}));
    BOOST_TEST(one.sha256() != two.sha256());
    Identity model = one;
    BOOST_REQUIRE(model.items.front().key == "model");
    BOOST_TEST(model.items.front().value == model_revision());
    model.items.front().value = hash_b;
    BOOST_TEST((differences(model, one) ==
                std::vector<std::string>{"model: recorded with bbbbbbbbbbbb, asked for with " +
                                         std::string(model_revision().substr(0, 12))}));
    BOOST_TEST(model.sha256() != one.sha256());
}

BOOST_AUTO_TEST_CASE(every_parameter_that_decides_lives_is_in_the_identity_and_no_other) {
    for (const ParameterRow &row : parameter_rows()) {
        const double value = row.standard == row.lowest ? row.highest : row.lowest;
        if (value == row.standard) continue;
        const auto lines = changed([&](Spec &s) { set_parameter(s.parameters, row.name, value); });
        BOOST_TEST(lines.size() == (decides_lives(row) ? 1u : 0u), row.name);
        if (!lines.empty())
            BOOST_TEST(lines.front().starts_with("parameter " + std::string(row.name) + ": recorded with "),
                       lines.front());
    }
}

BOOST_AUTO_TEST_CASE(names_places_and_lengths_are_not_in_the_identity) {
    BOOST_TEST(changed([](Spec &s) { s.name = "other"; }).empty());
    BOOST_TEST(changed([](Spec &s) { s.title = "Other"; }).empty());
    BOOST_TEST(changed([](Spec &s) { s.parameters.design.generations = 7; }).empty());
    BOOST_TEST(changed([](Spec &s) { s.parameters.design.seeds = 7; }).empty());
    BOOST_TEST(changed([](Spec &s) { set_parameter(s.parameters, "confidence", 0.5); }).empty());
    BOOST_TEST(changed([](Spec &s) { s.record = sample_record; }).empty());
    BOOST_TEST(changed([](Spec &s) { s.judgement[0].place = "elsewhere.lua:99"; }).empty());
    BOOST_TEST(changed([](Spec &s) { s.judge = [](const Life &) { return Evaluation{}; }; }).empty());
}

BOOST_AUTO_TEST_CASE(aims_are_in_the_identity_where_they_are_stated) {
    using enum Objective::Value;
    const auto with = [](Objective::Goal goal, double to) {
        return [=](Spec &s) { s.aims = {{{"work", stated, goal}}, {{"size", 0, to, 4}}}; };
    };
    const auto lines = changed(with(Objective::Goal::minimise, 10));
    BOOST_REQUIRE(lines.size() == 2u);
    BOOST_TEST(lines[0] == "objective 1: recorded with nothing, asked for with minimise work");
    BOOST_TEST(lines[1] == "descriptor 1: recorded with nothing, asked for with size 0 to 10 in 4");
    BOOST_TEST(changed([](Spec &s) { s.aims = {{}, {{"size"}}}; }).size() == 1u);
}

BOOST_AUTO_TEST_CASE(functions_are_compared_by_meaning_and_named_with_their_places) {
    BOOST_TEST(change_of([](Spec &s) {
                   s.judgement[0] = {"fitness", hash_b, "b.lua:5"};
               }) ==
               "function fitness: recorded with that of a.lua:3, asked for with that of b.lua:5, which means "
               "something else");
    BOOST_TEST(
        change_of([](Spec &s) { s.judgement.pop_back(); }) ==
        "function behaviour: recorded with that of a.lua:7, asked for with that of nowhere, which means "
        "something else");
    BOOST_TEST(change_of([](Spec &s) {
                   s.judgement.push_back({"penalty", hash_a, "a.lua:9"});
               }) ==
               "function penalty: recorded with that of nowhere, asked for with that of a.lua:9, which means "
               "something else");
}

BOOST_AUTO_TEST_CASE(a_parameter_that_the_record_does_not_know_had_its_standard_value) {
    const Identity whole = identity_of(setting(), seed);
    Identity older = whole;
    std::erase_if(older.items, [](const IdentityItem &item) { return item.key == "parameter gravity"; });
    BOOST_TEST(older.items.size() + 1 == whole.items.size());
    BOOST_TEST(older.sha256() == whole.sha256());
    BOOST_TEST(differences(older, whole).empty());
    BOOST_TEST(differences(whole, older).empty());
    Spec other = setting();
    other.parameters.land.gravity = 1;
    BOOST_TEST((differences(older, identity_of(other, seed)) ==
                std::vector<std::string>{"parameter gravity: recorded with 5, asked for with 1"}));

    // The value of a parameter that this version does not know always counts.
    Identity newer = whole;
    newer.items.push_back({"parameter lift", "0.5", ""});
    BOOST_TEST(newer.sha256() != whole.sha256());
    BOOST_TEST((differences(newer, whole) ==
                std::vector<std::string>{"parameter lift: recorded with 0.5, asked for with nothing"}));
}

BOOST_AUTO_TEST_CASE(a_part_that_the_record_does_not_know_had_what_worlds_without_it_have) {
    const Identity older = identity_of(setting(), seed);
    const auto with = [&](const std::string &key, const std::string &value, const std::string &standard) {
        Identity newer = older;
        newer.items.insert(newer.items.begin() + 8, {key, value, "", standard});
        return newer;
    };
    for (const auto &[key, standard] : {std::pair{"environment lift", "0"}, {"environment walls", "none"}}) {
        const Identity without = with(key, standard, standard), stated = with(key, "0.5", standard);
        BOOST_TEST(without.sha256() == older.sha256(), key);
        BOOST_TEST(differences(older, without).empty(), key);
        BOOST_TEST(differences(without, older).empty(), key);
        BOOST_TEST(stated.sha256() != older.sha256(), key);
        const std::string named = key;
        BOOST_TEST(
            (differences(older, stated) ==
             std::vector<std::string>{named + ": recorded with " + standard + ", asked for with 0.5"}));
        BOOST_TEST((differences(stated, older) ==
                    std::vector<std::string>{named + ": recorded with 0.5, asked for with " + standard}));
    }
}

BOOST_AUTO_TEST_CASE(a_part_of_the_environment_is_recorded_if_every_run_has_it_or_it_is_stated) {
    const Identity identity = identity_of(setting(), seed);
    for (const WorldNumber &number : world_numbers()) {
        const bool is_recorded = identity.find("environment " + std::string(number.name)) != nullptr;
        BOOST_TEST(is_recorded == !(number.absent && *number.absent == value_of(number, setting())),
                   number.name);
    }
}

BOOST_AUTO_TEST_CASE(the_hash_of_a_setting_is_the_one_that_runs_were_recorded_with) {
    // What a later version adds to parameters and environments must not change it.
    Identity identity = identity_of(setting(), seed);
    identity.items.front().value = hash_b;
    BOOST_TEST(identity.sha256() == "f3bc30d46e748417cee55a252790d5ad01f04c2fc89d2c9409ce8b45c62c71d7");
}

BOOST_AUTO_TEST_CASE(every_key_is_there_once_and_found) {
    const Identity identity = identity_of(setting(), seed);
    std::set<std::string> keys;
    for (const IdentityItem &item : identity.items) {
        BOOST_TEST(keys.insert(item.key).second, item.key);
        BOOST_TEST(identity.find(item.key) == &item.value);
        BOOST_TEST(!item.value.empty(), item.key);
    }
    BOOST_TEST(!identity.find("title"));
    BOOST_TEST(*identity.find("seed") == "3");
}

BOOST_AUTO_TEST_CASE(a_hash_depends_on_the_borders_between_keys_and_values) {
    Identity one, two;
    one.items = {{"ab", "c", ""}};
    two.items = {{"a", "bc", ""}};
    BOOST_TEST(one.sha256() != two.sha256());
}
