// SPDX-License-Identifier: MIT
#include "program/tool.h"

#include "base/error.h"
#include "base/text.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace planula {

namespace {

bool is_on_path(const std::string &program) {
    const char *path = std::getenv("PATH");
    std::string_view folders = path ? path : "";
    for (;;) {
        const std::size_t colon = folders.find(':');
        const std::filesystem::path file = std::filesystem::path(folders.substr(0, colon)) / program;
        if (access(file.c_str(), X_OK) == 0) return true;
        if (colon == folders.npos) return false;
        folders.remove_prefix(colon + 1);
    }
}

/// Starts the program with its output on a pipe; the process, and the end to read from.
std::pair<pid_t, int> start(const std::string &program, const std::vector<std::string> &arguments) {
    int pipe[2];
    if (pipe2(pipe, O_CLOEXEC) != 0) throw IoError(program + ": " + std::strerror(errno));
    std::vector<char *> words{const_cast<char *>(program.c_str())};
    for (const std::string &argument : arguments) words.push_back(const_cast<char *>(argument.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, pipe[1], STDERR_FILENO);
    pid_t process = 0;
    const int failure = posix_spawnp(&process, program.c_str(), &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(pipe[1]);
    if (failure == 0) return {process, pipe[0]};
    close(pipe[0]);
    throw IoError(program + " cannot be started: " + std::strerror(failure));
}

/// The last part of all that can be read.
std::string last_words(int from) {
    constexpr std::size_t most = 600;
    std::string words;
    std::array<char, 4096> buffer{};
    for (;;) {
        const ssize_t size = read(from, buffer.data(), buffer.size());
        if (size < 0 && errno == EINTR) continue;
        if (size <= 0) break;
        words.append(buffer.data(), static_cast<std::size_t>(size));
        if (words.size() > most) words.erase(0, words.size() - most);
    }
    close(from);
    while (words.ends_with('\n')) words.pop_back();
    return words;
}

} // namespace

void require_tool(const std::string &program, const std::string &package, const std::string &purpose) {
    if (!is_on_path(program))
        throw CreateError(purpose + " needs the program " + program +
                          ", which is not installed; on Debian: apt-get install " + package);
}

void run_tool(const std::string &program, const std::vector<std::string> &arguments) {
    const auto [process, output] = start(program, arguments);
    const std::string words = last_words(output);
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
    throw IoError(program + " failed" +
                  (WIFEXITED(status) ? " with exit code " + to_text(WEXITSTATUS(status))
                                     : " by signal " + to_text(WTERMSIG(status))) +
                  (words.empty() ? "" : ":\n" + words));
}

Workshop::Workshop() {
    std::string name = (std::filesystem::temp_directory_path() / "planula-").string() + std::string(6, 'X');
    if (!mkdtemp(name.data())) throw CreateError(name + ": " + std::strerror(errno));
    folder_ = name;
}

Workshop::~Workshop() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

} // namespace planula
