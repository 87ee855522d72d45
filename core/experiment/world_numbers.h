// SPDX-License-Identifier: MIT
// The numbers of a setting's environment, once: what a run's identity and the table of worlds call them, and the
// parameter that the paper's worlds (§2.5) take each from. An experiment may take it from another parameter, or state
// it itself: then the parameter has no part in its lives.
#pragma once

#include "experiment/spec.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace planula {

struct WorldNumber {
    std::string_view name, unit;
    double &(*in)(Conditions &conditions);
    /// The parameter of the paper's worlds; empty if they have no such number.
    std::string_view (*standard)(const Environment &environment);
    /// Of a number that not every run records: the value that counts where it is not recorded, and that is not recorded.
    std::optional<double> absent = std::nullopt;
};

/// Gravity first.
std::span<const WorldNumber> world_numbers();

/// Whether these conditions state the number: not if it has the value that counts where it is absent.
bool is_stated(const WorldNumber &number, const Conditions &conditions);

/// The conditions of a phase, beside all that holds in every world.
Conditions conditions_of(const Phase &phase);
/// What its numbers are called: "phase 1 gravity".
std::string name_in_phase(std::size_t phase, std::string_view number);

double value_of(const WorldNumber &number, const Conditions &conditions);

/// The parameter that a setting takes this number from; empty if the experiment states the number itself.
std::string_view source_of(const WorldNumber &number, const Spec &spec);
/// The same of a number of any of its worlds, by its name.
std::string_view source_of(std::string_view name, const Spec &spec);

/// Whether the paper's worlds are made of this parameter.
bool is_of_worlds(std::string_view parameter);

/// Whether this setting takes a number of its world from the parameter.
bool makes_world(std::string_view parameter, const Spec &spec);

/// The number that the experiment states itself and the paper takes from this parameter, or null.
const WorldNumber *stated_instead_of(std::string_view parameter, const Spec &spec);

} // namespace planula
