// SPDX-License-Identifier: MIT
// An experiment as the folder of a run keeps it, and back.
#include "statement/recorded.h"

#include "base/error.h"
#include "experiment/deciding.h"
#include "tables/csv.h"

#include <algorithm>

namespace planula {

namespace {

/// The file of a module below the folder of scripts: "paper.judgement" is paper/judgement.lua.
std::string file_of(const std::string &module) {
    if (module.empty()) return script_file;
    std::string path = module;
    std::replace(path.begin(), path.end(), '.', '/');
    return path + ".lua";
}

} // namespace

RunSources sources_of(const Experiment &experiment) {
    RunSources sources;
    for (const Source &source : experiment.sources->all()) {
        const std::string file = file_of(source.module);
        for (const RunSources::File &other : sources.files)
            if (other.path == file)
                throw InputError(source.name +
                                 ": the name is reserved in a recorded experiment; rename the module '" +
                                 source.module + "'");
        sources.files.push_back({file, source.name, source.text});
    }
    for (const auto &[name, value] : experiment.overrides)
        if (decides_lives(parameter_row(name))) sources.overrides.emplace_back(name, value);
    return sources;
}

Experiment recorded_experiment(const std::filesystem::path &folder, Part part) {
    const std::filesystem::path scripts = script_folder(folder);
    Overrides overrides;
    for (const OverrideRow &row : read_table<OverrideRow>(scripts))
        overrides.emplace_back(row.parameter, value_of(parameter_row(row.parameter), row.value));
    return load_experiment(scripts / script_file, scripts, overrides, part);
}

SettingForRun recorded_setting(const RecordedRun &run) {
    const Experiment experiment = recorded_experiment(run.folder, Part::settings);
    const Spec *setting = experiment.find(run.setting);
    if (!setting)
        throw InputError((script_folder(run.folder) / script_file).string() + ": there is no setting '" +
                         run.setting + "'");
    const auto lines = differences(run.identity, identity_of(*setting, static_cast<std::uint64_t>(run.seed)));
    if (!lines.empty())
        throw InputError(run.folder.string() +
                         ": this program would not repeat the recorded run: " + lines.front());
    return setting_for_run(experiment, static_cast<std::size_t>(setting - experiment.settings.data()));
}

} // namespace planula
