// SPDX-License-Identifier: MIT
#include "page/page.h"

#include "base/error.h"
#include "storage/input.h"
#include "support/folder.h"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace planula;
using namespace planula::test;

namespace {

/// The bytes behind a text in Base64 (RFC 4648).
std::string decoded(const std::string &text) {
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    BOOST_REQUIRE(text.size() % 4 == 0u);
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char letter : text) {
        if (letter == '=') break;
        BOOST_REQUIRE(alphabet.find(letter) != alphabet.npos);
        bits = bits << 6 | static_cast<unsigned>(alphabet.find(letter));
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 255);
    }
    return bytes;
}

bool has(std::string_view text, std::string_view part) { return text.find(part) != text.npos; }

} // namespace

BOOST_AUTO_TEST_CASE(packed_texts_are_gzip_in_base64_whatever_their_length) {
    const Folder folder;
    for (std::size_t length = 0; length < 40; ++length) {
        std::string text;
        for (std::size_t i = 0; i < length; ++i) text += static_cast<char>('a' + i * i % 26);
        folder.write("text.gz", decoded(packed_for_page(text)));
        BOOST_TEST(read_file(folder.path / "text.gz") == text);
    }
}

BOOST_AUTO_TEST_CASE(a_page_is_filled_with_each_text_once) {
    BOOST_TEST(filled_page("a {{x}} b {{y}}{{x}}", {{"x", "{{y}}"}, {"y", "2"}}) == "a {{y}} b 2{{y}}");
    BOOST_CHECK_THROW(filled_page("{{z}}", {{"x", "1"}}), std::exception);
}

BOOST_AUTO_TEST_CASE(a_module_travels_in_the_page_and_nothing_else_does) {
    const Folder folder;
    folder.write("planula.js", "var planulaModule = \"a\\n</script>\";");
    folder.write("other.js", "alert()");
    const std::string module = packed_module(folder.path / "planula.js");
    BOOST_TEST(has(replay_page("a", "{}", module), ">" + module + "</script>"));
    folder.write("text.gz", decoded(module));
    BOOST_TEST(read_file(folder.path / "text.gz") == R"("var planulaModule = \"a\\n</script>\";")");
    BOOST_CHECK_THROW(packed_module(folder.path / "other.js"), InputError);
    BOOST_TEST(has(replay_page("a", "{}"), "<script id=\"module\" type=\"application/gzip\"></script>"));
}

BOOST_AUTO_TEST_CASE(a_replay_needs_nothing_beside_its_page) {
    const std::string page = replay_page("a < b & c", "{\"format\":\"none\"}");
    BOOST_TEST(has(page, "<title>a &lt; b &amp; c</title>"));
    BOOST_TEST(has(page, packed_for_page("{\"format\":\"none\"}")));
    BOOST_TEST(has(page, viewer_script()));
    BOOST_TEST(has(page, viewer_style()));
    BOOST_TEST(has(viewer_script(), "planula.mountReplay = "));
    for (const char *outside : {"http:", "https:", "src=", "url(", "@import"}) {
        std::string rest = page;
        for (const std::string name : {"http://www.w3.org/2000/svg"})
            for (std::size_t at = 0; (at = rest.find(name)) != rest.npos;) rest.erase(at, name.size());
        BOOST_TEST(!has(rest, outside), outside);
    }
    // A script ends where the first "</script" is.
    BOOST_TEST(!has(viewer_script(), "</script"));
    BOOST_TEST(!has(viewer_style(), "</style"));
}
