// SPDX-License-Identifier: MIT
// What runs packed trials: a graphics processor, or a loop that does as one in tests.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace planula::device {

/// A trial that a runner is handed.
struct Job {
    std::vector<std::byte> input;  // pack()
    std::vector<std::byte> result; // made by the runner
};

class Runner {
  public:
    virtual ~Runner() = default;

    /// How many batches run at once, each by a thread that waits for it, and how many trials one has at most.
    virtual int batches() const = 0;
    virtual int largest_batch() const = 0;
    /// The memory, in bytes, and the threads that one trial may take (Task::fast_bytes, Task::nodes).
    virtual unsigned fast_bytes() const = 0;
    virtual int threads() const = 0;
    /// Runs the trials of a batch and waits for them. At any time at most one thread is in here with each number of a
    /// batch, 0 … batches() − 1. Throws Error if the device fails.
    virtual void run(int batch, std::span<Job *const> jobs) = 0;
};

} // namespace planula::device
