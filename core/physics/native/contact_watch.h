// SPDX-License-Identifier: MIT
// When pairs of a contact cell and an outline link must be measured, and when their list must be made again, judged by
// how far nodes can have moved against each other. However it judges, the forces are the same.
#pragma once

#include "base/portable.h"

namespace planula::native {

struct ContactWatch {
    // How much farther than the law reaches pairs are listed, and what is far above that which rounding does to
    // distances, and to motion in a step.
    static constexpr float skin = 0.8f, margin = 1e-3f;

    float clearance = 0; // how far nodes may move against each other until the first pair could touch,
    float moved = 0;     // and how far they have at most since the list was made

    /// After a step in which a node moved by up to `step_moved`, up to rounding: whether no pair can touch yet.
    PORTABLE bool sees_none(float step_moved) {
        const float against = 2 * step_moved + margin;
        clearance -= against, moved += against;
        return clearance > 0;
    }
    /// Whether the list, if there is one, still has all pairs that may touch.
    PORTABLE bool keeps_list() const { return moved < skin; }
    /// The distance within which pairs are listed.
    PORTABLE float listed_within(float reach) const { return reach + skin + margin; }
    /// The least distance of a listed pair. Pairs that are not listed were farther apart than reach and skin.
    PORTABLE void measured(float least, float reach) {
        const float listed = least - reach, others = skin - moved;
        clearance = (others < listed ? others : listed) - margin;
    }
};

} // namespace planula::native
