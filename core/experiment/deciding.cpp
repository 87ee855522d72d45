// SPDX-License-Identifier: MIT
#include "experiment/deciding.h"

namespace planula {

bool decides_lives(const ParameterRow &row) {
    return row.section != "Statistics" && row.name != "seeds" && row.name != "generations";
}

std::string why_not_shown(std::string_view name) {
    for (const ParameterRow &row : parameter_rows()) {
        if (row.name != name || decides_lives(row)) continue;
        return row.section == "Statistics" ? "statistics alone read it"
                                           : "how much is run must not change how a life is judged";
    }
    return "";
}

} // namespace planula
