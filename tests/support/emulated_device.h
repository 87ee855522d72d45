// SPDX-License-Identifier: MIT
// A device without a device: the text of its kernel run by this thread, phase after phase, each thread of a block in
// turn. The order of the threads may be turned round or mixed, in which a phase that reads what another thread of the
// same phase writes gives other results.
#pragma once

#include "device/device.h"
#include "device/pack.h"
#include "device/trial_text.h"

#include <atomic>
#include <limits>
#include <numeric>

namespace planula::test {

enum class Order { forward, backward, mixed };

/// A block of threads (device/cuda/block.cuh).
class EmulatedBlock {
  public:
    explicit EmulatedBlock(Order order) : order_(order) {}

    template <class Act> void each(int count, const Act &act) {
        // Mixed: with a stride that has no divisor in common with the count, from phase to phase another one.
        std::int64_t stride = 1, from = 0;
        if (order_ == Order::backward) stride = count - 1, from = count - 1;
        if (order_ == Order::mixed && count > 0) {
            from = ++phases_ * 7919 % count;
            for (stride = phases_ % 89 + 2; std::gcd(stride, count) != 1;) ++stride;
        }
        for (int i = 0; i < count; ++i) act(static_cast<int>((from + i * stride) % count));
    }
    template <class Number> float most(int count, const Number &number) {
        float largest = 0;
        each(count, [&](int i) {
            const float one = number(i);
            if (!(one <= largest)) largest = one;
        });
        return largest;
    }
    template <class Number> float least(int count, const Number &number) {
        float smallest = std::numeric_limits<float>::infinity();
        each(count, [&](int i) { smallest = std::min(smallest, number(i)); });
        return smallest;
    }
    template <class Number> int total(int count, const Number &number) {
        int sum = 0;
        each(count, [&](int i) { sum += number(i); });
        return sum;
    }
    template <class Holds> bool all(int count, const Holds &holds) {
        bool result = true;
        each(count, [&](int i) { result = holds(i) && result; });
        return result;
    }
    template <class Holds> void mark(int count, const Holds &holds, unsigned *words) {
        each((count + 31) / 32, [&](int word) {
            unsigned bits = 0;
            for (int i = 32 * word; i < count && i < 32 * word + 32; ++i)
                if (holds(i)) bits |= 1u << i % 32;
            words[word] = bits;
        });
    }
    void copy(const std::byte *from, unsigned bytes, std::byte *to) { std::copy_n(from, bytes, to); }

  private:
    Order order_;
    std::int64_t phases_ = 0;
};

/// Memory as a device has it: aligned, and full of anything: of what is no number.
class DeviceMemory {
  public:
    explicit DeviceMemory(unsigned bytes) : lines_(bytes / device::alignment + 1) {}
    std::byte *data() { return lines_.data()->bytes; }

  private:
    struct alignas(device::alignment) Line {
        std::byte bytes[device::alignment];
        Line() { std::fill(std::begin(bytes), std::end(bytes), std::byte{0xff}); }
    };
    std::vector<Line> lines_;
};

/// Runs the trials of a batch one after another.
class EmulatedRunner : public device::Runner {
  public:
    explicit EmulatedRunner(Order order = Order::forward) : order_(order) {}

    int batches() const override { return 2; }
    int largest_batch() const override { return 3; }
    unsigned fast_bytes() const override { return 227 * 1024; }
    int threads() const override { return 1024; }
    void run(int, std::span<device::Job *const> jobs) override {
        for (device::Job *job : jobs) run(*job);
        trials += static_cast<int>(jobs.size());
    }

    std::atomic<int> trials = 0; // so far

  private:
    void run(device::Job &job) const {
        const auto task = device::task_of(job.input);
        DeviceMemory input(task.input_bytes), fast(task.fast_bytes), scratch(task.scratch_bytes),
            result(task.result_bytes);
        std::copy(job.input.begin(), job.input.end(), input.data());
        EmulatedBlock block(order_);
        device::run_trial(block, {input.data(), fast.data(), scratch.data(), result.data()});
        std::copy_n(result.data(), task.result_bytes, job.result.begin());
    }

    Order order_;
};

/// Lives are on an emulated device as long as this is there.
class OnDevice {
  public:
    explicit OnDevice(Order order) {
        auto runner = std::make_unique<EmulatedRunner>(order);
        runner_ = runner.get();
        device_ = std::make_unique<Device>(std::move(runner));
        choose_device(device_.get());
    }
    ~OnDevice() { choose_device(nullptr); }
    OnDevice(const OnDevice &) = delete;
    OnDevice &operator=(const OnDevice &) = delete;
    /// So far.
    int trials() const { return runner_->trials; }

  private:
    const EmulatedRunner *runner_;
    std::unique_ptr<Device> device_;
};

} // namespace planula::test
