// SPDX-License-Identifier: MIT
// Eqs. (4) and (6) as experiments/paper/judgement.lua states them, against numbers worked by hand.
#include "statement/judging_functions.h"

#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

// The paper's judgement, with the standard parameters or others.
Evaluation judged(const Life &life, const Parameters &parameters = {}) {
    return JudgingFunctions(
               test::script("local paper = require 'paper' return paper.experiment { name = 'x' }"), 0,
               parameters)
        .judge(life);
}

// 3 right and 4 up from (1, 2): displacement 5.
Life walker() {
    Life life;
    life.outcome = Outcome::viable;
    life.cells = life.largest = 20;
    life.births = 25;
    life.rest = {1, 2};
    life.finish = {4, 6};
    return life;
}

} // namespace

BOOST_AUTO_TEST_CASE(fitness_is_the_displacement_from_rest_to_end) {
    const Evaluation evaluation = judged(walker());
    BOOST_TEST(evaluation.fitness == 5);
    BOOST_TEST(evaluation.penalty == 1);
}

BOOST_AUTO_TEST_CASE(the_descriptor_is_where_the_body_ended) {
    const std::vector<double> expected{4, 6};
    BOOST_TEST(judged(walker()).behaviour == expected);
}

BOOST_AUTO_TEST_CASE(activity_adds_a_tenth_of_a_cell_at_most) {
    Life life = walker();
    life.activity = 1;
    BOOST_TEST(judged(life).fitness == 5 + 0.1);
    life.activity = 0.5;
    BOOST_TEST(judged(life).fitness == 5 + 0.05);
    Parameters parameters;
    set_parameter(parameters, "activity_bonus", 4);
    BOOST_TEST(judged(life, parameters).fitness == 7);
}

BOOST_AUTO_TEST_CASE(reaching_the_birth_limit_costs_nine_tenths) {
    Life life = walker();
    life.births = 1024;
    BOOST_TEST(judged(life).fitness == 0.5);
    BOOST_TEST(judged(life).penalty == 0.1);
    life.births = 1023;
    BOOST_TEST(judged(life).penalty == 1);
}

BOOST_AUTO_TEST_CASE(only_viable_individuals_are_valid) {
    for (const Outcome outcome : {Outcome::died_out, Outcome::too_small, Outcome::overgrown,
                                  Outcome::never_settled, Outcome::exploded}) {
        Life life = walker();
        life.outcome = outcome;
        const Evaluation evaluation = judged(life);
        BOOST_TEST(evaluation.penalty == 0, name_of(outcome));
        BOOST_TEST(evaluation.fitness == 0, name_of(outcome));
        BOOST_TEST(!evaluation.valid(), name_of(outcome));
    }
}
