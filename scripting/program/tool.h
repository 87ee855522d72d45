// SPDX-License-Identifier: MIT
// Other programs that a command needs for some of its outputs: whether they are installed, and a call of one, without a
// shell. A folder for what passes between them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace planula {

/// Throws CreateError, which says that `purpose` needs the program and which package of Debian has it, if there is no
/// such program on the PATH.
void require_tool(const std::string &program, const std::string &package, const std::string &purpose);

/// Runs the program and waits for its end. Throws IoError with its last words if it fails.
void run_tool(const std::string &program, const std::vector<std::string> &arguments);

/// An empty folder among temporary files, removed afterwards.
class Workshop {
  public:
    Workshop();
    ~Workshop();
    Workshop(const Workshop &) = delete;
    Workshop &operator=(const Workshop &) = delete;

    std::filesystem::path file(const std::string &name) const { return folder_ / name; }

  private:
    std::filesystem::path folder_;
};

} // namespace planula
