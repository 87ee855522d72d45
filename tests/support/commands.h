// SPDX-License-Identifier: MIT
// Commands of planula as a user gives them, in this process or in one that can be killed, and the folders that they
// write.
#pragma once

#include "program/commands.h"
#include "support/folder.h"
#include "support/scripts.h"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace planula::test {

struct Said {
    int code;
    std::string out, err;
};

/// Runs a command; its output and exit code.
inline Said planula_says(const std::vector<std::string> &words) {
    std::ostringstream out, err;
    Console console{out, err, false, experiments_folder()};
    const int code = run_program(words, console);
    return {code, out.str(), err.str()};
}

inline std::string content(const std::filesystem::path &path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline void write(const std::filesystem::path &path, const std::string &text) {
    std::ofstream(path, std::ios::binary) << text;
}

/// A text with every `from` in it, of which there must be one at least, replaced by `to`.
inline std::string replaced(std::string text, const std::string &from, const std::string &to) {
    if (!contains(text, from)) throw std::runtime_error("the text has no '" + from + "'");
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

/// Every file below a folder, by name.
inline std::map<std::string, std::string> all_files(const std::filesystem::path &folder) {
    std::map<std::string, std::string> files;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            files[std::filesystem::relative(entry.path(), folder).string()] = content(entry.path());
    return files;
}

/// The first file in which two folders differ; "" if they are equal.
inline std::string difference(const std::filesystem::path &a, const std::filesystem::path &b) {
    const auto left = all_files(a), right = all_files(b);
    for (const auto &[name, bytes] : left)
        if (!right.contains(name) || right.at(name) != bytes) return name;
    for (const auto &[name, bytes] : right)
        if (!left.contains(name)) return name;
    return "";
}

inline void copy_folder(const std::filesystem::path &from, const std::filesystem::path &to) {
    std::filesystem::remove_all(to);
    std::filesystem::create_directories(to.parent_path());
    std::filesystem::copy(from, to, std::filesystem::copy_options::recursive);
}

/// Populations of six, simulated for three hundred steps: a run takes milliseconds.
inline const char *const small = "local paper = require 'paper'\n"
                                 "return paper.experiment { name = 'small', search = 'novelty', parameters = "
                                 "{ population = 6, generations = 2,\n"
                                 "seeds = 2, development_steps = 200, locomotion_steps = 100 } }\n";

/// A folder with one small experiment, removed afterwards.
struct Workplace : Folder {
    explicit Workplace(const std::string &text = small) { test::write(path / "small.lua", text); }
    std::string script() const { return path / "small.lua"; }
    std::string runs() const { return path / "runs"; }
    /// The folder of the setting's run of a seed below 10.
    std::filesystem::path run(int seed = 1) const {
        return std::filesystem::path(runs()) / "small" / ("seed-00" + std::to_string(seed));
    }
    /// `planula run` of the script into runs(), with further words.
    Said run_says(std::vector<std::string> words = {}) const {
        words.insert(words.begin(), {"run", script(), "--out", runs()});
        if (std::find(words.begin(), words.end(), "--threads") == words.end())
            words.insert(words.end(), {"--threads", "1"});
        return planula_says(words);
    }
};

/// Runs a command in a process of its own; its output goes to the file `said`.
inline pid_t start(const std::filesystem::path &said, const std::vector<std::string> &words) {
    const pid_t child = fork();
    if (child != 0) return child;
    std::ofstream silent(said);
    Console console{silent, silent, false, experiments_folder()};
    const int code = run_program(words, console);
    silent.flush();
    _exit(code);
}

/// Waits for the end of a process; its exit code, or the negative of the signal that killed it.
inline int end_of(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

/// Waits, for a minute at most, until something holds.
inline bool wait_until(const std::function<bool()> &holds) {
    for (int i = 0; i < 60000; ++i) {
        if (holds()) return true; // it need not hold a moment later: a checkpoint is replaced by the next
        usleep(1000);
    }
    return false;
}

/// Waits until a process has made a file, or a minute has passed; then kills it by this signal.
inline int kill_once_there(pid_t child, const std::filesystem::path &file, int signal = SIGKILL) {
    wait_until([&] { return std::filesystem::exists(file); });
    kill(child, signal);
    return end_of(child);
}

} // namespace planula::test
