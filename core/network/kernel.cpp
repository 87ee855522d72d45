// SPDX-License-Identifier: MIT
#include "network/kernel.h"

#include "network/kernel_list.h"

namespace planula::neural {

Kernel kernel_for(LaneSet lanes) {
#if defined(__x86_64__)
    constexpr Kernel (*makers[])() = {scalar_kernel, sse2_kernel, avx2_kernel, avx512_kernel};
#else
    constexpr Kernel (*makers[])() = {scalar_kernel};
#endif
    return makers[static_cast<std::size_t>(lanes)]();
}

} // namespace planula::neural
