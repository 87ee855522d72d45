// SPDX-License-Identifier: MIT
#include "genome/align.h"

#include "core/genome/specimens.h"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace planula;
using specimens::linked;

namespace {

/// One letter a link: m matching, d and D disjoint in a and in b, e and E excess in a and in b.
std::string pattern(const Genome &a, const Genome &b) {
    std::string text;
    align(
        a, b, [&](const LinkGene &x, const LinkGene &y) { text += x.innovation == y.innovation ? 'm' : '?'; },
        [&](const LinkGene &, Side side, bool excess) {
            text += side == Side::first ? (excess ? 'e' : 'd') : (excess ? 'E' : 'D');
        });
    return text;
}

} // namespace

BOOST_AUTO_TEST_CASE(links_are_matching_disjoint_or_excess) {
    const Genome a = linked({{1, 0}, {2, 0}, {4, 0}}), b = linked({{1, 0}, {3, 0}, {4, 0}, {7, 0}, {8, 0}});
    BOOST_TEST(pattern(a, b) == "mdDmEE");
    BOOST_TEST(pattern(b, a) == "mDdmee");
    BOOST_TEST(pattern(a, linked({})) == "eee");
    BOOST_TEST(pattern(linked({{0, 0}, {9, 0}}), linked({{5, 0}})) == "dDe");
}
