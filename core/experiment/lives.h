// SPDX-License-Identifier: MIT
// How a generation lives and is judged: in parallel and in slot order.
#pragma once

#include "base/parallel.h"
#include "evolution/population.h"
#include "experiment/spec.h"

#include <functional>
#include <span>
#include <vector>

namespace planula {

/// Asked before each generation and between evaluations, by any thread; true ends the run with Stopped.
using StopRequest = std::function<bool()>;
/// What the genome in a slot does; pure.
using Living = std::function<Life(int slot, const Genome &)>;

/// Every individual's life, by any of the workers: lives share nothing.
std::vector<Life> live_all(const Population &population, const Living &living, const Workers &workers,
                           const StopRequest &stop);

/// Every life's evaluation, in slot order on this thread.
std::vector<Evaluation> judge_all(const Judge &judge, std::span<const Life> lives);

} // namespace planula
