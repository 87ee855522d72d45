// SPDX-License-Identifier: MIT
// Built for processors with AVX2 (core/CMakeLists.txt).
#if defined(__AVX2__)

#include "physics/native/kernel_list.h"
#include "physics/native/kernel_text.h"

namespace planula::native {

Kernel avx2_kernel() { return kernel_of<Lanes<8>>("avx2"); }

} // namespace planula::native

#endif
