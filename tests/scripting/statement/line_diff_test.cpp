// SPDX-License-Identifier: MIT
#include "statement/line_diff.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace planula;

namespace {

using Lines = std::vector<std::string>;

void check_diff(const Lines &before, const Lines &after, const Lines &expected) {
    const Lines lines = line_diff(before, after);
    BOOST_TEST(lines == expected, boost::test_tools::per_element());
}

} // namespace

BOOST_AUTO_TEST_CASE(common_lines_stay_and_others_are_marked) {
    check_diff({}, {}, {});
    check_diff({"a", "b"}, {"a", "b"}, {"  a", "  b"});
    check_diff({"a"}, {}, {"- a"});
    check_diff({}, {"a"}, {"+ a"});
    check_diff({"a", "b", "c"}, {"a", "x", "c"}, {"  a", "- b", "+ x", "  c"});
    check_diff({"f", "1", "2", "end"}, {"f", "3", "4", "5", "end"},
               {"  f", "- 1", "- 2", "+ 3", "+ 4", "+ 5", "  end"});
}

BOOST_AUTO_TEST_CASE(as_many_lines_as_possible_are_common) {
    const Lines before{"a", "b", "c", "a", "b", "b", "a"}, after{"c", "b", "a", "b", "a", "c"};
    const Lines lines = line_diff(before, after);
    const auto count = [&](char mark) {
        return std::count_if(lines.begin(), lines.end(),
                             [&](const std::string &line) { return line[0] == mark; });
    };
    BOOST_TEST(count(' ') == 4); // the longest common subsequence of Myers (1986), figure 1
    BOOST_TEST(count('-') == 3);
    BOOST_TEST(count('+') == 2);
    // Either side can be read off the lines.
    Lines first, second;
    for (const std::string &line : lines) {
        if (line[0] != '+') first.push_back(line.substr(2));
        if (line[0] != '-') second.push_back(line.substr(2));
    }
    BOOST_TEST(first == before, boost::test_tools::per_element());
    BOOST_TEST(second == after, boost::test_tools::per_element());
}
