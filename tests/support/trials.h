// SPDX-License-Identifier: MIT
// Gaits to try on any body, and trials compared to the bit.
#pragma once

#include "base/math.h"
#include "locomotion/grn.h"
#include "locomotion/oscillator.h"
#include "locomotion/trial.h"
#include "support/specimens.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

namespace planula::test {

inline std::unique_ptr<Gait> oscillators(const Body &body, const Parameters &p) {
    std::vector<Oscillator> list;
    for (int cell = 0; cell < body.cells(); ++cell)
        list.push_back({100 + 0.7 * cell, body.positions[cell].x * 0.4 + body.positions[cell].y});
    return std::make_unique<Oscillators>(list, p.gait);
}

/// Networks whose outputs swing and depend on those of the neighbours, in states that differ from cell to cell.
struct Networks {
    static Genome genome() {
        Genome genome = specimens::random_genome(Actuation::grn, 3);
        for (const auto output : {output::morphogen, output::spring}) {
            specimens::wire(genome, input::morphogen, output, 3);
            specimens::add_link(genome, genome.inputs + output, genome.inputs + output, -2);
        }
        return genome;
    }
    Network network = express(genome(), 16);
    std::unique_ptr<Gait> gait(const Body &body, const Parameters &p) const {
        Tissue tissue{Activations(network.nodes, body.cells()), {}};
        for (int cell = 0; cell < body.cells(); ++cell) {
            tissue.morphogens.push_back(math::sin(0.3 * cell));
            for (int node = network.inputs; node < network.nodes; ++node)
                tissue.activations.at(cell, node) = math::sin(cell + 0.1 * node);
        }
        return std::make_unique<GrnMuscles>(network, body, tissue, p);
    }
};

inline bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
inline bool same(Vec2d a, Vec2d b) { return same(a.x, b.x) && same(a.y, b.y); }
/// All numbers of two trials, to the bit.
inline bool same(const Trial &a, const Trial &b) {
    return a.outcome == b.outcome && a.settle_steps == b.settle_steps && same(a.rest, b.rest) &&
           same(a.finish, b.finish) && same(a.activity, b.activity) &&
           same(a.late_actuation, b.late_actuation) &&
           std::equal(a.path.begin(), a.path.end(), b.path.begin(), b.path.end(),
                      [](Vec2d p, Vec2d q) { return same(p, q); });
}

} // namespace planula::test
