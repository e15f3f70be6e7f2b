#include "core/loads/spring_system.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/linear_algebra/lanczos.h"
#include "core/loads/support_answer.h"
#include "core/numerics/pi.h"

namespace sherd {

namespace {

/// What a mass moves under a half sine wave until its peak, over force / mass: (pi / 2 - 1) (T / pi)^2.
double travel(double duration_s) {
    return (pi / 2 - 1) * duration_s * duration_s / (pi * pi);
}

SpringEnd endAt(const Partner* partner, const Vec3& point, const Vec3& force) {
    if (!partner) return {};
    return {partner, partner->root * partner->mobility.wrench(point, force)};
}

double waveSpeed(const ContactBody& body) {
    return std::sqrt(body.material.youngs_modulus_pa / body.material.density_kg_m3);
}

void addSprings(const ContactBody& body, const Foundation& foundation, double duration_s,
                SpringSystem& system) {
    const double reached = waveShare(foundation.distance_m / waveSpeed(body), duration_s);
    if (!(reached > 0)) return;
    const Partner* partner = system.partner(foundation.partner_number, foundation.partner);
    for (const FoundationPoint& point : foundation.points) {
        Spring spring;
        spring.position = point.position;
        spring.push = foundation.push;
        spring.stiffness_n_m = point.share * reached * foundation.stiffness_n_m;
        spring.own = system.struck_root * body.mobility.wrench(point.position, foundation.push);
        spring.ends[0] = endAt(partner, point.position, -foundation.push);
        system.springs.push_back(spring);
    }
}

Mobility mobilityOf(const Stack& stack, int number) {
    const StackBody* body = stack.body(number);
    return body ? body->mobility : Mobility{};
}

/// The springs between partners. A wave is taken to run through them as through the struck body.
void addSprings(const ContactBody& body, const Stack& stack, const Vec3& from, double duration_s,
                SpringSystem& system) {
    for (const StackContact& contact : stack.contacts) {
        const double reached = waveShare((contact.point - from).norm() / waveSpeed(body), duration_s);
        if (!(reached > 0)) continue;
        Spring spring;
        spring.position = contact.point;
        spring.push = contact.push;
        spring.is_own = false;
        spring.stiffness_n_m = reached * contact.stiffness_n_m;
        spring.ends[0] = endAt(system.partner(contact.first, mobilityOf(stack, contact.first)), contact.point,
                               contact.push);
        spring.ends[1] = endAt(system.partner(contact.second, mobilityOf(stack, contact.second)),
                               contact.point, -contact.push);
        system.springs.push_back(spring);
    }
}

/// Leaves out what no spring stretches: one bed of springs takes three of a partner's six motions.
void findMotions(SpringSystem& system) {
    constexpr double unmoved = 1e-12;  // of the largest sum of squares
    std::vector<SpringEnd*> ends{&system.distant};
    for (Spring& spring : system.springs)
        for (SpringEnd& end : spring.ends) ends.push_back(&end);
    for (auto& numbered : system.partners) {
        Partner& partner = numbered.second;
        Eigen::Matrix<double, 6, 6> squares = Eigen::Matrix<double, 6, 6>::Zero();
        for (const SpringEnd* end : ends)
            if (end->partner == &partner) squares += end->stretch * end->stretch.transpose();
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> axes(squares);
        const Wrench& values = axes.eigenvalues();  // ascending
        const long count = (values.array() > unmoved * values[5]).count();
        partner.motions = axes.eigenvectors().rightCols(count);
        partner.place = system.size;
        system.size += count;
    }
    for (SpringEnd* end : ends)
        if (end->partner) end->of_motions = end->partner->motions.transpose() * end->stretch;
}

Eigen::VectorXd strikeOn(const SpringSystem& system) {
    Eigen::VectorXd strike = Eigen::VectorXd::Zero(system.size);
    strike.head<6>() = system.strike;
    if (const Partner* p = system.distant.partner)
        strike.segment(p->place, p->motions.cols()) = system.distant.of_motions;
    return strike;
}

Eigen::MatrixXd stiffnessOf(const SpringSystem& system, const std::vector<char>& pressed) {
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(system.size, system.size);
    for (std::size_t i = 0; i < system.springs.size(); ++i) {
        if (!pressed[i]) continue;
        const Spring& spring = system.springs[i];
        const double k = spring.stiffness_n_m;
        if (spring.is_own) stiffness.topLeftCorner<6, 6>() += k * spring.own * spring.own.transpose();
        for (const SpringEnd& row : spring.ends) {
            if (!row.partner) continue;
            const long place = row.partner->place, count = row.of_motions.size();
            const Motions force = k * row.of_motions;
            if (spring.is_own) stiffness.block(place, 0, count, 6) += force * spring.own.transpose();
            for (const SpringEnd& column : spring.ends)
                if (column.partner && column.partner->place <= place)
                    stiffness.block(place, column.partner->place, count, column.of_motions.size()) +=
                        force * column.of_motions.transpose();
        }
    }
    return stiffness;  // its lower triangle
}

/// The rigid bodies' displacement by a unit strike, on those springs that are pressed.
struct Rest {
    Eigen::VectorXd displacement;
    double held = 0;
};

Rest restOn(const SpringSystem& system, const std::vector<char>& pressed, const Eigen::VectorXd& strike,
            double duration_s) {
    const auto answered = [&](double squared_rate) {
        return springShare(std::sqrt(std::max(0.0, squared_rate)), duration_s);
    };
    const auto moved = [&](double squared_rate) {
        const double share = answered(squared_rate);
        return share > 0 ? share / squared_rate : travel(duration_s);
    };
    FunctionProduct found = functionProduct(stiffnessOf(system, pressed), strike, moved);
    return {std::move(found.product), (found.weights * found.values.unaryExpr(answered)).sum()};
}

double force(const SpringSystem& system, const Spring& spring, const Eigen::VectorXd& displacement) {
    return -spring.stiffness_n_m * system.stretch(spring, displacement);
}

/// How much of a step to go until the potential of springs that only push is least. `at_start` is what each
/// presses there, N, negative where it would pull, and `per_step` what the whole step adds; `slope` and
/// `curvature` are those of the potential without springs. By Newton's method on a slope that is linear in
/// parts and grows.
double bestLength(const std::vector<Spring>& springs, const Eigen::VectorXd& at_start,
                  const Eigen::VectorXd& per_step, double slope, double curvature) {
    constexpr int most_turns = 20;
    double length = 1;
    for (int turn = 0; turn < most_turns; ++turn) {
        double slope_here = slope + length * curvature, curvature_here = curvature;
        for (std::size_t i = 0; i < springs.size(); ++i) {
            const double pressing = at_start[i] + length * per_step[i];
            if (!(pressing > 0)) continue;
            slope_here += pressing * per_step[i] / springs[i].stiffness_n_m;
            curvature_here += per_step[i] * per_step[i] / springs[i].stiffness_n_m;
        }
        if (!(curvature_here > 0)) break;
        const double change = slope_here / curvature_here;
        length = std::max(0.0, length - change);
        if (std::abs(change) < 1e-9 * length) break;
    }
    return length;
}

/// About which springs are pressed: those under the bodies' displacements u that make 1/2 u.u / travel +
/// 1/2 sum k pressed^2 - strike.u least. That is convex, so that it is found however many springs come and
/// go; it stands for the bodies' inertia by what free ones travel.
void pressAbout(const SpringSystem& system, const Eigen::VectorXd& strike, double duration_s,
                std::vector<char>& pressed) {
    constexpr int most_rounds = 100;
    const std::vector<Spring>& springs = system.springs;
    const auto count = static_cast<long>(springs.size());
    const double inertia = 1 / travel(duration_s);
    Eigen::VectorXd displacement = Eigen::VectorXd::Zero(system.size), presses = Eigen::VectorXd::Zero(count);
    Eigen::VectorXd per_step(count);
    for (int round = 0; round < most_rounds; ++round) {
        Eigen::MatrixXd stiffness = stiffnessOf(system, pressed);
        stiffness.diagonal().array() += inertia;
        const Eigen::VectorXd step =
            Eigen::LLT<Eigen::MatrixXd>(std::move(stiffness)).solve(strike) - displacement;
        for (long i = 0; i < count; ++i) per_step[i] = force(system, springs[i], step);
        const double length =
            bestLength(springs, presses, per_step, inertia * displacement.dot(step) - strike.dot(step),
                       inertia * step.squaredNorm());
        displacement += length * step;
        presses += length * per_step;
        bool same = true;
        for (long i = 0; i < count; ++i) {
            const char is_pressed = presses[i] > 0;
            same = same && is_pressed == pressed[i];
            pressed[i] = is_pressed;
        }
        if (same) break;
    }
}

/// Lets springs that would pull go and come back until those that are on the wrong side count for nothing.
/// Returns where the bodies are then.
Rest settle(const SpringSystem& system, const Eigen::VectorXd& strike, double duration_s,
            std::vector<char>& pressed) {
    constexpr double nothing_n = 5e-3;  // of a strike of 1 N
    constexpr int most_rounds = 30;
    constexpr int free_rounds = 2;  // then springs only leave: those of a heap may come and go for ever
    std::vector<char> next(system.springs.size());
    Rest rest;
    for (int round = 0; round < most_rounds; ++round) {
        rest = restOn(system, pressed, strike, duration_s);
        double wrong_n = 0;
        for (std::size_t i = 0; i < next.size(); ++i) {
            const double pressing = force(system, system.springs[i], rest.displacement);
            next[i] = (pressed[i] || round < free_rounds) && pressing > 0;
            if (next[i] != pressed[i]) wrong_n += std::abs(pressing);
        }
        if (!(wrong_n > nothing_n)) break;
        pressed = next;
    }
    return rest;
}

}  // namespace

double SpringSystem::stretch(const Spring& spring, const Eigen::VectorXd& displacement) const {
    double stretch = spring.own.dot(displacement.head<6>());
    for (const SpringEnd& end : spring.ends)
        if (const Partner* p = end.partner)
            stretch += end.of_motions.dot(displacement.segment(p->place, p->motions.cols()));
    return stretch;
}

const Partner* SpringSystem::partner(int number, const Mobility& mobility) {
    if (mobility.fixed()) return nullptr;
    return &partners.try_emplace(number, Partner{mobility, mobility.root()}).first->second;
}

SpringSystem springSystemOf(const ContactBody& body, const std::vector<Foundation>& foundations,
                            const std::vector<PointForce>& unit_strike, double duration_s,
                            const Stack& stack) {
    const bool is_distant = unit_strike.empty();
    SpringSystem system;
    system.struck_root = body.mobility.root() / std::sqrt(is_distant ? 1 : movingShare(body, duration_s));
    for (const Foundation& foundation : foundations) addSprings(body, foundation, duration_s, system);
    if (system.springs.empty()) return system;
    addSprings(body, stack, is_distant ? stack.strike.point : unit_strike.front().position, duration_s,
               system);
    for (const PointForce& force : unit_strike)
        system.strike += system.struck_root * body.mobility.wrench(force.position, force.force);
    if (is_distant)
        system.distant = endAt(system.partner(stack.strike.number, mobilityOf(stack, stack.strike.number)),
                               stack.strike.point, stack.strike.push);
    findMotions(system);
    return system;
}

Pressed pressedSprings(const SpringSystem& system, double duration_s,
                       const std::vector<char>& pressed_before) {
    const Eigen::VectorXd strike = strikeOn(system);
    const std::vector<Spring>& springs = system.springs;
    std::vector<char> pressed = pressed_before;
    if (pressed.size() != springs.size()) pressed.assign(springs.size(), 1);
    pressAbout(system, strike, duration_s, pressed);
    const Rest rest = settle(system, strike, duration_s, pressed);
    Pressed found{std::vector<double>(springs.size()), rest.held, {}};
    for (std::size_t i = 0; i < springs.size(); ++i)
        if (pressed[i]) found.forces_n[i] = std::max(0.0, force(system, springs[i], rest.displacement));
    found.pressed = std::move(pressed);
    return found;
}

}  // namespace sherd
