// SPDX-License-Identifier: MIT
// A table of a run while it grows: plain text at <target>.part, to which rows are only ever added. A mark says
// how much of it is safe on disk; another process resumes the journal at a mark, and what came after it is cut.
// The finished content is published under the target's name in one piece, so that a target's bytes, packed or
// not, do not depend on how often its run was stopped. A run that is to become longer begins its journals again
// from the published tables, which stay as they are until the longer ones replace them.
#pragma once

#include "base/hash.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace planula {

/// The first bytes of a journal: how many, and their SHA-256.
struct JournalMark {
    std::int64_t length = 0;
    std::string sha256;
};

/// Where the journal of a target lies.
std::filesystem::path journal_path(const std::filesystem::path &target);

/// Throws InputError, naming the file, if it does not begin as the mark says.
void check_mark(const std::filesystem::path &path, const JournalMark &mark);

/// Where a journal begins: empty, or with what its own file or the published target holds up to a mark.
struct JournalStart {
    enum class From { nothing, journal, target };
    From from = From::nothing;
    JournalMark mark;
};

class Journal {
  public:
    /// Throws CreateError, or InputError naming the file if that does not begin as the mark says.
    explicit Journal(std::filesystem::path target, const JournalStart &start = {});
    /// A journal that was never marked is removed: nothing knows how to resume it.
    ~Journal();
    Journal(const Journal &) = delete;
    Journal &operator=(const Journal &) = delete;

    void write(std::string_view bytes);
    /// Makes sure that everything written so far is on disk. Throws IoError.
    JournalMark mark();
    bool is_empty() const { return length_ == 0; }
    /// Writes the target; returns the SHA-256 of its content. The journal stays.
    std::string publish();

  private:
    void resume(const JournalMark &mark);
    void copy(const JournalMark &mark);
    void open(int flags);
    void flush();

    std::filesystem::path target_, path_;
    int file_ = -1;
    bool kept_ = false;
    std::string pending_; // at most a buffer full
    std::int64_t length_ = 0;
    Hash hash_; // of all that was written
};

} // namespace planula
