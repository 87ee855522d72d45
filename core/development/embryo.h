// SPDX-License-Identifier: MIT
// The state of a growing embryo: disks in a plane, each with a copy of the control network's activations
// (§2.1). Cells are in ascending order of id; links hold indices into `cells`.
#pragma once

#include "body/mesh.h"
#include "network/activations.h"

#include <cstdint>
#include <vector>

namespace planula {

struct Cell {
    int id = 0;                // 0: the zygote; then in the order of births
    std::uint64_t lineage = 0; // a hash of the divisions that it comes from
    int daughters = 0;
    Vec2d position, velocity;
    Vec2d orientation{1, 0}; // unit vector
    double morphogen = 0;    // the output at the latest decision
};

struct Embryo {
    std::vector<Cell> cells;
    Activations activations; // of the cells' networks
    std::vector<Link> links; // as of the last refresh, ascending
    Neighbours neighbours;   // of each cell by these links
    int births = 1;          // cells created, the zygote included
    int largest = 1;         // most cells alive at once
};

/// One cell at the origin, at rest, orientation +x, all activations 0.
Embryo zygote(int network_nodes);

std::vector<Vec2d> positions(const Embryo &embryo);

} // namespace planula
