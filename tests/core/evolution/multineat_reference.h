// SPDX-License-Identifier: MIT
// What MultiNEAT at d361660, the library and revision of the paper, shows over 50 runs of the task of
// regression_task.h: median and quartiles of each quantity, as they were measured and rounded. Its own rules were
// left untouched; where they differ from ours is listed in tests/benchmarks/README.md.
#pragma once

#include "core/evolution/regression_task.h"

#include "base/text.h"

#include <cmath>
#include <string_view>

namespace planula::regression {

inline constexpr int reference_runs = 50;

struct Reference {
    bool recurrent;
    int generation;
    std::string_view quantity;
    double Row::*value;
    std::string_view median, low, high; // as printed: their digits say how far they were rounded
};

inline double number(std::string_view text) { return parse_double(text).value(); }

/// Half a unit of the last digit: so far may a rounded number lie from the one that was measured.
inline double rounding(std::string_view text) {
    const std::size_t mantissa_end = std::min(text.find('e'), text.size());
    const std::size_t point = text.find('.');
    double half = 0.5;
    for (std::size_t digit = point + 1; point != text.npos && digit < mantissa_end; ++digit) half /= 10;
    if (mantissa_end < text.size())
        for (int power = static_cast<int>(*parse_int(text.substr(mantissa_end + 1))); power < 0; ++power)
            half /= 10;
    return half;
}

// clang-format off
inline constexpr Reference references[] = {
    {false, 0, "10 - best", &Row::shortfall, "0.28", "0.19", "0.39"},
    {false, 5, "10 - best", &Row::shortfall, "0.014", "0.012", "0.02"},
    {false, 10, "10 - best", &Row::shortfall, "0.0041", "0.0021", "0.0055"},
    {false, 20, "10 - best", &Row::shortfall, "3.9e-4", "2.0e-4", "6.7e-4"},
    {false, 50, "10 - best", &Row::shortfall, "6.2e-5", "3.4e-5", "1.7e-4"},
    {false, 100, "10 - best", &Row::shortfall, "5.7e-6", "1.7e-6", "2.6e-5"},
    {false, 0, "mean fitness", &Row::mean_fitness, "6.88", "6.82", "6.93"},
    {false, 5, "mean fitness", &Row::mean_fitness, "8.99", "8.88", "9.06"},
    {false, 10, "mean fitness", &Row::mean_fitness, "8.83", "8.62", "8.91"},
    {false, 20, "mean fitness", &Row::mean_fitness, "9.11", "9.03", "9.18"},
    {false, 50, "mean fitness", &Row::mean_fitness, "9.13", "9.07", "9.20"},
    {false, 100, "mean fitness", &Row::mean_fitness, "9.18", "9.12", "9.22"},
    {false, 0, "species", &Row::species, "1", "1", "1"},
    {false, 5, "species", &Row::species, "2", "1", "2"},
    {false, 10, "species", &Row::species, "9", "7", "11"},
    {false, 20, "species", &Row::species, "15.5", "14.3", "17.8"},
    {false, 50, "species", &Row::species, "14", "13", "15.8"},
    {false, 100, "species", &Row::species, "11", "10", "12"},
    {false, 0, "threshold", &Row::threshold, "5", "5", "5"},
    {false, 5, "threshold", &Row::threshold, "4", "4", "4"},
    {false, 10, "threshold", &Row::threshold, "3.4", "3.2", "3.8"},
    {false, 20, "threshold", &Row::threshold, "5.2", "4.8", "5.6"},
    {false, 50, "threshold", &Row::threshold, "11.1", "10.8", "11.6"},
    {false, 100, "threshold", &Row::threshold, "20.6", "17.4", "21.2"},
    {false, 0, "mean links", &Row::links, "54", "54", "54"},
    {false, 5, "mean links", &Row::links, "54.0", "54.0", "55.1"},
    {false, 10, "mean links", &Row::links, "56.0", "55.3", "56.8"},
    {false, 20, "mean links", &Row::links, "57.9", "57.2", "58.7"},
    {false, 50, "mean links", &Row::links, "60.8", "60.2", "61.9"},
    {false, 100, "mean links", &Row::links, "65.9", "64.8", "66.9"},
    {false, 0, "mean hidden", &Row::hidden, "0", "0", "0"},
    {false, 5, "mean hidden", &Row::hidden, "0.035", "0.020", "0.58"},
    {false, 10, "mean hidden", &Row::hidden, "1.34", "1.02", "1.57"},
    {false, 20, "mean hidden", &Row::hidden, "2.16", "1.97", "2.41"},
    {false, 50, "mean hidden", &Row::hidden, "2.87", "2.54", "3.06"},
    {false, 100, "mean hidden", &Row::hidden, "3.98", "3.65", "4.36"},
    {false, 0, "weight s.d.", &Row::weight_deviation, "0.408", "0.407", "0.409"},
    {false, 5, "weight s.d.", &Row::weight_deviation, "0.375", "0.36", "0.44"},
    {false, 10, "weight s.d.", &Row::weight_deviation, "0.485", "0.47", "0.52"},
    {false, 20, "weight s.d.", &Row::weight_deviation, "0.532", "0.51", "0.59"},
    {false, 50, "weight s.d.", &Row::weight_deviation, "0.623", "0.57", "0.66"},
    {false, 100, "weight s.d.", &Row::weight_deviation, "0.627", "0.57", "0.66"},
    {false, 0, "largest species", &Row::largest, "300", "300", "300"},
    {false, 5, "largest species", &Row::largest, "299", "164", "300"},
    {false, 10, "largest species", &Row::largest, "56.5", "40", "84"},
    {false, 20, "largest species", &Row::largest, "35.5", "30", "39"},
    {false, 50, "largest species", &Row::largest, "31.5", "24", "42"},
    {false, 100, "largest species", &Row::largest, "32", "29", "41"},
    {true, 0, "10 - best", &Row::shortfall, "0.19", "0.14", "0.28"},
    {true, 5, "10 - best", &Row::shortfall, "0.0087", "0.0055", "0.013"},
    {true, 10, "10 - best", &Row::shortfall, "0.0021", "0.0013", "0.003"},
    {true, 20, "10 - best", &Row::shortfall, "2.5e-4", "1.2e-4", "4.4e-4"},
    {true, 50, "10 - best", &Row::shortfall, "1.2e-5", "5.9e-6", "4.5e-5"},
    {true, 100, "10 - best", &Row::shortfall, "7.5e-7", "2.6e-7", "2.1e-6"},
    {true, 0, "mean fitness", &Row::mean_fitness, "7.17", "7.12", "7.21"},
    {true, 5, "mean fitness", &Row::mean_fitness, "9.15", "9.08", "9.21"},
    {true, 10, "mean fitness", &Row::mean_fitness, "8.94", "8.85", "9.12"},
    {true, 20, "mean fitness", &Row::mean_fitness, "9.25", "9.22", "9.33"},
    {true, 50, "mean fitness", &Row::mean_fitness, "9.28", "9.23", "9.34"},
    {true, 100, "mean fitness", &Row::mean_fitness, "9.32", "9.25", "9.37"},
    {true, 0, "species", &Row::species, "1", "1", "1"},
    {true, 5, "species", &Row::species, "1", "1", "2"},
    {true, 10, "species", &Row::species, "9", "7.3", "11"},
    {true, 20, "species", &Row::species, "17", "14", "18"},
    {true, 50, "species", &Row::species, "15", "12.3", "16"},
    {true, 100, "species", &Row::species, "11", "10", "12.8"},
    {true, 0, "threshold", &Row::threshold, "5", "5", "5"},
    {true, 5, "threshold", &Row::threshold, "4", "4", "4"},
    {true, 10, "threshold", &Row::threshold, "3.4", "3.2", "3.6"},
    {true, 20, "threshold", &Row::threshold, "5.2", "5", "5.4"},
    {true, 50, "threshold", &Row::threshold, "11.2", "11", "11.4"},
    {true, 100, "threshold", &Row::threshold, "20.8", "19.1", "21"},
};
// clang-format on

} // namespace planula::regression
