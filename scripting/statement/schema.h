// SPDX-License-Identifier: MIT
// From an experiment file to what the core understands. The file returns a table:
//
// - name, title: of the experiment
// - actuation: "oscillator" or "grn"
// - search: a name of evolution/searches.inl
// - engine: a name of make_engine(): "native" (if not given), "reference", "bullet"
// - environment: {gravity, ground, friction, drag = {normal, tangential}, flow = {x, y}, actuation_range, obstacles,
//   ceiling, friction_patches, object}
// - parameters: {name = value}, departures from the standard values
// - fitness, penalty, behaviour: functions (statement/judging_functions.h)
// - objectives, descriptor: what the search aims at (statement/schema_aims.h)
// - start: {generations, behaviour}, if generation 0 is evolved by growth alone (experiment/start.h)
// - record: "full" (if not given) or "sample": how many individuals a run records (experiment/sample.h)
// - statistics: a table, or the name of a module that returns one (statement/schema_statistics.h)
// - sensitivity: a table (statement/schema_sensitivity.h)
// - settings: instead of actuation … start, a list of tables with a name, a title and these keys;
//   `parameters` and `record` beside `settings` hold for all of them
//
// A number of an environment may be the name of a parameter, which then stands for its value. Every unknown
// key, wrong kind and broken rule is reported, all together, each with its line and the nearest name.
#pragma once

#include "analysis/analysis.h"
#include "experiment/spec.h"
#include "language/sources.h"
#include "record/run_reader.h"
#include "statement/judging_functions.h"
#include "statement/overrides.h"
#include "statement/schema_environment.h"
#include "statement/schema_sensitivity.h"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace planula {

struct Experiment {
    std::string name, title;
    std::vector<Spec> settings;
    std::vector<std::shared_ptr<JudgingFunctions>> functions; // one per setting; its judge calls them
    std::vector<Places> world_places;                         // of each setting's environment
    /// Of each setting where the script states its keys ("search"), its parameters ("parameters.gravity") and the table
    /// itself ("").
    std::vector<Places> places;
    Places shared_parameters; // of the parameters beside `settings`, by name
    Analysis analysis;
    SensitivityPlan sensitivity;
    std::shared_ptr<Sources> sources;
    Overrides overrides;

    const Spec *find(std::string_view setting) const;
};

/// What of an experiment is read: of a recorded run the settings alone, because no statistic decides a result.
enum class Part { all, settings };

/// Loads and checks an experiment file, and tries out its functions. Throws InputError with all errors, each on a line
/// that starts with its place, name:line.
Experiment load_experiment(const std::filesystem::path &script, const std::filesystem::path &library,
                           const Overrides &overrides = {}, Part part = Part::all);
Experiment load_experiment(std::shared_ptr<Sources> sources, const Overrides &overrides = {},
                           Part part = Part::all);

/// A setting with judging functions of its own, so that it can run at the same time as others.
struct SettingForRun {
    Spec spec;
    std::shared_ptr<JudgingFunctions> functions;
    std::string experiment; // its name
};
SettingForRun setting_for_run(const Experiment &experiment, std::size_t index);

/// What a run's folder keeps of the experiment: the script, every module that it requires, and the overrides.
RunSources sources_of(const Experiment &experiment);

/// The setting of a run as its folder states it, with judging functions of its own. Throws InputError if that is not
/// the run of the folder's identity.csv: if the model is another, for instance.
SettingForRun recorded_setting(const RecordedRun &run);

} // namespace planula
