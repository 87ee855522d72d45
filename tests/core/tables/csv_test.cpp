// SPDX-License-Identifier: MIT
#include "tables/csv.h"

#include "base/error.h"
#include "base/random.h"
#include "core/storage/temporary_folder.h"

#include <bit>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

using namespace planula;

namespace {

/// What reading a curves.csv of these bytes says.
std::string refusal(const std::string &bytes) {
    const TemporaryFolder folder;
    write_bytes(folder / "curves.csv", bytes);
    std::string said = message_of<InputError>([&] { read_table<CurveRow>(folder.path()); });
    // The place starts with the file's name, wherever it lies.
    const std::string prefix = folder.path().string() + "/";
    return said.starts_with(prefix) ? said.substr(prefix.size()) : said;
}

const std::string header = "setting,generation,runs,mean,low,high\n";

} // namespace

BOOST_AUTO_TEST_CASE(numbers_come_back_with_the_same_bits) {
    using Limits = std::numeric_limits<double>;
    std::vector<double> values{0.0,           -0.0,          0.1,     1.0 / 3, Limits::denorm_min(),
                               Limits::max(), Limits::min(), -1e-300, 1e22,    9007199254740993.0};
    Stream stream(1, 0, 0, Purpose::sampling);
    while (values.size() < 2000) {
        const std::uint64_t high = stream.bits(), low = stream.bits();
        const double value = std::bit_cast<double>(high << 32 | low);
        if (std::isfinite(value)) values.push_back(value);
    }
    const TemporaryFolder folder;
    std::vector<CurveRow> rows;
    for (const double value : values) rows.push_back({"a", 1, 2, value, -value, value});
    write_table<CurveRow>(folder.path(), rows);
    const auto back = read_table<CurveRow>(folder.path());
    BOOST_REQUIRE(back.size() == values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        BOOST_TEST(std::bit_cast<std::uint64_t>(back[i].mean) == std::bit_cast<std::uint64_t>(values[i]));
        BOOST_TEST(std::bit_cast<std::uint64_t>(back[i].low.value()) ==
                   std::bit_cast<std::uint64_t>(-values[i]));
    }
}

BOOST_AUTO_TEST_CASE(any_text_of_one_line_reads_back_equal) {
    const TemporaryFolder folder;
    const std::vector<std::string> texts{"plain", "a,b",      "say \"yes\"", "\"", ",",
                                         "",      " spaced ", "π·Δx",        "'",  "\t"};
    std::vector<ManifestRow> rows;
    for (std::size_t i = 0; i < texts.size(); ++i) rows.push_back({"key" + std::to_string(i), texts[i]});
    write_table<ManifestRow>(folder.path(), rows);
    const auto back = read_table<ManifestRow>(folder.path());
    BOOST_REQUIRE(back.size() == texts.size());
    for (std::size_t i = 0; i < texts.size(); ++i) BOOST_TEST(back[i].value == texts[i]);
}

BOOST_AUTO_TEST_CASE(quoting_is_that_of_rfc_4180) {
    BOOST_TEST(to_field(std::string("a,b")) == "\"a,b\"");
    BOOST_TEST(to_field(std::string("say \"yes\"")) == "\"say \"\"yes\"\"\"");
    BOOST_TEST(to_field(std::string("it's")) == "it's");
}

BOOST_AUTO_TEST_CASE(an_empty_value_stays_empty) {
    const TemporaryFolder folder;
    const std::vector<ArchivePointRow> rows{{"a", 1, 2, 0.5, std::nullopt}, {"a", 1, 3, 0.5, 0.25}};
    write_table<ArchivePointRow>(folder.path(), rows);
    const auto back = read_table<ArchivePointRow>(folder.path());
    BOOST_TEST(!back.at(0).y.has_value());
    BOOST_TEST(back.at(1).y.value() == 0.25);
}

BOOST_AUTO_TEST_CASE(a_number_that_is_not_finite_is_never_written) {
    BOOST_CHECK_THROW(to_field(std::nan("")), InternalError);
    BOOST_CHECK_THROW(to_field(-std::numeric_limits<double>::infinity()), InternalError);
    BOOST_CHECK_THROW(to_field(Maybe(std::nan(""))), InternalError);
}

BOOST_AUTO_TEST_CASE(a_text_of_two_lines_is_refused) {
    BOOST_CHECK_THROW(to_field(std::string("two\nlines")), InputError);
    BOOST_CHECK_THROW(to_field(std::string("a\0b", 3)), InputError);
}

BOOST_AUTO_TEST_CASE(wrong_values_are_named_with_file_line_column_and_value) {
    BOOST_TEST(refusal(header + "a,1,2,0.5,0.5,0.5\na,1,2,fast,0.5,0.5\n") ==
               "curves.csv:3: column 'mean': 'fast' is not a finite number");
    BOOST_TEST(refusal(header + "a,1,2,1e999,0,0\n") ==
               "curves.csv:2: column 'mean': '1e999' is not a finite number");
    BOOST_TEST(refusal(header + "a,1,2,nan,0,0\n") ==
               "curves.csv:2: column 'mean': 'nan' is not a finite number");
    BOOST_TEST(refusal(header + "a,1,2,0,0,-inf\n") ==
               "curves.csv:2: column 'high': '-inf' is not a finite number");
    BOOST_TEST(refusal(header + "a,1,2,0,0, 1\n") ==
               "curves.csv:2: column 'high': ' 1' is not a finite number");
    BOOST_TEST(refusal(header + "a,1,2,,0,0\n") == "curves.csv:2: column 'mean': '' is not a finite number");
    BOOST_TEST(refusal(header + "a,2147483648,2,0,0,0\n") ==
               "curves.csv:2: column 'generation': '2147483648' is not a whole number of 32 bits");
    BOOST_TEST(refusal(header + "a,99999999999999999999,2,0,0,0\n") ==
               "curves.csv:2: column 'generation': '99999999999999999999' is not a whole number of 32 bits");
    BOOST_TEST(refusal(header + "a,1.5,2,0,0,0\n") ==
               "curves.csv:2: column 'generation': '1.5' is not a whole number of 32 bits");
}

BOOST_AUTO_TEST_CASE(wrong_shapes_are_named_with_file_and_line) {
    BOOST_TEST(refusal(header + "a,1,2,0,0\n") == "curves.csv:2: 5 fields, where the header has 6");
    BOOST_TEST(refusal(header + "a,1,2,0,0,0,0\n") == "curves.csv:2: 7 fields, where the header has 6");
    BOOST_TEST(refusal(header + "\n") == "curves.csv:2: 1 fields, where the header has 6");
    BOOST_TEST(refusal("setting,generation,runs,median,low,high\n") ==
               "curves.csv:1: column 4 is called 'median' and must be 'mean'");
    BOOST_TEST(refusal("setting,generation,runs,mean,low\n") ==
               "curves.csv:1: 5 columns, where there must be 6");
    BOOST_TEST(refusal("") == "curves.csv:1: the file is empty");
    BOOST_TEST(refusal(header + "\"a,1,2,0,0,0\n") == "curves.csv:2: a quoted field is not closed");
}

BOOST_AUTO_TEST_CASE(a_table_cut_off_at_any_byte_is_read_as_less_or_refused) {
    const std::string whole = header + "a,1,2,0.125,0.25,0.5\nb,3,4,0.125,0.25,0.75\n";
    const TemporaryFolder folder;
    for (std::size_t size = 0; size < whole.size(); ++size) {
        write_bytes(folder / "curves.csv", whole.substr(0, size));
        const std::string said = message_of<InputError>([&] { read_table<CurveRow>(folder.path()); });
        const bool at_line_end = size > 0 && whole[size - 1] == '\n';
        BOOST_TEST(said.empty() == at_line_end, size);
        if (!at_line_end && size > 0) BOOST_TEST(contains(said, ": the file ends in the middle of a line"));
    }
}

BOOST_AUTO_TEST_CASE(a_nul_byte_is_found_on_its_line) {
    BOOST_TEST(refusal(header + "a,1,2,0,0,0\n" + std::string("b\0,1,2,0,0,0\n", 13)) ==
               "curves.csv:3: a NUL byte");
}

BOOST_AUTO_TEST_CASE(a_line_without_end_is_refused_before_it_fills_memory) {
    BOOST_TEST(refusal(header + std::string(17'000'000, 'x') + "\n") ==
               "curves.csv:2: a line longer than 16 million bytes");
}

BOOST_AUTO_TEST_CASE(line_ends_of_other_systems_and_a_byte_order_mark_are_read) {
    const TemporaryFolder folder;
    write_bytes(folder / "curves.csv",
                "\xEF\xBB\xBFsetting,generation,runs,mean,low,high\r\na,1,2,0,0,0.5\r\n");
    const auto rows = read_table<CurveRow>(folder.path());
    BOOST_TEST(rows.at(0).setting == "a");
    BOOST_TEST(rows.at(0).high.value() == 0.5);
}

BOOST_AUTO_TEST_CASE(a_table_larger_than_the_readers_buffer_is_read_whole) {
    const TemporaryFolder folder;
    constexpr int count = 700'000; // 40 MB of text, several blocks of the library
    {
        TableWriter<IndividualRow> writer(folder.path());
        for (int i = 0; i < count; ++i)
            writer.write({.generation = i, .fitness = i / 3.0, .outcome = "viable"});
        writer.commit();
    }
    TableReader<IndividualRow> reader(folder.path());
    int rows = 0, wrong = 0;
    for (IndividualRow row; reader.next(row); ++rows)
        wrong += row.generation != rows || row.fitness != rows / 3.0;
    BOOST_TEST(rows == count);
    BOOST_TEST(wrong == 0);
}
