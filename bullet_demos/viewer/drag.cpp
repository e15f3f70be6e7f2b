#include "viewer/drag.h"

#include "viewer/conversions.h"

namespace demo {

bool Drag::take(const render::Ray& ray) {
    letGo();
    const RayHit hit = castRay(world_, ray);
    if (!hit.body || hit.body->isStaticOrKinematicObject()) return false;
    body_ = hit.body;
    distance_m_ = hit.distance_m;
    body_->setActivationState(DISABLE_DEACTIVATION);
    joint_ = std::make_unique<btPoint2PointConstraint>(
        *body_, body_->getCenterOfMassTransform().inverse() * hit.point);
    // Soft, and no stronger than a hand for what it holds: a few times the weight a step.
    joint_->m_setting.m_tau = 0.1f;
    joint_->m_setting.m_impulseClamp = 0.5f / body_->getInvMass();
    world_.addConstraint(joint_.get(), true);
    return true;
}

void Drag::moveTo(const render::Ray& ray) {
    if (joint_) joint_->setPivotB(toBullet(ray.origin + float(distance_m_) * ray.direction));
}

void Drag::letGo() {
    if (!joint_) return;
    world_.removeConstraint(joint_.get());
    joint_.reset();
    body_->forceActivationState(ACTIVE_TAG);
    body_->activate();
}

void Drag::forget(const btTypedConstraint* removed) {
    if (joint_.get() == removed) joint_.reset();
}

}  // namespace demo
