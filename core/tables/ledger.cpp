// SPDX-License-Identifier: MIT
#include "tables/ledger.h"

#include "base/check.h"

namespace planula {

namespace {

std::string common_value(std::span<const Parameters> settings, const ParameterRow &row) {
    const double value = parameter(settings.front(), row.name);
    for (const Parameters &other : settings.subspan(1))
        if (parameter(other, row.name) != value) return "";
    return value_text(row, value);
}

} // namespace

std::vector<LedgerRow> ledger(std::span<const Parameters> settings) {
    CHECK(!settings.empty());
    std::vector<LedgerRow> rows;
    for (const ParameterRow &row : parameter_rows())
        rows.push_back({std::string(row.section), std::string(row.name), common_value(settings, row),
                        value_text(row, row.standard), std::string(row.unit), std::string(row.origin),
                        std::string(row.meaning)});
    return rows;
}

} // namespace planula
