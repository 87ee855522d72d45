// SPDX-License-Identifier: MIT
#include "network/kernel_list.h"
#include "network/kernel_text.h"

namespace planula::neural {

Kernel scalar_kernel() { return advance<DoubleLanes<1>>; }

} // namespace planula::neural
