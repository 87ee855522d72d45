// SPDX-License-Identifier: MIT
// The texts that are compiled into the program from the files of this folder (scripting/CMakeLists.txt).
#pragma once

#include <string_view>

namespace planula {

std::string_view replay_template(); // replay.html

} // namespace planula
