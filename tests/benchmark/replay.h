#pragma once

#include <btBulletDynamicsCommon.h>

#include <chrono>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace sherd::benchmarks {

/// The rigid bodies of a world as they come, go, and move from step to step: plain Bullet steps bodies of the
/// same shapes, from the same places at the same speeds, in a world without Sherd.
class Replay {
  public:
    /// What is in the world before its first step.
    explicit Replay(const btDiscreteDynamicsWorld& world) : gravity_(world.getGravity()) { note(world); }

    /// To be called after each step of the world.
    void note(const btDiscreteDynamicsWorld& world) {
        Moment moment;
        std::map<Key, std::size_t> here;
        const auto& objects = world.getCollisionObjectArray();
        for (int i = 0; i < objects.size(); ++i) {
            const btRigidBody& body = *btRigidBody::upcast(objects[i]);
            const Key key{&body, body.internalGetExtensionPointer()};
            const auto known = here_.find(key);
            if (known == here_.end()) {
                moment.came.push_back(twins_.size());
                twins_.push_back(twinOf(body));
            }
            const std::size_t number = known == here_.end() ? moment.came.back() : known->second;
            here[key] = number;
            moment.states.push_back({number, body.getWorldTransform(), body.getLinearVelocity(),
                                     body.getAngularVelocity(), body.getActivationState()});
        }
        for (const auto& [key, number] : here_)
            if (here.count(key) == 0) moment.left.push_back(number);
        here_ = std::move(here);
        moments_.push_back(std::move(moment));
    }

    /// All steps that were noted, of `time_step_s` each; returns what each takes, ms. To be called once.
    std::vector<double> play(double time_step_s) {
        btDefaultCollisionConfiguration configuration;
        btCollisionDispatcher dispatcher(&configuration);
        btDbvtBroadphase broadphase;
        btSequentialImpulseConstraintSolver solver;
        btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
        world.setGravity(gravity_);
        std::vector<double> ms;
        for (const Moment& moment : moments_) {
            apply(moment, world);
            if (&moment == &moments_.back()) break;
            using namespace std::chrono;
            const auto start = steady_clock::now();
            world.stepSimulation(btScalar(time_step_s), 0);
            ms.push_back(duration<double, std::milli>(steady_clock::now() - start).count());
        }
        while (world.getNumCollisionObjects() > 0)
            world.removeCollisionObject(world.getCollisionObjectArray()[0]);
        return ms;
    }

  private:
    using Key = std::pair<const btRigidBody*, const void*>;  // an address may be that of another body later
    struct State {
        std::size_t number;
        btTransform place;
        btVector3 velocity, turning;
        int activation;
    };
    struct Moment {
        std::vector<std::size_t> left, came;
        std::vector<State> states;
    };
    struct Twin {
        std::vector<std::unique_ptr<btCollisionShape>> shapes;  // the whole last
        std::unique_ptr<btRigidBody> body;
        int group = 0, mask = 0;
    };

    static std::unique_ptr<btCollisionShape> convexCopy(const btCollisionShape& shape) {
        switch (shape.getShapeType()) {
            case CONVEX_HULL_SHAPE_PROXYTYPE: {
                const auto& hull = static_cast<const btConvexHullShape&>(shape);
                auto twin = std::make_unique<btConvexHullShape>(hull.getUnscaledPoints()->m_floats,
                                                                hull.getNumPoints());
                twin->setMargin(hull.getMargin());
                twin->recalcLocalAabb();  // which has the margin in it
                return twin;
            }
            case BOX_SHAPE_PROXYTYPE: {
                auto twin = std::make_unique<btBoxShape>(
                    static_cast<const btBoxShape&>(shape).getHalfExtentsWithMargin());
                twin->setMargin(shape.getMargin());
                return twin;
            }
            case SPHERE_SHAPE_PROXYTYPE:
                return std::make_unique<btSphereShape>(static_cast<const btSphereShape&>(shape).getRadius());
            default:
                throw std::invalid_argument("no copy is made of such a shape");
        }
    }

    static void addShapes(const btCollisionShape& shape, Twin& twin) {
        if (!shape.isCompound()) {
            twin.shapes.push_back(convexCopy(shape));
            return;
        }
        const auto& parts = static_cast<const btCompoundShape&>(shape);
        auto compound = std::make_unique<btCompoundShape>();
        for (int i = 0; i < parts.getNumChildShapes(); ++i) {
            twin.shapes.push_back(convexCopy(*parts.getChildShape(i)));
            compound->addChildShape(parts.getChildTransform(i), twin.shapes.back().get());
        }
        twin.shapes.push_back(std::move(compound));
    }

    static Twin twinOf(const btRigidBody& body) {
        Twin twin;
        addShapes(*body.getCollisionShape(), twin);
        const btScalar mass = body.getInvMass() > 0 ? 1 / body.getInvMass() : 0;
        btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, twin.shapes.back().get(),
                                                      body.getLocalInertia());
        info.m_friction = body.getFriction();
        info.m_restitution = body.getRestitution();
        info.m_rollingFriction = body.getRollingFriction();
        info.m_spinningFriction = body.getSpinningFriction();
        info.m_linearDamping = body.getLinearDamping();
        info.m_angularDamping = body.getAngularDamping();
        info.m_linearSleepingThreshold = body.getLinearSleepingThreshold();
        info.m_angularSleepingThreshold = body.getAngularSleepingThreshold();
        twin.body = std::make_unique<btRigidBody>(info);
        twin.body->setCcdMotionThreshold(body.getCcdMotionThreshold());
        twin.body->setCcdSweptSphereRadius(body.getCcdSweptSphereRadius());
        twin.group = body.getBroadphaseProxy()->m_collisionFilterGroup;
        twin.mask = body.getBroadphaseProxy()->m_collisionFilterMask;
        return twin;
    }

    void apply(const Moment& moment, btDiscreteDynamicsWorld& world) {
        for (const std::size_t number : moment.left) world.removeRigidBody(twins_[number].body.get());
        for (const std::size_t number : moment.came)
            world.addRigidBody(twins_[number].body.get(), twins_[number].group, twins_[number].mask);
        for (const State& state : moment.states) {
            btRigidBody& body = *twins_[state.number].body;
            body.setCenterOfMassTransform(state.place);
            body.setInterpolationWorldTransform(state.place);
            body.setLinearVelocity(state.velocity);
            body.setAngularVelocity(state.turning);
            body.forceActivationState(state.activation);
        }
    }

    const btVector3 gravity_;
    std::map<Key, std::size_t> here_;
    std::vector<Twin> twins_;
    std::vector<Moment> moments_;
};

}  // namespace sherd::benchmarks
