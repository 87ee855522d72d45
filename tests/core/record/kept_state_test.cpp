// SPDX-License-Identifier: MIT
#include "record/kept_state.h"

#include "base/error.h"
#include "base/state.h"
#include "core/genome/specimens.h"
#include "core/record/fake_run.h"
#include "evolution/population_state.h"
#include "evolution/reproduce.h"
#include "evolution/species.h"
#include "storage/packed.h"
#include "storage/sealed.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <set>

using namespace planula;

namespace {

KeptState sample(int generation) {
    return {.identity = "this run",
            .generation = generation,
            .tables = {{"generations.csv", {12, "abc"}}, {"champions.csv", {0, "def"}}},
            .link = "the link before",
            .archive = 3,
            .best_fitness = 1.0 / 3,
            .state = "state",
            .memory = std::string("mem\0ory", 7)};
}

void write_two(const std::filesystem::path &folder) {
    for (const int generation : {2, 4}) write_checkpoint(folder, sample(generation));
}

/// 300 genomes of some 145 links each, bred for some generations from one that has grown; at first no two weights are
/// equal. The record of innovations is as long as those of runs of 1600 generations.
Population late_population() {
    Parameters parameters;
    Population population;
    population.threshold = parameters.neat.compatibility_threshold;
    Stream stream = specimens::stream(1);
    Genome ancestor = specimens::connected(12, 4, population.innovations);
    while (ancestor.links.size() < 145)
        mutate(specimens::structural(), false, population.innovations, stream, ancestor);
    for (Genome other = ancestor; population.innovations.links() < 2000;)
        mutate(specimens::structural(), false, population.innovations, stream, other);
    for (int slot = 0; slot < parameters.neat.population; ++slot) {
        Genome child = ancestor;
        for (LinkGene &link : child.links) link.weight = stream.triangular();
        add_child(parameters.neat, population, child);
    }
    complete_generation(parameters.neat.population, population);
    for (int generation = 0; generation < 10; ++generation) {
        std::vector<double> scores(population.genomes.size());
        for (double &score : scores) score = stream.uniform();
        population = reproduce(population, scores, Adjustment::sharing, false, parameters.neat, 1);
    }
    return population;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_state_of_a_late_population_takes_250_kilobytes) {
    const Population population = late_population();
    std::size_t links = 0;
    std::set<double> weights;
    for (const Genome &genome : population.genomes) {
        links += genome.links.size();
        for (const LinkGene &link : genome.links) weights.insert(link.weight);
    }
    BOOST_TEST(links >= 300u * 145);
    BOOST_TEST(weights.size() * 3 >= links * 2); // in runs, two thirds of all weights differ
    BOOST_TEST(population.innovations.links() >= 2000);

    const TemporaryFolder folder;
    StateWriter writer;
    save(population, writer);
    KeptState kept = sample(1600);
    kept.state = writer.bytes();
    keep_state(folder.path(), kept);
    BOOST_TEST(std::filesystem::file_size(state_path(folder.path(), 1600)) <= 250'000u);
    BOOST_TEST((read_state(state_path(folder.path(), 1600)).value().state == kept.state));
}

BOOST_AUTO_TEST_CASE(a_seal_shows_every_cut_and_every_changed_bit) {
    const std::string content = "what was kept", whole = seal(content);
    BOOST_TEST(std::string(unseal(whole).value()) == content);
    for (std::size_t length = 0; length < whole.size(); ++length)
        BOOST_TEST(!unseal(whole.substr(0, length)));
    BOOST_TEST(!unseal(whole + '\0'));
    for (std::size_t bit = 0; bit < whole.size() * 8; ++bit) {
        std::string flipped = whole;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ 1 << bit % 8);
        BOOST_TEST(!unseal(flipped), bit);
    }
}

BOOST_AUTO_TEST_CASE(a_kept_state_reads_back_whole) {
    const TemporaryFolder folder;
    const std::string hash = keep_state(folder.path(), sample(25));
    BOOST_TEST(hash == sha256(read_bytes(folder / "states/000025.state")));
    const KeptState back = read_state(state_path(folder.path(), 25)).value(), kept = sample(25);
    BOOST_TEST(back.identity == kept.identity);
    BOOST_TEST(back.generation == 25);
    BOOST_TEST(back.mark_of("generations.csv").length == 12);
    BOOST_TEST(back.mark_of("champions.csv").sha256 == "def");
    BOOST_TEST(message_of<InputError>([&] { back.mark_of("species.csv"); }) ==
               "it has no mark of species.csv");
    BOOST_TEST(back.tables.size() == 2u);
    BOOST_TEST(back.link == kept.link);
    BOOST_TEST(back.archive == 3);
    BOOST_TEST(back.best_fitness == kept.best_fitness);
    BOOST_TEST(back.state == kept.state);
    BOOST_TEST(back.memory == kept.memory);
}

BOOST_AUTO_TEST_CASE(a_new_checkpoint_keeps_the_one_before) {
    const TemporaryFolder folder;
    BOOST_TEST(checkpoints(folder.path()).empty());
    write_checkpoint(folder.path(), sample(2));
    BOOST_TEST((checkpoints(folder.path()) == std::vector{folder / "checkpoint"}));
    write_checkpoint(folder.path(), sample(4));
    BOOST_TEST(
        (checkpoints(folder.path()) == std::vector{folder / "checkpoint", folder / "checkpoint.previous"}));
    BOOST_TEST(read_state(folder / "checkpoint").value().generation == 4);
    BOOST_TEST(read_state(folder / "checkpoint.previous").value().generation == 2);
    remove_checkpoints(folder.path());
    BOOST_TEST(std::filesystem::is_empty(folder.path()));
}

BOOST_AUTO_TEST_CASE(a_damaged_file_is_no_state_and_one_that_is_not_there_is_refused) {
    const TemporaryFolder folder;
    write_two(folder.path());
    const std::string whole = read_bytes(folder / "checkpoint");
    std::string gzip = whole;
    gzip[0] = '\x1f', gzip[1] = '\x8b';
    for (const std::string &bytes :
         {std::string(), whole.substr(0, 1), whole.substr(0, 60), whole + "x", gzip, seal(whole).substr(1)}) {
        write_bytes(folder / "checkpoint", bytes);
        BOOST_TEST(!read_state(folder / "checkpoint"));
    }
    std::filesystem::remove(folder / "checkpoint");
    BOOST_TEST(contains(message_of<InputError>([&] { read_state(folder / "checkpoint"); }), "cannot open"));
}

BOOST_AUTO_TEST_CASE(a_whole_file_with_invalid_content_is_refused_by_name) {
    const TemporaryFolder folder;
    const auto refused = [&](const StateWriter &content) {
        write_bytes(folder / "checkpoint", seal(pack(content.bytes())));
        const std::string said = message_of<InputError>([&] { read_state(folder / "checkpoint"); });
        BOOST_TEST(contains(said, (folder / "checkpoint").string() + ": saved state, byte "), said);
    };
    // A complete content except for one thing.
    struct Content {
        std::string group = "run";
        std::int64_t generation = 2, archive = 3;
        double fitness = 1;
        std::int64_t tables = 1, length = 5;
        StateWriter whole() const {
            StateWriter writer;
            writer.group(group)
                .text("this run")
                .integer(generation)
                .text("link")
                .integer(archive)
                .real(fitness);
            writer.group("tables").integer(tables).text("a.csv").integer(length).text("hash");
            return writer.group("parts").text("state").text("memory");
        }
    };
    refused(StateWriter());
    refused(Content{.group = "walk"}.whole());
    refused(Content{.generation = -1}.whole());
    refused(Content{.generation = std::int64_t{1} << 31}.whole());
    refused(Content{.archive = -1}.whole());
    refused(Content{.fitness = std::numeric_limits<double>::infinity()}.whole());
    refused(Content{.tables = 0}.whole());
    refused(Content{.tables = 2}.whole());
    refused(Content{.tables = std::int64_t{1} << 60}.whole());
    refused(Content{.length = -5}.whole());
    refused(Content{}.whole().integer(1));
    write_bytes(folder / "checkpoint", seal(pack(Content{}.whole().bytes())));
    BOOST_TEST(read_state(folder / "checkpoint").value().mark_of("a.csv").length == 5);
    write_bytes(folder / "checkpoint", seal("not packed"));
    BOOST_CHECK_THROW(read_state(folder / "checkpoint"), InputError);
}

BOOST_AUTO_TEST_CASE(without_room_for_a_new_checkpoint_the_old_one_stays) {
    const TemporaryFolder folder;
    write_checkpoint(folder.path(), sample(2));
    std::filesystem::create_symlink("/dev/full", folder / "checkpoint.tmp");
    BOOST_CHECK_THROW(write_checkpoint(folder.path(), sample(4)), IoError);
    std::vector<int> whole;
    for (const auto &path : checkpoints(folder.path()))
        if (const auto state = read_state(path)) whole.push_back(state->generation);
    BOOST_TEST((whole == std::vector{2}));
}

BOOST_AUTO_TEST_CASE(kept_generations_are_those_with_a_file_of_their_name) {
    const TemporaryFolder folder;
    BOOST_TEST(kept_generations(folder.path()).empty());
    for (const int generation : {100, 3, 25, 1234567}) keep_state(folder.path(), sample(generation));
    BOOST_TEST(std::filesystem::exists(folder / "states/1234567.state"));
    for (const char *stray : {"7.state", "000009.state.tmp", "-00008.state", "000010", "notes.txt"})
        write_bytes(folder / "states" / std::filesystem::path(stray), "stray");
    BOOST_TEST((kept_generations(folder.path()) == std::vector{3, 25, 100, 1234567}));
}
