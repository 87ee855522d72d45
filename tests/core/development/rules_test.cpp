// SPDX-License-Identifier: MIT
// The rules of development on whole embryos (decisions 0001 to 0005): degenerate shapes, limits, what is read
// when, and equal bits.
#include "development/grow.h"

#include "base/hash.h"
#include "base/math.h"
#include "body/connect.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

using namespace planula;
using namespace planula::specimens;

namespace {

const auto near = boost::test_tools::tolerance(1e-12);

Growth grown(const Genome &genome, Actuation actuation, const GrowthWatch &watch = {},
             const Parameters &parameters = turning()) {
    return grow(express(genome, parameters.network.propagation_limit), actuation, parameters, watch);
}

/// Cells and links before the physics of one step, as a watch sees them.
struct Snapshot {
    std::vector<Vec2d> cells;
    std::vector<Link> links;
};

/// Those at one step.
Snapshot seen(const Genome &genome, Actuation actuation, int wanted) {
    Snapshot snapshot;
    grown(genome, actuation, [&](int step, const Embryo &embryo) {
        if (step == wanted) snapshot = {positions(embryo), embryo.links};
    });
    return snapshot;
}

/// A network output of one cell at the end of development.
double output_of(const Growth &growth, int cell, int channel) {
    return growth.tissue.activations.at(cell, input::count + channel);
}

/// tanh of the X input that a cell at this place has.
double east(Vec2d place) { return math::tanh(place.x / Parameters{}.network.position_scale); }

/// The mean of values over a cell's neighbours.
double mean(std::span<const int> neighbours, const std::vector<double> &values) {
    double sum = 0;
    for (const int other : neighbours) sum += values[other];
    return sum / static_cast<double>(neighbours.size());
}

/// A random genome whose cells stop dividing after step 510 and whose morphogen is tanh of their X; the output `reader`
/// is tanh of the neighbours' mean morphogen.
Genome morphogen_genome(Actuation actuation, std::uint64_t seed, output::Channel reader) {
    Genome genome = random_genome(actuation, seed);
    std::erase_if(genome.links, [&](const LinkGene &link) {
        const int channel = link.to - genome.inputs;
        return link.from == input::morphogen || channel == output::morphogen || channel == reader ||
               channel == output::division_inhibitor;
    });
    wire(genome, input::time, output::division_inhibitor, 8);
    wire(genome, input::bias, output::division_inhibitor, -7);
    wire(genome, input::x, output::morphogen, 1);
    wire(genome, input::morphogen, reader, 1);
    return genome;
}

bool is_connected(const Snapshot &snapshot) {
    std::vector<char> reached(snapshot.cells.size());
    reached[0] = 1;
    for (std::size_t round = 0; round < snapshot.cells.size(); ++round)
        for (const auto &[a, b] : snapshot.links)
            if (reached[a] || reached[b]) reached[a] = reached[b] = 1;
    return std::all_of(reached.begin(), reached.end(), [](char r) { return r; });
}

double longest(const Snapshot &snapshot) {
    double most = 0;
    for (const auto &[a, b] : snapshot.links)
        most = std::max(most, length(snapshot.cells[b] - snapshot.cells[a]));
    return most;
}

} // namespace

BOOST_AUTO_TEST_CASE(two_cells_share_one_link) {
    const Growth growth = grown(line_genome(Actuation::oscillator, 1), Actuation::oscillator);
    BOOST_TEST(growth.outcome == Outcome::too_small);
    BOOST_TEST(growth.cells == 2);
    BOOST_TEST((growth.body.mesh.links == std::vector<Link>{{0, 1}}));
    BOOST_TEST(growth.body.rest_lengths[0] == 1, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(exactly_collinear_cells_are_a_chain) {
    Parameters p;
    p.development.division_jitter = 0;
    const Growth growth = grown(line_genome(Actuation::oscillator, 9), Actuation::oscillator, {}, p);
    BOOST_TEST(growth.outcome == Outcome::viable);
    BOOST_TEST(growth.cells == 10);
    for (const Vec2d place : growth.body.positions) BOOST_TEST(place.y == 0);
    BOOST_TEST(growth.body.mesh.links.size() == 9u);
    for (const auto &[a, b] : growth.body.mesh.links) BOOST_TEST(b == a + 1);
    BOOST_TEST(growth.body.mesh.triangles.empty());
}

BOOST_AUTO_TEST_CASE(cocircular_cells_have_the_same_links_in_any_order_and_place) {
    // Four corners of a square: one diagonal, by symbolic perturbation always the same.
    const std::vector<Vec2d> square{{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    std::vector<int> order{0, 1, 2, 3};
    do
        for (const Vec2d shift : {Vec2d{0, 0}, Vec2d{-3, 0.25}, Vec2d{100, -7}}) {
            std::vector<Vec2d> places;
            for (const int i : order) places.push_back(square[i] + shift);
            const Mesh mesh = connect(places, 1.5);
            BOOST_TEST(mesh.links.size() == 5u);
            BOOST_TEST(mesh.triangles.size() == 2u);
            const auto diagonal = [&](const Link &link) {
                return order[link.a] + order[link.b] == 3 && std::min(order[link.a], order[link.b]) == 1;
            };
            BOOST_TEST(std::count_if(mesh.links.begin(), mesh.links.end(), diagonal) == 1);
        }
    while (std::next_permutation(order.begin(), order.end()));
}

BOOST_AUTO_TEST_CASE(a_line_whose_middle_dies_stays_linked_by_a_bridge) {
    // At step 570 cells at 3.5 < x < 8.5 die: the halves are about 6 apart, and one link holds them.
    Genome genome = line_genome(Actuation::oscillator, 12);
    for (const int node : {add_switch(genome, input::x, 40, -14), add_switch(genome, input::x, -40, 34),
                           add_switch(genome, input::time, 40, -40 * 0.925)})
        add_link(genome, node, genome.inputs + output::apoptosis, 0.5);
    const Snapshot before = seen(genome, Actuation::oscillator, 569),
                   after = seen(genome, Actuation::oscillator, 570);
    BOOST_TEST(before.cells.size() == 13u);
    BOOST_TEST(longest(before) < 1.5);
    BOOST_TEST(after.cells.size() < 10u);
    BOOST_TEST(longest(after) > 3);
    BOOST_TEST(is_connected(after));
    BOOST_TEST(std::count_if(after.links.begin(), after.links.end(), [&](Link link) {
                   return length(after.cells[link.b] - after.cells[link.a]) > 1.5;
               }) == 1);
}

BOOST_AUTO_TEST_CASE(a_body_may_die_out_after_it_has_grown) {
    Genome genome = line_genome(Actuation::grn, 12);
    wire(genome, input::time, output::apoptosis, 2);
    const Growth growth = grown(genome, Actuation::grn);
    BOOST_TEST(growth.outcome == Outcome::died_out);
    BOOST_TEST(growth.cells == 0);
    BOOST_TEST(growth.births > 5);
    BOOST_TEST(growth.largest == growth.births);
    BOOST_TEST(growth.body.positions.empty());
}

BOOST_AUTO_TEST_CASE(at_256_cells_development_stops) {
    int last = -1;
    const Growth growth = grown(random_genome(Actuation::grn, 126), Actuation::grn,
                                [&](int step, const Embryo &) { last = step; });
    BOOST_TEST(growth.outcome == Outcome::overgrown);
    BOOST_TEST(growth.largest == 256);
    BOOST_TEST(last < 599);
    BOOST_TEST(last % 30 == 29); // in a decision
}

BOOST_AUTO_TEST_CASE(the_birth_limit_counts_dead_cells_too) {
    // A line that grows by one cell a decision in the east and dies as fast in the west.
    Genome genome = line_genome(Actuation::oscillator, 20);
    wire(genome, input::time, output::apoptosis, 4);
    wire(genome, input::x, output::apoptosis, -2);
    Parameters p;
    const Growth free = grown(genome, Actuation::oscillator, {}, p);
    BOOST_TEST(free.births == 21);
    BOOST_TEST(free.largest < 12);
    p.development.birth_limit = 15;
    BOOST_TEST(grown(genome, Actuation::oscillator, {}, p).births == 15);
}

BOOST_AUTO_TEST_CASE(a_daughter_is_placed_before_the_next_cell_divides) {
    // Both cells of the pair at 0 and (1/2, √3/2) would put a daughter at (−1/2, √3/2): angles of 60, then 60 + 60 and
    // 60 + 120 degrees. The lower id divides.
    const auto atanh = [](double y) { return 0.5 * math::log((1 + y) / (1 - y)); };
    const double first = atanh(1.0 / 3), both = atanh(2.0 / 3);
    Genome genome = bare_genome(Actuation::oscillator);
    wire(genome, input::bias, output::division_angle, first);
    wire(genome, input::x, output::division_angle, (both - first) / 0.05);
    const Snapshot snapshot = seen(genome, Actuation::oscillator, 30);
    BOOST_TEST(snapshot.cells.size() == 3u);
    BOOST_TEST(length(snapshot.cells[2] - Vec2d{-0.5, std::sqrt(0.75)}) < 0.01);
    // If the second cell divides in another direction there is room for both.
    genome.links.back().weight = 0;
    BOOST_TEST(seen(genome, Actuation::oscillator, 30).cells.size() == 4u);
}

BOOST_AUTO_TEST_CASE(the_read_out_reads_the_morphogens_of_step_570_over_the_final_mesh) {
    // A body whose links change in the last ten steps.
    const Genome genome = morphogen_genome(Actuation::oscillator, 327, output::period);
    const Snapshot source = seen(genome, Actuation::oscillator, 570);
    const Growth growth = grown(genome, Actuation::oscillator);
    BOOST_TEST((seen(genome, Actuation::oscillator, 599).links != growth.body.mesh.links));
    BOOST_REQUIRE(source.cells.size() == growth.body.positions.size());
    std::vector<double> morphogens;
    for (const Vec2d place : source.cells) morphogens.push_back(east(place));
    const Neighbours adjacent(growth.body.mesh.links, growth.cells);
    for (int cell = 0; cell < growth.cells; ++cell)
        BOOST_TEST(output_of(growth, cell, output::period) == math::tanh(mean(adjacent[cell], morphogens)),
                   near);
}

BOOST_AUTO_TEST_CASE(a_decision_reads_the_morphogens_of_the_one_before_over_the_links_of_ten_steps_before) {
    // The GRN's last update, at step 570, in a body whose links at 570 are not those of 560.
    const Genome genome = morphogen_genome(Actuation::grn, 343, output::spring);
    const Snapshot source = seen(genome, Actuation::grn, 540), linked = seen(genome, Actuation::grn, 560);
    const Growth growth = grown(genome, Actuation::grn);
    BOOST_TEST((seen(genome, Actuation::grn, 570).links != linked.links));
    BOOST_TEST(growth.births == growth.cells);
    BOOST_REQUIRE(source.cells.size() == growth.body.positions.size());
    std::vector<double> morphogens;
    for (const Vec2d place : source.cells) morphogens.push_back(east(place));
    const Neighbours adjacent(linked.links, growth.cells);
    for (int cell = 0; cell < growth.cells; ++cell)
        BOOST_TEST(output_of(growth, cell, output::spring) == math::tanh(mean(adjacent[cell], morphogens)),
                   near);
}

BOOST_AUTO_TEST_CASE(a_decision_reads_the_links_before_its_deaths_and_the_morphogens_of_dying_cells) {
    // A line whose eastern end dies at step 570, the last update of the GRN: the cells that stay have read
    // at 570 the morphogens that all had at 540, over the links of step 560.
    Genome genome = line_genome(Actuation::grn, 12);
    wire(genome, input::time, output::apoptosis, 40);
    wire(genome, input::x, output::apoptosis, 3);
    wire(genome, input::bias, output::apoptosis, -40 * 0.95 - 3 * 0.65 + 1);
    wire(genome, input::x, output::morphogen, 1);
    wire(genome, input::morphogen, output::spring, 1);
    const Snapshot source = seen(genome, Actuation::grn, 540), linked = seen(genome, Actuation::grn, 560);
    const Growth growth = grown(genome, Actuation::grn);
    BOOST_TEST(linked.cells.size() == 13u);
    BOOST_REQUIRE(growth.cells < 9);
    BOOST_REQUIRE(growth.cells > 3);
    std::vector<double> morphogens;
    for (const Vec2d place : source.cells) morphogens.push_back(east(place));
    const Neighbours adjacent(linked.links, 13);
    for (int cell = 0; cell < growth.cells; ++cell)
        BOOST_TEST(output_of(growth, cell, output::spring) == math::tanh(mean(adjacent[cell], morphogens)),
                   near);
    BOOST_TEST(adjacent[growth.cells - 1].back() == growth.cells); // a cell that died
}

BOOST_AUTO_TEST_CASE(specimens_have_the_shapes_of_their_names) {
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn}) {
        const Growth disc = grown(disc_genome(actuation), actuation);
        BOOST_TEST(disc.cells == 60);
        BOOST_TEST(elongation(disc.body.positions) < 1.1);

        // Below the body's middle there are cells on both sides and none between.
        const Growth legged = grown(two_legged_genome(actuation), actuation);
        BOOST_TEST(legged.cells == (actuation == Actuation::oscillator ? 57 : 58));
        BOOST_TEST(legged.births == 74);
        int west = 0, between = 0, east_side = 0;
        for (const Vec2d place : legged.body.positions)
            if (place.y < -1) ++(place.x < -1 ? west : place.x > 1 ? east_side : between);
        BOOST_TEST(west > 5);
        BOOST_TEST(between == 0);
        BOOST_TEST(east_side > 5);
    }
}

BOOST_AUTO_TEST_CASE(identical_networks_grow_identical_embryos) {
    // A disc, to the bit, on every compiler and at every optimisation level.
    const auto signature = [](Actuation actuation) {
        Hash hash;
        for (const Vec2d place : grown(disc_genome(actuation), actuation).body.positions)
            hash.number(place.x).number(place.y);
        return hash.hex();
    };
    const std::string golden = "ae98d9a845dbd0e9fc4218d669d2ea3ff6d4941ea93a1faa593205ef1d5bcfb6";
    BOOST_TEST(signature(Actuation::oscillator) == golden);
    BOOST_TEST(signature(Actuation::grn) == golden);
}
