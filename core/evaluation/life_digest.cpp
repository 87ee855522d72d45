// SPDX-License-Identifier: MIT
#include "evaluation/life_digest.h"

#include <cstdint>

namespace planula {

namespace {

void add(Hash &hash, int value) { hash.number(value); }
void add(Hash &hash, double value) { hash.number(value); }
void add(Hash &hash, Outcome outcome) { hash.number(static_cast<int>(outcome)); }
void add(Hash &hash, Vec2d point) { hash.number(point.x).number(point.y); }
void add(Hash &hash, const ShapeDistribution &shape) {
    for (const float share : shape) hash.number(static_cast<double>(share));
}
void add(Hash &hash, const std::vector<Vec2d> &points) {
    hash.number(std::uint64_t{points.size()});
    for (const Vec2d point : points) add(hash, point);
}

} // namespace

void feed(Hash &hash, const Life &life) {
    each_field(life, [&](const auto &field) { add(hash, field); });
}

std::string life_sha256(const Life &life) {
    Hash hash;
    feed(hash, life);
    return hash.hex();
}

} // namespace planula
