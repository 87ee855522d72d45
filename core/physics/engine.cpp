// SPDX-License-Identifier: MIT
#include "physics/engine.h"

#include "base/error.h"
#include "base/text.h"
#include "physics/bullet/bullet_engine.h"
#include "physics/native/native_engine.h"
#include "physics/reference/reference_engine.h"

#include <array>
#include <string>

namespace planula {

namespace {

constexpr std::array<std::string_view, 3> names{"native", "reference", "bullet"};

} // namespace

std::span<const std::string_view> engine_names() { return names; }

std::unique_ptr<Engine> make_engine(std::string_view name) {
    if (name == "native") return std::make_unique<NativeEngine>();
    if (name == "reference") return std::make_unique<ReferenceEngine>();
    if (name == "bullet") return std::make_unique<BulletEngine>();
    const std::string nearest = nearest_name(name, names);
    throw InputError("there is no engine '" + std::string(name) + "'" +
                     (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
}

} // namespace planula
