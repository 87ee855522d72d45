// SPDX-License-Identifier: MIT
// Lives that need not be lived again (§2.7: a champion is copied unchanged into the next generation). Evaluation is pure,
// so what an equal genome did, this one does; and a body driven by oscillators moves as one with the same cell centres,
// periods and phases moved, whatever its genome. With networks as muscles the genome alone decides.
//
// A memo belongs to one run: all its lives have the same conditions. It remembers the generation before the present one
// and no other, in which parents lived; equals are found by comparing all that a life depends on, bit by bit. While a
// generation lives it is only read, so that what is known does not depend on threads. Holds some 10 kB an individual.
#pragma once

#include "evaluation/live.h"

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace planula {

/// How many lives of a generation were known.
struct Known {
    int lives = 0;     // whole, from an equal genome
    int movements = 0; // grown anew, but to the body and gait of another
};

class Memo {
  public:
    /// The conditions must outlive the memo.
    explicit Memo(const Conditions &conditions) : conditions_(conditions) {}

    /// Begins a generation of that many individuals; the one before is what will be remembered.
    void begin_generation(int individuals);
    /// What live() gives for these conditions. To be called once for each slot, from any thread.
    Life live(int slot, const Genome &genome);
    /// Of the present generation, all of whose individuals have lived.
    Known known() const;

  private:
    // One individual: what its life depends on, and the life.
    struct Entry {
        std::string genome; // its nodes and links
        std::string start;  // what its movement depends on; empty if that is unknown
        Life life;
        bool knew_life = false, knew_movement = false;
    };
    // Looked up, never walked.
    using Index = std::unordered_map<std::string_view, const Entry *>;
    static const Entry *find(const Index &index, std::string_view key);

    const Conditions &conditions_;
    std::vector<Entry> last_, present_;
    Index genomes_, starts_; // of last_
};

} // namespace planula
