// SPDX-License-Identifier: MIT
// Two genomes side by side: their links in step by innovation, as NEAT compares and crosses them (§2.7.1). Needs the
// links of both in ascending order of innovation.
#pragma once

#include "genome/genome.h"

namespace planula {

enum class Side { first, second };

/// Walks the links of both genomes in ascending order of innovation and calls matching(of_a, of_b) for a link that both
/// have, and alone(link, side, excess) for one that only `side` has; it is an excess link if it is newer than all links
/// of the other genome, else a disjoint one.
template <class Matching, class Alone>
void align(const Genome &a, const Genome &b, Matching matching, Alone alone) {
    auto in_a = a.links.begin();
    auto in_b = b.links.begin();
    while (in_a != a.links.end() && in_b != b.links.end()) {
        if (in_a->innovation == in_b->innovation)
            matching(*in_a++, *in_b++);
        else if (in_a->innovation < in_b->innovation)
            alone(*in_a++, Side::first, false);
        else
            alone(*in_b++, Side::second, false);
    }
    for (; in_a != a.links.end(); ++in_a) alone(*in_a, Side::first, true);
    for (; in_b != b.links.end(); ++in_b) alone(*in_b, Side::second, true);
}

} // namespace planula
