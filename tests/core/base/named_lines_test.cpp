// SPDX-License-Identifier: MIT
#include "base/named_lines.h"

#include "base/error.h"
#include "core/storage/temporary_folder.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <limits>

using namespace planula;

namespace {

enum class Colour { red, green };
constexpr std::array<std::string_view, 2> colours{"red", "green"};

struct Sample {
    double number = 0;
    int whole = 0;
    bool is_set = false;
    std::string word = "w";
    Vec2d point;
    Colour colour = Colour::red;
    std::optional<double> maybe;
    std::vector<Vec2d> list;
    std::optional<Vec2d> item;
    bool operator==(const Sample &) const = default;
};

void pass(Sample &sample, auto &lines) {
    lines.line("number", sample.number);
    lines.line("several", sample.whole, sample.is_set, sample.word, sample.point);
    lines.line("colour", named(sample.colour, colours));
    lines.line("maybe", sample.maybe);
    lines.list("list", sample.list, [&](Vec2d &point) { lines.line("point", point); });
    lines.maybe("item", sample.item, [&](Vec2d &point) { lines.line("point", point); });
}

std::string written(Sample sample) {
    LineWriter lines;
    pass(sample, lines);
    return lines.text();
}

Sample read(std::string_view text) {
    Sample sample;
    LineReader lines(text);
    pass(sample, lines);
    lines.done();
    return sample;
}

const Sample full{0.1, -7, true, "oak", {1e300, -0.0}, Colour::green, 5e-324, {{1, 2}, {3, 4}}, Vec2d{5, 6}};
const std::string full_text = "number 0.1\nseveral -7 1 oak 1e+300 -0\ncolour green\nmaybe 5e-324\n"
                              "list 2\npoint 1 2\npoint 3 4\nitem 1\npoint 5 6\n";

/// The message about the full text with `from` replaced by `to`.
std::string refusal(const std::string &from, const std::string &to) {
    std::string text = full_text;
    const std::size_t at = text.find(from);
    BOOST_REQUIRE(at != std::string::npos);
    text.replace(at, from.size(), to);
    return message_of<InputError>([&] { read(text); });
}

} // namespace

BOOST_AUTO_TEST_CASE(named_lines_say_what_they_hold) {
    BOOST_TEST(written(full) == full_text);
    BOOST_TEST(written({}) == "number 0\nseveral 0 0 w 0 0\ncolour red\nmaybe none\nlist 0\nitem 0\n");
}

BOOST_AUTO_TEST_CASE(named_lines_read_back_to_the_bit) {
    BOOST_TEST((read(full_text) == full));
    BOOST_TEST(std::signbit(read(full_text).point.y));
    BOOST_TEST((read(written({})) == Sample()));
    Sample far = full;
    far.number = -std::numeric_limits<double>::infinity();
    BOOST_TEST((read(written(far)) == far));
}

BOOST_AUTO_TEST_CASE(named_lines_refuse_anything_else_by_its_line) {
    BOOST_TEST(refusal("number 0.1", "numbers 0.1") == "line 1: expected 'number', not 'numbers 0.1'");
    BOOST_TEST(refusal("number 0.1", "number  0.1") == "line 1: '' is not a number");
    BOOST_TEST(refusal("number 0.1", "number") == "line 1: a value is missing");
    BOOST_TEST(refusal("number 0.1", "number nan") == "line 1: 'nan' is not a number");
    BOOST_TEST(refusal("number 0.1", "number 0.1 2") == "line 1: '2' is left over");
    BOOST_TEST(refusal("-7", "1.5") == "line 2: '1.5' is not a whole number");
    BOOST_TEST(refusal("-7", "3000000000") == "line 2: '3000000000' is not a whole number");
    BOOST_TEST(refusal("1 oak", "yes oak") == "line 2: 'yes' is neither 0 nor 1");
    BOOST_TEST(refusal("green", "greem") == "line 3: 'greem' is none of red, green; did you mean 'green'?");
    BOOST_TEST(refusal("5e-324", "nothing") == "line 4: 'nothing' is not a number");
    BOOST_TEST(refusal("list 2", "list 2000000") == "line 5: 2000000 items cannot follow");
    BOOST_TEST(refusal("list 2", "list -1") == "line 5: -1 items cannot follow");
    BOOST_TEST(refusal("point 5 6\n", "") == "line 9: the text ends before 'point'");
    BOOST_TEST(refusal("point 5 6\n", "point 5 6\nmore\n") == "line 10: 'more' is left over");
}
