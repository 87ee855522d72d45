// SPDX-License-Identifier: MIT
#include "storage/output.h"

#include "base/check.h"
#include "storage/gzip.h"
#include "storage/system.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace planula {

namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 16;

/// Fills the buffer from an open file as far as one call does; 0 at the end.
std::size_t read_some(int file, std::string &buffer, const std::filesystem::path &path) {
    for (;;) {
        const ssize_t size = ::read(file, buffer.data(), buffer.size());
        if (size >= 0) return static_cast<std::size_t>(size);
        if (errno != EINTR) fail<IoError>("read", path, errno);
    }
}

} // namespace

Output::Output(std::filesystem::path path) : path_(std::move(path)), temporary_(path_) {
    temporary_ += ".tmp";
    file_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file_ < 0) fail<CreateError>("create", path_, errno);
    if (path_.extension() == ".gz") gzip_ = std::make_unique<Gzip>();
}

Output::~Output() {
    if (file_ < 0) return;
    ::close(file_);
    ::unlink(temporary_.c_str());
}

void Output::write(std::string_view bytes) {
    hash_.bytes(bytes.data(), bytes.size());
    while (!bytes.empty()) {
        const std::string_view piece = bytes.substr(0, buffer_size - pending_.size());
        pending_.append(piece);
        bytes.remove_prefix(piece.size());
        if (pending_.size() == buffer_size) flush(false);
    }
}

void Output::flush(bool last) {
    const std::string bytes = gzip_ ? gzip_->compress(pending_, last) : std::move(pending_);
    pending_.clear();
    write_all(file_, bytes, path_);
}

std::string Output::commit() {
    CHECK(file_ >= 0, path_);
    flush(true);
    sync_file(file_, path_);

    // Once closed, the temporary is this function's to remove.
    const int closed = ::close(file_);
    int failure = closed == 0 ? 0 : errno;
    file_ = -1;
    if (failure == 0 && ::rename(temporary_.c_str(), path_.c_str()) != 0) failure = errno;
    if (failure != 0) {
        ::unlink(temporary_.c_str());
        fail<IoError>("finish", path_, failure);
    }
    sync_folder(path_.parent_path());
    return hash_.hex();
}

std::string write_file(const std::filesystem::path &path, std::string_view content) {
    Output output(path);
    output.write(content);
    return output.commit();
}

void copy_file(const std::filesystem::path &from, const std::filesystem::path &to) {
    const int source = ::open(from.c_str(), O_RDONLY | O_CLOEXEC);
    if (source < 0) fail<IoError>("open", from, errno);
    const int target = ::open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (target < 0) {
        const int failure = errno;
        ::close(source);
        fail<CreateError>("create", to, failure);
    }
    try {
        std::string buffer(buffer_size, '\0');
        while (const std::size_t size = read_some(source, buffer, from))
            write_all(target, std::string_view(buffer).substr(0, size), to);
        sync_file(target, to);
    } catch (...) {
        ::close(source);
        ::close(target);
        throw;
    }
    ::close(source);
    if (::close(target) != 0) fail<IoError>("finish", to, errno);
}

void make_folder(const std::filesystem::path &folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw CreateError("cannot create folder " + folder.string() + ": " + error.message());
}

void remove_file(const std::filesystem::path &path) {
    if (::unlink(path.c_str()) == 0)
        sync_folder(path.parent_path());
    else if (errno != ENOENT)
        fail<IoError>("remove", path, errno);
}

FolderLock::FolderLock(const std::filesystem::path &folder)
    : file_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (file_ < 0) fail<CreateError>("open folder", folder, errno);
    if (::flock(file_, LOCK_EX | LOCK_NB) == 0) return;
    const int failure = errno;
    ::close(file_);
    if (failure == EWOULDBLOCK) throw RefusedError(folder.string() + " is in use by another process");
    fail<CreateError>("lock folder", folder, failure);
}

FolderLock::~FolderLock() { ::close(file_); }

} // namespace planula
