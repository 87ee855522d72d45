// SPDX-License-Identifier: MIT
// SHA-256 (FIPS 180-4), for signatures, manifests and the identity of a specification; sha256sum agrees. Numbers are
// fed as little-endian bytes of their bit patterns, so equal hashes mean equal bits.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace planula {

class Hash {
  public:
    Hash &bytes(const void *data, std::size_t size);
    Hash &text(std::string_view value) {
        return number(std::uint64_t{value.size()}).bytes(value.data(), value.size());
    }
    Hash &number(std::uint64_t value);
    Hash &number(double value) { return number(std::bit_cast<std::uint64_t>(value)); }
    Hash &number(int value) { return number(static_cast<std::uint64_t>(static_cast<std::int64_t>(value))); }

    /// 64 lower-case hexadecimal digits. The hash itself stays open: more may be fed afterwards.
    std::string hex() const;

  private:
    void block(const unsigned char *chunk);

    std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                        0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    std::array<unsigned char, 64> pending_{};
    std::uint64_t length_ = 0;
};

/// SHA-256 of a text's bytes, as sha256sum prints it.
std::string sha256(std::string_view bytes);

/// A 64-bit mixer: every bit of the result depends on every bit of `value` (the finaliser of SplitMix64, Steele, Lea &
/// Flood 2014). For fixed, meaningless variety; not for secrets.
constexpr std::uint64_t mix(std::uint64_t value) {
    value = (value ^ value >> 30) * 0xbf58476d1ce4e5b9;
    value = (value ^ value >> 27) * 0x94d049bb133111eb;
    return value ^ value >> 31;
}

} // namespace planula
