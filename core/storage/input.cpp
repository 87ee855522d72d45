// SPDX-License-Identifier: MIT
#include "storage/input.h"

#include "base/error.h"
#include "base/hash.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <vector>
#include <zlib.h>

namespace planula {

namespace {

std::string reason(int number) { return std::generic_category().message(number); }

constexpr std::size_t largest_content = std::size_t{1} << 30; // of what is read as a whole

gzFile handle(void *stream) { return static_cast<gzFile>(stream); }

} // namespace

Input::Input(std::filesystem::path path) : path_(std::move(path)), packed_(path_.extension() == ".gz") {
    // Without waiting for somebody to write into a pipe.
    const int file = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0) {
        const int failure = errno;
        const std::string said = "cannot open " + path_.string() + ": " + reason(failure);
        if (failure == ENOENT || failure == ENOTDIR) throw InputError(said);
        throw IoError(said);
    }
    struct stat about {};
    if (::fstat(file, &about) == 0 && (S_ISDIR(about.st_mode) || S_ISFIFO(about.st_mode))) {
        ::close(file);
        throw InputError(path_.string() + ": is not a file");
    }
    stream_ = gzdopen(file, "rb");
    if (stream_ == nullptr) {
        ::close(file);
        throw IoError("cannot open " + path_.string() + ": out of memory");
    }
}

namespace {

/// What zlib says, in brackets, without the name that it gives the stream, as in "<fd:3>: incorrect data check".
std::string reason_of(const std::string &said) {
    const std::size_t colon = said.find(": ");
    const std::string reason = colon == std::string::npos ? said : said.substr(colon + 2);
    return reason.empty() ? "" : " (" + reason + ")";
}

} // namespace

Input::~Input() { gzclose_r(handle(stream_)); }

int Input::read(char *buffer, int size) {
    int filled = 0;
    while (filled < size) {
        const int got = gzread(handle(stream_), buffer + filled, static_cast<unsigned>(size - filled));

        // zlib reports a stream that is cut off only beside a short count.
        int state = Z_OK;
        const std::string said = gzerror(handle(stream_), &state);
        if (state == Z_ERRNO) throw IoError("cannot read " + path_.string() + ": " + reason(errno));
        if (state == Z_BUF_ERROR) throw InputError(path_.string() + ": the compressed data are cut off");
        if (got < 0 || state < 0)
            throw InputError(path_.string() + ": damaged compressed data" + reason_of(said));
        const bool unpacked = !gzdirect(handle(stream_));
        if (packed_ && !unpacked) throw InputError(path_.string() + ": not a gzip file");
        if (!packed_ && unpacked)
            throw InputError(path_.string() + ": a gzip file whose name does not say so");
        if (got == 0) break;
        filled += got;
    }
    return filled;
}

std::string read_file(const std::filesystem::path &path) {
    Input input(path);
    std::string content;
    std::vector<char> buffer(std::size_t{1} << 16);
    while (const int size = input.read(buffer.data(), static_cast<int>(buffer.size()))) {
        content.append(buffer.data(), static_cast<std::size_t>(size));
        if (content.size() > largest_content) throw InputError(path.string() + ": is larger than 1 GiB");
    }
    return content;
}

std::string content_sha256(const std::filesystem::path &path) {
    Input input(path);
    Hash hash;
    std::vector<char> buffer(std::size_t{1} << 16);
    while (const int size = input.read(buffer.data(), static_cast<int>(buffer.size())))
        hash.bytes(buffer.data(), static_cast<std::size_t>(size));
    return hash.hex();
}

} // namespace planula
