// SPDX-License-Identifier: MIT
#include "physics/native/kernel_list.h"
#include "physics/native/kernel_text.h"

namespace planula::native {

Kernel scalar_kernel() { return kernel_of<Lanes<1>>("scalar"); }

} // namespace planula::native
