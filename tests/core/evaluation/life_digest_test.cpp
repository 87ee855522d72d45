// SPDX-License-Identifier: MIT
#include "evaluation/life_digest.h"

#include "evaluation/example_life.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

using namespace planula;

namespace {

void change(int &value) { ++value; }
void change(double &value) { value = std::nextafter(value, 1e9); }
void change(Outcome &outcome) { outcome = outcome == Outcome::viable ? Outcome::exploded : Outcome::viable; }
void change(Vec2d &point) { change(point.y); }
void change(ShapeDistribution &shape) { shape.back() = std::nextafter(shape.back(), 1e9f); }
void change(std::vector<Vec2d> &points) { points.push_back({}); }

} // namespace

BOOST_AUTO_TEST_CASE(lives_have_equal_hashes_if_and_only_if_every_field_is_equal) {
    const Life life = example_life(Outcome::viable, KnownAfter::locomotion, Parameters{});
    BOOST_TEST(life_sha256(life) == life_sha256(Life(life)));
    std::set<std::string> hashes{life_sha256(life)};
    const std::size_t fields = life_fields().size();
    for (std::size_t changed = 0; changed < fields; ++changed) {
        Life other = life;
        std::size_t at = 0;
        each_field(other, [&](auto &field) {
            if (at++ == changed) change(field);
        });
        hashes.insert(life_sha256(other));
    }
    BOOST_TEST(hashes.size() == fields + 1);
    Life negative = life, positive = life;
    negative.rest.x = -0.0, positive.rest.x = 0.0;
    BOOST_TEST(life_sha256(negative) != life_sha256(positive));
}
