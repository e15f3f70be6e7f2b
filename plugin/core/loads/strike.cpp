#include "core/loads/strike.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/numerics/pi.h"

namespace sherd {

namespace {

/// Velocity changes along the normals over normal impulses, #points x #points, 1/kg.
Eigen::MatrixXd normalMobility(const Mobility& mobility, const Strike& strike) {
    const long count = static_cast<long>(strike.points.size());
    Eigen::MatrixXd wrenches(6, count), changes(6, count);
    for (long i = 0; i < count; ++i) {
        const ContactImpulse& contact = *strike.points[i].contact;
        wrenches.col(i) = mobility.wrench(contact.point, contact.normal);
        changes.col(i) = mobility.response(wrenches.col(i));
    }
    return wrenches.transpose() * changes;
}

/// Normal impulses p >= 0 with A p = v. A is singular where points are many: contacts give way a little, each
/// by itself, which makes the impulses as even as they can be.
Eigen::VectorXd sharedImpulses(Eigen::MatrixXd a, const Eigen::VectorXd& v) {
    constexpr double give = 0.01;  // of a point's own mobility
    const long count = v.size();
    a.diagonal() *= 1 + give;
    std::vector<int> pressed(count);
    for (int i = 0; i < count; ++i) pressed[i] = i;
    Eigen::VectorXd impulses = Eigen::VectorXd::Zero(count);
    while (!pressed.empty()) {
        const Eigen::VectorXd p = a(pressed, pressed).llt().solve(v(pressed));
        std::vector<int> kept;
        for (std::size_t i = 0; i < pressed.size(); ++i)
            if (p[static_cast<long>(i)] > 0) kept.push_back(pressed[i]);
        impulses.setZero();
        impulses(pressed) = p;
        if (kept.size() == pressed.size()) break;
        pressed = kept;
    }
    return impulses.cwiseMax(0);
}

/// Tangential force over normal force of a rigid blow at the points' mean.
Vec3 friction(const Mobility& body, const Mobility& partner, const Strike& strike) {
    Vec3 place = Vec3::Zero(), normal = Vec3::Zero(), closing = Vec3::Zero();
    double coefficient = 0;
    for (const StrikePoint& point : strike.points) {
        const ContactImpulse& contact = *point.contact;
        place += point.share * contact.point;
        normal += point.share * contact.normal;
        closing += point.share * (contact.approach_m_s * contact.normal + contact.slip_m_s);
        coefficient += point.share * contact.friction;
    }
    if (!(normal.norm() > 0)) return Vec3::Zero();
    normal.normalize();
    const Vec3 impulse = (body.at(place) + partner.at(place)).ldlt().solve(closing);
    const double pressed = impulse.dot(normal);
    if (!(pressed > 0)) return Vec3::Zero();
    const Vec3 held = impulse / pressed - normal;
    return held.norm() > coefficient ? Vec3(coefficient * held.normalized()) : held;
}

/// The velocity along the normals that the strike's points get by its pushes, each as its share says, 1/kg.
double feltMobility(const Mobility& mobility, const Strike& strike) {
    Wrench normal = Wrench::Zero(), push = Wrench::Zero();
    for (const StrikePoint& point : strike.points) {
        normal += point.share * mobility.wrench(point.contact->point, point.contact->normal);
        push += point.share * mobility.wrench(point.contact->point, point.push);
    }
    // Friction may make the points feel more than the whole body; there is no more of it to stop.
    return std::max(normal.dot(mobility.response(push)), mobility.inverse_mass);
}

/// The force of a contact whose impulse says all, with a normal part of 1.
Vec3 alongImpulse(const ContactImpulse& contact) {
    const double pushed = contact.pushed();
    return pushed > 0 ? Vec3(contact.impulse / pushed) : contact.normal;
}

}  // namespace

const ContactImpulse* leadingTouch(const std::vector<ContactImpulse>& contacts, int partner) {
    constexpr double hard = 0.8;  // of the fastest: two thirds of its energy
    const auto counts = [&](const ContactImpulse& contact) {
        return contact.strikes() && (partner == any_partner || contact.partner == partner);
    };
    double fastest = 0;
    for (const ContactImpulse& contact : contacts)
        if (counts(contact)) fastest = std::max(fastest, contact.approach_m_s);
    const ContactImpulse* first = nullptr;
    for (const ContactImpulse& contact : contacts)
        if (counts(contact) && contact.approach_m_s >= hard * fastest &&
            (!first || contact.touched_s > first->touched_s))
            first = &contact;
    return first;
}

double presence(double apart_s, double duration_s) {
    return std::abs(apart_s) < duration_s / 2 ? std::cos(pi * apart_s / duration_s) : 0;
}

void shareOut(const Mobility& body, const Mobility& partner, Strike& strike) {
    Eigen::VectorXd speeds(static_cast<long>(strike.points.size()));
    for (long i = 0; i < speeds.size(); ++i) speeds[i] = strike.points[i].contact->approach_m_s;
    const Eigen::VectorXd impulses =
        sharedImpulses(normalMobility(body, strike) + normalMobility(partner, strike), speeds);
    double sum = 0;
    for (long i = 0; i < speeds.size(); ++i) sum += strike.points[i].share *= impulses[i];
    strike.speed_m_s = 0;
    for (StrikePoint& point : strike.points) {
        point.share /= sum;
        strike.speed_m_s += point.share * point.contact->approach_m_s;
    }
    const bool known = strike.points.front().contact->friction >= 0;
    const Vec3 lateral = known ? friction(body, partner, strike) : Vec3(Vec3::Zero());
    for (StrikePoint& point : strike.points)
        point.push = known ? Vec3(point.contact->normal + lateral) : alongImpulse(*point.contact);
    strike.body_mobility = feltMobility(body, strike);
    strike.partner_mobility = feltMobility(partner, strike);
}

Strike strikeOn(const Stack& stack) {
    const DistantStrike& distant = stack.strike;
    Strike strike;
    const StackBody* struck = stack.body(distant.number);
    if (!struck) return strike;
    strike.points.push_back({nullptr, {}, distant.hertz, 1, distant.push});
    strike.body_mobility = distant.push.dot(struck->mobility.at(distant.point) * distant.push);
    strike.partner_mobility = distant.striker_mobility;
    strike.speed_m_s = distant.speed_m_s;
    return strike;
}

double Strike::mass(double held) const {
    return 1 / (partner_mobility > 0 ? (1 - held) * body_mobility + partner_mobility : body_mobility);
}

double Strike::hertzDuration() const {
    double force = 0;
    for (const StrikePoint& point : points)
        force += hertzPeakForce(point.hertz, point.share * mass(0), speed_m_s);
    return force > 0 ? pulseDuration(force, mass(0) * speed_m_s) : 0;
}

}  // namespace sherd
