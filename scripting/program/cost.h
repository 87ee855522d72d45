// SPDX-License-Identifier: MIT
// What runs take, derived from a few generations that are measured: time, disk space and memory. Writes nothing.
#pragma once

#include "experiment/run.h"
#include "record/run_tables.h"

#include <cstdint>
#include <functional>
#include <string>

namespace planula {

/// The processor time that this process has used, in seconds.
double processor_seconds();
/// The most memory that this process has held so far, in MB.
double peak_megabytes();

/// What the measured generations of a setting cost.
struct Measured {
    double seconds = 0; // of processor time, after generation 0
    std::int64_t evaluations = 0;
    RowTexts rows;          // of these generations, all individuals
    int population = 0;     // of a generation
    int generations = 0;    // after generation 0, or 1 if there is no other
    double state_bytes = 0; // of a saved state
    double archive = 0;     // entries of the archive, in a generation
};

/// Runs up to `generations` generations of the setting, and shows each to `observe`. Throws Stopped.
Measured measure(
    const Spec &setting, std::uint64_t seed, int generations, int threads, const StopRequest &stop,
    const Observer &observe = [](const Generation &) {});

/// What a run of a setting costs.
struct Cost {
    double core_seconds = 0, table_bytes = 0, state_bytes = 0, journal_bytes = 0, archive_bytes = 0;
};

/// The cost of a whole run, of a population that may be larger than the measured one.
Cost cost_of(const Spec &setting, const Measured &measured);

/// "3.2 h", "12.5 days".
std::string long_time(double seconds);
/// "3.2 MB", "1.25 GB".
std::string size_text(double bytes);
/// "1080 evaluations", "96.00 million evaluations".
std::string evaluations_text(double evaluations);

} // namespace planula
