// SPDX-License-Identifier: MIT
#include "report/report_page.h"

#include "analysis/history.h"
#include "base/check.h"
#include "base/error.h"
#include "base/markup.h"
#include "base/parallel.h"
#include "base/text.h"
#include "page/page.h"
#include "recording/recording_json.h"
#include "storage/input.h"
#include "tables/manifest.h"

#include <algorithm>

namespace planula {

namespace {

const Spec &setting_called(const Experiment &experiment, const std::string &name) {
    const Spec *setting = experiment.find(name);
    CHECK(setting, name);
    return *setting;
}

constexpr std::size_t most_recorded = 12'000'000; // bytes of all recordings in a page
constexpr int longest_interval = 100;             // steps between two frames

// What a page with a module may do besides: start a worker from its text, and compile it there from a text in that.
constexpr std::string_view module_policy = " 'wasm-unsafe-eval'; worker-src blob:; connect-src data:";

std::string champion_recording(const Experiment &experiment, const ShownRun &shown, const Detail &detail) {
    const RecordedRun &run = *shown.run;
    const Spec &setting = setting_called(experiment, run.setting);
    const ChampionRow champion = champion_after(read_champions(run), shown.generations);
    const Caption caption{setting.title,       experiment.name, run.setting,     run.seed,
                          champion.generation, champion.slot,   champion.fitness};
    const LifeRecording recording =
        record_life(read_champion_genome(run, shown.generations), setting, caption, detail);
    if (recording.life.displacement() != champion.displacement || recording.life.cells != champion.cells)
        throw InputError(run.folder.string() + ": the champion of generation " +
                         to_text(champion.generation) + " moved " + to_text(champion.displacement) +
                         " cells, and simulated again it moves " + to_text(recording.life.displacement()) +
                         "; planula verify names the first generation that differs");
    return packed_for_page(recording_json(recording));
}

std::string read_part(const std::filesystem::path &file) {
    if (!std::filesystem::exists(file))
        throw InputError(file.string() +
                         " is not there: the scripts of reports are not bundled yet; run `make report` once");
    return read_file(file);
}

/// How much there is, in words.
std::string lead_of(const ReportSources &sources, std::size_t runs) {
    const Experiment &experiment = sources.experiment;
    return "Experiment " + experiment.name + ": " + counted(runs, "run") + " of " +
           counted(experiment.settings.size(), "setting") + ", in " + sources.runs.choice.folder.string();
}

} // namespace

ReportBundle read_bundle(const std::filesystem::path &folder) {
    return {read_part(folder / "report.js"), read_part(folder / "report.css"),
            read_part(folder / "licences.txt")};
}

std::vector<std::string> champion_recordings(const ReportSources &sources, int threads) {
    const std::vector<ShownRun> runs = shown_runs_of(sources);
    std::vector<std::string> recordings(runs.size());
    for (Detail detail = gallery_detail;;) {
        parallel_for(static_cast<int>(runs.size()), threads, [&](int i) {
            const auto at = static_cast<std::size_t>(i);
            recordings[at] = champion_recording(sources.experiment, runs[at], detail);
        });
        std::size_t size = 0;
        for (const std::string &recording : recordings) size += recording.size();
        if (size <= most_recorded || detail.gait_interval >= longest_interval) return recordings;
        detail.growth_interval += detail.growth_interval / 2;
        detail.gait_interval += detail.gait_interval / 2;
    }
}

std::string report_page(const ReportSources &sources, const ReportBundle &bundle, std::string_view data,
                        const std::vector<std::string> &recordings, std::string_view module) {
    const Experiment &experiment = sources.experiment;
    std::string elements;
    if (!module.empty())
        elements.append("<script id=\"module\" type=\"application/gzip\">")
            .append(module)
            .append("</script>\n");
    for (std::size_t i = 0; i < recordings.size(); ++i)
        elements += "<script type=\"application/gzip\" data-run=\"" + to_text(static_cast<std::int64_t>(i)) +
                    "\">" + recordings[i] + "</script>\n";
    const std::string title = markup_text(experiment.title.empty() ? experiment.name : experiment.title);
    const std::string lead = markup_text(lead_of(sources, shown_runs_of(sources).size()));
    const std::string packed = packed_for_page(data), licences = markup_text(bundle.licences);
    return filled_page(report_template(), {{"title", title},
                                           {"lead", lead},
                                           {"version", version()},
                                           {"data", packed},
                                           {"module_policy", module.empty() ? "" : module_policy},
                                           {"recordings", elements},
                                           {"licences", licences},
                                           {"viewer_style", viewer_style()},
                                           {"style", bundle.style},
                                           {"viewer_script", viewer_script()},
                                           {"script", bundle.script}});
}

} // namespace planula
