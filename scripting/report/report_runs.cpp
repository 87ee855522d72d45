// SPDX-License-Identifier: MIT
#include "report/report_runs.h"

#include "base/error.h"
#include "base/text.h"
#include "experiment/identity.h"
#include "record/run_reader.h"

#include <algorithm>
#include <set>

namespace planula {

namespace {

/// <runs> of <runs>/<setting>/seed-NNN.
std::filesystem::path design_of(const std::filesystem::path &run) { return run.parent_path().parent_path(); }

std::string progress_text(const std::filesystem::path &folder) {
    const int kept = recorded_generations(folder);
    return folder.string() + ": not complete" +
           (kept > 0 ? ", " + to_text(kept) + " generations are saved" : std::string());
}

/// The only design that the runs are of.
std::filesystem::path only_design(const std::filesystem::path &folder, const std::vector<RecordedRun> &runs) {
    std::set<std::string> designs;
    for (const RecordedRun &run : runs) designs.insert(design_of(run.folder).string());
    if (designs.size() > 1)
        throw InputError(folder.string() + " has runs of " +
                         to_text(static_cast<std::int64_t>(designs.size())) +
                         " designs, and a report is about one; name one of " + list_of(designs));
    return *designs.begin();
}

bool is_same(const std::filesystem::path &a, const std::filesystem::path &b) {
    return std::filesystem::equivalent(a, b);
}

} // namespace

ReportRuns report_runs(const std::filesystem::path &folder) {
    ReportRuns found;
    for (const std::filesystem::path &run : folders_with_runs(folder)) {
        if (std::filesystem::exists(run / ManifestRow::file_name))
            found.runs.push_back(open_run(run.lexically_normal()));
        else
            found.unfinished.push_back(progress_text(run));
    }
    if (found.runs.empty())
        throw InputError(folder.string() + ": there is no complete run (<setting>/seed-NNN) in this folder" +
                         (found.unfinished.empty() ? "" : "; " + found.unfinished.front()));
    found.choice.folder = only_design(folder, found.runs);
    if (is_same(folder, found.choice.folder)) return found;

    const RecordedRun &first = found.runs.front();
    found.settings = {first.folder.parent_path().filename().string()};
    if (is_same(folder, first.folder)) found.choice.seeds = {static_cast<std::uint64_t>(first.seed)};
    return found;
}

void keep_settings(Experiment &experiment, const std::vector<std::string> &names) {
    const auto is_kept = [&](const std::string &name) {
        return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
    };
    for (std::size_t i = experiment.settings.size(); i-- > 0;) {
        if (is_kept(experiment.settings[i].name)) continue;
        const auto at = static_cast<std::ptrdiff_t>(i);
        experiment.settings.erase(experiment.settings.begin() + at);
        experiment.functions.erase(experiment.functions.begin() + at);
        experiment.world_places.erase(experiment.world_places.begin() + at);
        experiment.places.erase(experiment.places.begin() + at);
    }
    Analysis &analysis = experiment.analysis;
    std::erase_if(analysis.claims, [&](const Claim &claim) {
        return !is_kept(claim.a) || (!claim.b.empty() && !is_kept(claim.b));
    });
    std::erase_if(analysis.endpoint_settings, [&](const std::string &name) { return !is_kept(name); });
}

void ask_common_generations(Experiment &experiment, const std::vector<RecordedRun> &runs) {
    for (Spec &setting : experiment.settings) {
        int common = 0;
        for (const RecordedRun &run : runs) {
            const bool is_of_setting =
                run.setting == setting.name &&
                differences(run.identity, identity_of(setting, static_cast<std::uint64_t>(run.seed))).empty();
            if (is_of_setting) common = common == 0 ? run.generations : std::min(common, run.generations);
        }
        if (common > 0) setting.parameters.design.generations = common;
    }
}

} // namespace planula
