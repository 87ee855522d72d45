// SPDX-License-Identifier: MIT
// Experiment scripts for tests: from a text, with the modules of experiments/.
#pragma once

#include "base/error.h"
#include "language/sources.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace planula::test {

inline std::filesystem::path experiments_folder() {
    return std::filesystem::path(PLANULA_SOURCE_DIR) / "experiments";
}

/// A script called test.lua.
inline std::shared_ptr<Sources> script(const std::string &text) {
    return std::make_shared<Sources>("test.lua", text, experiments_folder());
}

/// The message of the InputError that `act` ends with; "" if it does not.
template <class Act> std::string refusal(Act act) {
    try {
        act();
    } catch (const InputError &error) {
        return error.what();
    }
    return "";
}

inline bool contains(const std::string &text, const std::string &part) {
    return text.find(part) != text.npos;
}

/// Every file that states an experiment.
inline std::vector<std::filesystem::path> experiment_files() {
    std::vector<std::filesystem::path> files{experiments_folder() / "paper" / "replication.lua"};
    for (const auto folder : {"", "variants"})
        for (const auto &entry : std::filesystem::directory_iterator(experiments_folder() / folder))
            if (entry.path().extension() == ".lua") files.push_back(entry.path());
    return files;
}

} // namespace planula::test
