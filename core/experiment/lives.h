// SPDX-License-Identifier: MIT
// How a generation lives and is judged: in parallel and in slot order.
#pragma once

#include "evolution/population.h"
#include "experiment/spec.h"

#include <functional>
#include <span>
#include <vector>

namespace planula {

/// Asked before each generation and between evaluations; true ends the run with Stopped.
using StopRequest = std::function<bool()>;
/// What the genome in a slot does; pure.
using Living = std::function<Life(int slot, const Genome &)>;

/// Every individual's life, on up to `threads` threads: lives share nothing.
std::vector<Life> live_all(const Population &population, const Living &living, int threads,
                           const StopRequest &stop);

/// Every life's evaluation, in slot order on this thread.
std::vector<Evaluation> judge_all(const Judge &judge, std::span<const Life> lives);

} // namespace planula
