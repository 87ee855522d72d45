// SPDX-License-Identifier: MIT
// Who a run is: everything that decides its genomes and lives, and nothing else. Two runs of one identity have equal
// results, however long each of them is and whatever else their scripts say: comments, titles, file names, other
// settings, claims, statistics, `seeds`, `generations` and the version of planula are no part of it.
//
// The model itself is a part by its revision (experiment/revision.h), the judging functions by their meaning
// (FunctionMeaning), and every parameter by its value (decides_lives()).
#pragma once

#include "experiment/spec.h"

#include <cstdint>
#include <string>
#include <vector>

namespace planula {

/// One thing that decides a run. `key`: model, seed, actuation, search, engine, start, environment …, function …,
/// parameter …; numbers are the shortest texts that read back to the same bits.
struct IdentityItem {
    std::string key, value;
    std::string place; // of a function: file:line; no part of the identity
    // What counts where an item is not there: of a parameter its standard value when the run began, of a part of the
    // environment that came later what environments without it have. Empty if every run has the item.
    std::string standard;
};

struct Identity {
    std::vector<IdentityItem> items;

    /// The value of a key, or null.
    const std::string *find(std::string_view key) const;
    /// The item of a key; where there is none, one with the standard value, or with "nothing" if that is empty.
    IdentityItem item(const std::string &key, const std::string &standard) const;
    /// A hash that is equal for runs of one identity. Items with their standard value do not enter, so that one which a
    /// later version adds changes no hash.
    std::string sha256() const;
};

Identity identity_of(const Spec &spec, std::uint64_t seed);

/// What differs between the identity of a recorded run and one that is asked for, a line each; empty if the runs are
/// one. An item that only one of them has counts in the other with its standard value.
std::vector<std::string> differences(const Identity &recorded, const Identity &asked);

} // namespace planula
