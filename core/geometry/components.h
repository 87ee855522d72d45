// SPDX-License-Identifier: MIT
// Connected components of a growing graph (union–find).
#pragma once

#include <numeric>
#include <vector>

namespace planula {

class Components {
  public:
    explicit Components(int count) : parent_(static_cast<std::size_t>(count)) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    /// Joins the components of two vertices; false if they were one already.
    bool join(int a, int b) {
        a = root(a), b = root(b);
        parent_[b] = a;
        return a != b;
    }
    bool connected(int a, int b) { return root(a) == root(b); }

  private:
    int root(int vertex) {
        while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
        return vertex;
    }

    std::vector<int> parent_;
};

} // namespace planula
