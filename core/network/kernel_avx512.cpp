// SPDX-License-Identifier: MIT
// Built for processors with AVX-512 (core/CMakeLists.txt).
#if defined(__AVX512DQ__)

#include "network/kernel_list.h"
#include "network/kernel_text.h"

namespace planula::neural {

Kernel avx512_kernel() { return advance<DoubleLanes<8>>; }

} // namespace planula::neural

#endif
