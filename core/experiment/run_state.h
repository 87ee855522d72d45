// SPDX-License-Identifier: MIT
// Where a run stands as saved state (base/state.h): what load gives goes on to the same results as what was
// saved.
#pragma once

#include "base/state.h"
#include "experiment/run.h"

namespace planula {

void save(const RunState &state, StateWriter &writer);

/// The archive of the search is not among what is saved: it is handed over as it was. Throws InputError naming the rule
/// that the bytes break: they are not the state of a run of this setting.
RunState load_run_state(const Spec &spec, std::span<const ArchiveEntry> archive, StateReader &reader);

} // namespace planula
