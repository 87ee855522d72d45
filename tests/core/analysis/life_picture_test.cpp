// SPDX-License-Identifier: MIT
#include "analysis/life_picture.h"

#include "analysis/life_scene.h"
#include "base/text.h"
#include "physics/object.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <string>
#include <utility>

using namespace planula;
using namespace planula::specimens;

namespace {

LifeRecording recorded(const Environment &environment) {
    Conditions c;
    c.parameters = turning();
    c.parameters.gait.locomotion_steps = 200;
    c.environment = environment;
    c.actuation_range = 0.3;
    return record_life(lump_genome(c.actuation, 6), c, {});
}

std::size_t count(const std::string &text, const std::string &part) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != text.npos; at += part.size()) ++found;
    return found;
}

/// Of the discs in a picture how far to the left and right they lie, pixels.
std::pair<double, double> span_of_discs(const std::string &picture) {
    double left = 1e9, right = -1e9;
    const std::string begin = "<circle cx=\"";
    for (std::size_t at = 0; (at = picture.find(begin, at)) != picture.npos;) {
        at += begin.size();
        const double x = *parse_double(picture.substr(at, picture.find('"', at) - at));
        left = std::min(left, x), right = std::max(right, x);
    }
    return {left, right};
}

} // namespace

BOOST_AUTO_TEST_CASE(a_strip_shows_every_cell_of_every_frame) {
    const LifeRecording recording = recorded(land());
    const std::string strip = life_strip(recording, "a < b");
    BOOST_TEST(count(strip, "a &lt; b") == 1u);
    for (const char *name : {"Growth", "Gait", "The whole path", "step 600", "step 200", "2 cells"})
        BOOST_TEST(count(strip, name) >= 1u, name);
    const auto cells = static_cast<std::size_t>(recording.life.cells);
    std::size_t grown = 0; // in the six frames of growth
    for (std::size_t i = 0; i < 6; ++i)
        grown += recording.growth[(recording.growth.size() - 1) * i / 5].cells.size();
    BOOST_TEST(count(strip, "<circle") == grown + 11 * cells + 1); // and the start of the path
    BOOST_TEST(life_strip(recorded(land()), "a < b") == strip);
}

BOOST_AUTO_TEST_CASE(walls_water_and_objects_are_drawn) {
    Environment world = land();
    const View view{{0, 0}, 10, 400, 300};
    const std::string ground = draw_world(&world, view);
    BOOST_TEST(count(ground, "<path") == 1u);
    world.ceiling = {{0, 12}};
    world.obstacles = {{{{5, 0}, {6, 0}, {6, 1}}, {}}};
    world.regions = {{.box = {.left = 1, .right = 3}, .drag_normal = 1}};
    const std::string all = draw_world(&world, view);
    BOOST_TEST(count(all, "<path") == 3u);
    BOOST_TEST(count(all, "<rect") == 2u);
    const Environment wet = water();
    BOOST_TEST(draw_world(&wet, view) != draw_world(nullptr, view));

    Environment push = land();
    push.object = make_object({9, 1}, 1.0);
    const LifeRecording recording = recorded(push);
    BOOST_REQUIRE(!recording.gait.empty());
    const Moment moment = moment_of(recording.gait.back(), recording);
    BOOST_TEST(moment.nodes.size() == moment.colours.size() + static_cast<std::size_t>(push.object.cells()));
    BOOST_TEST(count(draw_body(moment, 0.5, view), "<circle") == moment.nodes.size());
}

BOOST_AUTO_TEST_CASE(a_film_has_growth_and_every_tenth_step_of_locomotion) {
    const LifeRecording recording = recorded(water());
    const std::vector<FilmFrame> frames = film_frames(recording);
    BOOST_TEST(frames.size() == 61u + 21u);
    const std::string first = film_picture(recording, frames.front(), "film"),
                      last = film_picture(recording, frames.back(), "film");
    BOOST_TEST(count(first, "growth, step 0, 1 cell<") == 1u);
    BOOST_TEST(count(last, "gait, step 200, ") == 1u);
}

BOOST_AUTO_TEST_CASE(a_film_shows_a_far_object_and_the_body) {
    for (const double x : {-20.0, 9.0, 20.0}) {
        Environment push = land();
        push.object = make_object({x, 1}, 1.0);
        const LifeRecording recording = recorded(push);
        const auto [left, right] =
            span_of_discs(film_picture(recording, film_frames(recording).back(), "film"));
        BOOST_TEST(left > 0);
        BOOST_TEST(right < 800);
    }
}
