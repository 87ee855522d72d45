// SPDX-License-Identifier: MIT
// The individuals of a generation: simulated in parallel, judged in slot order.
#pragma once

#include "base/parallel.h"
#include "evolution/population.h"
#include "experiment/spec.h"

#include <functional>
#include <span>
#include <vector>

namespace planula {

/// Asked before each generation and each simulation, by any thread; true ends the run with Stopped.
using StopRequest = std::function<bool()>;
/// The life of the genome in a slot; pure.
using LifeOf = std::function<Life(int slot, const Genome &)>;

/// The life of every individual, simulated by any of the workers: simulations share nothing.
std::vector<Life> live_all(const Population &population, const LifeOf &life_of, const Workers &workers,
                           const StopRequest &stop);

/// The evaluation of every life, in slot order on this thread.
std::vector<Evaluation> judge_all(const Judge &judge, std::span<const Life> lives);

} // namespace planula
