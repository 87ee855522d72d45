// SPDX-License-Identifier: MIT
// Named, counter-based random streams. A stream is a pure function of (seed; generation, individual, purpose): there is
// no state to save, and no draw of one stream can move another. The generator is Philox4x32-10 (Salmon et al. 2011,
// "Parallel random numbers: as easy as 1, 2, 3"). Development and physics take no chance.
#pragma once

#include <array>
#include <cstdint>

namespace planula {

/// What a stream is drawn for. Values are part of every result: append, never renumber.
enum class Purpose : std::uint32_t {
    initial_weights = 1,
    reproduction = 2,
    bootstrap = 3,
    sampling = 4,
    start = 5,
    permutation = 6,
};

/// One block of Philox4x32-10: 128 random bits of a 128-bit counter and a 64-bit key.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

class Stream {
  public:
    Stream(std::uint64_t seed, std::uint32_t generation, std::uint32_t individual, Purpose purpose);

    std::uint32_t bits();
    /// Uniform on [0, 1), 53 bits.
    double uniform();
    /// The difference of two uniform draws: triangular on (-1, 1).
    double triangular();
    /// Uniform on 0 … count - 1, without bias; count >= 1.
    std::uint32_t below(std::uint32_t count);
    bool chance(double probability) { return uniform() < probability; }

  private:
    std::array<std::uint32_t, 2> key_;
    std::array<std::uint32_t, 4> counter_; // block, individual, generation, purpose
    std::array<std::uint32_t, 4> block_{};
    int used_ = 4;
};

} // namespace planula
