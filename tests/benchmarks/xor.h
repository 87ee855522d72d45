// SPDX-License-Identifier: MIT
// Exclusive or, the test of whether a search grows structure (Stanley & Miikkulainen 2002, section 4.1): there is
// no solution without a hidden node. Fitness (4 − Σ|error|)² over the four cases; solved if each output lies on
// the right side of one half. tanh outputs are mapped from [−1, 1] to [0, 1].
#pragma once

#include "benchmarks/task.h"

namespace planula::benchmark {

/// Inputs a, b and the bias; behaviour: the four outputs.
Task xor_task();

/// What a policy of two inputs, bias and one output makes of the four cases.
Attempt attempt_xor(Policy policy);

} // namespace planula::benchmark
