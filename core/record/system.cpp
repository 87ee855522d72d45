// SPDX-License-Identifier: MIT
#include "record/system.h"

#include "base/error.h"

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
