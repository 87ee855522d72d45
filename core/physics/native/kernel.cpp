// SPDX-License-Identifier: MIT
#include "physics/native/kernel.h"

#include "base/error.h"
#include "base/text.h"
#include "physics/native/kernel_list.h"

#include <atomic>
#include <string>

namespace planula::native {

namespace {

std::vector<Kernel> runnable_kernels() {
    std::vector<Kernel> result{scalar_kernel()};
#if defined(__x86_64__)
    result.push_back(sse2_kernel());
    if (__builtin_cpu_supports("avx2")) result.push_back(avx2_kernel());
#endif
    return result;
}

std::atomic<const Kernel *> &choice() {
    static std::atomic<const Kernel *> chosen = &kernels().back();
    return chosen;
}

} // namespace

std::span<const Kernel> kernels() {
    static const std::vector<Kernel> runnable = runnable_kernels();
    return runnable;
}

const Kernel &chosen_kernel() { return *choice(); }

void choose_kernel(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Kernel &kernel : kernels()) {
        if (kernel.name == name) choice() = &kernel;
        names.push_back(kernel.name);
    }
    if (chosen_kernel().name == name) return;
    const std::string nearest = nearest_name(name, names);
    throw InputError("this processor has no lanes '" + std::string(name) + "'" +
                     (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
}

} // namespace planula::native
