// SPDX-License-Identifier: MIT
#include "storage/gzip.h"

#include "base/check.h"

#include <zlib.h>

namespace planula {

struct Gzip::Stream {
    z_stream state{};
    gz_header header{};
};

Gzip::Gzip() : stream_(std::make_unique<Stream>()) {
    constexpr int level = 6, gzip_window = 15 + 16, memory = 8;
    CHECK(deflateInit2(&stream_->state, level, Z_DEFLATED, gzip_window, memory, Z_DEFAULT_STRATEGY) == Z_OK);
    stream_->header.time = 0;
    stream_->header.os = 255;
    CHECK(deflateSetHeader(&stream_->state, &stream_->header) == Z_OK);
}

Gzip::~Gzip() { deflateEnd(&stream_->state); }

std::string Gzip::compress(std::string_view bytes, bool last) {
    z_stream &state = stream_->state;
    std::string out;
    state.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(bytes.data()));
    state.avail_in = static_cast<uInt>(bytes.size());
    int code = Z_OK;
    do {
        char chunk[1 << 16];
        state.next_out = reinterpret_cast<Bytef *>(chunk);
        state.avail_out = sizeof chunk;
        code = deflate(&state, last ? Z_FINISH : Z_NO_FLUSH);
        CHECK(code != Z_STREAM_ERROR);
        out.append(chunk, sizeof chunk - state.avail_out);
    } while (state.avail_out == 0);
    CHECK(!last || code == Z_STREAM_END);
    return out;
}

std::string gzipped(std::string_view content) { return Gzip().compress(content, true); }

} // namespace planula
