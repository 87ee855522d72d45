// SPDX-License-Identifier: MIT
// What planula sensitivity varies in an experiment: sensitivity = {sample, factors, parameters}, all of them optional.
// The meaning of its results: analysis/sensitivity.h.
#pragma once

#include "statement/reader.h"

#include <string>
#include <vector>

namespace planula {

struct SensitivityPlan {
    int sample = 200;                      // individuals of each setting
    std::vector<double> factors{0.5, 2};   // that a value is multiplied by
    std::vector<std::string> parameters{}; // names; all assumed ones, if none
};

/// Reports what is wrong to `problems`.
SensitivityPlan read_sensitivity(const Value &table, const Place &place, Problems &problems);

} // namespace planula
