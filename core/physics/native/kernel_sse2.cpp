// SPDX-License-Identifier: MIT
// Every x86-64 processor has SSE2.
#if defined(__SSE2__)

#include "physics/native/kernel_list.h"
#include "physics/native/kernel_text.h"

namespace planula::native {

Kernel sse2_kernel() { return kernel_of<Lanes<4>>("sse2"); }

} // namespace planula::native

#endif
