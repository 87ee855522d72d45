// SPDX-License-Identifier: MIT
#include "analysis/analysis.h"
#include "analysis/claims.h"
#include "analysis/density.h"
#include "analysis/survey.h"
#include "analysis/tables.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/parallel.h"
#include "base/text.h"
#include "experiment/sample.h"
#include "experiment/world_numbers.h"
#include "record/chain.h"
#include "storage/output.h"
#include "tables/csv.h"
#include "tables/ledger.h"

#include <algorithm>

namespace planula {

namespace {

/// A run is read through a buffer of some 50 MB, which bounds the number of threads.
int reading_threads() { return std::min(hardware_threads(), 8); }

/// Checks and reads all runs, in parallel.
void read_histories(const Analysis &analysis, std::vector<SettingRuns> &settings) {
    struct Task {
        SettingRuns *setting;
        std::size_t run;
    };
    std::vector<Task> tasks;
    for (SettingRuns &setting : settings) {
        setting.histories.resize(setting.runs.size());
        for (std::size_t run = 0; run < setting.runs.size(); ++run) tasks.push_back({&setting, run});
    }
    parallel_for(static_cast<int>(tasks.size()), reading_threads(), [&](int i) {
        const auto &[setting, run] = tasks[i];
        check_files(setting->runs[run]);
        setting->histories[run] = read_history(setting->runs[run], setting->generations,
                                               analysis.fitness_classes, analysis.direction_distance);
    });
}

/// The sample that the analysis takes of a run must be among the individuals that the run has recorded.
void check_samples(const Analysis &analysis, std::span<const SettingRuns> settings) {
    for (const SettingRuns &setting : settings)
        for (const RecordedRun &run : setting.runs)
            if (!run.record.full &&
                (analysis.sample_share > recorded_share || analysis.sample_least > run.record.least))
                throw InputError(run.folder.string() + ": recorded as a sample of " +
                                 to_text(recorded_share) + ", at least " + to_text(run.record.least) +
                                 " individuals; sample_share = " + to_text(analysis.sample_share) +
                                 " and sample_least = " + to_text(analysis.sample_least) + " ask for more");
}

/// Writes a table of what make(setting) returns for each setting, in their order.
template <class Row, class Make>
void write_each(const std::filesystem::path &out, std::span<const SettingRuns *const> settings, Make &&make) {
    std::vector<std::vector<Row>> rows(settings.size());
    parallel_for(static_cast<int>(settings.size()), reading_threads(),
                 [&](int i) { rows[i] = make(*settings[i]); });
    TableWriter<Row> writer(out);
    for (const std::vector<Row> &some : rows)
        for (const Row &row : some) writer.write(row);
    writer.commit();
}

/// All rows of one kind for both runs that represent a setting.
template <class Row, class Make>
std::vector<Row> for_representatives(const SettingRuns &setting, Make &&make) {
    std::vector<Row> rows;
    for (const Representative &chosen : representatives(setting))
        for (Row &row : make(chosen)) rows.push_back(std::move(row));
    return rows;
}

void write_settings(const Analysis &analysis, std::span<const SettingRuns *const> present,
                    const std::filesystem::path &out) {
    write_each<SettingRow>(out, present,
                           [](const SettingRuns &s) { return std::vector<SettingRow>{setting_row(s)}; });
    write_each<WorldRow>(out, present, world_rows);
    write_each<RunRow>(out, present, run_rows);
    write_each<CurveRow>(out, present, [&](const SettingRuns &s) { return curve_rows(s, analysis); });
    write_each<ShapeDiversityRow>(out, present,
                                  [&](const SettingRuns &s) { return shape_diversity_rows(s, analysis); });
    write_each<HeredityRow>(out, present, heredity_rows);
    write_each<EntropyRow>(out, present,
                           [&](const SettingRuns &s) { return std::vector{entropy_row(s, analysis)}; });
    write_each<OutcomeRow>(out, present, outcome_rows);
    write_each<FitnessShareRow>(out, present, fitness_share_rows);
    write_each<FitnessHistoryRow>(out, present, fitness_history_rows);
    write_each<BestGenomeRow>(out, present, best_genome_rows);
}

void write_exploration(const Analysis &analysis, std::span<const SettingRuns *const> chosen,
                       const std::filesystem::path &out) {
    write_each<EndpointRow>(out, chosen, [&](const SettingRuns &s) {
        return for_representatives<EndpointRow>(
            s, [&](const Representative &r) { return endpoint_rows(s, r, sampled_share(s, analysis)); });
    });
    write_each<EndpointDensityRow>(out, chosen, [](const SettingRuns &s) {
        return for_representatives<EndpointDensityRow>(
            s, [&](const Representative &r) { return endpoint_density_rows(s, r); });
    });
    write_each<EndpointPathRow>(out, chosen, [&](const SettingRuns &s) {
        return for_representatives<EndpointPathRow>(
            s, [&](const Representative &r) { return endpoint_path_rows(s, r); });
    });
    write_each<ArchivePointRow>(out, chosen, archive_point_rows);
}

void write_claims(const RunData &data, const std::filesystem::path &out) {
    const Analysis &analysis = data.analysis;
    std::vector<ClaimRow> rows(analysis.claims.size());
    parallel_for(static_cast<int>(rows.size()), reading_threads(),
                 [&](int i) { rows[i] = judge_claim(analysis.claims[i], data); });
    correct_claims(rows, analysis.significance);
    write_table<ClaimRow>(out, rows);
}

/// Writes the tables of the experiment's own, and adds the hash of each to the manifest. Which one lacks data is told.
void write_own_tables(const RunData &data, const RunChoice &runs, const std::filesystem::path &out,
                      Manifest &manifest) {
    for (const TableStatement &statement : data.analysis.tables) {
        const std::string file = statement.name + ".csv";
        Asked asked;
        const OwnTable table = statement.make(data, asked);
        remove_file(out / file);
        if (asked.missing) {
            int generations = asked.generations;
            for (const SettingRuns *setting : asked.settings)
                generations = std::min(generations, setting->generations);
            runs.tell("left out: " + file + ": " +
                      shortfall(asked.settings, data.analysis, asked.generations, generations));
            continue;
        }
        std::string text = to_line(table.columns);
        for (const auto &row : table.rows) text += line_of(row);
        manifest.add(statement.name + "_sha256", write_file(out / file, text));
    }
}

void write_dictionaries(std::span<const SettingRuns> settings, const std::filesystem::path &out) {
    std::vector<Parameters> parameters;
    for (const SettingRuns &setting : settings) parameters.push_back(setting.spec->parameters);
    std::vector<LedgerRow> rows = ledger(parameters);
    for (LedgerRow &row : rows) {
        const bool is_taken = std::any_of(settings.begin(), settings.end(), [&](const SettingRuns &setting) {
            return makes_world(row.name, *setting.spec);
        });
        if (is_of_worlds(row.name) && !is_taken) row.value.clear();
    }
    write_table<LedgerRow>(out, rows);
    write_table<ColumnRow>(out, columns());
}

/// What the tables rest on, beside what was planned.
Manifest data_manifest(const Analysis &analysis, std::span<const SettingRuns> settings) {
    const Parameters &design = analysis.design;
    int seeds = static_cast<int>(settings.front().runs.size()), runs = 0;
    int generations = settings.front().generations;
    int population = settings.front().spec->parameters.neat.population;
    std::int64_t evaluations = 0;
    Hash results;
    for (const SettingRuns &setting : settings) {
        seeds = std::min(seeds, static_cast<int>(setting.runs.size()));
        generations = std::min(generations, setting.generations);
        population = std::min(population, setting.spec->parameters.neat.population);
        for (const RecordedRun &run : setting.runs) {
            ++runs;
            evaluations += std::int64_t{setting.generations} * run.population;
            results.text(setting.spec->name).number(static_cast<std::uint64_t>(run.seed));
            for (const ChainRow &row : read_chain(run.folder))
                if (row.generation < setting.generations) results.text(row.content);
        }
    }
    const auto count = static_cast<std::int64_t>(settings.size());
    const bool complete = seeds >= design.design.seeds && generations >= design.design.generations &&
                          population >= design.neat.population;

    Manifest manifest;
    manifest.add("experiment", analysis.experiment);
    manifest.add("version", std::string(version()));
    manifest.add("settings", count);
    manifest.add("runs", runs);
    manifest.add("seeds", seeds);
    manifest.add("seeds_planned", design.design.seeds);
    manifest.add("generations", generations);
    manifest.add("generations_planned", design.design.generations);
    manifest.add("population", population);
    manifest.add("population_planned", design.neat.population);
    manifest.add("endpoint_share", to_text(sample_share(analysis.sample_share, analysis.sample_least,
                                                        population, generations)));
    manifest.add("evaluations", evaluations);
    manifest.add("evaluations_planned",
                 count * design.design.seeds * design.design.generations * design.neat.population);
    manifest.add("results_sha256", results.hex());
    manifest.add("complete", complete ? 1 : 0);
    return manifest;
}

} // namespace

void reduce(const Analysis &analysis, std::span<const Spec> settings, const RunChoice &runs,
            const std::filesystem::path &out) {
    check_analysis(analysis, settings);
    const FolderLock held = hold_for_tables(out);
    std::vector<SettingRuns> found = survey(settings, runs);
    check_samples(analysis, found);
    read_histories(analysis, found);
    std::vector<const SettingRuns *> present, explored;
    for (const SettingRuns &setting : found) {
        if (setting.runs.empty()) continue;
        present.push_back(&setting);
        if (std::count(analysis.endpoint_settings.begin(), analysis.endpoint_settings.end(),
                       setting.spec->name))
            explored.push_back(&setting);
    }

    const RunData data = recorded_data(analysis, found);
    Manifest manifest = data_manifest(analysis, found);

    // A manifest is there only if all tables were made together.
    remove_file(out / ManifestRow::file_name);
    write_settings(analysis, present, out);
    write_exploration(analysis, explored, out);
    write_claims(data, out);
    write_own_tables(data, runs, out, manifest);
    write_dictionaries(found, out);
    manifest.write(out);
}

} // namespace planula
