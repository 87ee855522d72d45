// SPDX-License-Identifier: MIT
// Individuals that need not be simulated again (§2.7: a champion is copied unchanged into the next generation). live()
// is pure, so equal genomes have equal lives; and bodies driven by oscillators move equally if their cell centres,
// periods and phases are equal, whatever their genomes. With networks as muscles the genome alone decides.
//
// A memo belongs to one run: all its lives have the same conditions. It remembers one generation, that of the parents.
// Equal individuals are found by comparing all that a life depends on, bit by bit. While a generation is simulated the
// memo is only read, so that what is known does not depend on threads. It holds some 10 kB for each individual.
#pragma once

#include "evaluation/live.h"

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace planula {

/// How many individuals of a generation were known.
struct Known {
    int lives = 0;     // by an equal genome
    int movements = 0; // by an equal body and gait, after they had grown
};

class Memo {
  public:
    /// The conditions must outlive the memo.
    explicit Memo(const Conditions &conditions) : conditions_(conditions) {}

    /// Begins a generation of that many individuals; the one before is what will be remembered.
    void begin_generation(int individuals);
    /// What live() gives for these conditions. To be called once for each slot, from any thread.
    Life live(int slot, const Genome &genome);
    /// Of the present generation, all of whose individuals have been simulated.
    Known known() const;

  private:
    // An individual: what its life depends on, and the life.
    struct Entry {
        std::string genome; // its nodes and links
        std::string start;  // what its movement depends on; empty if that is unknown
        Life life;
        bool knew_life = false, knew_movement = false;
    };
    // Only looked up: its order is not defined.
    using Index = std::unordered_map<std::string_view, const Entry *>;
    static const Entry *find(const Index &index, std::string_view key);

    const Conditions &conditions_;
    std::vector<Entry> last_, present_;
    Index genomes_, starts_; // of last_
};

} // namespace planula
