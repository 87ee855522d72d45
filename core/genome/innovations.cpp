// SPDX-License-Identifier: MIT
#include "genome/innovations.h"

namespace planula {

namespace {

constexpr int most_inputs_and_outputs = 1 << 20; // of any network: a bound for saved numbers

/// Both ends of a link in one key.
std::uint64_t key_of(int from, int to) {
    return std::uint64_t{static_cast<std::uint32_t>(from)} << 32 | static_cast<std::uint32_t>(to);
}

void write_ends(std::span<const Ends> links, StateWriter &writer) {
    writer.integer(static_cast<std::int64_t>(links.size()));
    for (const auto &[from, to] : links) writer.integer(from).integer(to);
}

/// The ends of a link between nodes below `nodes`.
Ends read_ends(int nodes, StateReader &reader) {
    const auto from = static_cast<int>(reader.integer(0, std::int64_t{nodes} - 1));
    const auto to = static_cast<int>(reader.integer(0, std::int64_t{nodes} - 1));
    return {from, to};
}

} // namespace

int Innovations::link(int from, int to) {
    const auto [entry, is_new] = links_.try_emplace(key_of(from, to), links());
    if (is_new) link_ends_.push_back({from, to});
    return entry->second;
}

std::span<const int> Innovations::splits(int from, int to) const {
    const auto entry = splits_.find(key_of(from, to));
    return entry == splits_.end() ? std::span<const int>() : std::span<const int>(entry->second);
}

int Innovations::new_split(int from, int to) {
    splits_[key_of(from, to)].push_back(next_node());
    split_ends_.push_back({from, to});
    return next_node() - 1;
}

void Innovations::save(StateWriter &writer) const {
    writer.group("innovations").integer(first_node_);
    write_ends(split_ends_, writer);
    write_ends(link_ends_, writer);
}

Innovations Innovations::load(StateReader &reader) {
    constexpr std::size_t pair_bytes = 16;
    reader.group("innovations");
    Innovations innovations(static_cast<int>(reader.integer(0, most_inputs_and_outputs)));
    for (std::size_t left = reader.count(pair_bytes); left > 0; --left) {
        const auto [from, to] = read_ends(innovations.next_node(), reader);
        innovations.new_split(from, to);
    }
    const std::size_t links = reader.count(pair_bytes);
    for (std::size_t number = 0; number < links; ++number) {
        const auto [from, to] = read_ends(innovations.next_node(), reader);
        if (innovations.link(from, to) != static_cast<int>(number)) reader.refuse("a link is there twice");
    }
    return innovations;
}

} // namespace planula
