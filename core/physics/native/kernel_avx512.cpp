// SPDX-License-Identifier: MIT
// Built for processors with AVX-512 (core/CMakeLists.txt).
#if defined(__AVX512DQ__)

#include "physics/native/kernel_list.h"
#include "physics/native/kernel_text.h"

namespace planula::native {

Kernel avx512_kernel() { return kernel_of<Lanes<8>, Lanes<16>>("avx512"); }

} // namespace planula::native

#endif
