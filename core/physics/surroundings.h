// SPDX-License-Identifier: MIT
// The fields of an environment as the laws read them (laws/region.h), counted from an engine's origin.
#pragma once

#include "physics/environment.h"
#include "physics/laws/region.h"

#include <vector>

namespace planula {

/// The regions, those without a flow of their own with `flow`. T: float or double.
template <class T>
std::vector<FluidRegion<T>> lay_regions(const Environment &environment, Vec2d flow, Vec2d origin);

/// The layers of water that carry a body.
template <class T> std::vector<Layer<T>> lay_water(const Environment &environment, Vec2d origin);

} // namespace planula
