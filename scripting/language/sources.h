// SPDX-License-Identifier: MIT
// The files of a script: itself and the modules that it requires. Each is read once and kept, so that every Lua state
// of a command runs the same text even if a file changes during a long run. States of several threads may share them.
//
// Where `require "paper.judgement"` looks, first found wins: paper/judgement.lua, then
// init.lua in paper/judgement, in the script's own folder, in each folder above it, and at last in the library
// folder (the `experiments` folder of this program).
#pragma once

#include "language/tokens.h"

#include <atomic>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

struct Source {
    std::string module; // as required; empty for the script itself
    std::string name;   // the file in messages
    std::string text;
    std::string sha256;
    std::vector<Token> tokens; // words of `text`
    std::vector<Requirement> requirements;
};

/// How many instructions all Lua states of a script together may execute until it is checked. A call of a function is
/// limited by itself; this limits scripts with thousands of calls or many settings.
inline constexpr std::int64_t instructions_of_a_check = 200'000'000;

class Sources {
  public:
    /// Throws InputError if the script cannot be read, is larger than 1 MiB, is bytecode, or uses what
    /// refuse_machine_dependent() refuses.
    Sources(const std::filesystem::path &script, std::filesystem::path library);
    /// A script that is not in a file, for tests; modules come from `library` alone.
    Sources(std::string name, std::string text, std::filesystem::path library);

    const Source &script() const;
    /// Reads the module when it is first asked for. Throws InputError: an unsafe name, not found (with the folders
    /// tried), or any error of the constructor.
    const Source &module(std::string_view name);
    /// The source of this message name; or null.
    const Source *named(std::string_view name) const;
    /// Not while another thread runs a script.
    const std::deque<Source> &all() const { return sources_; }
    /// Begins or ends the check of the script, during which spend() counts.
    void limit_instructions(bool limited);
    /// Counts instructions of any state of the script; false once they are too many.
    bool spend(std::int64_t instructions);
    /// The sources read so far, in their order, with each function on a line of its own, and named by their number from
    /// 0: a line number tells which function it is.
    std::shared_ptr<Sources> with_functions_on_lines() const;

  private:
    Sources() = default;
    const Source &add(std::string module, std::string name, std::string text);

    std::vector<std::filesystem::path> folders_;
    std::atomic<bool> limited_ = false;
    std::atomic<std::int64_t> spent_ = 0;
    mutable std::mutex mutex_;   // of sources_
    std::deque<Source> sources_; // a deque: references stay valid
};

} // namespace planula
