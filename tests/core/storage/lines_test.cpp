// SPDX-License-Identifier: MIT
#include "storage/lines.h"

#include "base/error.h"
#include "base/text.h"
#include "core/storage/temporary_folder.h"
#include "storage/output.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

std::vector<std::string> lines_of(const std::filesystem::path &path) {
    std::vector<std::string> all;
    Lines lines(path);
    while (lines.next()) all.push_back(lines.line());
    BOOST_TEST(!lines.next());
    return all;
}

using Texts = std::vector<std::string>;

} // namespace

BOOST_AUTO_TEST_CASE(every_line_comes_once_and_unchanged) {
    const TemporaryFolder folder;
    const std::string text = "a,b\n\n \"c\r\n,\n";
    write_file(folder / "plain", text);
    write_file(folder / "packed.gz", text);
    for (const char *name : {"plain", "packed.gz"})
        BOOST_TEST((lines_of(folder / name) == Texts{"a,b", "", " \"c\r", ","}));
}

BOOST_AUTO_TEST_CASE(a_last_line_without_an_end_is_a_line) {
    const TemporaryFolder folder;
    for (const auto &[text, expected] : {std::pair{"", Texts{}},
                                         {"\n", Texts{""}},
                                         {"a", Texts{"a"}},
                                         {"a\nb", Texts{"a", "b"}},
                                         {"a\n\n", Texts{"a", ""}}}) {
        write_file(folder / "file", text);
        BOOST_TEST((lines_of(folder / "file") == expected), text);
    }
}

BOOST_AUTO_TEST_CASE(lines_of_any_length_are_whole_wherever_the_buffer_ends) {
    const TemporaryFolder folder;
    constexpr std::size_t buffer = 65'536;
    for (const std::size_t length : {buffer - 2, buffer - 1, buffer, buffer + 1, 3 * buffer}) {
        const Texts expected{std::string(length, 'x'), "second", std::string(length, 'y'), "last"};
        std::string text;
        for (const std::string &line : expected) text += line + '\n';
        write_file(folder / "file.gz", text);
        BOOST_TEST((lines_of(folder / "file.gz") == expected), length);
    }
}

BOOST_AUTO_TEST_CASE(a_file_that_is_not_there_or_cut_off_is_an_error) {
    const TemporaryFolder folder;
    BOOST_CHECK_THROW(Lines(folder / "nowhere"), InputError);
    std::string text;
    for (int i = 0; i < 20'000; ++i) text += to_text(i * 7919 % 10'007) + "\n";
    write_file(folder / "whole.gz", text);
    const std::string bytes = read_bytes(folder / "whole.gz");
    write_bytes(folder / "cut.gz", bytes.substr(0, bytes.size() / 2));
    BOOST_CHECK_THROW(lines_of(folder / "cut.gz"), InputError);
}
