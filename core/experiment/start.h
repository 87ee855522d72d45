// SPDX-License-Identifier: MIT
// Generation 0. The paper draws it at random (§2.7.2), where few genomes grow a body at all and most bodies
// are similar. Its discussion proposes to evolve it for diverse morphologies first: here by novelty search on
// growth alone, which costs a small part of a whole simulation. The run begins with the genomes and innovations
// of the last generation, as if they had been drawn: without ancestors, and with new species.
#pragma once

#include "experiment/lives.h"

#include <cstdint>

namespace planula {

/// Generation 0 of a run, at random or as spec.start says: its parameters are those of the run, its chance is
/// its own. The result depends on (spec, seed) alone. Throws Stopped.
Population first_population(const Spec &spec, std::uint64_t seed, const Workers &workers,
                            const StopRequest &stop);

} // namespace planula
