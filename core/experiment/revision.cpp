// SPDX-License-Identifier: MIT
#include "experiment/revision.h"

namespace planula {

std::string_view model_revision() { return PLANULA_MODEL_REVISION; }

} // namespace planula
