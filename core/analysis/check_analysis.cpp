// SPDX-License-Identifier: MIT
#include "analysis/analysis.h"
#include "base/error.h"
#include "base/text.h"
#include "tables/columns.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace planula {

namespace {

std::string unknown_name(const std::string &name, const std::string &nearest) {
    return "'" + name + "'" + (nearest.empty() ? "" : "; did you mean '" + nearest + "'?");
}

void require_setting(const std::string &name, const std::string &where, std::span<const Spec> settings) {
    std::vector<std::string> names;
    for (const Spec &spec : settings) names.push_back(spec.name);
    if (std::find(names.begin(), names.end(), name) == names.end())
        throw InputError(where + ": there is no setting " + unknown_name(name, nearest_name(name, names)));
}

void check_claim(const Claim &claim, std::span<const Spec> settings) {
    const std::string where = "claim '" + claim.id + "'";
    require_setting(claim.a, where, settings);
    if (!claim.b.empty()) require_setting(claim.b, where, settings);
    if (claim.generation < 0)
        throw InputError(where + ": generation = " + to_text(claim.generation) + " must be at least 0");
}

/// The file of a table must not be that of another.
void check_table(const TableStatement &table) {
    check_name("a table", table.name);
    for (const ColumnRow &column : columns())
        if (column.file == table.name + ".csv")
            throw InputError("planula writes " + column.file + " itself; give the table '" + table.name +
                             "' another name");
}

void require_share(double value, const char *name) {
    if (!(value > 0 && value <= 1))
        throw InputError(std::string("statistics: ") + name + " = " + to_text(value) +
                         " must be above 0 and at most 1");
}

} // namespace

void check_analysis(const Analysis &analysis, std::span<const Spec> settings) {
    require_share(analysis.sample_share, "sample_share");
    require_share(analysis.significance, "significance");
    require_share(analysis.confidence, "confidence");
    if (analysis.confidence == 1) throw InputError("statistics: confidence = 1 must be below 1");
    if (analysis.resamples < 1)
        throw InputError("statistics: resamples = " + to_text(analysis.resamples) + " must be at least 1");
    if (analysis.interval_runs < 1)
        throw InputError("statistics: interval_runs = " + to_text(analysis.interval_runs) +
                         " must be at least 1");
    if (!(analysis.direction_distance >= 0) || std::isinf(analysis.direction_distance))
        throw InputError("statistics: direction_distance = " + to_text(analysis.direction_distance) +
                         " must be finite and at least 0");
    if (analysis.sample_least < 0)
        throw InputError("statistics: sample_least = " + to_text(analysis.sample_least) +
                         " must be at least 0");
    if (analysis.fitness_classes < 1 || 100 % analysis.fitness_classes != 0)
        throw InputError("statistics: fitness_classes = " + to_text(analysis.fitness_classes) +
                         " must divide 100: 1, 2, 4, 5, 10, 20, 25, 50 or 100");
    for (const std::string &name : analysis.endpoint_settings) require_setting(name, "endpoints", settings);
    for (const Claim &claim : analysis.claims) check_claim(claim, settings);
    for (const TableStatement &table : analysis.tables) check_table(table);
}

} // namespace planula
