// SPDX-License-Identifier: MIT
#include "base/hash.h"

#include <algorithm>
#include <cstring>

namespace planula {

namespace {

constexpr bool is_prime(unsigned n) {
    for (unsigned d = 2; d * d <= n; ++d)
        if (n % d == 0) return false;
    return n > 1;
}

/// The first 32 bits of the fractional part of the cube root of n, found by bisection in integers: the standard's round
/// constants are defined so (FIPS 180-4, section 4.2.2).
constexpr std::uint32_t cube_root_fraction(unsigned n) {
    // The largest r with r^3 <= n * 2^96 has 2^32 times the root; compared in 128 bits.
    __extension__ using Wide = unsigned __int128;
    Wide low = 0, high = Wide(8) << 32;
    while (high - low > 1) {
        const Wide middle = (low + high) / 2;
        // middle < 2^35, so middle^3 < 2^105 and n * 2^96 < 2^105 as n < 512.
        if (middle * middle * middle <= Wide(n) << 96)
            low = middle;
        else
            high = middle;
    }
    return static_cast<std::uint32_t>(low);
}

constexpr std::array<std::uint32_t, 64> make_round_constants() {
    std::array<std::uint32_t, 64> constants{};
    unsigned candidate = 2;
    for (auto &constant : constants) {
        while (!is_prime(candidate)) ++candidate;
        constant = cube_root_fraction(candidate++);
    }
    return constants;
}

constexpr auto round_constants = make_round_constants();

} // namespace

Hash &Hash::bytes(const void *data, std::size_t size) {
    auto source = static_cast<const unsigned char *>(data);
    std::size_t filled = length_ % 64;
    length_ += size;
    while (size > 0) {
        const std::size_t taken = std::min<std::size_t>(64 - filled, size);
        std::memcpy(pending_.data() + filled, source, taken);
        source += taken, size -= taken, filled += taken;
        if (filled == 64) block(pending_.data()), filled = 0;
    }
    return *this;
}

Hash &Hash::number(std::uint64_t value) {
    unsigned char little[8];
    for (int i = 0; i < 8; ++i) little[i] = static_cast<unsigned char>(value >> (8 * i));
    return bytes(little, sizeof little);
}

std::string Hash::hex() const {
    // Padding: a one bit, zeros, and the length in bits, big-endian, to a whole number of blocks.
    Hash closed = *this;
    const std::uint64_t bits = length_ * 8;
    unsigned char padding[72] = {0x80};
    const std::size_t zeros = (119 - length_ % 64) % 64;
    for (int i = 0; i < 8; ++i) padding[1 + zeros + i] = static_cast<unsigned char>(bits >> (56 - 8 * i));
    closed.bytes(padding, 1 + zeros + 8);

    std::string digits;
    for (const std::uint32_t word : closed.state_)
        for (int shift = 28; shift >= 0; shift -= 4) digits += "0123456789abcdef"[word >> shift & 15];
    return digits;
}

void Hash::block(const unsigned char *chunk) {
    std::array<std::uint32_t, 64> w;
    for (int i = 0; i < 16; ++i)
        w[i] = std::uint32_t(chunk[4 * i]) << 24 | std::uint32_t(chunk[4 * i + 1]) << 16 |
               std::uint32_t(chunk[4 * i + 2]) << 8 | chunk[4 * i + 3];
    for (int i = 16; i < 64; ++i) {
        const std::uint32_t s0 = std::rotr(w[i - 15], 7) ^ std::rotr(w[i - 15], 18) ^ w[i - 15] >> 3;
        const std::uint32_t s1 = std::rotr(w[i - 2], 17) ^ std::rotr(w[i - 2], 19) ^ w[i - 2] >> 10;
        w[i] = w[i - 16] + s0 + w[i - 7] + s1;
    }

    auto [a, b, c, d, e, f, g, h] = state_;
    for (int i = 0; i < 64; ++i) {
        const std::uint32_t sum1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
        const std::uint32_t choice = (e & f) ^ (~e & g);
        const std::uint32_t t1 = h + sum1 + choice + round_constants[i] + w[i];
        const std::uint32_t sum0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
        const std::uint32_t majority = (a & b) ^ (a & c) ^ (b & c);
        h = g, g = f, f = e, e = d + t1, d = c, c = b, b = a, a = t1 + sum0 + majority;
    }
    const std::array<std::uint32_t, 8> mixed{a, b, c, d, e, f, g, h};
    for (int i = 0; i < 8; ++i) state_[i] += mixed[i];
}

std::string sha256(std::string_view bytes) { return Hash().bytes(bytes.data(), bytes.size()).hex(); }

} // namespace planula
