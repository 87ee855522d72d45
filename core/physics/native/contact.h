// SPDX-License-Identifier: MIT
// Self-collision in the native engine: measures several pairs of cell and link at once and leaves the law to
// touch_of. Pairs that may meet soon are kept in a list (Verlet) that is made again when nodes have moved against
// each other by more than its skin; and while they have moved too little for any listed pair to come into reach,
// nothing is looked at. The touches are those of a search over all pairs, to the bit.
#pragma once

#include "physics/native/kernel.h"
#include "physics/self_contact.h"

#include <span>
#include <vector>

namespace planula::native {

class Contact {
  public:
    /// Forgets the list. Layout and kernel must outlive the use of this.
    void load(const Layout &layout, const Kernel &kernel);
    /// The touches of this state, in the order of contact cells; valid until the next call.
    std::span<const Touch<float>> touches(const Record *now);

  private:
    void find_unmasked();
    void make_list(const Record *now);
    void group_pairs();
    float motion(const std::vector<Record> &then, const Record *now) const;

    const Layout *layout_ = nullptr;
    const Kernel *kernel_ = nullptr;
    float reach_ = 0;                   // of the law
    int first_node_ = 0, end_node_ = 0; // the groups that hold the outline
    std::vector<Record> listed_at_;     // all nodes when the list was made
    std::vector<Record> searched_at_;   // and when its pairs were last measured,
    float clearance_ = 0;               // with so much lacking until the first could touch
    std::vector<float> circle_x_, circle_y_, circle_squared_radius_; // per outline link
    std::vector<unsigned char> inside_;
    std::vector<unsigned char> unmasked_; // groups of outline links × contact cells, a row per cell

    std::vector<int> cells_, links_;  // of each listed pair: nodes ascending, the links of each ascending
    std::vector<PairGroup> pairs_;    // the same; the last group is filled up with the first pair
    std::vector<unsigned char> near_; // per group, the pairs that touch
    std::vector<Touch<float>> touches_;
};

} // namespace planula::native
