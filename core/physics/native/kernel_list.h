// SPDX-License-Identifier: MIT
// The kernels of this build, each from a file of its own. Only kernel.cpp asks for them, and only for those
// that the processor can run.
#pragma once

#include "physics/native/kernel.h"

namespace planula::native {

Kernel scalar_kernel();
Kernel sse2_kernel();
Kernel avx2_kernel();
Kernel avx512_kernel();

} // namespace planula::native
