// SPDX-License-Identifier: MIT
// The engines of the module, in place of those of physics/engine.cpp: Bullet is not built for browsers.
#include "base/error.h"
#include "physics/engine.h"
#include "physics/native/native_engine.h"
#include "physics/reference/reference_engine.h"

namespace planula {

std::unique_ptr<Engine> make_engine(std::string_view name) {
    if (name == "native") return std::make_unique<NativeEngine>();
    if (name == "reference") return std::make_unique<ReferenceEngine>();
    throw InputError("the engine '" + std::string(name) + "' does not run in a browser");
}

} // namespace planula
