// SPDX-License-Identifier: MIT
#include "analysis/survey.h"

#include "base/check.h"
#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <numeric>

namespace planula {

namespace {

bool is_chosen(const RunChoice &choice, std::int64_t seed) {
    return choice.seeds.empty() ||
           std::count(choice.seeds.begin(), choice.seeds.end(), static_cast<std::uint64_t>(seed)) > 0;
}

/// Whether a line "folder: reason" is of the folder of a chosen seed.
bool is_about_chosen(const Spec &spec, const RunChoice &choice, const std::string &line) {
    return choice.seeds.empty() ||
           std::any_of(choice.seeds.begin(), choice.seeds.end(), [&](std::uint64_t seed) {
               return line.starts_with(run_folder(choice.folder, spec.name, seed).string() + ": ");
           });
}

/// Tells of each seed that is asked for and has no run.
void tell_missing(const Spec &spec, const RunChoice &choice, std::span<const RecordedRun> runs) {
    for (const std::uint64_t seed : choice.seeds)
        if (std::none_of(runs.begin(), runs.end(), [&](const RecordedRun &run) {
                return static_cast<std::uint64_t>(run.seed) == seed;
            }))
            choice.tell("missing: " + run_folder(choice.folder, spec.name, seed).string());
}

std::vector<RecordedRun> chosen_runs(const Spec &spec, const RunChoice &choice) {
    FoundRuns found = find_runs(choice.folder, spec, spec.parameters.design.generations);
    for (const std::string &line : found.left_out)
        if (is_about_chosen(spec, choice, line)) choice.tell("left out: " + line);
    std::erase_if(found.runs, [&](const RecordedRun &run) { return !is_chosen(choice, run.seed); });
    tell_missing(spec, choice, found.runs);
    return std::move(found.runs);
}

} // namespace

SettingRuns runs_of_setting(const Spec &spec, const RunChoice &choice) {
    SettingRuns setting{.spec = &spec, .runs = chosen_runs(spec, choice)};
    if (!setting.runs.empty()) setting.generations = spec.parameters.design.generations;
    return setting;
}

std::vector<SettingRuns> survey(std::span<const Spec> settings, const RunChoice &choice) {
    std::vector<SettingRuns> all;
    for (const Spec &spec : settings) all.push_back(runs_of_setting(spec, choice));
    if (std::all_of(all.begin(), all.end(), [](const SettingRuns &setting) { return setting.runs.empty(); }))
        throw InputError("there is no run of this experiment below " + choice.folder.string() + " that has " +
                         to_text(settings.front().parameters.design.generations) + " generations");
    for (const SettingRuns &setting : all)
        if (setting.runs.empty() && choice.seeds.empty())
            choice.tell("left out: the setting " + setting.spec->name + ": there is no run of it in " +
                        (choice.folder / setting.spec->name).string());
    return all;
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
