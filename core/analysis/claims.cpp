// SPDX-License-Identifier: MIT
#include "analysis/claims.h"

#include "base/check.h"
#include "statistics/holm.h"

#include <algorithm>
#include <string>
#include <vector>

namespace planula {

namespace {

const SettingRuns &runs_of(const std::string &name, std::span<const SettingRuns> settings) {
    const auto found = std::find_if(settings.begin(), settings.end(),
                                    [&](const SettingRuns &setting) { return setting.spec->name == name; });
    CHECK(found != settings.end(), name);
    return *found;
}

/// The settings that a claim names.
std::vector<const SettingRuns *> named_settings(const Claim &claim, const RunData &data) {
    std::vector<const SettingRuns *> named{&runs_of(claim.a, data.settings)};
    if (!claim.b.empty()) named.push_back(&runs_of(claim.b, data.settings));
    return named;
}

int wanted_generations(const Claim &claim, const Analysis &analysis) {
    return claim.generation > 0 ? claim.generation : analysis.design.design.generations;
}

/// By which p the verdict of the data that there are is decided; empty if by none.
std::string deciding(const ClaimRow &row, double significance) {
    if (row.verdict_reached != "reproduced" && row.verdict_reached != "contradicted") return "";
    const bool equivalence = row.verdict_reached == "reproduced" && row.p_equivalence.has_value();
    const std::string name = equivalence ? "p_equivalence" : "p";
    const Maybe corrected = equivalence ? row.p_equivalence_holm : row.p_holm;
    return corrected.has_value() && *corrected < significance ? name + "_holm" : name;
}

} // namespace

ClaimRow judge_claim(const Claim &claim, const RunData &data) {
    std::vector<const SettingRuns *> settings = named_settings(claim, data);
    const int wanted = wanted_generations(claim, data.analysis);
    int generations = wanted;
    for (const SettingRuns *setting : settings) generations = std::min(generations, setting->generations);
    Finding finding;
    Asked asked;
    if (generations > 0) finding = claim.judge({data, claim, generations}, asked);
    if (asked.missing) finding = {};
    for (const SettingRuns *other : asked.settings) {
        if (std::count(settings.begin(), settings.end(), other) == 0) settings.push_back(other);
        generations = std::min(generations, other->generations);
    }
    const std::string note =
        shortfall(settings, data.analysis, std::max(wanted, asked.generations), generations);
    return {.id = claim.id,
            .statement = claim.statement,
            .section = claim.section,
            .paper = claim.paper,
            .test = claim.test,
            .setting_a = claim.a,
            .setting_b = claim.b,
            .generation = wanted,
            .at_generation = generations,
            .runs_a = static_cast<int>(settings[0]->runs.size()),
            .runs_b = claim.b.empty() ? 0 : static_cast<int>(settings[1]->runs.size()),
            .effect_name = finding.effect_name,
            .effect = finding.effect,
            .low = finding.low,
            .high = finding.high,
            .p = finding.p,
            .method = finding.method,
            .p_equivalence = finding.p_equivalence,
            .verdict = note.empty() ? finding.verdict : "open",
            .verdict_reached = finding.verdict,
            .calibrated = claim.calibrated,
            .note = note.empty() ? finding.note : note,
            .note_reached = finding.note};
}

void correct_claims(std::span<ClaimRow> rows, double significance) {
    std::vector<double> values;
    for (const ClaimRow &row : rows)
        for (const Maybe &p : {row.p, row.p_equivalence})
            if (p.has_value()) values.push_back(*p);
    const std::vector<double> corrected = holm(values);
    auto next = corrected.begin();
    for (ClaimRow &row : rows) {
        if (row.p.has_value()) row.p_holm = *next++;
        if (row.p_equivalence.has_value()) row.p_equivalence_holm = *next++;
        row.decided_by = deciding(row, significance);
    }
}

} // namespace planula
