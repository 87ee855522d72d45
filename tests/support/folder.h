// SPDX-License-Identifier: MIT
// A folder for files of a test, removed after it.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace planula::test {

struct Folder {
    Folder() { std::filesystem::remove_all(path), std::filesystem::create_directories(path); }
    Folder(const Folder &) = delete;
    ~Folder() { std::filesystem::remove_all(path); }
    void write(const std::string &name, const std::string &text) const {
        std::filesystem::create_directories((path / name).parent_path());
        std::ofstream(path / name) << text;
    }
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("planula-test-" + std::to_string(getpid()));
};

} // namespace planula::test
