// SPDX-License-Identifier: MIT
#include "storage/packed.h"

#include "base/check.h"
#include "base/error.h"
#include "base/state.h"

#include <cstdint>
#include <lzma.h>

namespace planula {

namespace {

constexpr std::int64_t most_times = 16;
constexpr std::uint64_t decoder_memory = std::uint64_t{64} << 20;

const std::uint8_t *bytes_of(std::string_view text) {
    return reinterpret_cast<const std::uint8_t *>(text.data());
}
std::uint8_t *bytes_of(std::string &text) { return reinterpret_cast<std::uint8_t *>(text.data()); }

/// The quickest preset, told that the content is words of eight bytes, and with a choice among repetitions. Of 300
/// genomes of 149 links it makes 171 kB in 50 ms; without the choice, 176 kB in 40 ms (paper/decisions/0019-runs.md).
lzma_options_lzma options() {
    constexpr std::uint32_t quickest = 0, word_bits = 3;
    lzma_options_lzma options;
    CHECK(!lzma_lzma_preset(&options, quickest));
    options.dict_size = std::uint32_t{1} << 20;
    options.lc = 0;
    options.lp = options.pb = word_bits;
    options.mode = LZMA_MODE_NORMAL;
    options.nice_len = 32;
    return options;
}

std::string compressed(std::string_view content) {
    lzma_options_lzma chosen = options();
    lzma_filter filters[] = {{LZMA_FILTER_LZMA2, &chosen}, {LZMA_VLI_UNKNOWN, nullptr}};
    std::string packed(lzma_stream_buffer_bound(content.size()), '\0');
    std::size_t size = 0;
    CHECK(lzma_stream_buffer_encode(filters, LZMA_CHECK_CRC32, nullptr, bytes_of(content), content.size(),
                                    bytes_of(packed), &size, packed.size()) == LZMA_OK);
    packed.resize(size);
    return packed;
}

/// Whether the stored bytes are exactly a stream that fills the content.
bool decompress(std::string_view stored, std::string &content) {
    std::uint64_t memory = decoder_memory;
    std::size_t read = 0, written = 0;
    const lzma_ret state =
        lzma_stream_buffer_decode(&memory, 0, nullptr, bytes_of(stored), &read, stored.size(),
                                  bytes_of(content), &written, content.size());
    return state == LZMA_OK && read == stored.size() && written == content.size();
}

} // namespace

std::string pack(std::string_view content) {
    const std::string packed = compressed(content);
    const bool shrinks = packed.size() < content.size() && content.size() <= most_times * packed.size();
    StateWriter writer;
    writer.group("packed").integer(shrinks).integer(static_cast<std::int64_t>(content.size()));
    writer.text(shrinks ? std::string_view(packed) : content);
    return writer.bytes();
}

std::string unpack(std::string_view bytes) {
    StateReader reader(bytes);
    reader.group("packed");
    const bool shrunk = reader.integer(0, 1) == 1;
    const std::int64_t length = reader.integer(0, most_times * static_cast<std::int64_t>(bytes.size()));
    std::string stored = reader.text();
    reader.done();
    if (!shrunk) {
        if (static_cast<std::int64_t>(stored.size()) != length) reader.refuse("its length is wrong");
        return stored;
    }
    std::string content(static_cast<std::size_t>(length), '\0');
    if (!decompress(stored, content)) reader.refuse("the compressed bytes are invalid");
    return content;
}

} // namespace planula
