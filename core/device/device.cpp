// SPDX-License-Identifier: MIT
#include "device/device.h"

#include "device/pack.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace planula {

namespace {

std::atomic<Device *> chosen = nullptr;

} // namespace

Device *chosen_device() { return chosen; }
void choose_device(Device *device) { chosen = device; }

Device::Device(std::unique_ptr<device::Runner> runner) : runner_(std::move(runner)) {
    for (int batch = 0; batch < runner_->batches(); ++batch) free_.push_back(batch);
}

std::optional<Trial> Device::locomote(const SoftBodyModel &model, const Environment &environment,
                                      double actuation_range, const Parameters &parameters,
                                      const Gait &gait) {
    auto input = device::pack(model, environment, actuation_range, parameters, gait);
    if (!input) return {};
    const device::Task task = device::task_of(*input);
    if (task.fast_bytes > runner_->fast_bytes() || task.nodes > runner_->threads()) return {};

    Waiting mine{.job = {std::move(*input), std::vector<std::byte>(task.result_bytes)},
                 .warps = (task.nodes + 31) / 32};
    wait_for(mine);
    if (mine.failure) std::rethrow_exception(mine.failure);
    return device::unpack(mine.job.input, mine.job.result);
}

void Device::wait_for(Waiting &mine) {
    Lock lock(mutex_);
    waiting_.push_back(&mine);
    if (!free_.empty()) mine.batch = free_.back(), free_.pop_back();
    while (mine.batch >= 0 || !mine.done)
        if (mine.batch >= 0)
            lead(std::exchange(mine.batch, -1), lock);
        else
            mine.changed.wait(lock);
}

void Device::lead(int batch, Lock &lock) {
    const std::vector<Waiting *> taken = take_oldest();
    if (!taken.empty()) {
        std::vector<device::Job *> jobs;
        for (Waiting *one : taken) jobs.push_back(&one->job);
        std::exception_ptr failure;
        lock.unlock();
        try {
            runner_->run(batch, jobs);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        for (Waiting *one : taken) one->done = true, one->failure = failure, one->changed.notify_one();
    }
    // The next that waits leads the next batch.
    const auto next =
        std::find_if(waiting_.begin(), waiting_.end(), [](Waiting *one) { return one->batch < 0; });
    if (next == waiting_.end()) {
        free_.push_back(batch);
        return;
    }
    (*next)->batch = batch;
    (*next)->changed.notify_one();
}

std::vector<Device::Waiting *> Device::take_oldest() {
    std::vector<Waiting *> taken;
    std::erase_if(waiting_, [&](Waiting *one) {
        const bool fits = taken.empty() || (one->warps == taken.front()->warps &&
                                            static_cast<int>(taken.size()) < runner_->largest_batch());
        if (fits) taken.push_back(one);
        return fits;
    });
    return taken;
}

} // namespace planula
