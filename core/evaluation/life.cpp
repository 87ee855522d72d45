// SPDX-License-Identifier: MIT
#include "evaluation/life.h"

#include "base/check.h"

#include <algorithm>
#include <iterator>

namespace planula {

namespace {

constexpr LifeField fields[] = {
#define FIELD(type, name, initial, unit, known, meaning) {#name, unit, meaning, KnownAfter::known, true},
#define HIDDEN_FIELD(type, name, initial, unit, known, meaning)                                              \
    {#name, unit, meaning, KnownAfter::known, false},
#include "evaluation/life.inl"
};

} // namespace

std::span<const LifeField> life_fields() { return fields; }

const LifeField &life_field(std::string_view name) {
    const auto found = std::find_if(std::begin(fields), std::end(fields),
                                    [&](const LifeField &field) { return field.name == name; });
    CHECK(found != std::end(fields), name);
    return *found;
}

} // namespace planula
