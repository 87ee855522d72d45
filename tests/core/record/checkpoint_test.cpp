// SPDX-License-Identifier: MIT
#include "record/checkpoint.h"

#include "base/error.h"
#include "base/state.h"
#include "core/record/fake_run.h"
#include "record/sealed.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

Checkpoint sample(int generation) {
    Checkpoint checkpoint{.identity = "this run", .generation = generation, .generations = 9};
    checkpoint.tables = {{"generations.csv", {12, "abc"}}, {"champions.csv", {0, "def"}}};
    checkpoint.state = "state";
    checkpoint.crown = std::string("cro\0wn", 6);
    return checkpoint;
}

} // namespace

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

BOOST_AUTO_TEST_CASE(a_checkpoint_reads_back_and_the_one_before_is_kept) {
    const TemporaryFolder folder;
    BOOST_TEST(!find_checkpoint(folder.path()).checkpoint);
    for (const int generation : {2, 4}) write_checkpoint(folder.path(), sample(generation));
    const FoundCheckpoint found = find_checkpoint(folder.path());
    BOOST_REQUIRE(found.checkpoint.has_value());
    BOOST_TEST(found.damaged.empty());
    BOOST_TEST(found.checkpoint->identity == "this run");
    BOOST_TEST(found.checkpoint->generation == 4);
    BOOST_TEST(found.checkpoint->generations == 9);
    BOOST_TEST(found.checkpoint->mark_of("generations.csv").length == 12);
    BOOST_TEST(found.checkpoint->mark_of("champions.csv").sha256 == "def");
    BOOST_CHECK_THROW(found.checkpoint->mark_of("species.csv"), InputError);
    BOOST_TEST(found.checkpoint->crown == std::string("cro\0wn", 6));
    BOOST_TEST(std::filesystem::exists(folder / "checkpoint.previous"));
    remove_checkpoints(folder.path());
    BOOST_TEST(std::filesystem::is_empty(folder.path()));
}

BOOST_AUTO_TEST_CASE(a_damaged_checkpoint_is_passed_over_for_the_one_before) {
    const TemporaryFolder folder;
    for (const int generation : {2, 4}) write_checkpoint(folder.path(), sample(generation));
    const std::string whole = read_bytes(folder / "checkpoint");
    std::string gzip = whole;
    gzip[0] = '\x1f', gzip[1] = '\x8b';
    for (const std::string &bytes :
         {std::string(), whole.substr(0, 1), whole.substr(0, 60), whole + "x", gzip}) {
        write_bytes(folder / "checkpoint", bytes);
        const FoundCheckpoint found = find_checkpoint(folder.path());
        BOOST_TEST(found.checkpoint.value().generation == 2);
        BOOST_TEST((found.damaged == std::vector{folder / "checkpoint"}));
    }
    write_bytes(folder / "checkpoint.previous", "");
    BOOST_TEST(!find_checkpoint(folder.path()).checkpoint);
    BOOST_TEST(find_checkpoint(folder.path()).damaged.size() == 2u);
}

BOOST_AUTO_TEST_CASE(a_checkpoint_whole_but_senseless_is_refused_by_name) {
    const TemporaryFolder folder;
    const auto refused = [&](const StateWriter &content) {
        write_bytes(folder / "checkpoint", seal(content.bytes()));
        const std::string said = message_of<InputError>([&] { find_checkpoint(folder.path()); });
        BOOST_TEST(contains(said, (folder / "checkpoint").string() + ": saved state, byte "), said);
    };
    const auto head = [] {
        StateWriter writer;
        return writer.group("run").text("this run");
    };
    refused(StateWriter());
    refused(head().integer(-1).integer(9));
    refused(head().integer(2).integer(0));
    refused(head().integer(2).integer(9).group("tables").integer(std::int64_t{1} << 60));
    refused(head().integer(2).integer(9).group("tables").integer(1).text("a").integer(-5).text("b"));
    refused(head()
                .integer(2)
                .integer(9)
                .group("tables")
                .integer(0)
                .group("parts")
                .text("")
                .text("")
                .text("")
                .integer(1));
}

BOOST_AUTO_TEST_CASE(without_room_for_a_new_checkpoint_the_old_one_stays) {
    const TemporaryFolder folder;
    write_checkpoint(folder.path(), sample(2));
    std::filesystem::create_symlink("/dev/full", folder / "checkpoint.tmp");
    BOOST_CHECK_THROW(write_checkpoint(folder.path(), sample(4)), IoError);
    BOOST_TEST(find_checkpoint(folder.path()).checkpoint.value().generation == 2);
}
