// SPDX-License-Identifier: MIT
#include "base/random.h"

#include "base/check.h"

namespace planula {

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t product0 = std::uint64_t{0xD2511F53} * counter[0];
        const std::uint64_t product1 = std::uint64_t{0xCD9E8D57} * counter[2];
        counter = {static_cast<std::uint32_t>(product1 >> 32) ^ counter[1] ^ key[0],
                   static_cast<std::uint32_t>(product1),
                   static_cast<std::uint32_t>(product0 >> 32) ^ counter[3] ^ key[1],
                   static_cast<std::uint32_t>(product0)};
        key[0] += 0x9E3779B9, key[1] += 0xBB67AE85;
    }
    return counter;
}

Stream::Stream(std::uint64_t seed, std::uint32_t generation, std::uint32_t individual, Purpose purpose)
    : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)},
      counter_{0, individual, generation, static_cast<std::uint32_t>(purpose)} {}

std::uint32_t Stream::bits() {
    if (used_ == 4) {
        block_ = philox(counter_, key_);
        ++counter_[0];
        CHECK(counter_[0] != 0);
        used_ = 0;
    }
    return block_[used_++];
}

double Stream::uniform() {
    const std::uint64_t high = bits() >> 5, low = bits() >> 6;
    return static_cast<double>(high << 26 | low) * 0x1p-53;
}

double Stream::triangular() {
    const double first = uniform();
    return first - uniform();
}

std::uint32_t Stream::below(std::uint32_t count) {
    CHECK(count >= 1);
    // Draws beyond the largest multiple of count are thrown away (Lemire 2019 puts it in one multiplication).
    const std::uint32_t rejected = (0 - count) % count;
    for (;;) {
        const std::uint64_t product = std::uint64_t{bits()} * count;
        if (static_cast<std::uint32_t>(product) >= rejected) return static_cast<std::uint32_t>(product >> 32);
    }
}

} // namespace planula
