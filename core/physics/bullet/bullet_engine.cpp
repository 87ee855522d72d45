// SPDX-License-Identifier: MIT
#include "physics/bullet/bullet_engine.h"

#include "base/check.h"
#include "physics/forces.h"
#include "physics/laws/spring.h"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>

namespace planula {

namespace {

static_assert(sizeof(btScalar) == sizeof(double), "Bullet must be built in double precision");

constexpr double node_radius =
    0.05; // of the spheres; the ground lies as much deeper, so nodes touch as points
constexpr int nodes_group = 1, ground_group = 2;

btVector3 to_bullet(Vec2d v) { return {v.x, v.y, 0}; }
Vec2d to_plane(const btVector3 &v) { return {v.x(), v.y()}; }

} // namespace

/// A Bullet world with one body in it. Members are destroyed in the order that Bullet asks for.
class BulletEngine::World {
  public:
    World(const SoftBodyModel &model, const Environment &environment)
        : model_(model), environment_(environment), dispatcher_(&configuration_),
          world_(&dispatcher_, &broadphase_, &solver_, &configuration_), sphere_(node_radius) {
        world_.setGravity(to_bullet({0, -environment.gravity}));
        if (environment.has_ground) add_ground();
        for (const Vec2d position : model.positions) add_node(position);
        forces_.load(model, environment);
        lengths_ = next_lengths_ = model.rest_lengths;
        changes_.resize(lengths_.size());
    }
    ~World() {
        for (const auto &body : nodes_) world_.removeRigidBody(body.get());
        for (const auto &body : grounds_) world_.removeRigidBody(body.get());
    }

    void actuate(std::span<const double> elongations, int steps) {
        lengths_ = next_lengths_;
        for (std::size_t i = 0; i < model_.links.size(); ++i) {
            const auto [a, b] = model_.links[i];
            next_lengths_[i] = actuated_length(model_.rest_lengths[i], elongations[a], elongations[b]);
            changes_[i] = (next_lengths_[i] - lengths_[i]) / steps;
        }
        steps_to_knot_ = steps;
    }

    Motion step(double damping) {
        // Rest lengths change linearly between knots.
        if (steps_to_knot_ > 0) {
            --steps_to_knot_;
            for (std::size_t i = 0; i < lengths_.size(); ++i)
                lengths_[i] = next_lengths_[i] - steps_to_knot_ * changes_[i];
        }

        const std::vector<Vec2d> x = positions(), v = velocities();
        std::vector<Vec2d> forces(x.size());
        forces_.compute(lengths_, x, v, forces);
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            nodes_[i]->applyCentralForce(to_bullet(forces[i] - v[i] * damping));
        world_.stepSimulation(model_.time_step, 0);

        Motion motion;
        for (const Vec2d velocity : velocities()) {
            const double speed = length(velocity);
            motion.exploded |= !(speed * model_.time_step <= model_.body.node_speed_limit);
            motion.fastest = std::max(motion.fastest, speed);
        }
        return motion;
    }

    std::vector<Vec2d> positions() const {
        std::vector<Vec2d> result;
        for (const auto &node : nodes_) result.push_back(to_plane(node->getWorldTransform().getOrigin()));
        return result;
    }
    std::vector<Vec2d> velocities() const {
        std::vector<Vec2d> result;
        for (const auto &node : nodes_) result.push_back(to_plane(node->getLinearVelocity()));
        return result;
    }

  private:
    void add_node(Vec2d position) {
        btRigidBody::btRigidBodyConstructionInfo info(1, nullptr, &sphere_, btVector3(0, 0, 0));
        info.m_startWorldTransform = btTransform(btQuaternion::getIdentity(), to_bullet(position));
        info.m_friction = environment_.friction;
        info.m_restitution = 0;
        auto node = std::make_unique<btRigidBody>(info);
        node->setLinearFactor(btVector3(1, 1, 0));
        node->setAngularFactor(btVector3(0, 0, 0));
        node->setActivationState(DISABLE_DEACTIVATION);
        world_.addRigidBody(node.get(), nodes_group, ground_group);
        nodes_.push_back(std::move(node));
    }

    /// A half-space for level ground, a row of thick slabs for a polyline; each lowered by the nodes' radius.
    void add_ground() {
        const auto &line = environment_.ground;
        if (line.empty())
            return add_slab(std::make_unique<btStaticPlaneShape>(btVector3(0, 1, 0), -node_radius), {});
        constexpr double far = 1e4;
        std::vector<Vec2d> points = line;
        points.insert(points.begin(), {line.front().x - far, line.front().y});
        points.push_back({line.back().x + far, line.back().y});
        for (std::size_t i = 1; i < points.size(); ++i) add_segment(points[i - 1], points[i]);
    }

    void add_segment(Vec2d a, Vec2d b) {
        constexpr double depth = 20, width = 10;
        const Vec2d along = b - a, up = -right_normal(along) / length(along), down = up * -node_radius;
        auto hull = std::make_unique<btConvexHullShape>();
        for (const Vec2d corner : {a + down, b + down, Vec2d{a.x, std::min(a.y, b.y) - depth},
                                   Vec2d{b.x, std::min(a.y, b.y) - depth}})
            for (const double z : {-width, width}) hull->addPoint(btVector3(corner.x, corner.y, z));
        hull->setMargin(0);
        add_slab(std::move(hull), {});
    }

    void add_slab(std::unique_ptr<btCollisionShape> shape, Vec2d place) {
        btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, shape.get());
        info.m_startWorldTransform = btTransform(btQuaternion::getIdentity(), to_bullet(place));
        info.m_friction = 1; // Bullet multiplies the two
        info.m_restitution = 0;
        auto ground = std::make_unique<btRigidBody>(info);
        world_.addRigidBody(ground.get(), ground_group, nodes_group);
        shapes_.push_back(std::move(shape));
        grounds_.push_back(std::move(ground));
    }

    const SoftBodyModel &model_;
    const Environment &environment_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_;
    btSphereShape sphere_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> grounds_, nodes_;
    Forces<double> forces_;
    std::vector<double> lengths_, next_lengths_, changes_; // per link: now, at the coming knot, in a step
    int steps_to_knot_ = 0;
};

BulletEngine::BulletEngine() = default;
BulletEngine::~BulletEngine() = default;

void BulletEngine::load(const SoftBodyModel &model, const Environment &environment) {
    world_.reset(); // one world at a time
    world_ = std::make_unique<World>(model, environment);
}

void BulletEngine::actuate(std::span<const double> elongations, int steps) {
    CHECK(world_ != nullptr);
    world_->actuate(elongations, steps);
}

Motion BulletEngine::step(double damping) {
    CHECK(world_ != nullptr);
    return world_->step(damping);
}

std::vector<Vec2d> BulletEngine::positions() const { return world_->positions(); }
std::vector<Vec2d> BulletEngine::velocities() const { return world_->velocities(); }

} // namespace planula
