// SPDX-License-Identifier: MIT
#include "genome/genome_text.h"

#include "base/error.h"
#include "core/storage/temporary_folder.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

/// Without what a life does not read.
Genome anonymous(Genome genome) {
    const Genome none;
    genome.id = none.id, genome.mother = none.mother, genome.father = none.father,
    genome.origin = none.origin;
    return genome;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_genome_comes_back_from_its_text) {
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn}) {
        Genome genome = specimens::two_legged_genome(actuation);
        genome.id = 12, genome.mother = 3, genome.origin = Origin::mutation;
        genome.links.front().weight = -1.0 / 3;
        BOOST_TEST((read_genome(write_genome(genome)) == anonymous(genome)));
    }
}

BOOST_AUTO_TEST_CASE(a_genome_text_is_refused_with_the_rule) {
    const Genome genome = specimens::random_genome(Actuation::oscillator, 1);
    std::string text = write_genome(genome);
    BOOST_TEST(message_of<InputError>([&] { read_genome(text.substr(0, text.size() / 2)); }).find("line ") ==
               0u);
    text.replace(text.find("bias"), 4, "bios");
    BOOST_TEST(message_of<InputError>([&] { read_genome(text); }).find("did you mean 'bias'?") !=
               std::string::npos);
    Genome crooked = genome;
    crooked.links.back().to = 999;
    BOOST_TEST(message_of<InputError>([&] { read_genome(write_genome(crooked)); }).find("999") !=
               std::string::npos);
}
