// SPDX-License-Identifier: MIT
#include "analysis/lineage.h"

#include "base/error.h"
#include "base/text.h"
#include "core/record/fake_run.h"
#include "tables/csv.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

/// A run of four generations of three: genome 3 g + slot; the mother is the one in the same slot before.
struct Family {
    Family() {
        const Spec spec = fake_spec("osc", 4, 3);
        RunWriter writer(folder / "run", spec, 1, fake_sources());
        FakeRun run(spec, 1);
        for (int g = 0; g < 4; ++g) {
            for (int slot = 0; slot < 3; ++slot) {
                Genome &genome = run.population().genomes[static_cast<std::size_t>(slot)];
                genome.mother = g == 0 ? -1 : 3 * (g - 1) + slot;
                genome.father = g == 2 ? 3 : -1;
                genome.origin = g == 0   ? Origin::initial
                                : g == 1 ? Origin::champion
                                : g == 2 ? Origin::crossover
                                         : Origin::clone;
            }
            run.step(writer,
                     [](int generation, int slot) { return FakeLife{.fitness = 1.0 + generation + slot}; });
        }
        writer.finish();
    }
    std::vector<std::int64_t> line(std::int64_t genome, bool copies) const {
        std::vector<std::int64_t> ids;
        for (const LineageRow &row : lineage(read_run(folder / "run"), genome, copies))
            ids.push_back(row.genome);
        return ids;
    }
    TemporaryFolder folder;
};

} // namespace

BOOST_AUTO_TEST_CASE(a_line_goes_from_the_first_generation_to_the_genome) {
    const Family family;
    BOOST_TEST((family.line(11, true) == std::vector<std::int64_t>{2, 5, 8, 11}));
    BOOST_TEST((family.line(6, true) == std::vector<std::int64_t>{0, 3, 6}));
    BOOST_TEST((family.line(0, true) == std::vector<std::int64_t>{0}));
}

BOOST_AUTO_TEST_CASE(a_line_leaves_out_unchanged_copies_except_the_genome_asked_for) {
    const Family family;
    BOOST_TEST((family.line(11, false) == std::vector<std::int64_t>{2, 8, 11}));
    BOOST_TEST((family.line(5, false) == std::vector<std::int64_t>{2, 5}));
}

BOOST_AUTO_TEST_CASE(a_lineage_has_what_each_ancestor_was_and_did) {
    const Family family;
    const LineageRow row = lineage(read_run(family.folder / "run"), 11, false).at(1);
    BOOST_TEST(row.generation == 2);
    BOOST_TEST(row.slot == 2);
    BOOST_TEST(row.origin == "crossover");
    BOOST_TEST(row.mother == 5);
    BOOST_TEST(row.father == 3);
    BOOST_TEST(row.fitness == 5);
    BOOST_TEST(row.cells == 10);
    BOOST_TEST(row.links == 54);
}

BOOST_AUTO_TEST_CASE(an_unknown_genome_and_a_mother_younger_than_her_child_are_refused) {
    const Family family;
    const RecordedRun run = read_run(family.folder / "run");
    const std::string file = (family.folder / "run/individuals.csv.gz").string();
    BOOST_TEST(contains(message_of<InputError>([&] { lineage(run, 12, true); }),
                        file + ": the run never had a genome 12"));
    auto rows = read_table<IndividualRow>(run.folder);
    rows[5].mother = 5;
    write_table<IndividualRow>(run.folder, rows);
    BOOST_TEST(
        contains(message_of<InputError>([&] { lineage(run, 11, true); }), "who is not born before it"));
}

BOOST_AUTO_TEST_CASE(a_sample_has_a_lineage_unless_an_ancestor_is_missing) {
    const Family family;
    RecordedRun run = read_run(family.folder / "run");
    const auto full = lineage(run, 11, true);
    run.record = sample_record;
    BOOST_TEST(lineage(run, 11, true).size() == full.size());

    // The mother of the youngest is not in the sample.
    auto rows = read_table<IndividualRow>(run.folder);
    const std::int64_t mother = full.at(full.size() - 2).genome;
    std::erase_if(rows, [&](const IndividualRow &row) { return row.genome == mother; });
    write_table<IndividualRow>(run.folder, rows);
    BOOST_TEST(contains(message_of<InputError>([&] { lineage(run, 11, true); }),
                        "genome " + to_text(mother) + " is not in the sample that the run has recorded"));
}
