// SPDX-License-Identifier: MIT
// The kernel: a block of threads for each trial (device/trial_text.h).
#pragma once

#include "device/cuda/block.cuh"
#include "device/trial_text.h"

namespace planula::device {

/// Where a trial's memories begin in those of its batch, in bytes.
struct Place {
    unsigned long long input, scratch, result;
};

extern __shared__ uint4 fast_memory[];

/// Blocks have whole warps of threads, at least one for each node, and Task::fast_bytes of dynamic shared memory.
__global__ void __launch_bounds__(1024)
    run_trials(const Place *places, const std::byte *inputs, std::byte *scratch, std::byte *results) {
    __shared__ Block::Told told;
    Block block(told);
    const Place place = places[blockIdx.x];
    run_trial(block, {inputs + place.input, reinterpret_cast<std::byte *>(fast_memory),
                      scratch + place.scratch, results + place.result});
}

} // namespace planula::device
