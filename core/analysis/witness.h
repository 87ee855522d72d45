// SPDX-License-Identifier: MIT
// An independent witness: every champion, the best individual of its run, is lived again in the native
// engine, there at half the time step, and in Bullet (MODEL section 8). A champion that half the step undoes
// is flagged as an integration exploit; what Bullet makes of it is stated beside, without a verdict, as its
// contact and friction are its own.
//
// Change of a displacement d to d': |d' - d| / max(d, one cell diameter). A champion that hardly moved is so
// judged by the cell diameters between the two lives, not by a quotient of two small numbers. A life that is
// not viable has displacement 0: its change is that of all the way lost.
#pragma once

#include "experiment/spec.h"
#include "record/columns.h"

#include <filesystem>
#include <span>

namespace planula {

/// The row of one champion from its three lives.
WitnessRow witness_row(const Spec &spec, const ChampionRow &champion, std::int64_t seed, const Life &native,
                       const Life &half, const Life &bullet);

/// What the champions of one setting come to.
EngineRow engine_row(const Spec &spec, std::span<const WitnessRow> champions);

/// Lives the champions of all complete runs below `runs` on up to `threads` threads, and writes witness.csv
/// and engines.csv into `out`. Settings without runs have no rows; nor has a run without a viable individual
/// in witness.csv. Throws InputError for damaged or foreign runs, for a champion whose life is not the
/// recorded one, and if there is no run at all.
void witness(std::span<const Spec> settings, const std::filesystem::path &runs,
             const std::filesystem::path &out, int threads);

} // namespace planula
