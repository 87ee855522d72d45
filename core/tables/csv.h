// SPDX-License-Identifier: MIT
// Tables as RFC 4180 text: a header, one line per row, a line feed after each. Numbers are the shortest text
// that reads back to the same bits, whatever the locale. A number that is not finite is never written: it is
// an InternalError. Texts with a line break or NUL are refused, as R, pandas and gnuplot must
// read the tables.
//
// TableWriter and TableReader know a table by its row type (tables/columns.h); CsvReader and to_field()
// beneath them know only fields, for the one table whose columns depend on the experiment
// (tables/archive_table.h).
#pragma once

#include "storage/output.h"
#include "tables/columns.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

/// The text of one field, quoted where it must be.
std::string to_field(int value);
std::string to_field(std::int64_t value);
std::string to_field(double value);
std::string to_field(const std::string &value);
template <class T> std::string to_field(const std::optional<T> &value) {
    return value ? to_field(*value) : "";
}

/// A line of fields, ended.
std::string to_line(std::span<const std::string> fields);
/// The line of a row.
template <class Row> std::string line_of(const Row &row) {
    std::vector<std::string> fields;
    each_column(row, [&](std::string_view, const auto &value) { fields.push_back(to_field(value)); });
    return to_line(fields);
}
/// The first line of a table.
template <class Row> std::string header_line() {
    const std::vector<std::string_view> names = header_of<Row>();
    return to_line(std::vector<std::string>(names.begin(), names.end()));
}

/// Writes a table to a folder, under its own name; it is there after commit(), which returns its SHA-256.
template <class Row> class TableWriter {
  public:
    explicit TableWriter(const std::filesystem::path &folder) : output_(folder / Row::file_name) {
        output_.write(header_line<Row>());
    }
    void write(const Row &row) { output_.write(line_of(row)); }
    std::string commit() { return output_.commit(); }

  private:
    Output output_;
};

/// Writes a whole table; returns the SHA-256 of its content.
template <class Row> std::string write_table(const std::filesystem::path &folder, std::span<const Row> rows) {
    TableWriter<Row> writer(folder);
    for (const Row &row : rows) writer.write(row);
    return writer.commit();
}

/// The lines of a CSV file, plain or packed, one at a time. Every error is an InputError that starts with
/// file:line; see Input for those of the file itself.
class CsvReader {
  public:
    /// Reads the first line, whatever it says.
    explicit CsvReader(std::filesystem::path path);
    /// Reads the first line, which must be this header; columns of objectives may follow (evolution/aims.h).
    CsvReader(std::filesystem::path path, const std::vector<std::string_view> &header);
    ~CsvReader();
    CsvReader(const CsvReader &) = delete;
    CsvReader &operator=(const CsvReader &) = delete;

    const std::vector<std::string> &header() const { return header_; }
    /// Goes to the next row, which has as many fields as the header; false at the end of the file.
    bool next();

    /// A field of the present row as a value of that type, finite if it is a number.
    void parse(std::size_t column, int &value) const;
    void parse(std::size_t column, std::int64_t &value) const;
    void parse(std::size_t column, double &value) const;
    void parse(std::size_t column, std::string &value) const { value = fields_[column]; }
    template <class T> void parse(std::size_t column, std::optional<T> &value) const {
        value.reset();
        if (*fields_[column] != '\0') parse(column, value.emplace());
    }

    /// Throws InputError: file:line and what is wrong there.
    [[noreturn]] void refuse(const std::string &what) const;

  private:
    class Lines;
    bool split();
    [[noreturn]] void refuse_field(std::size_t column, const char *rule) const;

    std::filesystem::path path_;
    std::unique_ptr<Lines> lines_;
    std::vector<std::string> header_;
    std::vector<char *> fields_; // of the present row
};

/// The rows of a table, one at a time.
template <class Row> class TableReader {
  public:
    explicit TableReader(const std::filesystem::path &folder)
        : TableReader(folder / Row::file_name, header_of<Row>()) {}
    /// Of a file with another name.
    TableReader(const std::filesystem::path &file, const std::vector<std::string_view> &header)
        : reader_(file, header) {}

    bool next(Row &row) {
        if (!reader_.next()) return false;
        std::size_t column = 0;
        each_column(row, [&](std::string_view, auto &value) { reader_.parse(column++, value); });
        return true;
    }
    [[noreturn]] void refuse(const std::string &what) const { reader_.refuse(what); }

  private:
    CsvReader reader_;
};

/// All rows of a table that is small.
template <class Row> std::vector<Row> read_table(const std::filesystem::path &folder) {
    TableReader<Row> reader(folder);
    std::vector<Row> rows;
    for (Row row; reader.next(row);) rows.push_back(row);
    return rows;
}

} // namespace planula
