// SPDX-License-Identifier: MIT
// A block of threads as the crew of a trial (device/trial_text.h). Each phase ends with a barrier.
#pragma once

#include <cstddef>
#include <cstdint>

namespace planula::device {

class Block {
  public:
    static constexpr int most_warps = 32;

    /// What warps tell each other, in shared memory: of two phases in turn, so that one barrier is enough.
    struct Told {
        unsigned of_warp[2][most_warps];
    };

    __device__ explicit Block(Told &told) : told_(told) {}

    template <class Act> __device__ void each(int count, const Act &act) {
        for (int i = thread(); i < count; i += blockDim.x) act(i);
        __syncthreads();
    }
    /// The largest of some numbers that are not negative; NaN is the largest.
    template <class Number> __device__ float most(int count, const Number &number) {
        unsigned largest = 0;
        for (int i = thread(); i < count; i += blockDim.x) largest = max(largest, __float_as_uint(number(i)));
        return __uint_as_float(told<Most>(__reduce_max_sync(everyone, largest)));
    }
    /// The least of some numbers; infinity of none.
    template <class Number> __device__ float least(int count, const Number &number) {
        unsigned smallest = ordered(__int_as_float(0x7f800000));
        for (int i = thread(); i < count; i += blockDim.x) smallest = min(smallest, ordered(number(i)));
        return number_at(told<Least>(__reduce_min_sync(everyone, smallest)));
    }
    template <class Number> __device__ int total(int count, const Number &number) {
        unsigned sum = 0;
        for (int i = thread(); i < count; i += blockDim.x) sum += number(i);
        return static_cast<int>(told<Total>(__reduce_add_sync(everyone, sum)));
    }
    template <class Holds> __device__ bool all(int count, const Holds &holds) {
        bool mine = true;
        for (int i = thread(); i < count; i += blockDim.x) mine = holds(i) && mine;
        return __syncthreads_and(mine);
    }
    /// Sets bit i % 32 of words[i / 32] where it holds, and clears it elsewhere.
    template <class Holds> __device__ void mark(int count, const Holds &holds, unsigned *words) {
        const int end = (count + 31) / 32 * 32;
        for (int i = thread(); i < end; i += blockDim.x) {
            const unsigned bits = __ballot_sync(everyone, i < count && holds(i));
            if (i % 32 == 0) words[i / 32] = bits;
        }
        __syncthreads();
    }
    /// Sizes are multiples of 16.
    __device__ void copy(const std::byte *from, unsigned bytes, std::byte *to) {
        for (unsigned i = thread() * 16; i < bytes; i += blockDim.x * 16)
            *reinterpret_cast<uint4 *>(to + i) = *reinterpret_cast<const uint4 *>(from + i);
        __syncthreads();
    }

  private:
    static constexpr unsigned everyone = 0xffffffff;
    struct Most {
        static constexpr unsigned none = 0;
        __device__ static unsigned of(unsigned a, unsigned b) { return max(a, b); }
    };
    struct Least {
        static constexpr unsigned none = 0xffffffff;
        __device__ static unsigned of(unsigned a, unsigned b) { return min(a, b); }
    };
    struct Total {
        static constexpr unsigned none = 0;
        __device__ static unsigned of(unsigned a, unsigned b) { return a + b; }
    };

    __device__ static int thread() { return static_cast<int>(threadIdx.x); }
    /// Floats as numbers of the same order.
    __device__ static unsigned ordered(float number) {
        const unsigned bits = __float_as_uint(number);
        return bits >> 31 ? ~bits : bits | 0x80000000;
    }
    __device__ static float number_at(unsigned place) {
        return __uint_as_float(place >> 31 ? place & 0x7fffffff : ~place);
    }
    /// What all warps' numbers come to.
    template <class How> __device__ unsigned told(unsigned of_my_warp) {
        unsigned *const of_warp = told_.of_warp[turn_ ^= 1];
        if (thread() % 32 == 0) of_warp[thread() / 32] = of_my_warp;
        __syncthreads();
        unsigned result = How::none;
        for (int warp = 0; warp < static_cast<int>(blockDim.x) / 32; ++warp)
            result = How::of(result, of_warp[warp]);
        return result;
    }

    Told &told_;
    int turn_ = 0;
};

} // namespace planula::device
