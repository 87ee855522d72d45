// SPDX-License-Identifier: MIT
#include "analysis/replay.h"

#include "base/check.h"
#include "base/error.h"
#include "base/text.h"
#include "record/chain.h"
#include "record/kept_state.h"

#include <algorithm>

namespace planula {

namespace {

/// The state before a generation that is not after this one.
RunState state_before(const RecordedRun &run, const Spec &setting, int generation, const Workers &workers,
                      const StopRequest &stop) {
    const std::vector<int> kept = kept_generations(run.folder);
    const auto later = std::upper_bound(kept.begin(), kept.end(), generation);
    if (later == kept.begin()) return begin(setting, static_cast<std::uint64_t>(run.seed), workers, stop);
    return read_run_state(run, setting, *(later - 1));
}

void check_place(const RecordedRun &run, int generation, int slot) {
    const auto check = [&](const char *what, int value, int count) {
        if (value < 0 || value >= count)
            throw InputError(run.folder.string() + ": no " + what + " " + to_text(value) +
                             "; they are 0 to " + to_text(count - 1));
    };
    check("generation", generation, run.generations);
    check("slot", slot, run.population);
}

} // namespace

void replay(const RecordedRun &run, const Spec &setting, int first, int last, const Workers &workers,
            const Observer &observe, const StopRequest &stop, const StateObserver &observe_state) {
    CHECK(first >= 0 && first <= last && last < run.generations, first, last, run.generations);
    Spec spec = setting;
    spec.parameters.design.generations = last + 2;
    RunState state = state_before(run, spec, first, workers, stop);
    const auto observe_wanted = [&](const Generation &generation) {
        if (generation.number >= first) observe(generation);
    };

    // The run is stopped once the state after the last generation is there.
    const auto is_past = [&] { return state.population.generation > last; };
    try {
        planula::run(spec, static_cast<std::uint64_t>(run.seed), workers, state, observe_wanted,
                     observe_state, [&] { return is_past() || stop(); });
    } catch (const Stopped &) {
        if (!is_past()) throw;
    }
}

Individual replay_individual(const RecordedRun &run, const Spec &setting, int generation, int slot,
                             const Workers &workers, const StopRequest &stop) {
    check_place(run, generation, slot);
    const std::string recorded = read_chain(run.folder).at(static_cast<std::size_t>(generation)).content;
    Individual individual;
    const auto observe = [&](const Generation &g) {
        if (generation_sha256(g) != recorded)
            throw InputError(run.folder.string() + ": generation " + to_text(generation) +
                             " is not what simulating it again gives");
        const auto at = static_cast<std::size_t>(slot);
        individual = {g.population.genomes[at], g.lives[at], g.evaluations[at], g.scores[at]};
    };
    replay(run, setting, generation, generation, workers, observe, stop);
    return individual;
}

} // namespace planula
