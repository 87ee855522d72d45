// SPDX-License-Identifier: MIT
// The control state of all cells at the end of development: what locomotion starts from (§2.6). Cells are in
// the order of the body's.
#pragma once

#include <span>
#include <vector>

namespace planula {

struct Tissue {
    int nodes = 0;                   // of the control network
    std::vector<double> activations; // cells × nodes, a row per cell
    std::vector<double> morphogens;  // the last morphogen output of each cell

    std::span<double> row(int cell) {
        return {activations.data() + static_cast<std::size_t>(cell) * nodes, static_cast<std::size_t>(nodes)};
    }
    std::span<const double> row(int cell) const {
        return {activations.data() + static_cast<std::size_t>(cell) * nodes, static_cast<std::size_t>(nodes)};
    }
};

} // namespace planula
