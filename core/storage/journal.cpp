// SPDX-License-Identifier: MIT
#include "storage/journal.h"

#include "base/error.h"
#include "base/text.h"
#include "storage/input.h"
#include "storage/output.h"
#include "storage/system.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>
#include <vector>

namespace planula {

namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 16;

/// Hands the first `length` bytes of a file to visit(bytes), piece by piece; how many there were.
template <class Visit>
std::int64_t each_piece(const std::filesystem::path &path, std::int64_t length, Visit &&visit) {
    Input input(path);
    std::vector<char> buffer(buffer_size);
    std::int64_t read = 0;
    while (read < length) {
        const auto wanted = std::min<std::int64_t>(length - read, static_cast<std::int64_t>(buffer.size()));
        const int size = input.read(buffer.data(), static_cast<int>(wanted));
        if (size == 0) break;
        visit(std::string_view(buffer.data(), static_cast<std::size_t>(size)));
        read += size;
    }
    return read;
}

/// What was read of a file must be what a mark says.
void check(const std::filesystem::path &path, std::int64_t length, const std::string &sha256,
           const JournalMark &mark) {
    if (length != mark.length)
        throw InputError(path.string() + ": " + to_text(length) + " bytes, where the kept state knows of " +
                         to_text(mark.length) + ": it was cut after the run had stopped");
    if (sha256 != mark.sha256) throw InputError(path.string() + ": it was changed after the run had stopped");
}

} // namespace

void check_mark(const std::filesystem::path &path, const JournalMark &mark) {
    Hash hash;
    const std::int64_t length = each_piece(
        path, mark.length, [&](std::string_view bytes) { hash.bytes(bytes.data(), bytes.size()); });
    check(path, length, hash.hex(), mark);
}

std::filesystem::path journal_path(const std::filesystem::path &target) {
    std::filesystem::path path = target;
    return path += ".part";
}

Journal::Journal(std::filesystem::path target, const JournalStart &start)
    : target_(std::move(target)), path_(journal_path(target_)) {
    using From = JournalStart::From;
    if (start.from == From::nothing)
        open(O_CREAT | O_TRUNC);
    else if (start.from == From::journal)
        resume(start.mark);
    else
        copy(start.mark);
}

void Journal::open(int flags) {
    file_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
    if (file_ < 0) fail<CreateError>("open", path_, errno);
}

void Journal::resume(const JournalMark &mark) {
    // The beginning must be what the mark says, before anything is cut.
    length_ = each_piece(path_, mark.length,
                         [&](std::string_view bytes) { hash_.bytes(bytes.data(), bytes.size()); });
    check(path_, length_, hash_.hex(), mark);
    kept_ = true;
    open(O_APPEND);
    if (::ftruncate(file_, mark.length) == 0) return;
    const int failure = errno;
    ::close(file_);
    fail<IoError>("cut", path_, failure);
}

void Journal::copy(const JournalMark &mark) {
    open(O_CREAT | O_TRUNC);
    try {
        each_piece(target_, mark.length, [&](std::string_view bytes) { write(bytes); });
        check(target_, length_, hash_.hex(), mark);
        flush();
    } catch (...) {
        ::close(file_);
        ::unlink(path_.c_str());
        throw;
    }
}

Journal::~Journal() {
    ::close(file_);
    if (!kept_) ::unlink(path_.c_str());
}

void Journal::write(std::string_view bytes) {
    hash_.bytes(bytes.data(), bytes.size());
    length_ += static_cast<std::int64_t>(bytes.size());
    pending_.append(bytes);
    if (pending_.size() >= buffer_size) flush();
}

void Journal::flush() {
    const std::string bytes = std::move(pending_);
    pending_.clear();
    write_all(file_, bytes, path_);
}

JournalMark Journal::mark() {
    flush();
    sync_file(file_, path_);
    kept_ = true;
    return {length_, hash_.hex()};
}

std::string Journal::publish() {
    flush();
    Output output(target_);
    Hash read;
    const std::int64_t length = each_piece(path_, length_, [&](std::string_view bytes) {
        read.bytes(bytes.data(), bytes.size());
        output.write(bytes);
    });
    if (length != length_)
        throw IoError("cannot read back " + path_.string() + ": it is shorter than what was written");
    if (read.hex() != hash_.hex()) throw IoError(path_.string() + " does not read back as it was written");
    return output.commit();
}

} // namespace planula
