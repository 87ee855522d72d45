// SPDX-License-Identifier: MIT
#include "analysis/survey.h"

#include "base/check.h"
#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <numeric>

namespace planula {

std::vector<SettingRuns> survey(std::span<const Spec> settings, const std::filesystem::path &runs) {
    std::vector<SettingRuns> found;
    bool any = false;
    for (const Spec &spec : settings) {
        SettingRuns &setting = found.emplace_back();
        setting.spec = &spec;
        setting.runs = find_runs(runs, spec.name);
        if (setting.runs.empty()) continue;
        any = true;
        setting.generations = spec.parameters.generations;
        for (const RecordedRun &run : setting.runs) {
            if (run.population != spec.parameters.population)
                throw InputError(run.folder.string() + " has a population of " + to_text(run.population) +
                                 ", and the experiment one of " + to_text(spec.parameters.population));
            setting.generations = std::min(setting.generations, run.generations);
        }
    }
    if (!any) throw InputError("there is no complete run below " + runs.string());
    return found;
}

std::vector<std::size_t> ranking(const SettingRuns &setting) {
    std::vector<std::size_t> order(setting.histories.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return setting.outcome_of(a).champion.fitness > setting.outcome_of(b).champion.fitness;
    });
    return order;
}

std::size_t rank_below_median(std::size_t count) {
    CHECK(count >= 1);
    return std::min((count + 1) / 2, count - 1);
}

} // namespace planula
