// SPDX-License-Identifier: MIT
// What R says of given samples: the lines of reference.inc, which reference.R writes.
#pragma once

#include <boost/test/unit_test.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace planula {

struct Reference {
    std::string function, kind;
    std::vector<double> a, b, expected;
};

/// The lines of one function, of which there is at least one.
inline std::vector<Reference> references_of(std::string_view function) {
    static const std::vector<Reference> all{
#include "reference.inc"
    };
    std::vector<Reference> found;
    for (const Reference &reference : all)
        if (reference.function == function) found.push_back(reference);
    BOOST_REQUIRE(!found.empty());
    return found;
}

} // namespace planula
