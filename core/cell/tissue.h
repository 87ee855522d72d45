// SPDX-License-Identifier: MIT
// The control state of all cells at the end of development: locomotion starts from it (§2.6). Cells are in
// the order of the body's.
#pragma once

#include "base/keep_only.h"
#include "network/activations.h"

#include <vector>

namespace planula {

struct Tissue {
    Activations activations;        // of the control networks
    std::vector<double> morphogens; // the last morphogen output of each cell

    /// Loses all cells but these, ascending.
    void keep(std::span<const int> cells) {
        std::vector<char> lost(morphogens.size(), 1);
        for (const int cell : cells) lost[cell] = 0;
        activations.remove(lost);
        keep_only(cells, morphogens);
    }
};

} // namespace planula
