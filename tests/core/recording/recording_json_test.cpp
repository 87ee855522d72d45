// SPDX-License-Identifier: MIT
#include "recording/recording_json.h"

#include "base/json.h"
#include "base/text.h"
#include "evaluation/conditions_text.h"
#include "evaluation/life_digest.h"
#include "evaluation/live.h"
#include "genome/genome_text.h"
#include "support/recordings.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace planula;
using namespace planula::test;
using namespace planula::specimens;

namespace {

LifeRecording recorded(const Detail &detail = full_detail, const Environment &environment = water()) {
    Conditions c;
    c.parameters = turning();
    c.parameters.gait.locomotion_steps = 400;
    c.actuation = Actuation::grn;
    c.environment = environment;
    c.actuation_range = 0.3;
    return record_life(lump_genome(c.actuation, 6), c, {.title = "A \"lump\"", .setting = "lump", .seed = 7},
                       detail);
}

/// The series that a packed text of equally long series holds.
std::vector<std::vector<std::int64_t>> series(const std::string &text, std::size_t length, int order) {
    const std::vector<std::int64_t> numbers = unpack_numbers(text);
    BOOST_REQUIRE(numbers.size() % length == 0u);
    std::vector<std::vector<std::int64_t>> all;
    for (auto at = numbers.begin(); at != numbers.end(); at += static_cast<std::ptrdiff_t>(length))
        all.push_back(summed({at, at + static_cast<std::ptrdiff_t>(length)}, order));
    return all;
}

} // namespace

BOOST_AUTO_TEST_CASE(packed_positions_are_those_of_the_frames_within_half_a_unit) {
    const LifeRecording recording = recorded();
    const std::string json = recording_json(recording), gait = json.substr(json.find("\"gait\":{"));
    const auto places = series(member(gait, "positions"), recording.gait.size(), 2);
    BOOST_REQUIRE(places.size() == 2 * recording.gait.front().nodes.size());
    for (std::size_t frame = 0; frame < recording.gait.size(); ++frame)
        for (std::size_t node = 0; 2 * node < places.size(); ++node) {
            const Vec2d there = recording.gait[frame].nodes[node];
            BOOST_REQUIRE(std::abs(there.x * 256 - static_cast<double>(places[2 * node][frame])) <= 0.5);
            BOOST_REQUIRE(std::abs(there.y * 256 - static_cast<double>(places[2 * node + 1][frame])) <= 0.5);
        }
}

BOOST_AUTO_TEST_CASE(signals_and_activations_are_packed_at_knots_and_updates) {
    const LifeRecording recording = recorded();
    const std::string json = recording_json(recording), network = json.substr(json.find("\"network\":"));
    const auto signals = series(member(json, "signals"), 41, 2);
    BOOST_REQUIRE(signals.size() == recording.gait.front().signals.size());
    for (std::size_t cell = 0; cell < signals.size(); ++cell)
        BOOST_TEST(
            std::abs(recording.gait[20].signals[cell] * 100 - static_cast<double>(signals[cell][10])) <= 0.5);
    const auto values = series(member(network.substr(network.find("\"gait\":")), "values"), 8, 1);
    const std::vector<double> &last = recording.gait_networks.back().activations;
    BOOST_REQUIRE(values.size() == last.size());
    for (std::size_t i = 0; i < last.size(); ++i)
        BOOST_REQUIRE(std::abs(last[i] * 100 - static_cast<double>(values[i].back())) <= 0.5);
}

BOOST_AUTO_TEST_CASE(the_text_names_life_and_individual) {
    const LifeRecording recording = recorded();
    const std::string json = recording_json(recording);
    BOOST_TEST(json.starts_with("{\"format\":\"planula recording 1\",\"title\":\"A \\\"lump\\\"\","),
               json.substr(0, 80));
    BOOST_TEST(member(json, "seed") == "7");
    BOOST_TEST(member(json, "slot") == "null");
    BOOST_TEST(member(json, "life") == life_sha256(recording.life));
    BOOST_TEST(member(json, "cells") == to_text(recording.life.cells));
    BOOST_TEST(member(json, "ground") == "null");
    BOOST_TEST(member(recording_json(recorded(full_detail, land())), "ground") == "[]");
    BOOST_TEST(recording_json(recorded()) == json); // the same life, the same text
}

BOOST_AUTO_TEST_CASE(the_source_gives_the_same_life) {
    const LifeRecording recording = recorded();
    const Genome genome = read_genome(write_genome(recording.genome));
    BOOST_TEST((live(genome, read_conditions(recording.conditions)) == recording.life));
    const std::string json = recording_json(recording);
    BOOST_TEST(json.ends_with(",\"source\":{\"genome\":" + json_text(write_genome(genome)) +
                              ",\"conditions\":" + json_text(recording.conditions) + "}}"));
}

BOOST_AUTO_TEST_CASE(less_detail_records_the_same_life_in_less_text) {
    const std::string full = recording_json(recorded()), gallery = recording_json(recorded(gallery_detail));
    BOOST_TEST(gallery.size() * 2 < full.size());
    BOOST_TEST(member(gallery, "life") == member(full, "life"));
    BOOST_TEST(member(gallery, "signals").empty());
}
