// SPDX-License-Identifier: MIT
// Connected components of a growing graph (union–find).
#pragma once

#include <numeric>
#include <vector>

namespace planula {

class Components {
  public:
    explicit Components(int count) : parent_(static_cast<std::size_t>(count)), count_(count) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    /// Joins the components of two vertices; false if they were one already.
    bool join(int a, int b) {
        a = root(a), b = root(b);
        parent_[b] = a;
        count_ -= a != b;
        return a != b;
    }
    bool connected(int a, int b) { return root(a) == root(b); }

    /// How many components there are.
    int count() const { return count_; }

  private:
    int root(int vertex) {
        while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
        return vertex;
    }

    std::vector<int> parent_;
    int count_;
};

} // namespace planula
