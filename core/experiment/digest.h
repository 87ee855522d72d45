// SPDX-License-Identifier: MIT
// Everything that a generation is, as one hash: population, lives, evaluations, scores, species and archive, to
// the bit. Two generations are equal if and only if their digests are (except for a collision of SHA-256). A list
// is fed with its length. Fields are fed as their bit patterns, so that 0 and -0 differ. It costs about 20 µs
// for an individual.
#pragma once

#include "base/hash.h"
#include "experiment/run.h"

namespace planula {

/// Feeds a finished generation into a hash. Of the archive, which only grows, come those entries that this
/// generation added, and the number of all. What follows from the fields fed, of this generation or
/// those before (Generation::mothers), or is no result (Generation::known), is left out.
void digest(Hash &hash, const Generation &generation);

} // namespace planula
