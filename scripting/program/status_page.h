// SPDX-License-Identifier: MIT
// The live page of a campaign (planula status --page): one HTML file without anything outside it, made from what the
// runs have written so far. A browser that has it open loads it again by itself. It only reads, so no run is disturbed.
#pragma once

#include "program/overview.h"

#include <filesystem>
#include <string>
#include <vector>

namespace planula {

/// What a run has written of its generations.
struct RunCurve {
    std::filesystem::path folder;
    std::string setting;
    int generations = 0;      // written so far; those since the last checkpoint are not
    std::vector<double> best; // best fitness up to each of them
    double viable = 0;        // share of the last of them
    std::string state;        // "complete", "unfinished", "begun", or why it cannot be read
};

/// Settings in words, and the unit of their fitness, by name; of a setting whose script cannot be read nothing.
struct SettingWords {
    std::string title, unit;
};
using Words = std::map<std::string, SettingWords, std::less<>>;

/// The curves of the runs of an overview.
std::vector<RunCurve> curves_of(const Overview &all);
/// Those that are known, with those of all other settings as the scripts of their runs say.
Words words_of(const Overview &all, Words known = {});

/// `written`: the time, in words. `refresh`: seconds after which a browser loads the page again; 0: never.
std::string status_page(const Overview &all, const std::vector<RunCurve> &curves, const Words &words,
                        const std::string &written, int refresh);

} // namespace planula
