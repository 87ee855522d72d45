// SPDX-License-Identifier: MIT
// The activations of many cells' copies of one network. Cells are stored in groups of eight, in each group a row of
// eight numbers per node, so that one instruction works on several cells (network/kernel.h).
#pragma once

#include <span>
#include <vector>

namespace planula {

class Activations {
  public:
    static constexpr int group_size = 8;

    Activations() = default;
    /// All 0.
    Activations(int nodes, int cells)
        : nodes_(nodes), cells_(cells), values_(static_cast<std::size_t>(groups()) * nodes * group_size) {}

    int nodes() const { return nodes_; }
    int cells() const { return cells_; }
    double &at(int cell, int node) { return values_[place(cell, node)]; }
    double at(int cell, int node) const { return values_[place(cell, node)]; }

    /// One cell more, with the activations of this one.
    void append_copy(int cell);
    /// Removes the marked cells, one mark per cell; the others keep their order.
    void remove(std::span<const char> marks);

    /// Whether all bits are the same; those of lanes that hold anything may make it false.
    friend bool identical(const Activations &a, const Activations &b);

    int groups() const { return (cells_ + group_size - 1) / group_size; }
    /// Group after group, node after node; lanes beyond the last cell hold anything.
    double *values() { return values_.data(); }

  private:
    std::size_t place(int cell, int node) const {
        return (static_cast<std::size_t>(cell / group_size) * nodes_ + node) * group_size + cell % group_size;
    }
    void copy(int from, int to);

    int nodes_ = 0, cells_ = 0;
    std::vector<double> values_;
};

} // namespace planula
