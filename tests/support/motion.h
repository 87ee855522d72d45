// SPDX-License-Identifier: MIT
// Bodies in motion that tests of the engines share: muscles that swing, and what can be measured of a body.
#pragma once

#include "base/math.h"
#include "physics/engine.h"
#include "physics/laws/spring.h"
#include "physics/reference/forces.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace planula::specimens {

/// Extensions that let rest lengths swing by up to ±40 % with a phase along the nodes, as a function of time in t.u.
inline std::vector<double> swinging(const SoftBodyModel &model, double time) {
    std::vector<double> extensions(model.positions.size());
    for (std::size_t i = 0; i < extensions.size(); ++i)
        extensions[i] = 0.2 * std::min(1.0, time / 2) * math::sin(6 * time + 0.7 * static_cast<double>(i));
    return extensions;
}

/// The same, while the outer links of a ring lengthen and the inner ones shorten, so that its ends meet.
inline std::vector<double> closing(const SoftBodyModel &model, double time) {
    std::vector<double> extensions = swinging(model, time);
    for (std::size_t i = 0; i < extensions.size(); ++i)
        extensions[i] += std::min(1.0, time / 4) * (i % 2 == 1 ? 0.125 : -0.125);
    return extensions;
}

/// The rest lengths of springs under these extensions.
inline std::vector<double> lengths_under(const std::vector<double> &extensions, const SoftBodyModel &model) {
    std::vector<double> lengths;
    for (std::size_t i = 0; i < model.links.size(); ++i) {
        const auto [a, b] = model.links[i];
        lengths.push_back(actuated_length(model.rest_lengths[i], extensions[a], extensions[b]));
    }
    return lengths;
}

/// The engine of this name with a body in it; model and environment must outlive it.
inline std::unique_ptr<Engine> loaded(std::string_view name, const SoftBodyModel &model,
                                      const Environment &environment) {
    auto engine = make_engine(name);
    engine->load(model, environment);
    return engine;
}

/// One step with these extensions.
inline Motion step_with(const std::vector<double> &extensions, Engine &engine) {
    engine.actuate(extensions, 1);
    return engine.step(0);
}

/// Whether any contact of the body with itself pushes.
inline bool is_touching(const SoftBodyModel &model, std::span<const Vec2d> x) {
    std::vector<Vec2d> push(x.size());
    reference::add_contact(model, x, push);
    return std::any_of(push.begin(), push.end(), [](Vec2d f) { return f != Vec2d{}; });
}

inline double kinetic_energy(std::span<const Vec2d> v) {
    double sum = 0;
    for (const Vec2d u : v) sum += 0.5 * squared_length(u);
    return sum;
}

/// The largest distance between nodes of the same number.
inline double farthest_apart(std::span<const Vec2d> a, std::span<const Vec2d> b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, length(a[i] - b[i]));
    return most;
}

} // namespace planula::specimens
