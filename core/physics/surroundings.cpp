// SPDX-License-Identifier: MIT
#include "physics/surroundings.h"

#include "physics/ground.h"

namespace planula {

template <class T>
std::vector<FluidRegion<T>> lay_regions(const Environment &environment, Vec2d flow, Vec2d origin) {
    std::vector<FluidRegion<T>> regions;
    for (const Region &region : environment.regions)
        regions.push_back({rounded_to<T>(Vec2d{region.box.left, region.box.bottom} - origin),
                           rounded_to<T>(Vec2d{region.box.right, region.box.top} - origin),
                           {static_cast<T>(region.drag_normal), static_cast<T>(region.drag_tangential),
                            rounded_to<T>(region.flow.value_or(flow))}});
    return regions;
}

template <class T> std::vector<Layer<T>> lay_water(const Environment &environment, Vec2d origin) {
    std::vector<Layer<T>> layers;
    for (const Region &region : environment.regions)
        if (region.buoyancy)
            layers.push_back({static_cast<T>(region.box.bottom - origin.y),
                              static_cast<T>(region.box.top - origin.y),
                              static_cast<T>(1 - *region.buoyancy)});
    return layers;
}

template std::vector<FluidRegion<float>> lay_regions(const Environment &, Vec2d, Vec2d);
template std::vector<FluidRegion<double>> lay_regions(const Environment &, Vec2d, Vec2d);
template std::vector<Layer<float>> lay_water(const Environment &, Vec2d);
template std::vector<Layer<double>> lay_water(const Environment &, Vec2d);

} // namespace planula
