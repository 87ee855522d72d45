// SPDX-License-Identifier: MIT
// Tables as a page carries them: CSV whose numbers have six digits, and of long tables a part of the rows. The page says
// so; the complete tables lie beside it.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

/// A number in at most six digits; any other text as it is.
std::string short_field(std::string_view field);

/// Whether a page shows this one of so many generations: about every k-th, so that at most `most` remain, and the last.
bool is_shown(int generation, int generations, int most);

/// The fields of a row, by the name of the column. Of a column that the table lacks, "".
class TableFields {
  public:
    TableFields(std::span<const std::string> header, std::span<const std::string> fields)
        : header_(header), fields_(fields) {}
    const std::string &operator[](std::string_view column) const;
    /// Throws InternalError if the field is not a whole number.
    int whole(std::string_view column) const;

  private:
    std::span<const std::string> header_, fields_;
};

using KeepRow = std::function<bool(const TableFields &)>;

/// The rows of a CSV file, plain or packed, that `keep` lets through, with a header.
std::string page_table(const std::filesystem::path &file, const KeepRow &keep);

/// The same in the named columns only (all: none named), each row after the fields of `before` and without a header.
std::string page_rows(const std::filesystem::path &file, const std::vector<std::string> &columns,
                      const std::vector<std::string> &before, const KeepRow &keep);

} // namespace planula
