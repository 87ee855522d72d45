// SPDX-License-Identifier: MIT
#include "storage/system.h"

#include "base/error.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

namespace planula {

void write_all(int file, std::string_view bytes, const std::filesystem::path &path) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail<IoError>("write", path, errno);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void sync_file(int file, const std::filesystem::path &path) {
    if (::fsync(file) != 0) fail<IoError>("sync", path, errno);
}

std::vector<std::filesystem::path> entries_of(const std::filesystem::path &folder) {
    std::vector<std::filesystem::path> entries;
    std::error_code failure;
    std::filesystem::directory_iterator at(folder, failure);
    for (const std::filesystem::directory_iterator end; !failure && at != end; at.increment(failure))
        entries.push_back(at->path());
    if (failure) fail<IoError>("list the folder", folder, failure.value());
    std::sort(entries.begin(), entries.end());
    return entries;
}

std::vector<std::filesystem::path> all_below(const std::filesystem::path &folder) {
    std::vector<std::filesystem::path> all;
    for (const std::filesystem::path &entry : entries_of(folder)) {
        all.push_back(entry);
        if (!std::filesystem::is_directory(std::filesystem::symlink_status(entry))) continue;
        const std::vector<std::filesystem::path> deeper = all_below(entry);
        all.insert(all.end(), deeper.begin(), deeper.end());
    }
    return all;
}

void sync_folder(const std::filesystem::path &folder) {
    const std::filesystem::path named = folder.empty() ? "." : folder;
    const int handle = ::open(named.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle < 0) fail<IoError>("open folder", named, errno);

    // File systems without this notion say EINVAL.
    const int failure = ::fsync(handle) == 0 || errno == EINVAL ? 0 : errno;
    ::close(handle);
    if (failure != 0) fail<IoError>("sync folder", named, failure);
}

} // namespace planula
