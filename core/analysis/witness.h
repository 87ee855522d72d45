// SPDX-License-Identifier: MIT
// An independent witness: every champion, the best individual of its run, is simulated again in the native
// engine, there also at half and at an eighth of the time step, and in Bullet (decision 0017). A champion whose
// distance changes too much at half the step is flagged as an integration exploit. In one more simulation the
// muscles then hold still for as long again: a body that still moves within itself gets its energy from the
// model and not from muscles, and the champion is flagged as perpetual motion. Where a life differs, the cause
// is named. At an eighth of the step the cells are also displaced by a tiny distance: a gait that this changes
// as much is chaotic, and its path cannot be predicted. Else the step is the cause, if a finer one gives another
// life; else the engine, as Bullet's contact with the ground and its friction are its own.
//
// Change of a displacement d to d': |d' - d| / max(d, one cell diameter). A champion that hardly moved is so
// judged by the cell diameters between the two displacements, not by a quotient of two small numbers. A life
// that is not viable has displacement 0, so that its change is that of the whole distance lost.
#pragma once

#include "analysis/analysis.h"
#include "experiment/spec.h"
#include "tables/columns.h"

#include <filesystem>
#include <span>
#include <vector>

namespace planula {

/// The lives of one champion.
struct WitnessedLives {
    Life native, half, eighth, bullet;
    std::vector<Life> nudged; // native, at an eighth of the step
    double held_unrest;       // native, muscles held: unrest() at the end, cells/t.u.
};

/// unrest() of the body when, after its life, the muscles have held still for as long again; the speed limit of
/// nodes if it explodes, 0 if it never settles.
double held_unrest(const Genome &genome, Conditions conditions);

/// The row of one champion.
WitnessRow witness_row(const Spec &spec, const ChampionRow &champion, std::int64_t seed,
                       const WitnessedLives &lives);

/// What the champions of one setting come to.
EngineRow engine_row(const Spec &spec, std::span<const WitnessRow> champions);

/// Simulates the champions of the chosen runs on up to `threads` threads, and writes witness.csv
/// and engines.csv into `out`. Settings without runs have no rows; nor has a run without a viable individual
/// in witness.csv. Throws InputError for damaged runs, for a champion
/// whose life is not the recorded one, and if there is no run at all, and CreateError as reduce() does.
void witness(std::span<const Spec> settings, const RunChoice &runs, const std::filesystem::path &out,
             int threads);

} // namespace planula
