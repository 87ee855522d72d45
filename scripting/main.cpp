// SPDX-License-Identifier: MIT
// planula: the command line. The experiments that belong to this program lie beside the folder it was built
// in.
#include "scripting/commands.h"

#include <csignal>
#include <iostream>

#include <unistd.h>

int main(int count, char **words) {
    // A reader that goes away is an error to report, not a reason to die.
    std::signal(SIGPIPE, SIG_IGN);
    std::error_code unknown;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
    const auto library = (program.parent_path() / ".." / "experiments").lexically_normal();
    planula::Console console{std::cout, std::cerr, isatty(STDERR_FILENO) == 1, library};
    return planula::run_program({words + 1, words + count}, console);
}
