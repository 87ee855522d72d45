// SPDX-License-Identifier: MIT
// The kernels of this build, each from a file of its own. Only kernel.cpp asks for them, and only for one that the
// processor can run.
#pragma once

#include "network/kernel.h"

namespace planula::neural {

Kernel scalar_kernel();
Kernel sse2_kernel();
Kernel avx2_kernel();
Kernel avx512_kernel();

} // namespace planula::neural
