// SPDX-License-Identifier: MIT
// A life as one hash: of all its fields, in the order of evaluation/life.inl, to the bit. It is the same wherever the
// life is simulated.
#pragma once

#include "base/hash.h"
#include "evaluation/life.h"

#include <string>

namespace planula {

/// Feeds every field into a hash, as its bit pattern, so that 0 and -0 differ; a list with its length.
void feed(Hash &hash, const Life &life);

/// The SHA-256 of what feed() feeds, 64 hexadecimal digits.
std::string life_sha256(const Life &life);

} // namespace planula
