// SPDX-License-Identifier: MIT
// Still ground gives no energy, whatever its form (decision 0010).
#include "physics/engine.h"

#include "physics/embody.h"
#include "support/motion.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <string>

using namespace planula;
using namespace planula::specimens;

namespace {

/// Kinetic energy and height times gravity, which is 5, per node: on still ground without friction, muscles at rest, it
/// never rises above its start.
double energy_of_fall(const Engine &engine) {
    const auto x = engine.positions();
    return (kinetic_energy(engine.velocities()) / static_cast<double>(x.size())) + 5 * centre_of_mass(x).y;
}

/// What a body did that slid on a ground without friction.
struct Slide {
    double start = 0, most = 0; // energy_of_fall()
    bool exploded = false;
    Vec2d end; // its centre of mass
};

Slide slid(std::string_view name, std::vector<Vec2d> ground, double duration, double time_step) {
    const Environment environment{.gravity = 5, .has_ground = true, .ground = std::move(ground)};
    Parameters parameters;
    parameters.development.time_step = time_step;
    const auto model = soft_body(lattice(4, 3), environment, parameters);
    const auto engine = loaded(name, model, environment);
    Slide slide;
    slide.start = slide.most = energy_of_fall(*engine);
    for (int t = 0; t < std::lround(duration / time_step); ++t) {
        slide.exploded |= engine->step(0).exploded;
        slide.most = std::max(slide.most, energy_of_fall(*engine));
    }
    slide.end = centre_of_mass(engine->positions());
    return slide;
}

/// Bullet's ground is made of slabs, which narrow walls have no counterpart in.
constexpr std::string_view engines[] = {"native", "reference"};

} // namespace

BOOST_AUTO_TEST_CASE(still_ground_gives_no_energy_however_narrow_its_walls) {
    // Down a slope against a wall, and over its edge into a pit, at up to 12 cells/t.u.
    for (const std::string_view name : engines)
        for (const double time_step : {0.01, 0.002, 1e-3})
            for (const double width : {1.0, 0.3, 0.1, 0.05, 0.01, 1e-3, 1e-5, 1e-7})
                for (const double height : {0.8, 1.2, 5.0, -0.8, -5.0}) {
                    if (name == "reference" && time_step < 0.01 && width != 1.0 && width != 1e-3) continue;
                    const Slide slide =
                        slid(name, {{-20, 10}, {10, -5}, {10 + width, height - 5}, {60, height - 5}},
                             time_step < 0.002 ? 10 : 20, time_step);
                    const auto what = [&](double value) {
                        return std::string(name) + ", wall " + std::to_string(width) + " wide, " +
                               std::to_string(height) + " high, dt " + std::to_string(time_step) + ": " +
                               std::to_string(value);
                    };
                    BOOST_TEST(!slide.exploded, what(0));
                    BOOST_TEST(slide.most < slide.start + 1e-3, what(slide.most - slide.start));
                    BOOST_TEST(slide.end.y > std::min(-5.0, height - 5), what(slide.end.y));
                }
}

BOOST_AUTO_TEST_CASE(stairs_pits_and_fences_give_no_energy_either) {
    const std::vector<Vec2d> stairs{{-20, 10}, {-10, 5}, {-10 + 1e-4, 3}, {0, 3},  {1e-4, 1},  {8, 1},
                                    {8.1, 2},  {12, 2},  {12 + 1e-6, 0},  {20, 0}, {20.01, 9}, {40, 9}};
    const std::vector<Vec2d> pit{{-9 - 1e-3, 0.8}, {-9, 0}, {9, 0}, {9 + 1e-3, 0.8}};
    const std::vector<Vec2d> fence{{-20, 10}, {0, 0}, {5, 0}, {5 + 1e-9, 1}, {5 + 2e-9, 0}, {30, 0}};
    const std::vector<Vec2d> spikes{{-20, 10}, {0, 0}, {0.3, 1}, {0.6, 0}, {0.9, 1}, {1.2, 0}, {20, -5}};
    for (const std::string_view name : engines)
        for (const auto &ground : {stairs, pit, fence, spikes})
            for (const double time_step : {0.015, 0.01, 0.002}) {
                const Slide slide = slid(name, ground, 20, time_step);
                BOOST_TEST(!slide.exploded, name);
                BOOST_TEST(slide.most < slide.start + 1e-3, name << ": " << slide.most - slide.start);
            }
}
