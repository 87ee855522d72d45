// SPDX-License-Identifier: MIT
// What the text of a block of threads on a graphics processor (core/device/cuda/block.cuh) takes from CUDA, made of this
// machine's threads: any compiler builds that text then, and it can be run and searched for data races here.
#pragma once

#include <algorithm>
#include <atomic>
#include <barrier>
#include <bit>
#include <deque>
#include <thread>
#include <vector>

#define __device__

struct uint4 {
    unsigned x, y, z, w;
};

namespace planula::test {

/// The threads of a block, in warps of 32.
class CudaThreads {
  public:
    explicit CudaThreads(int threads) : threads_(threads), values_(threads), all_(threads) {
        for (int warp = 0; warp < threads / 32; ++warp) warps_.emplace_back(32);
    }
    /// Calls act() on each of them.
    template <class Act> void run(const Act &act);

    void wait() { all_.arrive_and_wait(); }
    /// A thread's value and those of the others of its warp, one after another.
    template <class Value, class Add>
    Value over_warp(int thread, unsigned mine, Value value, const Add &add) {
        values_[thread] = mine;
        auto &warp = warps_[thread / 32];
        warp.arrive_and_wait();
        for (int lane = 0; lane < 32; ++lane) value = add(value, values_[thread / 32 * 32 + lane], lane);
        warp.arrive_and_wait();
        return value;
    }
    bool holds_for_all(bool mine) {
        if (!mine) holds_ = false;
        wait();
        const bool result = holds_;
        wait();
        holds_ = true;
        wait();
        return result;
    }

  private:
    const int threads_;
    std::vector<unsigned> values_; // that warps exchange
    std::barrier<> all_;
    std::deque<std::barrier<>> warps_;
    std::atomic<bool> holds_ = true;
};

} // namespace planula::test

inline thread_local planula::test::CudaThreads *cuda_block = nullptr;
inline thread_local struct CudaIndex { unsigned x; } threadIdx, blockDim;

template <class Act> void planula::test::CudaThreads::run(const Act &act) {
    std::vector<std::jthread> threads;
    for (int i = 0; i < threads_; ++i)
        threads.emplace_back([&, i] {
            cuda_block = this;
            threadIdx.x = static_cast<unsigned>(i), blockDim.x = static_cast<unsigned>(threads_);
            act();
        });
}

using std::max, std::min;
inline void __syncthreads() { cuda_block->wait(); }
inline bool __syncthreads_and(bool holds) { return cuda_block->holds_for_all(holds); }
inline unsigned __reduce_max_sync(unsigned, unsigned mine) {
    return cuda_block->over_warp(static_cast<int>(threadIdx.x), mine, 0u,
                                 [](unsigned a, unsigned b, int) { return max(a, b); });
}
inline unsigned __reduce_min_sync(unsigned, unsigned mine) {
    return cuda_block->over_warp(static_cast<int>(threadIdx.x), mine, ~0u,
                                 [](unsigned a, unsigned b, int) { return min(a, b); });
}
inline unsigned __reduce_add_sync(unsigned, unsigned mine) {
    return cuda_block->over_warp(static_cast<int>(threadIdx.x), mine, 0u,
                                 [](unsigned a, unsigned b, int) { return a + b; });
}
inline unsigned __ballot_sync(unsigned, bool mine) {
    return cuda_block->over_warp(static_cast<int>(threadIdx.x), mine, 0u,
                                 [](unsigned a, unsigned b, int lane) { return a | b << lane; });
}
inline unsigned __float_as_uint(float number) { return std::bit_cast<unsigned>(number); }
inline float __uint_as_float(unsigned bits) { return std::bit_cast<float>(bits); }
inline float __int_as_float(int bits) { return std::bit_cast<float>(bits); }
