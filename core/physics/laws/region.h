// SPDX-License-Identifier: MIT
// What surrounds a body where the plane is divided into regions (decision 0025): the fluid at a place, and how much of
// gravity water leaves at a height. The laws are templates on the number type; regions are stored as plain numbers.
#pragma once

#include "base/vec2.h"

namespace planula {

/// Drag coefficients of the fluid, and its velocity.
template <class T> struct Fluid {
    T normal = 0, tangential = 0;
    Vec2<T> flow;
};

/// The places from `low` on and before `high`, along x and along y.
template <class Number> struct FluidRegion {
    Vec2<Number> low, high;
    Fluid<Number> fluid;
};

/// The fluid at a place: that of the first region that holds it, or else `open`.
template <class T, class Number>
PORTABLE Fluid<T> fluid_at(Vec2<T> place, Fluid<T> open, const FluidRegion<Number> *regions, int count) {
    Fluid<T> found = open;
    for (const FluidRegion<Number> *region = regions + count; region-- != regions;) {
        const auto inside = (T(region->low.x) <= place.x) & (place.x < T(region->high.x)) &
                            (T(region->low.y) <= place.y) & (place.y < T(region->high.y));
        const Fluid<Number> &fluid = region->fluid;
        found.normal = select(inside, T(fluid.normal), found.normal);
        found.tangential = select(inside, T(fluid.tangential), found.tangential);
        found.flow.x = select(inside, T(fluid.flow.x), found.flow.x);
        found.flow.y = select(inside, T(fluid.flow.y), found.flow.y);
    }
    return found;
}

/// A level layer of water: the heights from `low` on and before `high`, and the share of gravity that it leaves.
template <class Number> struct Layer { Number low, high, share; };

/// The share of gravity that acts at a height: that of the first layer that holds it, or else 1.
template <class T, class Number> PORTABLE T gravity_share(T height, const Layer<Number> *layers, int count) {
    T share(1);
    for (const Layer<Number> *layer = layers + count; layer-- != layers;)
        share = select((T(layer->low) <= height) & (height < T(layer->high)), T(layer->share), share);
    return share;
}

} // namespace planula
