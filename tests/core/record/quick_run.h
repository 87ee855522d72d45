// SPDX-License-Identifier: MIT
// Real runs that are over soon, and that end early as asked.
#pragma once

#include "base/error.h"
#include "core/record/fake_run.h"
#include "support/specimens.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace planula::quick {

inline constexpr std::uint64_t seed = 6;
inline constexpr int population = 6;

/// Embryos of a few steps, judged by the body that they became.
inline Spec spec(const std::string &search = "novelty", int generations = 5) {
    Spec spec = fake_spec("quick", generations, population, search);
    spec.environment = specimens::water();
    spec.parameters.gait.locomotion_steps = 20;
    spec.parameters.development.development_steps = 300;
    spec.parameters.novelty.archive_threshold = 0.001;
    spec.judge = [](const Life &life) {
        return Evaluation{life.elongation + life.cells, {life.elongation, life.cells * 0.1}, 1};
    };
    return spec;
}

/// How a process ends that does not come to the run's end.
enum class End { stopped, killed };

/// Runs as a process does: for this many further evaluations, or to the end without a number. Whether it reached the
/// end.
inline bool run_on(const std::filesystem::path &folder, const Spec &asked, int evaluations = -1,
                   End end = End::stopped, int interval = 2) {
    RunWriter writer(folder, asked, seed, fake_sources(), interval);
    if (writer.is_complete()) return true;
    Spec spec = asked;
    spec.parameters.design.generations = writer.generations();
    std::optional<RunState> left = writer.take_state();
    RunState state = left ? std::move(*left) : begin(spec, seed);
    if (!left) writer.before_generation(state, "");
    try {
        run(
            spec, seed, 1, state, [&](const Generation &generation) { writer.observe(generation); },
            [&](const RunState &now) { writer.before_generation(now, ""); },
            [counted = 0, evaluations]() mutable { return counted++ == evaluations; });
    } catch (const Stopped &) {
        if (end == End::stopped) writer.checkpoint(state, "");
        return false;
    }
    writer.finish();
    return true;
}

/// A whole run.
inline void write(const std::filesystem::path &folder, const Spec &spec) { run_on(folder, spec); }

} // namespace planula::quick
