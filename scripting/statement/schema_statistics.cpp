// SPDX-License-Identifier: MIT
#include "statement/schema_statistics.h"

#include <set>

namespace planula {

namespace {

std::vector<std::string> read_endpoints(Reader &reader, std::span<const Spec> settings, Problems &problems) {
    std::vector<std::string> names;
    const Value *stated = reader.field("endpoints", Value::Kind::table, false);
    if (!stated) {
        for (const Spec &setting : settings) names.push_back(setting.name);
        return names;
    }
    const Place place = reader.at("endpoints");
    const Reader list(*stated, place, {}, problems, true);
    for (std::size_t i = 0; i < stated->list.size(); ++i) {
        if (stated->list[i].is(Value::Kind::text))
            names.push_back(stated->list[i].text);
        else
            problems.add(place.at(static_cast<int>(i + 1)), place.words + " is a list of settings' names");
    }
    return names;
}

Claim read_claim(const Value &table, const Place &place, Problems &problems) {
    Reader reader(table, place, keys_of("statistics.claims[]"), problems);
    Claim claim;
    claim.id = reader.text("id", true);
    claim.statement = reader.text("statement", true);
    claim.section = reader.text("section");
    claim.paper = reader.text("paper");
    claim.test = reader.text("test");
    claim.a = reader.text("a", true);
    claim.b = reader.text("b");
    claim.generation = reader.whole("generation");
    const Value *calibrated = reader.field("calibrated", Value::Kind::boolean, false);
    claim.calibrated = calibrated != nullptr && calibrated->boolean;
    reader.field("judge", Value::Kind::function, true);
    return claim;
}

// Each claim is checked by itself, so that its line is known, and then all together.
void read_claims(const Value &list, const Place &place, const StatisticSource &source,
                 std::span<const Spec> settings, Analysis &analysis, Problems &problems) {
    const Reader reader(list, place, {}, problems, true);
    std::vector<Claim> claims;
    std::set<std::string> ids;
    for (std::size_t i = 0; i < list.list.size(); ++i) {
        const Value &entry = list.list[i];
        const Place here = place.at(static_cast<int>(i + 1), &entry);
        const std::size_t problems_before = problems.count();
        if (entry.is(Value::Kind::table))
            claims.push_back(read_claim(entry, here, problems));
        else
            problems.add(here, here.words + " must be a table");
        if (problems.count() > problems_before) continue;
        claims.back().judge = judge_of(source, i);
        if (!ids.insert(claims.back().id).second)
            problems.add(here, "two claims are called '" + claims.back().id + "'");
        analysis.claims = {claims.back()};
        check_at(here, problems, [&] { check_analysis(analysis, settings); });
    }
    analysis.claims = std::move(claims);
}

void read_tables(const Value &tables, const Place &place, const StatisticSource &source,
                 std::span<const Spec> settings, Analysis &analysis, Problems &problems) {
    if (!tables.list.empty()) problems.add(place, place.words + " are stated by name: name = function");
    for (const auto &[name, value] : tables.fields) {
        const Place here = place.at(name, &value);
        if (!value.is(Value::Kind::function)) {
            problems.add(here, here.words + " must be a function, not " + name_of(value.kind));
            continue;
        }
        analysis.tables.push_back({name, table_of(source, name)});
        check_at(here, problems, [&] { check_analysis(analysis, settings); });
    }
}

} // namespace

Analysis read_statistics(const Value &table, const Place &place, const StatisticSource &source,
                         const std::string &experiment, const Parameters &design,
                         std::span<const Spec> settings, Problems &problems) {
    const std::size_t problems_before = problems.count();
    Reader reader(table, place, keys_of("statistics"), problems);
    Analysis analysis;
    analysis.experiment = experiment;
    analysis.design = design;
    analysis.confidence = reader.quantity("confidence", design, true).value_or(0);
    analysis.resamples = static_cast<int>(reader.quantity("resamples", design, true).value_or(0));
    analysis.significance = reader.number("significance", true).value_or(0);
    analysis.sample_share = reader.number("sample_share", true).value_or(0);
    if (table.find("sample_least")) analysis.sample_least = reader.whole("sample_least");
    if (table.find("interval_runs")) analysis.interval_runs = reader.whole("interval_runs");
    if (table.find("direction_distance"))
        analysis.direction_distance = reader.number("direction_distance").value_or(0);
    if (table.find("fitness_classes")) analysis.fitness_classes = reader.whole("fitness_classes");
    analysis.endpoint_settings = read_endpoints(reader, settings, problems);

    // The rules of the analysis, first without claims.
    if (problems.count() == problems_before)
        check_at(place, problems, [&] { check_analysis(analysis, settings); });
    const Value *claims = reader.field("claims", Value::Kind::table, false);
    if (claims && problems.count() == problems_before)
        read_claims(*claims, reader.at("claims"), source, settings, analysis, problems);
    const Value *tables = reader.field("tables", Value::Kind::table, false);
    if (tables && problems.count() == problems_before)
        read_tables(*tables, reader.at("tables"), source, settings, analysis, problems);
    if (problems.count() == problems_before)
        check_at(place, problems, [&] { check_analysis(analysis, settings); });
    return analysis;
}

} // namespace planula
