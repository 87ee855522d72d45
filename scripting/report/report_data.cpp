// SPDX-License-Identifier: MIT
#include "report/report_data.h"

#include "analysis/survey.h"
#include "base/json.h"
#include "base/text.h"
#include "experiment/revision.h"
#include "experiment/sample.h"
#include "report/page_table.h"
#include "statement/departures.h"
#include "tables/csv.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace planula {

namespace {

constexpr int most_generations = 250; // of a curve
constexpr int most_rows = 12000;      // of the generations of all runs
constexpr int least_generations = 50; // of a run, however many runs there are
constexpr int species_generations = 150;
constexpr int map_individuals = 1000; // of a run, on average
constexpr int archive_entries = 2000; // of a setting
constexpr int own_rows = 2000;        // of a table of the experiment

/// Tables of reduce() that are embedded whole, and those of which every k-th generation is.
constexpr const char *whole_tables[] = {"manifest", "settings", "worlds",     "runs",          "entropy",
                                        "outcomes", "claims",   "parameters", "fitness_shares"};
constexpr const char *curve_tables[] = {"curves", "shape_diversity", "heredity"};

bool keep_all(const TableFields &) { return true; }

std::string json_texts(const std::vector<std::string> &texts) { return json_list(texts, json_text); }

std::string as_is(const std::string &json) { return json; }

void add_text(JsonObject &object, std::string_view name, std::string_view text) {
    object.add(name, json_text(text));
}

class ReportData {
  public:
    explicit ReportData(const ReportSources &sources) : sources_(sources), runs_(shown_runs_of(sources)) {
        for (const ShownRun &shown : runs_) generations_[shown.run->setting] = shown.generations;
    }

    std::string json() {
        const Experiment &experiment = sources_.experiment;
        JsonObject object;
        add_text(object, "title", experiment.title);
        add_text(object, "experiment", experiment.name);
        add_text(object, "folder", sources_.runs.choice.folder.string());
        add_text(object, "revision", model_revision());
        object.add("confidence", to_text(experiment.analysis.confidence));
        object.add("interval_runs", to_text(experiment.analysis.interval_runs));
        object.add("tables", tables());
        add_text(object, "dictionary", page_table(sources_.tables / ColumnRow::file_name, keep_all));
        object.add("own", json_texts(own_));
        object.add("runs", run_list());
        add_description(object);
        object.add("missing", json_texts(missing()));
        return object.text();
    }

  private:
    std::filesystem::path file(const std::string &name) const { return sources_.tables / (name + ".csv"); }

    std::string tables() {
        JsonObject object;
        for (const std::string name : whole_tables) add_text(object, name, page_table(file(name), keep_all));
        for (const std::string name : curve_tables)
            add_text(object, name, page_table(file(name), [&](const TableFields &row) {
                         return is_shown(row.whole("generation"), generations_.at(row["setting"]),
                                         most_generations);
                     }));
        add_text(object, "archives", archives());
        add_text(object, "generations", generations());
        add_text(object, "champions", champions());
        add_text(object, "individuals", individuals());
        add_text(object, "species", species());
        add_text(object, "sizes", sizes());
        for (const TableStatement &statement : sources_.experiment.analysis.tables) {
            if (!std::filesystem::exists(file(statement.name))) continue;
            int rows = 0;
            own_.push_back(statement.name);
            add_text(
                object, "own " + statement.name,
                page_table(file(statement.name), [&](const TableFields &) { return rows++ < own_rows; }));
        }
        return object.text();
    }

    /// A table of rows of runs: a header, and of each run what rows(run, setting and seed) returns.
    template <class Rows> std::string of_runs(std::vector<std::string> columns, Rows &&rows) const {
        columns.insert(columns.begin(), {"setting", "seed"});
        std::string text = to_line(columns);
        for (const ShownRun &shown : runs_)
            text += rows(shown, std::vector<std::string>{shown.run->setting, to_text(shown.run->seed)});
        return text;
    }

    std::string archives() const {
        std::map<std::string, int> count, seen;
        const auto visit = [](std::map<std::string, int> &counts, const TableFields &row) {
            return counts[row["setting"]]++;
        };
        page_table(file("archives"), [&](const TableFields &row) { return visit(count, row), false; });
        return page_table(file("archives"), [&](const TableFields &row) {
            return is_shown(visit(seen, row), count[row["setting"]], archive_entries);
        });
    }

    std::string generations() const {
        const std::vector<std::string> columns{
            "generation", "best_fitness", "fitness_low", "fitness_median", "fitness_high", "species",
            "archive",    "mean_links",   "mean_hidden", "viable",         "valid",        "shape_diversity"};
        const int most =
            std::clamp(most_rows / static_cast<int>(runs_.size()), least_generations, most_generations);
        return of_runs(columns, [&](const ShownRun &shown, const auto &before) {
            return page_rows(shown.run->folder / GenerationRow::file_name, columns, before,
                             [&](const TableFields &row) {
                                 return is_shown(row.whole("generation"), shown.generations, most);
                             });
        });
    }

    std::string champions() const {
        std::vector<std::string> columns;
        for (const std::string_view name : header_of<ChampionRow>()) columns.emplace_back(name);
        return of_runs(columns, [&](const ShownRun &shown, const auto &before) {
            return page_rows(
                shown.run->folder / ChampionRow::file_name, columns, before,
                [&](const TableFields &row) { return row.whole("generation") < shown.generations; });
        });
    }

    /// Of each setting's best run, and of its best below the median, a random part of the individuals.
    std::string individuals() const {
        std::vector<std::string> columns;
        for (const std::string_view name : header_of<IndividualRow>()) columns.emplace_back(name);
        const RunNames chosen = ranked([](std::size_t count) {
            return std::set{std::size_t{0}, rank_below_median(count)};
        });
        return of_runs(columns, [&](const ShownRun &shown, const auto &before) -> std::string {
            const RecordedRun &run = *shown.run;
            if (!chosen.contains({run.setting, run.seed})) return "";
            const double share = sample_share(0, map_individuals, run.population, shown.generations);
            return page_rows(
                run.folder / IndividualRow::file_name, columns, before, [&](const TableFields &row) {
                    const int generation = row.whole("generation");
                    return generation < shown.generations && row["outcome"] == name_of(Outcome::viable) &&
                           lot(static_cast<std::uint64_t>(run.seed), generation, row.whole("slot")) < share;
                });
        });
    }

    /// Setting and seed of the runs of each setting that have these ranks by their champions; of equals the lower seed
    /// comes first.
    using RunNames = std::set<std::pair<std::string, std::int64_t>>;
    RunNames ranked(const std::function<std::set<std::size_t>(std::size_t count)> &ranks) const {
        std::map<std::string, std::vector<RunRow>> runs;
        for (const RunRow &row : read_table<RunRow>(sources_.tables)) runs[row.setting].push_back(row);
        RunNames names;
        for (auto &[setting, rows] : runs) {
            std::stable_sort(rows.begin(), rows.end(), [](const RunRow &a, const RunRow &b) {
                return a.best_fitness > b.best_fitness;
            });
            for (const std::size_t rank : ranks(rows.size())) names.insert({setting, rows[rank].seed});
        }
        return names;
    }

    /// Of each setting's best run the sizes of its species.
    std::string species() const {
        const std::vector<std::string> columns{"generation", "species", "size", "age"};
        const RunNames best = ranked([](std::size_t) { return std::set{std::size_t{0}}; });
        return of_runs(columns, [&](const ShownRun &shown, const auto &before) -> std::string {
            const RecordedRun &run = *shown.run;
            if (!best.contains({run.setting, run.seed}) || !run.manifest.has(SpeciesRow::file_name))
                return "";
            return page_rows(
                run.folder / SpeciesRow::file_name, columns, before, [&](const TableFields &row) {
                    return is_shown(row.whole("generation"), shown.generations, species_generations);
                });
        });
    }

    /// Individuals by setting and number of cells, over all generations and runs.
    std::string sizes() const {
        std::map<std::string, std::map<int, std::int64_t>> counts;
        for (const ShownRun &shown : runs_) {
            TableReader<SizeRow> reader(shown.run->folder);
            for (SizeRow row; reader.next(row) && row.generation < shown.generations;)
                counts[shown.run->setting][row.cells] += row.individuals;
        }
        std::string text = to_line(std::vector<std::string>{"setting", "cells", "individuals"});
        for (const auto &[setting, of_cells] : counts)
            for (const auto &[cells, individuals] : of_cells)
                text += to_line(
                    std::vector<std::string>{to_field(setting), to_field(cells), to_field(individuals)});
        return text;
    }

    std::string run_list() const {
        std::vector<std::string> list;
        for (const ShownRun &shown : runs_) {
            JsonObject object;
            add_text(object, "folder", shown.run->folder.string());
            if (const std::string *model = shown.run->identity.find("model"))
                add_text(object, "model", *model);
            for (const ManifestRow &row : shown.run->manifest.rows())
                if (!is_file(row.key)) add_text(object, row.key, row.value);
            list.push_back(object.text());
        }
        return json_list(list, as_is);
    }

    void add_description(JsonObject &object) const {
        const Experiment &experiment = sources_.experiment;
        Comparison comparison(experiment, sources_.library);
        JsonObject environments;
        std::vector<std::string> departures;
        for (std::size_t i = 0; i < experiment.settings.size(); ++i) {
            const Spec &setting = experiment.settings[i];
            if (!generations_.contains(setting.name)) continue;
            add_text(environments, setting.name, environment_text(setting));
            for (const Departure &d : comparison.of_setting(i)) {
                JsonObject row;
                add_text(row, "setting", setting.name);
                for (const auto &[name, value] :
                     {std::pair{"part", d.part}, std::pair{"name", d.name}, std::pair{"value", d.value},
                      std::pair{"paper", d.paper}, std::pair{"origin", d.origin}, std::pair{"note", d.note}})
                    add_text(row, name, value);
                row.add("lines", json_texts(d.lines));
                departures.push_back(row.text());
            }
        }
        object.add("environments", environments.text());
        object.add("departures", json_list(departures, as_is));
    }

    std::vector<std::string> missing() const {
        std::vector<std::string> all = sources_.missing;
        all.insert(all.end(), sources_.runs.unfinished.begin(), sources_.runs.unfinished.end());
        return all;
    }

    const ReportSources &sources_;
    const std::vector<ShownRun> runs_;
    std::map<std::string, int> generations_; // shown, of each setting that has runs
    std::vector<std::string> own_;
};

} // namespace

std::vector<ShownRun> shown_runs_of(const ReportSources &sources) {
    std::vector<ShownRun> shown;
    for (const RunRow &row : read_table<RunRow>(sources.tables))
        for (const RecordedRun &run : sources.runs.runs)
            if (run.setting == row.setting && run.seed == row.seed) shown.push_back({&run, row.generations});
    return shown;
}

std::string report_data(const ReportSources &sources) { return ReportData(sources).json(); }

} // namespace planula
