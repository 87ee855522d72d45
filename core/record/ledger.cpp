// SPDX-License-Identifier: MIT
#include "record/ledger.h"

#include "base/check.h"

namespace planula {

namespace {

Maybe common_value(std::span<const Parameters> settings, std::string_view name) {
    const double value = parameter(settings.front(), name);
    for (const Parameters &other : settings.subspan(1))
        if (parameter(other, name) != value) return std::nullopt;
    return value;
}

} // namespace

std::vector<LedgerRow> ledger(std::span<const Parameters> settings) {
    CHECK(!settings.empty());
    std::vector<LedgerRow> rows;
    for (const ParameterRow &row : parameter_rows())
        rows.push_back({std::string(row.section), std::string(row.name), common_value(settings, row.name),
                        row.standard, std::string(row.unit), std::string(row.origin),
                        std::string(row.meaning)});
    return rows;
}

} // namespace planula
