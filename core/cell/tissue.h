// SPDX-License-Identifier: MIT
// The control state of all cells at the end of development: locomotion starts from it (§2.6). Cells are in
// the order of the body's.
#pragma once

#include "network/activations.h"

#include <vector>

namespace planula {

struct Tissue {
    Activations activations;        // of the control networks
    std::vector<double> morphogens; // the last morphogen output of each cell
};

} // namespace planula
