// SPDX-License-Identifier: MIT
#include "analysis/statistic.h"

#include "analysis/tables.h"
#include "base/text.h"
#include "experiment/sample.h"
#include "tables/archive_table.h"

#include <algorithm>
#include <array>

namespace planula {

namespace {

std::vector<ArchiveEntry> recorded_archive(const SettingRuns &setting, std::size_t run) {
    const RecordedRun &recorded = setting.runs[run];
    if (!recorded.manifest.has(ArchiveRow::file_name)) return {};
    std::vector<ArchiveEntry> archive = read_archive(recorded.folder);
    std::erase_if(archive,
                  [&](const ArchiveEntry &entry) { return entry.generation >= setting.generations; });
    return archive;
}

std::vector<EndpointRow> recorded_endpoints(const SettingRuns &setting, std::size_t run) {
    const double share =
        setting.runs[run].record.share(setting.spec->parameters.neat.population, setting.generations);
    return endpoint_rows(setting, {"", run}, share);
}

std::string runs_note(const SettingRuns &setting, int planned) {
    return to_text(static_cast<int>(setting.runs.size())) + " of " + to_text(planned) + " runs of " +
           setting.spec->name;
}

/// What one setting lacks, added to the list.
void add_lack(const SettingRuns &setting, const Parameters &design, std::vector<std::string> &parts) {
    const std::string &name = setting.spec->name;
    const int runs = static_cast<int>(setting.runs.size()),
              population = setting.spec->parameters.neat.population;
    if (runs == 0) return parts.push_back("no runs of " + name);
    if (runs < design.design.seeds) parts.push_back(runs_note(setting, design.design.seeds));
    if (population < design.neat.population)
        parts.push_back("population " + to_text(population) + " of " + to_text(design.neat.population) +
                        " in " + name);
}

} // namespace

RunData recorded_data(const Analysis &analysis, std::span<const SettingRuns> settings) {
    return {analysis, settings, recorded_endpoints, recorded_archive};
}

std::span<const std::string_view> verdicts() {
    static constexpr std::array<std::string_view, 3> names{"reproduced", "contradicted", "inconclusive"};
    return names;
}

std::string shortfall(std::span<const SettingRuns *const> settings, const Analysis &analysis, int wanted,
                      int generations) {
    std::vector<std::string> parts;
    if (generations > 0 && generations < wanted)
        parts.push_back("data end after " + to_text(generations) + " of " + to_text(wanted) + " generations");
    for (const SettingRuns *setting : settings) add_lack(*setting, analysis.design, parts);
    std::string note;
    for (const std::string &part : parts) note += (note.empty() ? "" : "; ") + part;
    return note;
}

std::string line_of(const std::vector<OwnTable::Cell> &row) {
    std::vector<std::string> fields;
    for (const OwnTable::Cell &cell : row) {
        const auto *number = std::get_if<double>(&cell);
        const auto *text = std::get_if<std::string>(&cell);
        fields.push_back(number ? to_field(*number) : text ? to_field(*text) : "");
    }
    return to_line(fields);
}

} // namespace planula
