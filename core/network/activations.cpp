// SPDX-License-Identifier: MIT
#include "network/activations.h"

#include "base/check.h"

#include <cstring>

namespace planula {

void Activations::append_copy(int cell) {
    CHECK(cell < cells_, cell, cells_);
    if (cells_++ % group_size == 0) values_.resize(static_cast<std::size_t>(groups()) * nodes_ * group_size);
    copy(cell, cells_ - 1);
}

void Activations::remove(std::span<const char> marks) {
    int kept = 0;
    for (int cell = 0; cell < cells_; ++cell) {
        if (marks[cell]) continue;
        if (kept != cell) copy(cell, kept);
        ++kept;
    }
    cells_ = kept;
    values_.resize(static_cast<std::size_t>(groups()) * nodes_ * group_size);
}

bool identical(const Activations &a, const Activations &b) {
    return a.nodes_ == b.nodes_ && a.cells_ == b.cells_ && a.values_.size() == b.values_.size() &&
           std::memcmp(a.values_.data(), b.values_.data(), a.values_.size() * sizeof(double)) == 0;
}

void Activations::copy(int from, int to) {
    for (int node = 0; node < nodes_; ++node) at(to, node) = at(from, node);
}

} // namespace planula
