// SPDX-License-Identifier: MIT
#include "development/grow.h"

#include "base/lane_sets.h"
#include "body/connect.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using namespace planula;
using namespace planula::specimens;

namespace {

Growth grown(const Genome &genome, Actuation actuation = Actuation::oscillator,
             const GrowthWatch &watch = {}) {
    return grow(express(genome, 16), actuation, Parameters{}, watch);
}

/// Those of all cells, one after another.
std::vector<double> activations_of(const Growth &growth) {
    std::vector<double> result;
    const Activations &activations = growth.tissue.activations;
    for (int cell = 0; cell < activations.cells(); ++cell)
        for (int node = 0; node < activations.nodes(); ++node) result.push_back(activations.at(cell, node));
    return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(cells_that_divide_eastwards_grow_a_line_by_one_cell_a_decision) {
    // Only the eastern end has room for a daughter.
    const Growth growth = grown(line_genome(Actuation::oscillator, 12));
    BOOST_TEST(growth.outcome == Outcome::viable);
    BOOST_TEST(growth.cells == 13);
    BOOST_TEST(elongation(growth.body.positions) > 20);
    for (const Vec2d p : growth.body.positions) BOOST_TEST(std::abs(p.y) < 0.5);
}

BOOST_AUTO_TEST_CASE(links_that_follow_moving_cells_are_those_of_a_new_triangulation) {
    // At every refresh of whole developments: discs, legs, lumps, and what random genomes do.
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn}) {
        std::vector<Genome> genomes{disc_genome(actuation), two_legged_genome(actuation),
                                    lump_genome(actuation, 12), line_genome(actuation, 12)};
        for (std::uint64_t seed = 1; seed <= 12; ++seed) genomes.push_back(random_genome(actuation, seed));
        for (const Genome &genome : genomes)
            grown(genome, actuation, [](int step, const Embryo &embryo) {
                if (step % 10 != 0) return;
                BOOST_REQUIRE((embryo.links == connect(positions(embryo), 1.5).links));
            });
    }
}

BOOST_AUTO_TEST_CASE(without_inhibition_every_cell_divides_at_every_decision) {
    // A network without links: inhibitor 0, so all divide; the first decision is at step 0.
    std::vector<std::size_t> sizes(600);
    const Growth growth =
        grown(bare_genome(Actuation::oscillator), Actuation::oscillator, [&](int step, const Embryo &embryo) {
            if (step < 600) sizes[step] = embryo.cells.size();
        });
    BOOST_TEST(sizes[0] == 2u);
    BOOST_TEST(sizes[29] == 2u);
    BOOST_TEST(sizes[30] > 2u);
    for (int step = 1; step < 600; ++step)
        if (step % 30 != 0) BOOST_TEST(sizes[step] == sizes[step - 1]);
    BOOST_TEST(growth.births == growth.cells);
}

BOOST_AUTO_TEST_CASE(an_inhibited_zygote_does_not_divide_and_is_too_small) {
    Genome genome = bare_genome(Actuation::oscillator);
    wire(genome, input::bias, output::division_inhibitor, 1);
    const Growth growth = grown(genome);
    BOOST_TEST(growth.outcome == Outcome::too_small);
    BOOST_TEST(growth.cells == 1);
    BOOST_TEST((growth.body.positions[0] == Vec2d{}));
}

BOOST_AUTO_TEST_CASE(apoptosis_above_zero_removes_a_cell_at_once) {
    Genome genome = bare_genome(Actuation::oscillator);
    wire(genome, input::bias, output::apoptosis, 0.01);
    const Growth growth = grown(genome);
    BOOST_TEST(growth.outcome == Outcome::died_out);
    BOOST_TEST(growth.cells == 0);
    BOOST_TEST(growth.births == 1); // a dying cell does not divide
}

BOOST_AUTO_TEST_CASE(reaching_the_cell_limit_once_stops_development) {
    Parameters p;
    p.development.cell_limit = 64;
    const Network network = express(lump_genome(Actuation::oscillator, 20), 16);
    const Growth growth = grow(network, Actuation::oscillator, p);
    BOOST_TEST(growth.outcome == Outcome::overgrown);
    BOOST_TEST(growth.largest == 64);
    BOOST_TEST(growth.body.positions.empty());
}

BOOST_AUTO_TEST_CASE(at_the_birth_limit_division_ends) {
    Parameters p;
    p.development.birth_limit = 20;
    const Network network = express(lump_genome(Actuation::oscillator, 20), 16);
    const Growth growth = grow(network, Actuation::oscillator, p);
    BOOST_TEST(growth.births == 20);
    BOOST_TEST(growth.cells == 20);
    BOOST_TEST(growth.outcome == Outcome::viable);
}

BOOST_AUTO_TEST_CASE(a_number_that_is_not_finite_explodes_the_embryo) {
    for (const double weight : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        Genome genome = lump_genome(Actuation::oscillator, 5);
        wire(genome, input::morphogen, output::period, weight); // inf · 0 at the first decision
        BOOST_TEST(grown(genome).outcome == Outcome::exploded);
    }
}

BOOST_AUTO_TEST_CASE(bodies_are_connected_and_relaxed_with_links_within_the_limit_or_bridges) {
    const Growth growth = grown(lump_genome(Actuation::oscillator, 6));
    BOOST_TEST(growth.outcome == Outcome::viable);
    const int n = growth.cells;
    BOOST_TEST(static_cast<int>(growth.body.mesh.links.size()) >= n - 1);
    std::set<int> reached{0};
    for (std::size_t before = 0; before != reached.size();) {
        before = reached.size();
        for (const auto &[a, b] : growth.body.mesh.links)
            if (reached.contains(a) || reached.contains(b)) reached.insert(a), reached.insert(b);
    }
    BOOST_TEST(static_cast<int>(reached.size()) == n);
    for (const double area : growth.body.areas) BOOST_TEST(area > 0);
}

BOOST_AUTO_TEST_CASE(the_neighbourhood_is_new_every_ten_steps_and_after_each_decision) {
    std::vector<std::vector<Link>> links;
    std::vector<std::size_t> cells;
    grown(lump_genome(Actuation::oscillator, 6), Actuation::oscillator, [&](int, const Embryo &embryo) {
        links.push_back(embryo.links);
        cells.push_back(embryo.cells.size());
    });
    for (std::size_t step = 1; step < 600; ++step) {
        if (step % 10 != 0) BOOST_TEST((links[step] == links[step - 1]));
        for (const Link link : links[step]) BOOST_REQUIRE(static_cast<std::size_t>(link.b) < cells[step]);
    }
}

BOOST_AUTO_TEST_CASE(oscillators_are_read_out_at_time_one_over_the_final_body) {
    // The period output reads only the time input: tanh(1) at the read-out, for every cell.
    Genome genome = line_genome(Actuation::oscillator, 9);
    wire(genome, input::time, output::period, 1);
    const Growth growth = grown(genome);
    for (int cell = 0; cell < growth.cells; ++cell)
        BOOST_TEST(growth.tissue.activations.at(cell, input::count + output::period) == std::tanh(1.0),
                   boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(the_grn_is_not_read_out_again) {
    // Its last update was at step 570.
    Genome genome = line_genome(Actuation::grn, 9);
    wire(genome, input::time, output::spring, 1);
    const Growth growth = grown(genome, Actuation::grn);
    BOOST_TEST(growth.tissue.activations.at(0, input::count + output::spring) == std::tanh(570.0 / 600),
               boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(growth_is_pure) {
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn}) {
        const Genome genome = random_genome(actuation, 3);
        const Growth first = grown(genome, actuation);
        grown(random_genome(actuation, 4), actuation);
        const Growth second = grown(genome, actuation);
        BOOST_TEST((first.body.positions == second.body.positions));
        BOOST_TEST(activations_of(first) == activations_of(second));
    }
}

BOOST_AUTO_TEST_CASE(every_width_of_lanes_grows_the_same_bits) {
    const std::string_view widest = name_of(chosen_lanes());
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn})
        for (const Genome &genome : {disc_genome(actuation), random_genome(actuation, 3)}) {
            choose_lanes("scalar");
            const Growth scalar = grown(genome, actuation);
            for (const LaneSet lanes : lane_sets()) {
                choose_lanes(name_of(lanes));
                const Growth wide = grown(genome, actuation);
                BOOST_TEST((wide.body.positions == scalar.body.positions), name_of(lanes));
                BOOST_TEST((activations_of(wide) == activations_of(scalar)), name_of(lanes));
            }
        }
    choose_lanes(widest);
}
