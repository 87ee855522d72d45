// SPDX-License-Identifier: MIT
// Which model this program is: the signature (`planula signature`) that it was built to have. Two builds of one
// revision give equal results for equal experiments and seeds; any change of a result changes the revision.
// `make signature` checks that a build has the signature that it states.
#pragma once

#include <string_view>

namespace planula {

/// 64 hexadecimal digits: tests/golden/signature, as it was when the program was compiled.
std::string_view model_revision();

} // namespace planula
