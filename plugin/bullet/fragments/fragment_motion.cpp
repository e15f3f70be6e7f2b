#include "bullet/fragments/fragment_motion.h"

#include <algorithm>
#include <cmath>

#include "bullet/world/conversions.h"

namespace sherd {

namespace {

double massOf(const btRigidBody& body) {
    return 1 / static_cast<double>(body.getInvMass());
}

Vec3 centreOf(const btRigidBody& body) {
    return fromBullet(body.getWorldTransform().getOrigin());
}

/// Inertia about the centre of mass, world axes; 0 about axes that the app locked with an infinite inertia.
Mat3 inertiaOf(const btRigidBody& body) {
    const Vec3 inverse = fromBullet(body.getInvInertiaDiagLocal());
    const Vec3 diagonal = (inverse.array() > 0).select(inverse.cwiseInverse(), 0);
    const Mat3 axes = fromBullet(body.getWorldTransform().getBasis());
    return axes * diagonal.asDiagonal() * axes.transpose();
}

/// The pieces as one rigid body.
struct Assembly {
    double mass = 0;
    Vec3 centre = Vec3::Zero();
    Mat3 inertia = Mat3::Zero();  // about the centre
};

Assembly assemble(const std::vector<btRigidBody*>& pieces) {
    Assembly all;
    for (const btRigidBody* piece : pieces) {
        all.mass += massOf(*piece);
        all.centre += massOf(*piece) * centreOf(*piece);
    }
    all.centre /= all.mass;
    for (const btRigidBody* piece : pieces) {
        const Vec3 arm = centreOf(*piece) - all.centre;
        all.inertia += inertiaOf(*piece) +
                       massOf(*piece) * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
    }
    return all;
}

/// How fast the pieces turn together, by the angular momentum of the whole. What Bullet gives hulls and
/// compounds is the inertia of the box around them: the pieces have less, and would turn many times as fast.
/// Where they would have more energy than the whole, they go on as it turned.
Vec3 commonSpin(const btRigidBody& whole, const Assembly& pieces, const Vec3& momentum) {
    constexpr double rounding = 1e-5;
    const Vec3 spin = fromBullet(whole.getAngularVelocity());
    const bool turns_freely = fromBullet(whole.getInvInertiaDiagLocal()).minCoeff() > 0;
    if (!turns_freely) return spin;
    const Mat3 inertia = inertiaOf(whole);
    const Vec3 angular = inertia * spin - (pieces.centre - centreOf(whole)).cross(momentum);
    const Vec3 kept = pieces.inertia.ldlt().solve(angular);
    const double twice_energy = spin.dot(inertia * spin);
    if (!(kept.dot(angular) > (1 + rounding) * twice_energy)) return kept;
    const double if_same = spin.dot(pieces.inertia * spin);
    return if_same > twice_energy ? Vec3(std::sqrt(twice_energy / if_same) * spin) : spin;
}

/// Bullet multiplies applied forces by the factors of a body. Divides by them, so that they are not applied
/// twice.
Vec3 unscaled(const Vec3& v, const Vec3& factor) {
    return (factor.array() != 0).select(v.cwiseQuotient(factor), 0);
}

}  // namespace

void shareMotion(const btRigidBody& whole, const std::vector<btRigidBody*>& pieces) {
    const Assembly all = assemble(pieces);
    const Vec3 momentum = massOf(whole) * fromBullet(whole.getLinearVelocity());
    const Vec3 velocity = momentum / all.mass;
    const Vec3 common_spin = commonSpin(whole, all, momentum);
    for (btRigidBody* piece : pieces) {
        piece->setLinearVelocity(toBullet(Vec3(velocity + common_spin.cross(centreOf(*piece) - all.centre))));
        piece->setAngularVelocity(toBullet(common_spin));
        // Until the next step the pieces are drawn as they moved when they were one body.
        const btVector3 spin_drawn = whole.getInterpolationAngularVelocity();
        const btVector3 arm = piece->getCenterOfMassPosition() - whole.getCenterOfMassPosition();
        piece->setInterpolationLinearVelocity(whole.getInterpolationLinearVelocity() + spin_drawn.cross(arm));
        piece->setInterpolationAngularVelocity(spin_drawn);
    }
}

void followMotion(const btRigidBody& whole, const std::vector<btRigidBody*>& pieces) {
    for (btRigidBody* piece : pieces) {
        const btVector3 arm = piece->getCenterOfMassPosition() - whole.getCenterOfMassPosition();
        piece->setLinearVelocity(whole.getLinearVelocity() + whole.getAngularVelocity().cross(arm));
        piece->setAngularVelocity(whole.getAngularVelocity());
    }
}

void pushAsOne(const std::vector<btRigidBody*>& pieces, const std::vector<Push>& pushes) {
    const Assembly all = assemble(pieces);
    Vec3 impulse = Vec3::Zero(), angular = Vec3::Zero();
    for (const Push& push : pushes) {
        impulse += fromBullet(push.impulse_n_s);
        angular += (fromBullet(push.point) - all.centre).cross(fromBullet(push.impulse_n_s));
    }
    Vec3 gained = impulse / all.mass, spin = all.inertia.ldlt().solve(angular);
    double share = 1;
    for (const Push& push : pushes) {
        const Vec3 motion = gained + spin.cross(fromBullet(push.point) - all.centre);
        const double speed = motion.dot(fromBullet(push.impulse_n_s).normalized());
        if (speed > push.speed_m_s) share = std::min(share, push.speed_m_s / speed);
    }
    gained *= share;
    spin *= share;
    for (btRigidBody* piece : pieces) {
        const btVector3 velocity = toBullet(Vec3(gained + spin.cross(centreOf(*piece) - all.centre)));
        piece->setLinearVelocity(piece->getLinearVelocity() + velocity * piece->getLinearFactor());
        piece->setAngularVelocity(piece->getAngularVelocity() + toBullet(spin) * piece->getAngularFactor());
    }
}

void shareForces(const btRigidBody& whole, const std::vector<btRigidBody*>& pieces, bool gravity_if_none) {
    const Vec3 force = fromBullet(whole.getTotalForce()), torque = fromBullet(whole.getTotalTorque());
    // Bullet applies no gravity to a body that sleeps when the step begins. Its fragments are active and get
    // theirs.
    const bool slept = gravity_if_none && force.norm() == 0 && torque.norm() == 0;
    const btVector3 weight = whole.getGravity() * (1 / whole.getInvMass()) * whole.getLinearFactor();
    const bool weighs_alone = force.norm() > 0 && torque.norm() == 0 && whole.getTotalForce() == weight;
    if (slept || weighs_alone) {
        // To the last bit what Bullet gives them at the beginning of a frame: whether that is this substep or
        // the next one, they fall alike.
        for (btRigidBody* piece : pieces)
            piece->applyCentralForce(whole.getGravity() * (1 / piece->getInvMass()));
        return;
    }
    const Vec3 acceleration = unscaled(force / massOf(whole), fromBullet(whole.getLinearFactor()));
    const Vec3 turning =
        fromBullet(whole.getInvInertiaTensorWorld()) * unscaled(torque, fromBullet(whole.getAngularFactor()));
    for (btRigidBody* piece : pieces) {
        const Vec3 arm = centreOf(*piece) - centreOf(whole);
        piece->applyCentralForce(toBullet(Vec3(massOf(*piece) * (acceleration + turning.cross(arm)))));
        piece->applyTorque(toBullet(Vec3(inertiaOf(*piece) * turning)));
    }
}

double momentumDifference(const btRigidBody& whole, const std::vector<const btRigidBody*>& pieces) {
    Vec3 linear = massOf(whole) * fromBullet(whole.getLinearVelocity());
    Vec3 angular = inertiaOf(whole) * fromBullet(whole.getAngularVelocity());
    double linear_scale = linear.norm(), angular_scale = angular.norm();
    for (const btRigidBody* piece : pieces) {
        const Vec3 momentum = massOf(*piece) * fromBullet(piece->getLinearVelocity());
        const Vec3 orbital = (centreOf(*piece) - centreOf(whole)).cross(momentum);
        const Vec3 own = inertiaOf(*piece) * fromBullet(piece->getAngularVelocity());
        linear -= momentum;
        angular -= orbital + own;
        linear_scale += momentum.norm();
        angular_scale += orbital.norm() + own.norm();
    }
    const auto relative = [](double difference, double scale) { return scale == 0 ? 0 : difference / scale; };
    return std::max(relative(linear.norm(), linear_scale), relative(angular.norm(), angular_scale));
}

}  // namespace sherd
