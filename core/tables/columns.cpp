// SPDX-License-Identifier: MIT
#include "tables/columns.h"

#include "evaluation/life.h"

#include "evolution/search.h"

namespace planula {

namespace {

std::vector<ColumnRow> make_columns() {
    std::vector<ColumnRow> rows;
    std::string table;
#define TABLE(row, file) table = file;
#define COLUMN(type, name, unit, meaning)                                                                    \
    rows.push_back({table, #name, std::string(unit), std::string(meaning)});
#define END_TABLE
#include "tables/columns.inl"
    return rows;
}

} // namespace

std::span<const ColumnRow> columns() {
    static const std::vector<ColumnRow> rows = make_columns();
    return rows;
}

} // namespace planula
