// SPDX-License-Identifier: MIT
// The tables of planula as types: for every table of columns.inl a struct with one member per column, in the
// order of the file, and its names. Everything that writes or reads a table does it through these, so that a
// header, a row and the dictionary of all columns cannot disagree.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace planula {

/// A value that a table may leave empty.
using Maybe = std::optional<double>;
using MaybeId = std::optional<std::int64_t>;

#define TABLE(row, file)                                                                                     \
    struct row {                                                                                             \
        static constexpr std::string_view file_name = file;
#define COLUMN(type, name, unit, meaning) type name{};
#define END_TABLE                                                                                            \
    }                                                                                                        \
    ;
#include "tables/columns.inl"

/// Calls visit(name, value) for each column of a row, in the order of the file.
#define TABLE(row_type, file)                                                                                \
    template <class Row, class Visit>                                                                        \
    requires std::same_as<std::remove_const_t<Row>, row_type>                                                \
    void each_column(Row &row, Visit &&visit) {
#define COLUMN(type, name, unit, meaning) visit(std::string_view(#name), row.name);
#define END_TABLE }
#include "tables/columns.inl"

/// The names of a table's columns.
template <class Row> std::vector<std::string_view> header_of() {
    std::vector<std::string_view> names;
    Row row;
    each_column(row, [&](std::string_view name, const auto &) { names.push_back(name); });
    return names;
}

/// The dictionary of all columns of all tables, in the order of columns.inl.
std::span<const ColumnRow> columns();

} // namespace planula
