// SPDX-License-Identifier: MIT
// The eight numbered equations of Joachimczak, Suzuki & Arita (2015), each against numbers worked out by
// hand. Eqs. (4) and (6) belong to the experiment and are asked of the paper's own script.
#include "base/math.h"
#include "evolution/novelty_search.h"
#include "locomotion/grn.h"
#include "locomotion/oscillator.h"
#include "physics/laws/spring.h"
#include "statement/schema.h"
#include "statistics/entropy.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <vector>

using namespace planula;
using namespace planula::specimens;

namespace {

const auto near = boost::test_tools::tolerance(1e-12);

/// The judge of a setting of the paper's replication.
Evaluation judged(const std::string &setting, const Life &life) {
    const std::filesystem::path library = std::filesystem::path(PLANULA_SOURCE_DIR) / "experiments";
    static const Experiment replication = load_experiment(library / "paper" / "replication.lua", library);
    return replication.find(setting)->judge(life);
}

/// A viable life that came to rest at (1, 2) and ended at (4, 6), 5 cells away, with activity 0.5.
Life five_cells_away() {
    Life life;
    life.outcome = Outcome::viable;
    life.cells = life.largest = life.births = 40;
    life.rest = {1, 2};
    life.finish = {4, 6};
    life.activity = 0.5;
    life.path = {life.rest, life.finish};
    return life;
}

} // namespace

BOOST_AUTO_TEST_CASE(eq_1_adds_the_sines_of_two_cells) {
    // A = 0.2 in water. At t = 225: 2π·225/100 + 0 = 4.5π, sine 1; 2π·225/300 + π/3 = 1.5π + π/3, sine −1/2.
    const Parameters p;
    const std::vector<Oscillator> cells{{100, 0}, {300, math::pi / 3}};
    const double A = 0.2;
    const double first = math::sin(2 * math::pi * 225 / cells[0].period + cells[0].phase);
    const double second = math::sin(2 * math::pi * 225 / cells[1].period + cells[1].phase);
    BOOST_TEST(first == 1, near);
    BOOST_TEST(second == -0.5, near);
    BOOST_TEST(actuated_length(1.5, extension(p.water.actuation_range_aquatic, 1, first),
                               extension(p.water.actuation_range_aquatic, 1, second)) ==
                   (1 + A * 1 + A * -0.5) * 1.5,
               near); // 1.65

    // The gait's signals are these sines, at its knots; t = 220 is one.
    Oscillators gait(cells, p.gait);
    std::vector<double> signal(2);
    for (int t = 0; t <= 220; t += 10) gait.signals(t, signal);
    BOOST_TEST(signal[0] == 0.9510565162951535, near);  // 4.4π: sin 72°
    BOOST_TEST(signal[1] == -0.5877852522924731, near); // 264° + 60°: sin 324°
}

BOOST_AUTO_TEST_CASE(eq_2_moves_linearly_from_the_last_output_to_the_newest) {
    // One output that is tanh of the bias alone from the first update on: s₀ = 0, s₁ = s₂ = tanh 1.
    Genome genome = bare_genome(Actuation::grn);
    wire(genome, input::bias, output::spring, 1);
    const Network network = express(genome, 16);
    const Body body = make_body({{0, 0}, {1, 0}}, 1.5);
    const Tissue tissue{Activations(network.nodes, 2), {0, 0}};
    const Parameters p;
    GrnMuscles gait(network, body, tissue, p);
    std::vector<double> signal(2);
    const double s = 0.7615941559557649; // tanh 1
    for (int t = 0; t <= 80; t += 10) {
        gait.signals(t, signal);
        BOOST_TEST(signal[0] == (t < 50 ? t / 50.0 * s : s), near);
    }
}

BOOST_AUTO_TEST_CASE(eq_3_averages_the_signals_of_two_cells) {
    // A = 0.3 on land, a₁ = 0.5, a₂ = −0.1: L = (1 + 0.3 · 0.2) · 2.
    BOOST_TEST(actuated_length(2.0, extension(Parameters{}.land.actuation_range_terrestrial, 1, 0.5),
                               extension(Parameters{}.land.actuation_range_terrestrial, 1, -0.1)) == 2.12,
               near);
}

BOOST_AUTO_TEST_CASE(eq_4_is_displacement_and_a_bonus_for_activity) {
    BOOST_TEST(judged("grn-aq-neat", five_cells_away()).fitness == 5.05, near); // 5 + 0.1 · 0.5
    Life calm = five_cells_away();
    calm.activity = 0;
    BOOST_TEST(judged("osc-te-ns", calm).fitness == 5, near);
}

BOOST_AUTO_TEST_CASE(eq_5_is_the_mean_change_between_updates_over_its_largest_possible) {
    // Three updates (150 steps) of one cell whose output alternates: s = 0.9, tanh(−3 · 0.9), tanh(−3 ·
    // that).
    Genome genome = bare_genome(Actuation::grn);
    const int spring = genome.inputs + output::spring;
    add_link(genome, spring, spring, -3);
    const Network network = express(genome, 16);
    const Body body = make_body({{0, 0}}, 1.5);
    Tissue tissue{Activations(network.nodes, 1), {0}};
    tissue.activations.at(0, spring) = 0.3;
    Parameters p;
    p.gait.locomotion_steps = 150;
    GrnMuscles gait(network, body, tissue, p);
    std::vector<double> signal(1);
    for (int t = 0; t <= 150; t += 10) gait.signals(t, signal);
    // s₁ = tanh(−0.9) = −0.71629787, s₂ = tanh(2.14889361), s₃ = tanh(−2.91950295), to eight digits.
    const double s1 = -0.71629787, s2 = 0.97316765, s3 = -0.99419344;
    BOOST_TEST(gait.activity() == (std::abs(s2 - s1) + std::abs(s3 - s2)) / (2 * 1 * 2),
               boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(eq_6_is_nothing_or_a_tenth) {
    for (const Outcome outcome : {Outcome::too_small, Outcome::overgrown, Outcome::never_settled,
                                  Outcome::died_out, Outcome::exploded}) {
        Life life = five_cells_away();
        life.outcome = outcome;
        BOOST_TEST(judged("grn-te-neat", life).fitness == 0);
        BOOST_TEST(!judged("grn-te-neat", life).valid());
    }
    Life prolific = five_cells_away();
    prolific.births = 1024;
    BOOST_TEST(judged("grn-te-neat", prolific).penalty == 0.1);
    BOOST_TEST(judged("grn-te-neat", prolific).fitness == 0.505, near);
    prolific.births = 1023;
    BOOST_TEST(judged("grn-te-neat", prolific).penalty == 1);
}

BOOST_AUTO_TEST_CASE(eq_7_is_the_mean_distance_to_the_nearest_behaviours) {
    // k = 2 and an empty archive. From (0, 0): 3, 4 and 6 away, so (3 + 4)/2.
    Parameters p;
    p.novelty.novelty_neighbours = 2;
    NoveltySearch search(p);
    const std::vector<Evaluation> evaluations{
        {1, {0, 0}, 1}, {1, {3, 0}, 1}, {1, {0, 4}, 1}, {1, {-6, 0}, 1}, {1, {0, 0.5}, 0}};
    Population population;
    population.genomes.resize(evaluations.size());
    const std::vector<double> novelty = search.score(population, evaluations);
    BOOST_TEST(novelty[0] == 3.5, near);
    BOOST_TEST(novelty[1] == 4, near); // 3 to the origin, 5 to (0, 4)
    BOOST_TEST(novelty[4] == 0);       // not valid, and no neighbour of others
}

BOOST_AUTO_TEST_CASE(eq_8_is_shannons_entropy_of_sizes_in_nats) {
    // Shares 1/2, 1/4, 1/4: ½ ln 2 + ½ ln 4 = 1.5 ln 2.
    BOOST_TEST(entropy(std::vector<int>{40, 40, 60, 80}) == 1.5 * 0.6931471805599453, near);
    BOOST_TEST(entropy(std::vector<int>{40, 40, 40}) == 0);
}
