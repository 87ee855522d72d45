// SPDX-License-Identifier: MIT
#include "analysis/audit.h"

#include "base/error.h"
#include "base/hash.h"
#include "base/random.h"
#include "base/text.h"
#include "core/record/quick_run.h"
#include "experiment/run_state.h"
#include "record/chain.h"
#include "record/kept_state.h"
#include "record/run_tables.h"
#include "storage/input.h"
#include "tables/csv.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace planula;
namespace fs = std::filesystem;

namespace {

constexpr int generations = 32; // states stay of 25 and 31

const StopRequest never = [] { return false; };

std::string text_of(const fs::path &folder, const std::string &file) { return read_file(folder / file); }

/// The lines of a text, ended.
std::vector<std::string> lines_of(const std::string &text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = text.find('\n', begin) + 1;
        lines.push_back(text.substr(begin, end - begin));
        begin = end;
    }
    return lines;
}

std::string joined(const std::vector<std::string> &lines) {
    std::string text;
    for (const std::string &line : lines) text += line;
    return text;
}

/// Packed or plain, by its name.
void put(const fs::path &file, const std::string &text) {
    if (file.extension() == ".gz")
        write_file(file, text);
    else
        write_bytes(file, text);
}

// ---- A forger who knows the program -----------------------------------------------------------------------

/// A manifest that agrees with the files of a folder, and with the rows given.
void mend(const fs::path &folder, const std::map<std::string, std::string> &rows = {}) {
    const Manifest manifest(folder);
    Manifest mended;
    for (const ManifestRow &row : manifest.rows()) {
        if (row.key == "manifest_sha256") continue;
        std::string value = row.value;
        if (is_file(row.key)) value = content_sha256(folder / row.key);
        if (row.key == "link") value = read_chain(folder).back().link;
        if (rows.contains(row.key)) value = rows.at(row.key);
        mended.add(row.key, value);
    }
    mended.seal();
    mended.write(folder);
}

/// What a table has of a generation.
std::string rows_of(const std::string &table, int generation) {
    std::string rows;
    for (const std::string &line : lines_of(table))
        if (line.starts_with(to_text(generation) + ",")) rows += line;
    return rows;
}

/// Links, kept states and manifest that agree with the tables.
void relink(const fs::path &folder) {
    std::vector<std::string> tables;
    for (const std::string_view file : run_tables)
        tables.push_back(fs::exists(folder / file) ? text_of(folder, std::string(file)) : "");
    std::vector<ChainRow> chain = read_chain(folder);
    std::string before = chain_start(recorded_run(folder).value().identity.sha256());
    for (ChainRow &row : chain) {
        Hash link;
        link.text(before).text(row.content);
        for (const std::string &table : tables) link.text(sha256(rows_of(table, row.generation)));
        before = row.link = link.hex();
    }
    write_table<ChainRow>(folder, chain);
    for (const int generation : kept_generations(folder)) {
        KeptState kept = read_state(state_path(folder, generation)).value();
        kept.link = chain.at(static_cast<std::size_t>(generation) - 1).link;
        for (auto &[file, mark] : kept.tables) {
            const auto lines = lines_of(text_of(folder, file));
            std::string text = lines.front();
            for (std::size_t i = 1; i < lines.size(); ++i)
                if (std::stoi(lines[i]) < generation) text += lines[i];
            mark = {static_cast<std::int64_t>(text.size()), sha256(text)};
        }
        keep_state(folder, kept);
    }
    mend(folder);
}

// ---- The run ------------------------------------------------------------------------------------------------

/// A real run, which may be altered and is whole again afterwards.
class Audited {
  public:
    explicit Audited(const std::string &search = "novelty", int length = generations,
                     Recording record = full_record)
        : spec(quick::spec(search, length)) {
        spec.record = record;
        quick::run_on(place, spec, -1, quick::End::stopped, 1000);
        whole_ = contents(place);
    }

    std::string inconsistency() const {
        return message_of<InputError>([&] { check_consistency(open_run(place)); });
    }
    std::string refuted(const Stretch &stretch) const {
        return message_of<InputError>([&] { recompute(open_run(place), spec, stretch, 1, never); });
    }
    void restore() const {
        for (const auto &[file, bytes] : contents(place))
            if (!whole_.contains(file)) fs::remove(place / file);
        for (const auto &[file, bytes] : whole_)
            if (!fs::exists(place / file) || read_bytes(place / file) != bytes)
                write_bytes(place / file, bytes);
    }

    TemporaryFolder folder;
    fs::path place = folder / "run";
    Spec spec;

  private:
    std::map<std::string, std::string> whole_;
};

std::string names(int generation) { return ": generation " + to_text(generation) + " is not "; }

/// Another digit at a place of a line that has one, and that is no digit of its first field.
bool alter(std::string &line, Stream &stream) {
    std::vector<std::size_t> digits;
    for (std::size_t at = line.find(','); at < line.size(); ++at)
        if (line[at] >= '0' && line[at] <= '9') digits.push_back(at);
    if (digits.empty()) return false;
    char &digit = line[digits[stream.below(static_cast<std::uint32_t>(digits.size()))]];
    digit = static_cast<char>('0' + (digit - '0' + 1 + static_cast<int>(stream.below(9))) % 10);
    return true;
}

template <class T> const T &drawn(const std::vector<T> &from, Stream &stream) {
    return from[stream.below(static_cast<std::uint32_t>(from.size()))];
}

const std::vector<std::string> tables{run_tables.begin(), run_tables.end()};

/// Alters a folder by chance; what must be said of it.
std::string alter_folder(const fs::path &place, Stream &stream) {
    const auto state = [&] { return state_path(place, stream.chance(0.5) ? 25 : 31); };
    const auto maybe_mend = [&] {
        if (stream.chance(0.5)) mend(place);
    };
    const std::uint32_t kind = stream.below(9);
    switch (kind) {
    case 0: // a digit in the row of a table
    case 1: {
        const std::string table = drawn(tables, stream);
        std::vector<std::string> lines = lines_of(text_of(place, table));
        std::string &line = lines[1 + stream.below(static_cast<std::uint32_t>(lines.size() - 1))];
        const int generation = std::stoi(line);
        while (!alter(line, stream)) line.insert(line.find(',') + 1, "1");
        put(place / table, joined(lines));
        maybe_mend();
        return names(generation);
    }
    case 2: { // two generations of a table exchanged
        const std::string table = drawn(tables, stream);
        std::vector<std::string> lines = lines_of(text_of(place, table));
        const int first = std::stoi(lines[1 + stream.below(static_cast<std::uint32_t>(lines.size() - 1))]);
        const auto other = std::find_if(lines.begin() + 1, lines.end(),
                                        [&](const std::string &line) { return std::stoi(line) != first; });
        if (other == lines.end()) return alter_folder(place, stream);
        const int second = std::stoi(*other);
        for (std::string &line : lines) {
            if (line.starts_with(to_text(first) + ","))
                line = to_text(second) + line.substr(line.find(','));
            else if (line.starts_with(to_text(second) + ","))
                line = to_text(first) + line.substr(line.find(','));
        }
        std::stable_sort(lines.begin() + 1, lines.end(), [](const std::string &a, const std::string &b) {
            return std::stoi(a) < std::stoi(b);
        });
        // Two generations may have equal rows of sizes or of champions.
        if (joined(lines) == text_of(place, table)) return alter_folder(place, stream);
        put(place / table, joined(lines));
        maybe_mend();
        return names(std::min(first, second));
    }
    case 3: { // a row that goes, or comes twice
        const std::string table = drawn(tables, stream);
        std::vector<std::string> lines = lines_of(text_of(place, table));
        const auto at = lines.begin() + 1 + stream.below(static_cast<std::uint32_t>(lines.size() - 1));
        const int generation = std::stoi(*at);
        if (stream.chance(0.5))
            lines.erase(at);
        else
            lines.insert(at, std::string(*at));
        put(place / table, joined(lines));
        maybe_mend();
        return names(generation);
    }
    case 4: { // a link or a content
        std::vector<ChainRow> chain = read_chain(place);
        ChainRow &row = chain[stream.below(generations)];
        char &digit = (stream.chance(0.5) ? row.link : row.content)[stream.below(64)];
        digit = digit == '5' ? '6' : '5';
        write_table<ChainRow>(place, chain);
        mend(place);
        return names(row.generation);
    }
    case 5: { // a bit of a kept state
        const fs::path path = state();
        std::string bytes = read_bytes(path);
        bytes[stream.below(static_cast<std::uint32_t>(bytes.size()))] ^=
            static_cast<char>(1 << stream.below(7));
        write_bytes(path, bytes);
        maybe_mend();
        return path.string() + ": ";
    }
    case 6: { // a kept state of another place
        const fs::path path = state();
        KeptState kept = read_state(path).value();
        const std::uint32_t what = stream.below(3);
        if (what == 0) kept.link[stream.below(64)] = 'x';
        if (what == 1) kept.identity[stream.below(64)] = 'x';
        if (what == 2) {
            fs::copy_file(state_path(place, kept.generation == 25 ? 31 : 25), path,
                          fs::copy_options::overwrite_existing);
        } else
            keep_state(place, kept);
        maybe_mend();
        return path.string() + ": ";
    }
    case 7: { // another seed
        write_bytes(place / "identity.csv",
                    replaced(read_bytes(place / "identity.csv"), "\nseed,6,", "\nseed,7,"));
        if (stream.chance(0.5)) return "it is of another run than identity.csv";
        mend(place, {{"identity", recorded_run(place).value().identity.sha256()}, {"seed", "7"}});
        return names(0);
    }
    default: { // a row of the manifest, sealed
        static const std::vector<std::pair<const char *, std::string>> rows{
            {"generations", "31"},
            {"generations", "33"},
            {"population", "7"},
            {"evaluations", "191"},
            {"record", "sample"},
            {"seed", "7"},
            {"link", std::string(64, 'a')},
            {"identity", std::string(64, 'b')},
            {"chain.csv", std::string(64, 'c')},
            {"script/experiment.lua", std::string(64, 'd')}};
        const auto &[key, value] = drawn(rows, stream);
        mend(place, {{key, value}});
        return "";
    }
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(an_unchanged_run_agrees_with_itself_and_with_the_model) {
    for (const std::string search : {"neat", "novelty"})
        for (const Recording record : {full_record, sample_record}) {
            const Audited run(search, 27, record);
            BOOST_TEST(run.inconsistency() == "");
            for (const Stretch &stretch : stretches(open_run(run.place)))
                BOOST_TEST(run.refuted(stretch) == "");
        }
}

BOOST_AUTO_TEST_CASE(without_the_kept_states_before_the_last_an_audit_simulates_longer_stretches) {
    const Audited run;
    BOOST_TEST(stretches(open_run(run.place)).size() == 3u);
    fs::remove(state_path(run.place, 25));
    BOOST_TEST(run.inconsistency() == "");
    const std::vector<Stretch> longer = stretches(open_run(run.place));
    BOOST_REQUIRE(longer.size() == 2u);
    BOOST_TEST(longer[0].first == 0);
    BOOST_TEST(longer[0].last == 30);
    for (const Stretch &stretch : longer) BOOST_TEST(run.refuted(stretch) == "");
    fs::remove(state_path(run.place, 31));
    BOOST_TEST(contains(run.inconsistency(), " lacks states/000031.state"));
}

BOOST_AUTO_TEST_CASE(an_audit_takes_from_the_record_how_much_is_recorded) {
    // Of 6 individuals in a generation some are left out after 167 generations.
    constexpr int length = 180;
    Audited run("neat", length, sample_record);
    BOOST_REQUIRE(read_table<IndividualRow>(run.place).size() < 6u * length);
    run.spec.record = full_record;
    BOOST_TEST(run.refuted({100, length - 2}) == "");
}

BOOST_AUTO_TEST_CASE(a_run_that_is_becoming_longer_agrees_with_itself_meanwhile) {
    const Audited run("novelty", 4);
    quick::run_on(run.place, quick::spec("novelty", 8), 4 * quick::population + 1, quick::End::killed, 2);
    BOOST_TEST((kept_generations(run.place) == std::vector{3, 7}));
    BOOST_TEST(run.inconsistency() == "");
    for (const Stretch &stretch : stretches(open_run(run.place))) BOOST_TEST(run.refuted(stretch) == "");
}

BOOST_AUTO_TEST_CASE(every_alteration_is_found_and_its_generation_named) {
    const Audited run;
    Stream stream(11, 0, 0, Purpose::sampling);
    for (int trial = 0; trial < 100; ++trial) {
        const std::string expected = alter_folder(run.place, stream), said = run.inconsistency();
        BOOST_TEST(!said.empty(), "trial " << trial << ": " << expected);
        BOOST_TEST(contains(said, expected), "trial " << trial << ": " << said << ", and not " << expected);
        run.restore();
    }
    BOOST_TEST(run.inconsistency() == "");
}

BOOST_AUTO_TEST_CASE(rows_that_were_forged_with_all_hashes_are_found_by_simulating_them_again) {
    for (const std::string table : {"generations.csv", "individuals.csv.gz", "sizes.csv.gz"}) {
        const Audited run;
        for (const int generation : {0, 12, 24, 25, 31}) {
            std::vector<std::string> lines = lines_of(text_of(run.place, table));
            const auto row = std::find_if(lines.begin(), lines.end(), [&](const std::string &line) {
                return line.starts_with(to_text(generation) + ",");
            });
            const std::size_t last = row->find_last_of("0123456789");
            (*row)[last] = (*row)[last] == '7' ? '3' : '7';
            put(run.place / table, joined(lines));
            relink(run.place);
            BOOST_TEST(run.inconsistency() == "");
            for (const Stretch &stretch : stretches(open_run(run.place))) {
                const bool is_there = stretch.first <= generation && generation <= stretch.last;
                const std::string said = run.refuted(stretch);
                BOOST_TEST(said == (is_there ? run.place.string() + names(generation) +
                                                   "what simulating it again gives: its rows differ"
                                             : ""));
            }
            run.restore();
        }
    }
}

BOOST_AUTO_TEST_CASE(a_content_that_was_forged_with_all_links_is_found_by_simulating_it_again) {
    const Audited run;
    std::vector<ChainRow> chain = read_chain(run.place);
    chain[9].content = sha256("invented");
    write_table<ChainRow>(run.place, chain);
    relink(run.place);
    BOOST_TEST(run.inconsistency() == "");
    BOOST_TEST(run.refuted({0, 24}) ==
               run.place.string() + names(9) + "what simulating it again gives: its genomes or lives differ");
    BOOST_TEST(run.refuted({25, 30}) == "");
}

BOOST_AUTO_TEST_CASE(a_kept_state_that_was_forged_is_found_by_simulating_up_to_it_and_from_it) {
    const Audited run;
    const auto forged = [&](const std::function<void(KeptState &)> &forge) {
        KeptState kept = read_state(state_path(run.place, 25)).value();
        forge(kept);
        keep_state(run.place, kept);
        mend(run.place);
        BOOST_TEST(run.inconsistency() == "");
        BOOST_TEST(run.refuted({0, 24}) == state_path(run.place, 25).string() +
                                               ": the kept state is not what simulating up to it gives");
        const std::string said = run.refuted({25, 30});
        run.restore();
        return said;
    };
    // Other genomes.
    BOOST_TEST(contains(forged([&](KeptState &kept) {
                            RunState state = read_run_state(open_run(run.place), run.spec, 25);
                            for (LinkGene &link : state.population.genomes.back().links) link.weight += 0.125;
                            for (Species &species : state.population.species)
                                species.representative = state.population.genomes[species.members.front()];
                            StateWriter saved;
                            save(state, saved);
                            kept.state = saved.bytes();
                        }),
                        names(25)));
    // Another best fitness, by which a longer run would have other champions.
    BOOST_TEST(forged([](KeptState &kept) { kept.best_fitness += 1; }) == "");
    // Another part of the archive.
    BOOST_TEST(contains(forged([](KeptState &kept) { kept.archive -= 1; }), "its archive has "));
}

BOOST_AUTO_TEST_CASE(another_judge_is_found_in_the_first_generation) {
    Audited run("novelty", 5);
    run.spec.judge = [](const Life &life) { return Evaluation{life.elongation, {life.elongation, 0}, 1}; };
    BOOST_TEST(contains(run.refuted({0, 3}), names(0)));
}

BOOST_AUTO_TEST_CASE(stretches_have_every_generation_once) {
    const Audited run("neat", 27);
    const auto lengths = [](const fs::path &place) {
        std::vector<std::pair<int, int>> all;
        for (const Stretch &stretch : stretches(open_run(place)))
            all.emplace_back(stretch.first, stretch.last);
        return all;
    };
    using Pairs = std::vector<std::pair<int, int>>;
    BOOST_TEST((lengths(run.place) == Pairs{{0, 24}, {25, 25}, {26, 26}}));
    const TemporaryFolder folder;
    for (const int length : {1, 2, 3, 26, 52, 101}) {
        const Spec spec = fake_spec("osc", length, 2);
        const auto place =
            write_fake_run(folder / to_text(length), spec, 1, [](int, int) { return FakeLife{}; });
        int next = 0;
        for (const Stretch &stretch : stretches(open_run(place))) {
            BOOST_TEST(stretch.first == next);
            BOOST_TEST(stretch.length() >= 1);
            BOOST_TEST(stretch.length() == stretch.last - stretch.first + 1);
            next = stretch.last + 1;
        }
        BOOST_TEST(next == length);
    }
}

BOOST_AUTO_TEST_CASE(an_order_is_drawn_of_all_and_by_the_draw_alone) {
    for (const int count : {0, 1, 2, 50}) {
        std::vector<int> order = drawn_order(count, 3);
        BOOST_TEST((order == drawn_order(count, 3)));
        std::sort(order.begin(), order.end());
        for (int i = 0; i < count; ++i) BOOST_TEST(order.at(static_cast<std::size_t>(i)) == i);
        BOOST_TEST(order.size() == static_cast<std::size_t>(count));
    }
    BOOST_TEST((drawn_order(50, 3) != drawn_order(50, 4)));
    // Each comes first about as often.
    std::vector<int> first(5);
    for (std::uint64_t draw = 0; draw < 1000; ++draw)
        ++first[static_cast<std::size_t>(drawn_order(5, draw).front())];
    for (const int count : first) BOOST_TEST((count > 140 && count < 260), count);
}

BOOST_AUTO_TEST_CASE(simulating_again_may_be_stopped_and_is_the_same_on_any_number_of_threads) {
    const Audited run("novelty", 5);
    BOOST_CHECK_THROW(
        recompute(open_run(run.place), run.spec, {0, 3}, 2, [asked = 0]() mutable { return asked++ == 9; }),
        Stopped);
    BOOST_CHECK_NO_THROW(recompute(open_run(run.place), run.spec, {0, 3}, 3, never));
}
