// SPDX-License-Identifier: MIT
#include "network/kernel.h"

#include "network/kernel_list.h"

namespace planula::neural {

Kernel kernel_for(LaneSet lanes) {
    switch (lanes) {
#if defined(__x86_64__)
    case LaneSet::avx2:
        return avx2_kernel();
    case LaneSet::sse2:
        return sse2_kernel();
#endif
    default:
        return scalar_kernel();
    }
}

} // namespace planula::neural
