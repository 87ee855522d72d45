// SPDX-License-Identifier: MIT
#include "analysis/simulate_again.h"

#include "base/error.h"
#include "core/record/fake_run.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>

using namespace planula;

namespace {

Spec swimmers() {
    Spec spec = fake_spec("water", 1, 60);
    spec.actuation_range = 0.2;
    spec.environment.drag_normal = 1;
    return spec;
}

/// The first viable individual of a random population.
RecordedIndividual recorded_of(const Spec &spec) {
    for (const Genome &genome : fake_population(spec, 1).genomes) {
        const Life life = live(genome, spec);
        if (life.outcome == Outcome::viable)
            return {.file = "table.csv",
                    .genome = genome,
                    .displacement = life.displacement(),
                    .cells = life.cells};
    }
    throw std::runtime_error("no individual is viable");
}

} // namespace

BOOST_AUTO_TEST_CASE(the_recorded_life_is_simulated_again_to_the_last_bit) {
    const Spec spec = swimmers();
    const RecordedIndividual recorded = recorded_of(spec);
    const Life life = simulate_again(recorded, spec);
    BOOST_TEST(life.displacement() > 0);
    BOOST_TEST(life.displacement() == recorded.displacement);
    BOOST_TEST(life.cells == recorded.cells);
}

BOOST_AUTO_TEST_CASE(another_distance_or_size_is_refused) {
    const Spec spec = swimmers();
    RecordedIndividual other = recorded_of(spec);
    other.displacement = std::nextafter(other.displacement, 1000);
    BOOST_TEST(contains(message_of<InputError>([&] { simulate_again(other, spec); }),
                        "table.csv: the best individual of 'water' moved"));
    other = recorded_of(spec);
    ++other.cells;
    BOOST_CHECK_THROW(simulate_again(other, spec), InputError);
}
