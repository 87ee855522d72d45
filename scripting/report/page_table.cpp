// SPDX-License-Identifier: MIT
#include "report/page_table.h"

#include "base/check.h"
#include "base/text.h"
#include "tables/csv.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace planula {

namespace {

constexpr int digits = 6;

/// Calls visit(row, header) for each row that is kept.
template <class Visit> void each_row(const std::filesystem::path &file, const KeepRow &keep, Visit &&visit) {
    CsvReader reader(file);
    std::vector<std::string> fields(reader.header().size());
    while (reader.next()) {
        for (std::size_t i = 0; i < fields.size(); ++i) reader.parse(i, fields[i]);
        const TableFields row(reader.header(), fields);
        if (keep(row)) visit(row, reader.header());
    }
}

} // namespace

std::string short_field(std::string_view field) {
    const auto value = parse_double(field);
    if (!value || field.size() <= digits || parse_int(field)) return to_field(std::string(field));
    std::array<char, 32> text;
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), *value, std::chars_format::general, digits);
    return {text.data(), end.ptr};
}

bool is_shown(int generation, int generations, int most) {
    const int step = std::max(1, (generations + most - 1) / most);
    return generation < generations && (generation % step == 0 || generation == generations - 1);
}

const std::string &TableFields::operator[](std::string_view column) const {
    static const std::string none;
    const auto at = std::find(header_.begin(), header_.end(), column);
    return at == header_.end() ? none : fields_[static_cast<std::size_t>(at - header_.begin())];
}

int TableFields::whole(std::string_view column) const {
    const auto value = parse_int((*this)[column]);
    CHECK(value, column, (*this)[column]);
    return static_cast<int>(*value);
}

std::string page_table(const std::filesystem::path &file, const KeepRow &keep) {
    std::string text = to_line(CsvReader(file).header());
    return text + page_rows(file, {}, {}, keep);
}

std::string page_rows(const std::filesystem::path &file, const std::vector<std::string> &columns,
                      const std::vector<std::string> &before, const KeepRow &keep) {
    std::string text;
    each_row(file, keep, [&](const TableFields &row, const auto &header) {
        std::vector<std::string> fields;
        for (const std::string &field : before) fields.push_back(to_field(field));
        for (const std::string &column : columns.empty() ? header : columns)
            fields.push_back(short_field(row[column]));
        text += to_line(fields);
    });
    return text;
}

} // namespace planula
