// SPDX-License-Identifier: MIT
// Made-up lives, for trying out functions that judge lives before any is simulated.
#pragma once

#include "evaluation/life.h"
#include "parameters/parameters.h"

namespace planula {

/// The life of a body of some size with this outcome, as it is known after this stage. Of a viable one every known
/// field that scripts see differs from its initial value, and so does every observation of the set.
Life example_life(Outcome outcome, KnownAfter stage, const Parameters &parameters,
                  const ObservationSet &observed = {});

} // namespace planula
