// SPDX-License-Identifier: MIT
#include "program/status_page.h"

#include "analysis/svg.h"
#include "base/error.h"
#include "base/markup.h"
#include "base/text.h"
#include "program/progress.h"
#include "statement/schema.h"
#include "tables/csv.h"

#include <algorithm>

namespace planula {

namespace {

constexpr double width = 300, height = 84; // of a chart, in pixels
constexpr std::size_t most_points = 150;   // of a curve in it

constexpr const char *style =
    R"(:root { color-scheme: light dark; --ink: #1d2125; --muted: #666d75; --line: #dcdcd8; --page: #fbfbfa; --accent: #1f5fa8; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e8ea; --muted: #98a0a8; --line: #33373c; --page: #15171a; --accent: #6db3f2; } }
body { font: 15px/1.45 system-ui, sans-serif; color: var(--ink); background: var(--page); margin: 1.5em auto; max-width: 75em; padding: 0 1em; }
h1 { font-size: 1.4em; margin: 0; }
p { margin: 0.4em 0; }
progress { width: 100%; height: 1em; accent-color: var(--accent); }
table { border-collapse: collapse; width: 100%; margin-top: 1em; }
th, td { text-align: right; padding: 0.3em 0.6em; border-bottom: 1px solid var(--line); vertical-align: middle; }
th { font-weight: 600; }
th:first-child, td:first-child { text-align: left; }
.quiet { color: var(--muted); }
summary { cursor: pointer; margin-top: 1.2em; }
svg { display: block; margin-left: auto; }
@media (max-width: 640px) { table { display: block; overflow-x: auto; } }
)";

std::string cell(const std::string &content) { return "<td>" + content + "</td>"; }

// ---- What the runs have written ----

/// The rows of a table that may still grow; none while it cannot be read.
std::vector<GenerationRow> written_rows(const std::filesystem::path &file) {
    std::vector<GenerationRow> rows;
    try {
        TableReader<GenerationRow> reader(file, header_of<GenerationRow>());
        for (GenerationRow row; reader.next(row);) rows.push_back(row);
    } catch (const Error &) {
        // There is no such file, or a row is just being written, which the next page has.
    }
    return rows;
}

/// Those of the complete run, or of the longer one that is under way.
std::vector<GenerationRow> generations_of(const std::filesystem::path &folder) {
    std::filesystem::path file = folder / GenerationRow::file_name;
    std::vector<GenerationRow> complete = written_rows(file);
    std::vector<GenerationRow> growing = written_rows(file += ".part");
    return growing.size() > complete.size() ? growing : complete;
}

std::string state_of(const RunStatus &run) {
    if (!run.trouble.empty()) return run.trouble;
    if (run.kept > run.complete) return "unfinished";
    return run.complete > 0 ? "complete" : "begun";
}

// ---- Charts ----

double top_of(const std::vector<const RunCurve *> &runs) {
    double top = 0;
    for (const RunCurve *run : runs)
        if (!run->best.empty()) top = std::max(top, run->best.back());
    return top > 0 ? top : 1;
}

std::string curve(const RunCurve &run, int generations, double top) {
    const std::size_t step = run.best.size() / most_points + 1;
    std::string points;
    const auto add = [&](std::size_t i) {
        const double x = generations > 1 ? width * static_cast<double>(i) / (generations - 1) : 0;
        points += (points.empty() ? "" : " ") +
                  svg::point({x, height - (height - 2) * std::max(0.0, run.best[i]) / top - 1});
    };
    for (std::size_t i = 0; i < run.best.size(); i += step) add(i);
    if (!run.best.empty()) add(run.best.size() - 1);
    return "<polyline points=\"" + points + "\"><title>" + markup_text(run.folder.filename().string()) +
           "</title></polyline>";
}

/// The best so far of each run of a setting, over the generations of the longest one asked for.
std::string chart(const std::vector<const RunCurve *> &runs, int generations) {
    const double top = top_of(runs);
    std::string drawn = "<svg role=\"img\" aria-label=\"best fitness so far of each run\" width=\"" +
                        svg::number(width) + "\" height=\"" + svg::number(height) + "\"><path d=\"M 0 0 V " +
                        svg::number(height) + " H " + svg::number(width) +
                        "\" fill=\"none\" stroke=\"var(--line)\"/><g fill=\"none\" stroke=\"var(--accent)\" "
                        "stroke-width=\"1.3\" stroke-opacity=\"0.75\">";
    for (const RunCurve *run : runs) drawn += curve(*run, generations, top);
    return drawn + "</g></svg>";
}

// ---- Tables ----

double mean_viable(const std::vector<const RunCurve *> &runs) {
    double sum = 0;
    int count = 0;
    for (const RunCurve *run : runs)
        if (run->generations > 0) sum += run->viable, ++count;
    return count > 0 ? sum / count : 0;
}

std::string percent(double share) { return to_fixed(100 * share, 0) + " %"; }

std::string setting_row(const std::string &name, const std::vector<const RunCurve *> &runs,
                        const SettingWords &words, int generations) {
    int done = 0, least = runs.front()->generations, most = 0;
    double best = 0;
    for (const RunCurve *run : runs) {
        done += run->generations >= generations;
        least = std::min(least, run->generations), most = std::max(most, run->generations);
        if (!run->best.empty()) best = std::max(best, run->best.back());
    }
    const std::string title =
        words.title.empty() || words.title == name
            ? markup_text(name)
            : markup_text(words.title) + "<br><span class=\"quiet\">" + name + "</span>";
    const std::string span = least < most ? to_text(least) + " to " + to_text(most) : to_text(most);
    return "<tr>" + cell(title) + cell(to_text(done) + " of " + to_text(static_cast<int>(runs.size()))) +
           cell(span) + cell(to_fixed(best, 2) + " " + markup_text(words.unit)) +
           cell(percent(mean_viable(runs))) + cell(chart(runs, std::max(generations, most))) + "</tr>\n";
}

std::string run_row(const RunCurve &run) {
    return "<tr>" + cell(markup_text(run.setting + " " + run.folder.filename().string())) +
           cell(markup_text(run.state)) + cell(to_text(run.generations)) +
           (run.best.empty() ? cell("") + cell("")
                             : cell(to_fixed(run.best.back(), 2)) + cell(percent(run.viable))) +
           "</tr>\n";
}

std::string process_text(const ProgressRow &row) {
    const double share = row.runs > 0 ? static_cast<double>(row.runs_done) / row.runs : 0;
    std::string text = "<p><progress max=\"1\" value=\"" + to_fixed(share, 3) + "\"></progress></p>\n<p><b>" +
                       to_text(row.runs_done) + " of " + to_text(row.runs) + " runs done, level " +
                       to_text(row.level) + "</b> (" + to_text(row.levels_left) + " more levels). ";
    if (!(row.rate > 0)) return text + "The time left is not known yet.</p>\n";
    text += to_fixed(row.rate, row.rate < 10 ? 1 : 0) + " evaluations per second; " +
            duration_text(row.seconds_left_level) + " left for this level";
    if (row.levels_left > 0) text += ", " + duration_text(row.seconds_left) + " for all";
    return text + ".</p>\n";
}

std::string head(const Overview &all, const std::string &written, int refresh) {
    std::string text = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width\">\n";
    if (refresh > 0) text += "<meta http-equiv=\"refresh\" content=\"" + to_text(refresh) + "\">\n";
    text += "<title>planula: " + counted(all.runs.size(), "run") + "</title>\n<style>\n" +
            std::string(style) + "</style>\n</head>\n<body>\n<h1>Runs under way</h1>\n<p class=\"quiet\">" +
            "Begun: " + counted(all.runs.size(), "run") + ". Written " + markup_text(written);
    return text + (refresh > 0 ? "; this page loads again every " + to_text(refresh) + " s" : "") + ".</p>\n";
}

} // namespace

std::vector<RunCurve> curves_of(const Overview &all) {
    std::vector<RunCurve> curves;
    for (const RunStatus &run : all.runs) {
        RunCurve &next = curves.emplace_back();
        next.folder = run.folder;
        next.setting = run.folder.parent_path().filename().string();
        next.state = state_of(run);
        double best = 0;
        for (const GenerationRow &row : generations_of(run.folder)) {
            best = next.best.empty() ? row.best_fitness : std::max(best, row.best_fitness);
            next.best.push_back(best);
            next.viable = run.population > 0 ? static_cast<double>(row.viable) / run.population : 0;
        }
        next.generations = static_cast<int>(next.best.size());
    }
    return curves;
}

Words words_of(const Overview &all, Words words) {
    for (const RunStatus &run : all.runs) {
        const std::string setting = run.folder.parent_path().filename().string();
        if (words.contains(setting)) continue;
        words[setting]; // also if its script cannot be read
        try {
            const std::filesystem::path scripts = script_folder(run.folder);
            const Experiment experiment = load_experiment(scripts / script_file, scripts, {}, Part::settings);
            for (const Spec &spec : experiment.settings) words[spec.name] = {spec.title, fitness_unit(spec)};
        } catch (const Error &) {
            // The page then has the setting's name alone.
        }
    }
    return words;
}

std::string status_page(const Overview &all, const std::vector<RunCurve> &curves, const Words &words,
                        const std::string &written, int refresh) {
    std::map<std::string, std::vector<const RunCurve *>> settings;
    int level = 0;
    for (const ProgressRow &row : all.processes) level = std::max(level, row.level);
    for (const RunCurve &run : curves) settings[run.setting].push_back(&run);

    std::string page = head(all, written, refresh);
    for (const ProgressRow &row : all.processes) page += process_text(row);
    if (all.processes.empty()) page += "<p><b>No process is working on them.</b></p>\n";
    page += "<table>\n<tr><th>setting</th><th>runs done</th><th>generations saved</th><th>best fitness</th>"
            "<th>viable</th><th>best so far, each run</th></tr>\n";
    for (const auto &[name, runs] : settings) {
        int generations = level;
        for (const RunCurve *run : runs)
            if (level == 0) generations = std::max(generations, run->generations);
        const auto known = words.find(name);
        page += setting_row(name, runs, known == words.end() ? SettingWords{} : known->second, generations);
    }
    page += "</table>\n<details>\n<summary>Each run</summary>\n<table>\n<tr><th>run</th><th>state</th>"
            "<th>generations saved</th><th>best fitness</th><th>viable</th></tr>\n";
    for (const RunCurve &run : curves) page += run_row(run);
    return page + "</table>\n</details>\n</body>\n</html>\n";
}

} // namespace planula
