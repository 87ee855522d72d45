// SPDX-License-Identifier: MIT
#include "body/body.h"

#include "base/check.h"
#include "body/connect.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <utility>

namespace planula {

Body make_body(std::vector<Vec2d> positions, double link_limit) {
    Mesh mesh = connect(positions, link_limit);
    return make_body(std::move(positions), std::move(mesh));
}

Body make_body(std::vector<Vec2d> positions, Mesh mesh) {
    Body body{.positions = std::move(positions), .mesh = std::move(mesh)};
    for (const auto &[a, b] : body.mesh.links)
        body.rest_lengths.push_back(length(body.positions[b] - body.positions[a]));
    for (const auto &[a, b, c] : body.mesh.triangles) {
        const Vec2d origin = body.positions[a];
        body.areas.push_back(0.5 * cross(body.positions[b] - origin, body.positions[c] - origin));
    }
    body.outline = outline(body.mesh);
    return body;
}

Vec2d centre_of_mass(std::span<const Vec2d> points) {
    Vec2d sum;
    for (const Vec2d point : points) sum += point;
    return points.empty() ? sum : sum / static_cast<double>(points.size());
}

double unrest(std::span<const Vec2d> points, std::span<const Vec2d> velocities) {
    const Vec2d centre = centre_of_mass(points), drift = centre_of_mass(velocities);
    double momentum = 0, inertia = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        momentum += cross(points[i] - centre, velocities[i] - drift);
        inertia += squared_length(points[i] - centre);
    }
    const double turn = inertia > 0 ? momentum / inertia : 0;
    double most = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2d arm = points[i] - centre;
        most = std::max(most, length(velocities[i] - drift - Vec2d{-arm.y, arm.x} * turn));
    }
    return most;
}

double elongation(std::span<const Vec2d> positions) {
    constexpr double chain = 1000;
    if (positions.size() < 3) return 0;

    // The variances along the principal axes are the eigenvalues of the covariance.
    const Vec2d centre = centre_of_mass(positions);
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    for (const Vec2d position : positions) {
        const Eigen::Vector2d offset(position.x - centre.x, position.y - centre.y);
        covariance += offset * offset.transpose();
    }
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
    axes.computeDirect(covariance, Eigen::EigenvaluesOnly);
    const double narrow = axes.eigenvalues()[0], wide = axes.eigenvalues()[1];
    return narrow * chain * chain <= wide ? chain : std::sqrt(wide / narrow);
}

} // namespace planula
