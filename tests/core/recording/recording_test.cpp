// SPDX-License-Identifier: MIT
#include "recording/recording.h"

#include "body/body.h"
#include "evaluation/live.h"
#include "recording/recording_json.h"
#include "support/print.h"
#include "support/recordings.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace planula;
using namespace planula::test;
using namespace planula::specimens;

namespace {

Conditions conditions(Actuation actuation, const Environment &environment) {
    Conditions c;
    c.parameters = turning();
    c.parameters.gait.locomotion_steps = 400;
    c.actuation = actuation;
    c.environment = environment;
    c.actuation_range = 0.3;
    return c;
}

LifeRecording recorded(const Conditions &c, const Detail &detail = full_detail) {
    return record_life(lump_genome(c.actuation, 6), c, {.setting = "lump"}, detail);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_recording_is_of_the_life_and_ends_where_it_ends) {
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn})
        for (const Environment &environment : {water(), land()}) {
            const Conditions c = conditions(actuation, environment);
            const LifeRecording recording = recorded(c);
            BOOST_TEST((recording.life == live(lump_genome(actuation, 6), c)));
            BOOST_REQUIRE(recording.bodies.size() == 1u);
            BOOST_TEST(recording.gait.size() == 81u);
            BOOST_TEST((centre_of_mass(recording.gait.front().nodes) == recording.life.rest));
            BOOST_TEST((centre_of_mass(recording.gait.back().nodes) == recording.life.finish));
            BOOST_TEST(static_cast<int>(recording.growth.back().cells.size()) == recording.life.cells);
            BOOST_TEST(static_cast<int>(recording.growth.back().links.size()) == recording.life.springs);
            BOOST_TEST(recording.growth.back().ids == recording.bodies[0].ids,
                       boost::test_tools::per_element());
            BOOST_TEST(recording.growth.front().cells.size() == 1u);
            BOOST_TEST(recording.growth_networks.size() == (actuation == Actuation::grn ? 20u : 21u));
            BOOST_TEST(recording.gait_networks.size() == (actuation == Actuation::grn ? 8u : 0u));
        }
}

BOOST_AUTO_TEST_CASE(signals_are_those_of_the_networks_that_are_recorded_beside_them) {
    // At step t = 50 u the muscles have reached the spring output before the newest (Eq. 2).
    const Conditions c = conditions(Actuation::grn, water());
    const LifeRecording recording = recorded(c);
    const std::size_t nodes = recording.genome.nodes.size();
    bool moves = false;
    for (std::size_t update = 1; update < recording.gait_networks.size(); ++update) {
        const GaitFrame &frame = recording.gait[update * 10];
        BOOST_REQUIRE(frame.step == recording.gait_networks[update].step);
        for (std::size_t cell = 0; cell < frame.signals.size(); ++cell) {
            const double output =
                recording.gait_networks[update - 1].activations[cell * nodes + input::count + output::spring];
            BOOST_REQUIRE(frame.signals[cell] == output);
            moves = moves || frame.signals[cell] != recording.gait.front().signals[cell];
        }
    }
    BOOST_TEST(moves);
}

BOOST_AUTO_TEST_CASE(a_compressed_body_has_positive_pressure) {
    // In water a body at rest is in equilibrium; on land its weight compresses it.
    const auto mean = [](const Environment &environment) {
        const GaitFrame frame = recorded(conditions(Actuation::oscillator, environment)).gait.front();
        double sum = 0;
        for (const double each : frame.compressions) sum += each;
        return sum / static_cast<double>(frame.compressions.size());
    };
    BOOST_TEST(std::abs(mean(water())) < 1e-6); // single precision
    BOOST_TEST(mean(land()) > 1e-4);
}

BOOST_AUTO_TEST_CASE(recordings_follow_lost_cells_and_further_worlds) {
    Conditions c = conditions(Actuation::grn, water());
    c.damage = Damage{.at = 200, .share = 0.3, .side = Side::left};
    c.phases = {{.at = 300, .environment = land(), .actuation_range = 0.3, .settles = false}};
    const LifeRecording recording = recorded(c);
    BOOST_REQUIRE(recording.bodies.size() == 2u);
    BOOST_REQUIRE(recording.worlds.size() == 2u);
    BOOST_TEST(recording.worlds[1].first_step == 300);
    const std::size_t loss = recording.bodies[1].first_frame;
    BOOST_TEST(recording.gait[loss].step == 205);
    BOOST_TEST(recording.gait[loss - 1].nodes.size() == recording.bodies[0].ids.size());
    BOOST_TEST(recording.gait[loss].nodes.size() == recording.bodies[1].ids.size());
    BOOST_TEST(recording.bodies[1].ids.size() < recording.bodies[0].ids.size());
    BOOST_TEST(recording.gait_networks.back().ids == recording.bodies[1].ids,
               boost::test_tools::per_element());
    BOOST_TEST(!recording_json(recording).empty());
    c.damage->at = 0; // before it moves
    BOOST_TEST(recorded(c).bodies.size() == 1u);
}

BOOST_AUTO_TEST_CASE(refined_steps_are_counted_as_those_of_the_parameters) {
    Conditions c = conditions(Actuation::grn, water());
    c.refinement = 2;
    const LifeRecording recording = recorded(c);
    BOOST_REQUIRE(recording.gait.size() == 81u);
    BOOST_TEST(recording.gait.back().step == 400);
    BOOST_TEST(recording.gait_networks.size() == 8u);
    BOOST_TEST((centre_of_mass(recording.gait.back().nodes) == recording.life.finish));
}

BOOST_AUTO_TEST_CASE(a_life_that_ends_early_is_recorded_as_far_as_it_went) {
    Conditions c = conditions(Actuation::oscillator, water());
    Genome dying = bare_genome(Actuation::oscillator);
    wire(dying, input::bias, output::apoptosis, 1);
    const LifeRecording dead = record_life(dying, c, {});
    BOOST_TEST((dead.life.outcome == Outcome::died_out));
    BOOST_TEST((dead.gait.empty() && dead.bodies.empty()));
    BOOST_TEST(member(recording_json(dead), "outcome") == "died_out");
}
