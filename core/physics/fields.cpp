// SPDX-License-Identifier: MIT
#include "physics/fields.h"

#include "base/error.h"
#include "base/math.h"
#include "base/text.h"
#include "physics/environment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace planula {

namespace {

constexpr std::size_t most_regions = 100;

void require(bool holds, const std::string &rule, double value) {
    if (!holds) throw InputError("environment: " + rule + ", not " + to_text(value));
}

void check_region(const Region &region, const std::string &name) {
    const Box &box = region.box;
    require(box.left < box.right, name + ": from must be less than to (" + to_text(box.right) + ")",
            box.left);
    require(box.bottom < box.top, name + ": bottom must be less than top (" + to_text(box.top) + ")",
            box.bottom);
    for (const double drag : {region.drag_normal, region.drag_tangential})
        require(std::isfinite(drag) && drag >= 0, name + ": drag must be a finite number, 0 or more", drag);
    if (region.flow)
        for (const double speed : {region.flow->x, region.flow->y})
            require(std::isfinite(speed), name + ": flow must be finite", speed);
    if (!region.buoyancy) return;
    require(*region.buoyancy >= 0 && *region.buoyancy <= 1, name + ": buoyancy is a share of gravity, 0 to 1",
            *region.buoyancy);
    const bool has_sides = std::isfinite(box.left) || std::isfinite(box.right);
    require(
        !has_sides,
        name + ": a region with buoyancy has no from and no to, for a body that rose inside and fell outside "
               "would gain energy: let the ground hold the water",
        std::isfinite(box.left) ? box.left : box.right);
}

} // namespace

Vec2d Current::at(double steps) const {
    const double place = steps / step;
    const auto before = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(before);
    const auto sample = [&](std::size_t i) {
        return samples[repeats ? i % samples.size() : std::min(i, samples.size() - 1)];
    };
    const Vec2d from = sample(before);
    return from + (sample(before + 1) - from) * share;
}

Vec2d gravity_vector(double gravity, double degrees) {
    if (degrees == 0) return {0, -gravity};
    const double angle = degrees * (math::pi / 180);
    return {gravity * math::sin(angle), -gravity * math::cos(angle)};
}

void check_fields(const Environment &environment) {
    const double tilt = environment.gravity_direction;
    require(tilt > -90 && tilt < 90,
            "gravity_direction is between -90 and 90 degrees from straight down, so that bodies fall onto "
            "the ground",
            tilt);
    const std::vector<Region> &regions = environment.regions;
    require(regions.size() <= most_regions,
            "there are at most " + to_text(static_cast<int>(most_regions)) + " regions",
            static_cast<double>(regions.size()));
    for (std::size_t i = 0; i < regions.size(); ++i) {
        check_region(regions[i], "regions[" + to_text(static_cast<int>(i + 1)) + "]");
        require(!regions[i].buoyancy || tilt == 0,
                "water that carries a body (buoyancy) is level: gravity_direction must be 0", tilt);
    }
    require(environment.current.step >= 1, "a flow that changes has 1 step or more between samples",
            environment.current.step);
    for (const Vec2d sample : environment.current.samples)
        for (const double speed : {sample.x, sample.y})
            require(std::isfinite(speed), "flow must be finite", speed);
}

} // namespace planula
