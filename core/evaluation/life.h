// SPDX-License-Identifier: MIT
// What one genome did: the finished, read-only record that an experiment judges. evaluation/life.inl says what each of
// its fields holds.
#pragma once

#include "base/vec2.h"
#include "body/outcome.h"
#include "body/shape.h"
#include "evaluation/observations.h"

#include <span>
#include <string_view>
#include <vector>

namespace planula {

struct Life {
#define FIELD(type, name, initial, unit, known, meaning) type name = initial;
#include "evaluation/life.inl"
    /// Of the conditions' observations, what this life tells; no part of the digest.
    Observations observations;

    /// |finish - rest|, the bare distance (Eq. 4); 0 unless viable.
    double displacement() const { return length(finish - rest); }
    bool operator==(const Life &) const = default;
};

/// A field is known after a stage; the outcome, known after growth, may still change in locomotion.
struct LifeField {
    std::string_view name, unit, meaning;
    KnownAfter known;
    bool is_shown; // to scripts
};

/// All fields, in the order of life.inl.
std::span<const LifeField> life_fields();

/// The field of that name, which must exist.
const LifeField &life_field(std::string_view name);

/// Calls visit(value) for each field, in the order of life.inl.
template <class SomeLife, class Visit> void each_field(SomeLife &life, Visit &&visit) {
#define FIELD(type, name, initial, unit, known, meaning) visit(life.name);
#include "evaluation/life.inl"
}

} // namespace planula
