// SPDX-License-Identifier: MIT
#include "analysis/claims.h"

#include "analysis/claim_test.h"
#include "base/check.h"
#include "base/text.h"
#include "statistics/holm.h"

#include <algorithm>
#include <string>
#include <vector>

namespace planula {

namespace {

const ClaimTest &test_of(const Claim &claim) {
    const ClaimTest *test = find_test(claim.test);
    CHECK(test != nullptr, claim.test);
    return *test;
}

const SettingRuns &runs_of(const std::string &name, std::span<const SettingRuns> settings) {
    const auto found = std::find_if(settings.begin(), settings.end(),
                                    [&](const SettingRuns &setting) { return setting.spec->name == name; });
    CHECK(found != settings.end(), name);
    return *found;
}

Case case_of(const Claim &claim, const Analysis &analysis, std::span<const SettingRuns> settings) {
    Case c{claim, analysis, &runs_of(claim.a, settings), nullptr, 0};
    if (test_of(claim).compares_two()) c.b = &runs_of(claim.b, settings);
    c.generations = generations_of(claim, analysis, settings);
    return c;
}

int wanted_generations(const Claim &claim, const Analysis &analysis) {
    return claim.generation > 0 ? claim.generation : analysis.design.design.generations;
}

std::string runs_note(const SettingRuns &setting, int planned) {
    return to_text(static_cast<int>(setting.runs.size())) + " of " + to_text(planned) + " runs of " +
           setting.spec->name;
}

/// What the data lack for a verdict, in words; empty if nothing.
std::string shortfall(const Case &c) {
    const Parameters &design = c.analysis.design;
    std::vector<std::string> parts;
    const int wanted = wanted_generations(c.claim, c.analysis);
    if (c.generations > 0 && c.generations < wanted)
        parts.push_back("data end after " + to_text(c.generations) + " of " + to_text(wanted) +
                        " generations");
    for (const SettingRuns *setting : {c.a, c.b}) {
        if (setting == nullptr) continue;
        if (setting->runs.empty()) {
            parts.push_back("no runs of " + setting->spec->name);
            continue;
        }
        if (static_cast<int>(setting->runs.size()) < design.design.seeds)
            parts.push_back(runs_note(*setting, design.design.seeds));
        if (setting->spec->parameters.neat.population < design.neat.population)
            parts.push_back("population " + to_text(setting->spec->parameters.neat.population) + " of " +
                            to_text(design.neat.population) + " in " + setting->spec->name);
    }
    std::string note;
    for (const std::string &part : parts) note += (note.empty() ? "" : "; ") + part;
    return note;
}

/// By which p a verdict is decided; empty if by none.
std::string deciding(const ClaimRow &row, double significance) {
    if (row.verdict != "reproduced" && row.verdict != "contradicted") return "";
    const bool equivalence = row.verdict == "reproduced" && row.p_equivalence.has_value();
    const std::string name = equivalence ? "p_equivalence" : "p";
    const Maybe corrected = equivalence ? row.p_equivalence_holm : row.p_holm;
    return corrected.has_value() && *corrected < significance ? name + "_holm" : name;
}

} // namespace

int generations_of(const Claim &claim, const Analysis &analysis, std::span<const SettingRuns> settings) {
    int generations = std::min(wanted_generations(claim, analysis), runs_of(claim.a, settings).generations);
    if (test_of(claim).compares_two())
        generations = std::min(generations, runs_of(claim.b, settings).generations);
    return generations;
}

ClaimRow judge_claim(const Claim &claim, const Analysis &analysis, std::span<const SettingRuns> settings) {
    const Case c = case_of(claim, analysis, settings);
    const Finding finding = c.generations > 0 ? test_of(claim).judge(c) : Finding{};
    const std::string note = shortfall(c);
    return {.id = claim.id,
            .statement = claim.statement,
            .section = claim.section,
            .paper = claim.paper,
            .test = claim.test,
            .setting_a = claim.a,
            .setting_b = claim.b,
            .generation = wanted_generations(claim, analysis),
            .at_generation = c.generations,
            .runs_a = static_cast<int>(c.a->runs.size()),
            .runs_b = c.b == nullptr ? 0 : static_cast<int>(c.b->runs.size()),
            .effect_name = finding.effect_name,
            .effect = finding.effect,
            .low = finding.low,
            .high = finding.high,
            .p = finding.p,
            .method = finding.method,
            .p_equivalence = finding.p_equivalence,
            .verdict = note.empty() ? finding.verdict : "open",
            .calibrated = claim.calibrated,
            .note = note.empty() ? finding.note : note};
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
