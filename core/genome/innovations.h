// SPDX-License-Identifier: MIT
// The record of a whole run's structural innovations: the same link or split gets the same marking in every genome
// (§2.7.1; MN keeps the record for the whole run).
#pragma once

#include "base/state.h"

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace planula {

/// The nodes that a link joins.
struct Ends {
    int from = 0, to = 0; // node ids
};

class Innovations {
  public:
    /// Node ids from `first_node` on are free for splits.
    explicit Innovations(int first_node = 0) : first_node_(first_node) {}

    /// The innovation number of a link between two nodes, new at its first mention.
    int link(int from, int to);
    /// The nodes that splits of this link have made so far, oldest first.
    std::span<const int> splits(int from, int to) const;
    /// Records a further split of this link and returns the id of its node.
    int new_split(int from, int to);

    int links() const { return static_cast<int>(link_ends_.size()); }
    int first_node() const { return first_node_; }
    int next_node() const { return first_node_ + static_cast<int>(split_ends_.size()); }
    /// What a link of the record joins, 0 <= innovation < links().
    Ends link_ends(int innovation) const { return link_ends_.at(innovation); }
    /// What the link joined whose split made a node, first_node() <= node < next_node(): nodes below it.
    Ends split_ends(int node) const { return split_ends_.at(node - first_node_); }

    /// Writes the record: which link each innovation is, and which split made each node.
    void save(StateWriter &writer) const;
    /// Throws InputError for bytes that are no record.
    static Innovations load(StateReader &reader);

  private:
    // Only looked up by key, never walked: the order of a hash table reaches no result.
    std::unordered_map<std::uint64_t, int> links_;
    std::unordered_map<std::uint64_t, std::vector<int>> splits_;
    std::vector<Ends> link_ends_, split_ends_; // by innovation; by node, from first_node_ on
    int first_node_ = 0;
};

} // namespace planula
