// SPDX-License-Identifier: MIT
#include "tables/csv.h"

#include "base/check.h"
#include "base/text.h"
#include "evolution/aims.h"
#include "storage/input.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

// The library's reader thread is left out: every thread of planula is one of base/parallel.h. It cuts file
// names for its own messages on purpose; GCC warns of that from within the functions below.
#define CSV_IO_NO_THREAD
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wstringop-truncation"
#endif
#include <libfccp/csv.h>

namespace planula {

namespace {

using Quoting = io::double_quote_escape<',', '"'>;

/// A file's bytes for libfccp. The library ends a line at a NUL, and reads beyond the end of data that lack a
/// final line feed; both are refused here, before it sees them.
class Source : public io::ByteSourceBase {
  public:
    explicit Source(const std::filesystem::path &path) : path_(path), input_(path) {}

    int read(char *buffer, int size) override {
        const int filled = input_.read(buffer, size);
        const char *start = buffer, *end = buffer + filled;
        const char *nul = std::find(start, end, '\0');
        const auto lines = std::count(start, nul, '\n');
        if (nul != end) refuse(line_ + lines, "a NUL byte");
        line_ += lines;
        if (filled > 0) open_ = end[-1] != '\n';
        if (filled < size && open_) refuse(line_, "the file ends in the middle of a line");
        return filled;
    }

  private:
    [[noreturn]] void refuse(std::int64_t line, const char *what) const {
        throw InputError(path_.string() + ":" + to_text(line) + ": " + what);
    }

    std::filesystem::path path_;
    Input input_;
    std::int64_t line_ = 1; // of the next byte
    bool open_ = false;     // the last byte did not end a line
};

} // namespace

std::string to_field(int value) { return to_text(value); }
std::string to_field(std::int64_t value) { return to_text(value); }

std::string to_field(double value) {
    CHECK(std::isfinite(value), value);
    return to_text(value);
}

std::string to_field(const std::string &value) {
    if (value.find_first_of(std::string_view("\r\n\0", 3)) != std::string::npos)
        throw InputError("a text for a table must be one line: '" + value + "'");
    if (value.find_first_of(",\"") == std::string::npos) return value;
    std::string quoted = "\"";
    for (const char letter : value) quoted.append(letter == '"' ? 2 : 1, letter);
    return quoted + '"';
}

std::string to_line(std::span<const std::string> fields) {
    CHECK(!fields.empty());
    std::string line;
    for (const std::string &field : fields) line += field, line += ',';
    line.back() = '\n';
    return line;
}

class CsvReader::Lines {
  public:
    explicit Lines(const std::filesystem::path &path) : reader_("", std::make_unique<Source>(path)) {}

    char *next() { return reader_.next_line(); }
    unsigned number() const { return reader_.get_file_line(); }

  private:
    io::LineReader reader_;
};

CsvReader::CsvReader(std::filesystem::path path)
    : path_(std::move(path)), lines_(std::make_unique<Lines>(path_)) {
    if (!split()) throw InputError(path_.string() + ":1: the file is empty");
    header_.assign(fields_.begin(), fields_.end());
}

CsvReader::CsvReader(std::filesystem::path path, const std::vector<std::string_view> &header)
    : CsvReader(std::move(path)) {
    for (std::size_t i = 0; i < std::min(header.size(), header_.size()); ++i)
        if (header_[i] != header[i])
            refuse("column " + to_text(static_cast<int>(i) + 1) + " is called '" + header_[i] +
                   "' and must be '" + std::string(header[i]) + "'");
    // Objectives that an experiment states follow the columns of all others.
    const auto extra = header_.begin() + static_cast<std::ptrdiff_t>(std::min(header.size(), header_.size()));
    const bool objectives_follow = std::all_of(
        extra, header_.end(), [](const std::string &title) { return title.starts_with(objective_prefix); });
    if (header_.size() < header.size() || !objectives_follow)
        refuse(to_text(static_cast<int>(header_.size())) + " columns, where there must be " +
               to_text(static_cast<int>(header.size())));
}

CsvReader::~CsvReader() = default;

bool CsvReader::split() {
    fields_.clear();
    try {
        char *at = lines_->next();
        if (at == nullptr) return false;
        for (bool last = false; !last;) {
            char *end = at + (Quoting::find_next_column_end(at) - at);
            char *next = end + 1;
            last = *end == '\0';
            *end = '\0';
            Quoting::unescape(at, end);
            fields_.push_back(at);
            at = next;
        }
    } catch (const io::error::escaped_string_not_closed &) {
        refuse("a quoted field is not closed");
    } catch (const io::error::line_length_limit_exceeded &) {
        refuse("a line longer than 16 million bytes");
    }
    return true;
}

bool CsvReader::next() {
    if (!split()) return false;
    if (fields_.size() != header_.size())
        refuse(to_text(static_cast<int>(fields_.size())) + " fields, where the header has " +
               to_text(static_cast<int>(header_.size())));
    return true;
}

void CsvReader::parse(std::size_t column, std::int64_t &value) const {
    const auto number = parse_int(fields_[column]);
    if (!number) refuse_field(column, "a whole number");
    value = *number;
}

void CsvReader::parse(std::size_t column, int &value) const {
    const auto number = parse_int(fields_[column]);
    using Limits = std::numeric_limits<int>;
    if (!number || *number < Limits::min() || *number > Limits::max())
        refuse_field(column, "a whole number of 32 bits");
    value = static_cast<int>(*number);
}

void CsvReader::parse(std::size_t column, double &value) const {
    const auto number = parse_double(fields_[column]);
    if (!number || !std::isfinite(*number)) refuse_field(column, "a finite number");
    value = *number;
}

void CsvReader::refuse_field(std::size_t column, const char *rule) const {
    constexpr std::size_t shown = 60;
    const std::string value = fields_[column];
    refuse("column '" + header_[column] + "': '" + value.substr(0, shown) +
           (value.size() > shown ? "…" : "") + "' is not " + rule);
}

void CsvReader::refuse(const std::string &what) const {
    throw InputError(path_.string() + ":" + to_text(static_cast<std::int64_t>(lines_->number())) + ": " +
                     what);
}

} // namespace planula
