// SPDX-License-Identifier: MIT
// The page of a report: report.html of this folder, filled with what runs have come to, the recordings of their champions,
// and the bundle of scripts that draws them (report/web, made by `make report`).
#pragma once

#include "report/report_data.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

/// The text of report.html.
std::string_view report_template();

/// What `make report` bundles.
struct ReportBundle {
    std::string script, style, licences;
};

/// The bundle in a folder: report.js, report.css and licences.txt. Throws InputError that says to run `make report` if
/// one is missing.
ReportBundle read_bundle(const std::filesystem::path &folder);

/// Simulates the champion of each shown run again and records it: the texts of core/recording/recording_json.h, packed for
/// a page, in the order of the runs; with fewer frames where all together would be too large. Throws InputError if one
/// does not move as its run says.
std::vector<std::string> champion_recordings(const ReportSources &sources, int threads);

/// The whole page. `data` is that of report_data(), `recordings` those of the shown runs or of the first of them. With a
/// packed module (page/page.h), which may be empty, the page simulates its champions again.
std::string report_page(const ReportSources &sources, const ReportBundle &bundle, std::string_view data,
                        const std::vector<std::string> &recordings, std::string_view module);

} // namespace planula
