// SPDX-License-Identifier: MIT
// Whole numbers as a short text, for recordings: Base64 VLQ, as source maps write it (Source Map Revision 3 Proposal,
// 2011). A number is one or more characters of the Base64 alphabet (RFC 4648), of six bits each: the highest bit says
// that more follow; of the others the lowest of a number's first character is its sign, the rest the magnitude, lowest
// first. Numbers from -15 to 15 take one character, so that compression finds what repeats.
//
// A series of numbers that change smoothly is written as differences: of order 1 the first number and then each minus
// the one before, of order 2 the same of these.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace planula {

/// The nearest multiple of 1/scale, counted in these; halves go up. Not a number is 0, and what is beyond ±2^50 that.
std::int64_t quantised(double value, double scale);

/// Appends the differences of a series.
void pack_series(std::span<const std::int64_t> series, int order, std::string &text);

} // namespace planula
