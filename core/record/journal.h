// SPDX-License-Identifier: MIT
// A table of a run while it grows: plain text at <target>.part, to which rows are only ever added. A mark says
// how much of it is safe on disk; another process takes the journal up at a mark, and what came after it goes.
// The finished content is published under the target's name in one piece, so that a target's bytes, packed or
// not, do not depend on how often its run was stopped.
#pragma once

#include "base/hash.h"
#include "record/csv.h"

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

class Journal {
  public:
    /// Begins an empty journal, or takes up the one that lies there. Throws CreateError, or InputError naming
    /// the file if it does not begin as the mark says.
    explicit Journal(std::filesystem::path target, const JournalMark *taken_up = nullptr);
    /// A journal that was never marked goes: nothing knows how to take it up.
    ~Journal();
    Journal(const Journal &) = delete;
    Journal &operator=(const Journal &) = delete;

    void write(std::string_view bytes);
    /// Makes sure that everything written so far is on disk. Throws IoError.
    JournalMark mark();
    /// Writes the target; returns the SHA-256 of its content. The journal stays.
    std::string publish();

  private:
    void take_up(const JournalMark &mark);
    void flush();

    std::filesystem::path target_, path_;
    int file_ = -1;
    bool kept_ = false;
    std::string pending_; // at most a buffer full
    std::int64_t length_ = 0;
    Hash hash_; // of all that was written
};

/// The journal of a table.
template <class Row> class TableJournal {
  public:
    explicit TableJournal(const std::filesystem::path &folder, const JournalMark *taken_up = nullptr)
        : journal_(folder / Row::file_name, taken_up) {
        if (taken_up == nullptr) journal_.write(header_line<Row>());
    }
    void write(const Row &row) { journal_.write(line_of(row)); }
    JournalMark mark() { return journal_.mark(); }
    std::string publish() { return journal_.publish(); }

  private:
    Journal journal_;
};

} // namespace planula
