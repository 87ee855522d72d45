// SPDX-License-Identifier: MIT
// The only threads of the core: independent tasks handed out one by one.
#pragma once

#include <functional>

namespace planula {

/// Calls task(0) … task(count - 1), each once, on up to `threads` threads; returns when all are done. Tasks
/// must not depend on each other. If tasks throw, the exception of the lowest index is thrown again here.
void parallel_for(int count, int threads, const std::function<void(int)> &task);

/// The number of threads that this machine runs at once, at least 1.
int hardware_threads();

} // namespace planula
