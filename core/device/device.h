// SPDX-License-Identifier: MIT
// Locomotion on a device: many threads grow bodies and hand their trials in, each waiting for its own; the trials that
// wait together run as a batch. What comes back are the bits of locomote() with the native engine (decision 0034). A
// device decides nothing but time: like the lanes of a processor (base/lane_sets.h) it is chosen for the process, and
// is no part of conditions or identities.
#pragma once

#include "device/runner.h"
#include "locomotion/trial.h"

#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace planula {

class Device {
  public:
    explicit Device(std::unique_ptr<device::Runner> runner);

    /// As locomote() with the native engine in one environment throughout, watched by nobody; the gait must not have
    /// begun and is not changed. Nothing for a trial that the device does not simulate: it is to be simulated here.
    /// Any thread may call this. Throws Error if the device fails.
    std::optional<Trial> locomote(const SoftBodyModel &model, const Environment &environment,
                                  double actuation_range, const Parameters &parameters, const Gait &gait);
    /// How many trials must be waiting or running at a time to keep the device busy.
    int trials_at_once() const { return 2 * runner_->batches() * runner_->largest_batch(); }

  private:
    // A trial and the thread that waits for it, or is to lead a batch: it hands the batch to the runner.
    struct Waiting {
        device::Job job;
        int warps = 0; // of threads that work on it; those of a batch have equally many
        int batch = -1;
        bool done = false;
        std::exception_ptr failure;
        std::condition_variable changed{};
    };
    using Lock = std::unique_lock<std::mutex>;
    void wait_for(Waiting &mine);
    void lead(int batch, Lock &lock);
    std::vector<Waiting *> take_oldest();

    std::unique_ptr<device::Runner> runner_;
    std::mutex mutex_;               // of all below
    std::vector<Waiting *> waiting_; // not in a batch yet, in the order in which they came
    std::vector<int> free_;          // numbers of batches that nobody leads
};

/// The device to use from now on; none at first. It must outlive its use.
Device *chosen_device();
void choose_device(Device *device);

/// The graphics processor of this machine. Throws InputError, with what to do, if this build knows none or there is
/// none.
std::unique_ptr<device::Runner> open_gpu();

} // namespace planula
