// SPDX-License-Identifier: MIT
// planula: the command line. The experiments of this program are in a folder beside the one that it was built in, the
// bundled scripts of reports in a folder of that one.
#include "program/commands.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <iostream>

#include <fcntl.h>
#include <unistd.h>

namespace {

/// Opens the standard descriptors that were closed when the program started: no file of a run may get their numbers.
void open_standard_descriptors() {
    for (int file = 0; file <= 2; ++file)
        if (::fcntl(file, F_GETFD) == -1 && errno == EBADF && ::open("/dev/null", O_RDWR) != file)
            std::abort(); // the lowest free number is the one that was closed
}

} // namespace

int main(int count, char **words) {
    open_standard_descriptors();
    // Writing into a pipe that is closed is reported as an error.
    std::signal(SIGPIPE, SIG_IGN);
    std::error_code unknown;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
    const auto library = (program.parent_path() / ".." / "experiments").lexically_normal();
    planula::Console console{std::cout, std::cerr, isatty(STDERR_FILENO) == 1, library,
                             program.parent_path() / "page"};
    return planula::run_program({words + 1, words + count}, console);
}
