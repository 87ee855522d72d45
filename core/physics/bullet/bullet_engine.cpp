// SPDX-License-Identifier: MIT
#include "physics/bullet/bullet_engine.h"

#include "base/check.h"
#include "physics/bullet/triangulate.h"
#include "physics/reference/reference_engine.h"
#include "physics/walls.h"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <array>
#include <span>

namespace planula {

namespace {

static_assert(sizeof(btScalar) == sizeof(double), "Bullet must be built in double precision");

// Of the spheres. Ground and ceiling lie as much deeper, so nodes touch them as points; obstacles, which may be thin,
// do not, so nodes are kept so far from them.
constexpr double node_radius = 0.05;
constexpr int nodes_group = 1, ground_group = 2;

btVector3 to_bullet(Vec2d v) { return {v.x, v.y, 0}; }
Vec2d to_plane(const btVector3 &v) { return {v.x(), v.y()}; }

} // namespace

/// A Bullet world with one body in it. Members are destroyed in the order that Bullet asks for.
class BulletEngine::World {
  public:
    World(const SoftBodyModel &model, const Environment &environment, const BodyState &state)
        : model_(model), environment_(environment), surroundings_(environment), dispatcher_(&configuration_),
          world_(&dispatcher_, &broadphase_, &solver_, &configuration_), sphere_(node_radius),
          walls_(environment, {}), rest_lengths_(model) {
        world_.setGravity(to_bullet(surroundings_.gravity));
        if (environment.has_walls())
            add_walls();
        else if (environment.has_ground)
            add_ground();
        for (std::size_t i = 0; i < state.positions.size(); ++i)
            add_node(state.positions[i], state.velocities[i]);
    }
    ~World() {
        for (const auto &body : nodes_) world_.removeRigidBody(body.get());
        for (const auto &body : grounds_) world_.removeRigidBody(body.get());
    }

    void set_flow(Vec2d flow) { surroundings_ = reference::Surroundings(environment_, flow); }
    void actuate(std::span<const double> extensions, int steps) { rest_lengths_.actuate(extensions, steps); }

    Motion step(double damping) {
        rest_lengths_.advance();
        const reference::Nodes nodes{positions(), velocities()};
        auto forces = reference::forces_on(model_, surroundings_, rest_lengths_.now(), nodes);
        if (!walls_.empty()) reference::add_pull_of_walls(model_, walls_.view(), {}, nodes.positions, forces);
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            nodes_[i]->applyCentralForce(to_bullet(forces[i] - nodes.velocities[i] * damping));
            if (surroundings_.water.empty()) continue;
            const Vec2d carried = surroundings_.fall(nodes.positions[i]) - surroundings_.gravity;
            nodes_[i]->applyCentralForce(to_bullet(carried));
        }
        world_.stepSimulation(model_.time_step, 0);
        return reference::motion_of(velocities(), model_);
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
    void add_node(Vec2d position, Vec2d velocity) {
        btRigidBody::btRigidBodyConstructionInfo info(1, nullptr, &sphere_, btVector3(0, 0, 0));
        info.m_startWorldTransform = btTransform(btQuaternion::getIdentity(), to_bullet(position));
        info.m_friction = 1; // Bullet multiplies it with that of the ground
        info.m_restitution = 0;
        auto node = std::make_unique<btRigidBody>(info);
        node->setLinearFactor(btVector3(1, 1, 0));
        node->setAngularFactor(btVector3(0, 0, 0));
        node->setActivationState(DISABLE_DEACTIVATION);
        node->setLinearVelocity(to_bullet(velocity));
        if (!environment_.obstacles.empty()) { // a fast node stops at a thin wall
            node->setCcdMotionThreshold(node_radius / 2);
            node->setCcdSweptSphereRadius(node_radius / 2);
        }
        world_.addRigidBody(node.get(), nodes_group, ground_group);
        nodes_.push_back(std::move(node));
    }

    /// A half-space for level ground, a row of thick slabs for a polyline; each lowered by the nodes' radius.
    void add_ground() {
        const auto &line = environment_.ground;
        if (!line.empty()) return add_line({line, {}}, true);
        add_slab(std::make_unique<btStaticPlaneShape>(btVector3(0, 1, 0), -node_radius),
                 environment_.friction);
    }

    void add_walls() {
        if (environment_.has_ground) add_line(cut(environment_.ground, environment_), true);
        if (!environment_.ceiling.empty()) add_line(cut(environment_.ceiling, environment_), false);
        for (const Obstacle &obstacle : environment_.obstacles)
            for (const auto &triangle : triangulate(obstacle.points))
                add_prism(triangle, obstacle.friction.value_or(environment_.friction));
    }

    /// Of ground, or of a ceiling. Without frictions of its own it has that of the environment.
    void add_line(const CutLine &line, bool is_ground) {
        constexpr double far = 1e4;
        std::vector<Vec2d> points = line.points;
        points.insert(points.begin(), {points.front().x - far, points.front().y});
        points.push_back({points.back().x + far, points.back().y});
        for (std::size_t i = 1; i < points.size(); ++i)
            add_segment(points[i - 1], points[i], is_ground ? -1 : 1,
                        line.frictions.empty() ? environment_.friction : line.frictions[i - 1]);
    }

    /// `inwards`: -1 for ground, which is solid below, 1 for a ceiling.
    void add_segment(Vec2d a, Vec2d b, double inwards, double friction) {
        constexpr double depth = 20;
        const Vec2d along = b - a, up = -right_normal(along) / length(along),
                    in = up * (inwards * node_radius);
        const double deep = (inwards < 0 ? std::min(a.y, b.y) : std::max(a.y, b.y)) + inwards * depth;
        add_prism(std::array{a + in, b + in, Vec2d{a.x, deep}, Vec2d{b.x, deep}}, friction);
    }

    void add_prism(std::span<const Vec2d> corners, double friction) {
        constexpr double width = 10;
        auto hull = std::make_unique<btConvexHullShape>();
        for (const Vec2d corner : corners)
            for (const double z : {-width, width}) hull->addPoint(btVector3(corner.x, corner.y, z));
        hull->setMargin(0);
        add_slab(std::move(hull), friction);
    }

    void add_slab(std::unique_ptr<btCollisionShape> shape, double friction) {
        btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, shape.get());
        info.m_friction = friction;
        info.m_restitution = 0;
        auto ground = std::make_unique<btRigidBody>(info);
        world_.addRigidBody(ground.get(), ground_group, nodes_group);
        shapes_.push_back(std::move(shape));
        grounds_.push_back(std::move(ground));
    }

    const SoftBodyModel &model_;
    const Environment &environment_;
    reference::Surroundings surroundings_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_;
    btSphereShape sphere_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> grounds_, nodes_;
    Walls<double> walls_; // which draw links back
    reference::RestLengths rest_lengths_;
};

BulletEngine::BulletEngine() = default;
BulletEngine::~BulletEngine() = default;

void BulletEngine::load(const SoftBodyModel &model, const Environment &environment, const BodyState &state) {
    world_.reset(); // one world at a time
    world_ = std::make_unique<World>(model, environment, state);
}

void BulletEngine::set_flow(Vec2d flow) {
    CHECK(world_ != nullptr);
    world_->set_flow(flow);
}

void BulletEngine::actuate(std::span<const double> extensions, int steps) {
    CHECK(world_ != nullptr);
    world_->actuate(extensions, steps);
}

Motion BulletEngine::step(double damping) {
    CHECK(world_ != nullptr);
    return world_->step(damping);
}

std::vector<Vec2d> BulletEngine::positions() const { return world_->positions(); }
std::vector<Vec2d> BulletEngine::velocities() const { return world_->velocities(); }

} // namespace planula
