// SPDX-License-Identifier: MIT
// The words in which an environment that breaks a rule is refused.
#pragma once

#include "physics/environment.h"

#include <string>

namespace planula {

/// Each throws InputError with the rule and the value.
void require(bool holds, const std::string &rule, double value);
void require_amount(const std::string &name, double value);
/// A finite point within 1e9 of 0, where doubles are still 1e-7 cells apart.
void require_place(Vec2d point, const std::string &name);

/// Obstacles, ceiling, friction patches and object: their own rules, and that they leave room for each other and for
/// the place where bodies start.
void check_obstacles(const Environment &environment);

} // namespace planula
