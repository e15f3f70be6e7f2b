#include "core/loads/strike.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/numerics/pi.h"

namespace sherd {

namespace {

constexpr double give = 0.01, least_give = 1e-3;  // of a point's own mobility

using Points = std::vector<StrikePoint>;

/// Places in a strike of the points of each partner, which stand in the order of the partners' numbers.
using ByPartner = std::map<int, std::vector<int>>;

ByPartner placesByPartner(const Points& points) {
    ByPartner places;
    for (std::size_t i = 0; i < points.size(); ++i)
        places[points[i].contact->partner].push_back(static_cast<int>(i));
    return places;
}

Points at(const Points& all, const std::vector<int>& places) {
    Points some;
    for (const int place : places) some.push_back(all[place]);
    return some;
}

/// Velocity changes along the normals over normal impulses, #points x #points, 1/kg.
Eigen::MatrixXd normalMobility(const Mobility& mobility, const Points& points) {
    const long count = static_cast<long>(points.size());
    Eigen::MatrixXd wrenches(6, count), changes(6, count);
    for (long i = 0; i < count; ++i) {
        const ContactImpulse& contact = *points[i].contact;
        wrenches.col(i) = mobility.wrench(contact.point, contact.normal);
        changes.col(i) = mobility.response(wrenches.col(i));
    }
    return wrenches.transpose() * changes;
}

/// Of the struck body and of all that strikes it.
Eigen::MatrixXd mobilityOfAll(const Mobility& body, const Blow& blow, const Points& points,
                              const ByPartner& by_partner) {
    Eigen::MatrixXd sum = normalMobility(body, points);
    for (const auto& [number, places] : by_partner) {
        const Mobility partner = blow.partner(number);
        if (partner.fixed()) continue;
        const Eigen::MatrixXd own = normalMobility(partner, at(points, places));
        for (std::size_t j = 0; j < places.size(); ++j)
            for (std::size_t i = 0; i < places.size(); ++i)
                sum(places[i], places[j]) += own(static_cast<long>(i), static_cast<long>(j));
    }
    return sum;
}

/// Normal impulses p >= 0 with A p = v. A is singular where points are many: contacts give way a little, each
/// by itself, which makes the impulses as even as they can be, and the more the less it is present.
Eigen::VectorXd sharedImpulses(Eigen::MatrixXd a, const Eigen::VectorXd& v, const Eigen::ArrayXd& presences) {
    const long count = v.size();
    a.diagonal().array() *= give + 1 / presences.square();
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

/// Tangential force over normal force of a rigid blow by one partner at the mean of its points.
Vec3 friction(const Mobility& body, const Mobility& partner, const Points& points) {
    Vec3 place = Vec3::Zero(), normal = Vec3::Zero(), closing = Vec3::Zero();
    double sum = 0, coefficient = 0;
    for (const StrikePoint& point : points) {
        const ContactImpulse& contact = *point.contact;
        place += point.share * contact.point;
        normal += point.share * contact.normal;
        closing += point.share * (contact.approach_m_s * contact.normal + contact.slip_m_s);
        coefficient += point.share * contact.friction;
        sum += point.share;
    }
    if (!(normal.norm() > 0)) return Vec3::Zero();
    normal.normalize();
    place /= sum;
    const Vec3 impulse = (body.at(place) + partner.at(place)).ldlt().solve(closing / sum);
    const double pressed = impulse.dot(normal);
    if (!(pressed > 0)) return Vec3::Zero();
    const Vec3 held = impulse / pressed - normal;
    return held.norm() > coefficient / sum ? Vec3(coefficient / sum * held.normalized()) : held;
}

/// The velocity along the normals that points get by their pushes, each as its share says, 1/kg.
double feltMobility(const Mobility& mobility, const Points& points) {
    Wrench normal = Wrench::Zero(), push = Wrench::Zero();
    for (const StrikePoint& point : points) {
        normal += point.share * mobility.wrench(point.contact->point, point.contact->normal);
        push += point.share * mobility.wrench(point.contact->point, point.push);
    }
    // Friction may make the points feel more than the whole body; there is no more of it to stop.
    return std::max(normal.dot(mobility.response(push)),
                    mobility.inverse_mass * normal.head<3>().squaredNorm());
}

/// The force of a contact whose impulse says all, with a normal part of 1.
Vec3 alongImpulse(const ContactImpulse& contact) {
    const double pushed = contact.pushed();
    return pushed > 0 ? Vec3(contact.impulse / pushed) : contact.normal;
}

}  // namespace

const ContactImpulse* leadingTouch(const Blow& blow, double mass_kg) {
    constexpr double hard = 0.64;         // of the hardest one's energy
    constexpr double same_time_s = 1e-5;  // shorter than contacts are
    const std::vector<const ContactImpulse*> striking = blow.strikes();
    const auto energyOf = [&](const ContactImpulse& contact) {
        const double speed = contact.approach_m_s;
        return 0.5 * stoppedMass(blow.partner(contact.partner), mass_kg) * speed * speed;
    };
    double hardest = 0, first_s = -std::numeric_limits<double>::infinity();
    for (const ContactImpulse* contact : striking) hardest = std::max(hardest, energyOf(*contact));
    const auto isHard = [&](const ContactImpulse& contact) { return energyOf(contact) >= hard * hardest; };
    for (const ContactImpulse* contact : striking)
        if (isHard(*contact)) first_s = std::max(first_s, contact->touched_s);
    const ContactImpulse* leading = nullptr;
    for (const ContactImpulse* contact : striking)
        if (isHard(*contact) && contact->touched_s >= first_s - same_time_s &&
            (!leading || energyOf(*contact) > energyOf(*leading)))
            leading = contact;
    return leading;
}

double presence(double apart_s, double duration_s) {
    return std::abs(apart_s) < duration_s / 2 ? std::cos(pi * apart_s / duration_s) : 0;
}

void shareOut(const Mobility& body, const Blow& blow, Strike& strike) {
    const long count = static_cast<long>(strike.points.size());
    Eigen::VectorXd speeds(count);
    Eigen::ArrayXd presences(count);
    for (long i = 0; i < count; ++i) {
        speeds[i] = strike.points[i].contact->approach_m_s;
        presences[i] = strike.points[i].share;
    }
    const ByPartner by_partner = placesByPartner(strike.points);
    const Eigen::MatrixXd mobility = mobilityOfAll(body, blow, strike.points, by_partner);
    Eigen::VectorXd shares = sharedImpulses(mobility, speeds, presences);
    shares /= shares.sum();
    for (long i = 0; i < count; ++i) strike.points[i].share = shares[i];
    strike.speed_m_s = shares.dot(speeds);
    strike.least_mobility = least_give * mobility.diagonal().dot(shares.cwiseAbs2());
    Points of_fixed;
    strike.partner_mobility = 0;
    for (const auto& [number, places] : by_partner) {
        const Mobility partner = blow.partner(number);
        const Points own = at(strike.points, places);
        const bool known = own.front().contact->friction >= 0;
        const Vec3 lateral = known ? friction(body, partner, own) : Vec3(Vec3::Zero());
        for (const int place : places) {
            StrikePoint& point = strike.points[place];
            point.push = known ? Vec3(point.contact->normal + lateral) : alongImpulse(*point.contact);
        }
        const Points pushed = at(strike.points, places);
        if (partner.fixed())
            of_fixed.insert(of_fixed.end(), pushed.begin(), pushed.end());
        else
            strike.partner_mobility += feltMobility(partner, pushed);
    }
    strike.body_mobility = feltMobility(body, strike.points);
    strike.lasting_mobility = std::min(feltMobility(body, of_fixed), strike.body_mobility);
}

Strike strikeOn(const Stack& stack) {
    const DistantStrike& distant = stack.strike;
    Strike strike;
    const StackBody* struck = stack.body(distant.number);
    if (!struck) return strike;
    StrikePoint& point = strike.points.emplace_back();
    point.hertz = distant.hertz;
    point.share = 1;
    point.push = distant.push;
    strike.body_mobility = distant.push.dot(struck->mobility.at(distant.point) * distant.push);
    strike.partner_mobility = distant.striker_mobility;
    if (!(distant.striker_mobility > 0)) strike.lasting_mobility = strike.body_mobility;
    strike.speed_m_s = distant.speed_m_s;
    return strike;
}

double Strike::mass(double held) const {
    const double felt = (1 - held) * (body_mobility - lasting_mobility) + lasting_mobility + partner_mobility;
    return 1 / std::max(felt, least_mobility);
}

double Strike::hertzForce(double held) const {
    double force = 0;
    for (const StrikePoint& point : points)
        force += hertzPeakForce(point.hertz, point.share * mass(held), speed_m_s);
    return force;
}

double Strike::hertzDuration() const {
    const double force = hertzForce(0);
    return force > 0 ? pulseDuration(force, mass(0) * speed_m_s) : 0;
}

}  // namespace sherd
