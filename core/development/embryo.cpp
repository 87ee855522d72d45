// SPDX-License-Identifier: MIT
#include "development/embryo.h"

namespace planula {

Embryo zygote(int network_nodes) {
    Embryo embryo;
    embryo.cells.resize(1);
    embryo.activations = Activations(network_nodes, 1);
    embryo.neighbours = Neighbours({}, 1);
    return embryo;
}

std::vector<Vec2d> positions(const Embryo &embryo) {
    std::vector<Vec2d> result;
    for (const Cell &cell : embryo.cells) result.push_back(cell.position);
    return result;
}

} // namespace planula
