// SPDX-License-Identifier: MIT
#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace planula {

void parallel_for(int count, int threads, const std::function<void(int)> &task) {
    std::vector<std::exception_ptr> failures(static_cast<std::size_t>(std::max(count, 0)));
    std::atomic<int> next{0};
    const auto work = [&] {
        for (int i; (i = next.fetch_add(1)) < count;) {
            try {
                task(i);
            } catch (...) {
                failures[i] = std::current_exception();
            }
        }
    };

    // The calling thread works too; the others are joined at the end of the block.
    {
        std::vector<std::jthread> helpers;
        for (int i = 1; i < std::min(threads, count); ++i) helpers.emplace_back(work);
        work();
    }
    for (const auto &failure : failures)
        if (failure) std::rethrow_exception(failure);
}

int hardware_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

} // namespace planula
