// SPDX-License-Identifier: MIT
#include "genome/innovations.h"

namespace planula {

namespace {

/// Both ends of a link in one key.
std::uint64_t key_of(int from, int to) {
    return std::uint64_t{static_cast<std::uint32_t>(from)} << 32 | static_cast<std::uint32_t>(to);
}

} // namespace

int Innovations::link(int from, int to) {
    const auto [entry, is_new] = links_.try_emplace(key_of(from, to), next_link_);
    if (is_new) ++next_link_;
    return entry->second;
}

std::span<const int> Innovations::splits(int from, int to) const {
    const auto entry = splits_.find(key_of(from, to));
    return entry == splits_.end() ? std::span<const int>() : std::span<const int>(entry->second);
}

int Innovations::new_split(int from, int to) {
    splits_[key_of(from, to)].push_back(next_node_);
    return next_node_++;
}

} // namespace planula
