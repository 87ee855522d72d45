// SPDX-License-Identifier: MIT
// Self-collision in the native engine: measures several pairs of cell and link at once, and takes the force of the few
// that touch from the law (laws/contact.h). Pairs that may meet soon are kept in a list (Verlet) that is made again
// when nodes have moved against each other by more than its skin. While they have moved too little for any listed pair
// to come into reach, no pair is measured: how far they can have moved is summed from step to step. The touches are
// those of a search over all pairs, to the bit.
#pragma once

#include "physics/laws/contact.h"
#include "physics/native/contact_watch.h"
#include "physics/native/kernel.h"

#include <span>
#include <vector>

namespace planula::native {

/// A contact cell that an outline link with the ends a and b pushes.
struct Touch {
    int cell, a, b;
    ContactForces<float> forces;
};

class Contact {
  public:
    /// Forgets the list. Layout and kernel must outlive the use of this.
    void load(const Layout &layout, const Kernel &kernel);
    /// The touches of this state, in the order of contact cells; valid until the next call. `moved`: how far a
    /// node has moved since the last call, at most, up to rounding.
    std::span<const Touch> touches(const Record *now, float moved);

  private:
    void find_unmasked();
    bool list_is_stale(const Record *now);
    void make_list(const Record *now);
    void set_pair(unsigned pair, Place cell, Place a, Place b);
    void measure(const Record *now);
    Touch touch(const Record *now, const PairGroup &group, unsigned lane) const;

    const Layout *layout_ = nullptr;
    const Kernel *kernel_ = nullptr;
    float stiffness_ = 0, reach_ = 0; // of the law
    ContactWatch watch_;
    std::vector<Record> listed_at_; // when the groups that hold outline were here
    std::vector<float> circle_x_, circle_y_, circle_squared_radius_; // per outline link
    std::vector<Place> cells_;                                       // that may touch
    std::vector<Word> unmasked_, inside_;                            // per cell, sets of outline links

    unsigned listed_ = 0;             // pairs: cells ascending, the links of each ascending
    std::vector<PairGroup> pairs_;    // with room for all; the last group is filled up with the first pair
    std::vector<unsigned char> near_; // per group, the pairs that touch
    std::vector<Touch> touches_;
};

} // namespace planula::native
