// SPDX-License-Identifier: MIT
#include "record/packed.h"

#include "base/check.h"
#include "base/error.h"
#include "base/state.h"

#include <cstdint>
#include <lzma.h>

namespace planula {

namespace {

constexpr std::int64_t most_times = 16;
constexpr std::uint32_t preset = 0; // half the time of the next one, and a twentieth larger
constexpr std::uint64_t decoder_memory = std::uint64_t{64} << 20;

const std::uint8_t *bytes_of(std::string_view text) {
    return reinterpret_cast<const std::uint8_t *>(text.data());
}
std::uint8_t *bytes_of(std::string &text) { return reinterpret_cast<std::uint8_t *>(text.data()); }

std::string compressed(std::string_view content) {
    std::string packed(lzma_stream_buffer_bound(content.size()), '\0');
    std::size_t size = 0;
    CHECK(lzma_easy_buffer_encode(preset, LZMA_CHECK_CRC32, nullptr, bytes_of(content), content.size(),
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
    if (!decompress(stored, content)) reader.refuse("the compressed bytes make no sense");
    return content;
}

} // namespace planula
