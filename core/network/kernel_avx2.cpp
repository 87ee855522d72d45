// SPDX-License-Identifier: MIT
// Built for processors with AVX2 (core/CMakeLists.txt).
#if defined(__AVX2__)

#include "network/kernel_list.h"
#include "network/kernel_text.h"

namespace planula::neural {

Kernel avx2_kernel() { return advance<DoubleLanes<4>>; }

} // namespace planula::neural

#endif
