// SPDX-License-Identifier: MIT
// Every x86-64 processor has SSE2.
#if defined(__SSE2__)

#include "network/kernel_list.h"
#include "network/kernel_text.h"

namespace planula::neural {

Kernel sse2_kernel() { return advance<DoubleLanes<2>>; }

} // namespace planula::neural

#endif
