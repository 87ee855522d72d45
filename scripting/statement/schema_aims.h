// SPDX-License-Identifier: MIT
// What a setting states of its search's aims (evolution/aims.h, decision 0027):
//
// - objectives: a list of {name, value, goal} and of the texts "fitness" and "novelty". value(life, parameters, penalty)
//   is a function of the judge (statement/judging_functions.h), goal "maximise" or "minimise".
// - descriptor: a list of {name, from, to, cells}, one for each number that `behaviour` returns. from, to and cells go
//   together; without them a number has a name alone.
#pragma once

#include "evolution/aims.h"
#include "statement/reader.h"

namespace planula {

/// The aims of a setting; what is wrong is reported.
Aims read_aims(Reader &setting, Problems &problems);

} // namespace planula
