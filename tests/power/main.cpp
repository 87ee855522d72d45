// SPDX-License-Identifier: MIT
// power OUT REPETITIONS: writes power.csv and coverage.csv into the folder OUT. `make power` keeps them in tests/power.
#include "base/text.h"
#include "power/simulate.h"

#include <charconv>
#include <cstdio>
#include <cstring>
#include <fstream>

using namespace planula;

namespace {

/// Four decimals, as text that does not depend on the locale.
std::string share(double value) {
    return to_text(static_cast<double>(static_cast<int>(value * 10000 + 0.5)) / 10000);
}

} // namespace

int main(int count, char **arguments) {
    int repetitions = 0;
    if (count == 3) std::from_chars(arguments[2], arguments[2] + std::strlen(arguments[2]), repetitions);
    if (repetitions < 1) {
        std::fputs("usage: power OUT REPETITIONS\n", stderr);
        return 2;
    }
    const std::string out = arguments[1];
    std::ofstream table(out + "/power.csv"), coverage(out + "/coverage.csv");
    table << "test,truth,runs,repetitions,reproduced,contradicted,reproduced_corrected,contradicted_"
             "corrected\n";
    for (const power::Outcome &row : power::outcomes(repetitions))
        table << row.test << ',' << row.truth << ',' << row.runs << ',' << row.repetitions << ','
              << share(row.reproduced) << ',' << share(row.contradicted) << ','
              << share(row.reproduced_corrected) << ',' << share(row.contradicted_corrected) << '\n';
    coverage << "interval,values,runs,repetitions,covered\n";
    for (const power::Coverage &row : power::coverages(repetitions))
        coverage << row.interval << ',' << row.values << ',' << row.runs << ',' << row.repetitions << ','
                 << share(row.covered) << '\n';
    table.flush(), coverage.flush();
    return table && coverage ? 0 : 1;
}
