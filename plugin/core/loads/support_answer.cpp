#include "core/loads/support_answer.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/linear_algebra/dense_kernels.h"
#include "core/numerics/pi.h"

namespace sherd {

namespace {

/// What a mass moves under a half sine wave until its peak, over force / mass: (pi / 2 - 1) (T / pi)^2.
double travel(double duration_s) {
    return (pi / 2 - 1) * duration_s * duration_s / (pi * pi);
}

/// A partner that gives way, by its number.
struct Partner {
    Mobility mobility;
    Eigen::Matrix<double, 6, 6> root;
    /// Orthonormal columns: the motions that stretch its springs; in the others it stays as it is.
    Eigen::Matrix<double, 6, Eigen::Dynamic> motions = {};
    long place = 0;  ///< of the first of them in the system
};

/// A spring between the struck body and a partner, in coordinates in which all masses are 1.
struct Spring {
    Vec3 position, push;
    double stiffness_n_m = 0;
    Wrench own = Wrench::Zero();  ///< stretch by the struck body's motions
    Wrench partners = Wrench::Zero();
    const Partner* partner = nullptr;  ///< none: it does not give way
    Eigen::VectorXd of_motions;        ///< stretch by the partner's `motions`
};

/// Rigid bodies with springs between them: six displacements of the struck body, then those of the partners.
struct SpringSystem {
    Eigen::Matrix<double, 6, 6> struck_root;
    std::map<int, Partner> partners;
    std::vector<Spring> springs;
    long size = 6;

    double stretch(const Spring& spring, const Eigen::VectorXd& displacement) const {
        double stretch = spring.own.dot(displacement.head<6>());
        if (const Partner* p = spring.partner)
            stretch += spring.of_motions.dot(displacement.segment(p->place, p->motions.cols()));
        return stretch;
    }
};

void addSprings(const ContactBody& body, const Foundation& foundation, double duration_s,
                SpringSystem& system) {
    const double speed = std::sqrt(body.material.youngs_modulus_pa / body.material.density_kg_m3);
    const double reached = waveShare(foundation.distance_m / speed, duration_s);
    if (!(reached > 0)) return;
    const Mobility& mobility = foundation.partner;
    const Partner* partner = nullptr;
    if (!mobility.fixed())
        partner = &system.partners.try_emplace(foundation.partner_number, Partner{mobility, mobility.root()})
                       .first->second;
    for (const FoundationPoint& point : foundation.points) {
        Spring spring;
        spring.position = point.position;
        spring.push = foundation.push;
        spring.stiffness_n_m = point.share * reached * foundation.stiffness_n_m;
        spring.own = system.struck_root * body.mobility.wrench(point.position, foundation.push);
        spring.partner = partner;
        if (partner)
            spring.partners = -partner->root * partner->mobility.wrench(point.position, foundation.push);
        system.springs.push_back(spring);
    }
}

/// Leaves out what no spring stretches: one bed of springs takes three of a partner's six motions.
void findMotions(SpringSystem& system) {
    constexpr double unmoved = 1e-12;  // of the largest sum of squares
    for (auto& numbered : system.partners) {
        Partner& partner = numbered.second;
        Eigen::Matrix<double, 6, 6> squares = Eigen::Matrix<double, 6, 6>::Zero();
        for (const Spring& spring : system.springs)
            if (spring.partner == &partner) squares += spring.partners * spring.partners.transpose();
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> axes(squares);
        const Wrench& values = axes.eigenvalues();  // ascending
        const long count = (values.array() > unmoved * values[5]).count();
        partner.motions = axes.eigenvectors().rightCols(count);
        partner.place = system.size;
        system.size += count;
    }
    for (Spring& spring : system.springs)
        if (spring.partner) spring.of_motions = spring.partner->motions.transpose() * spring.partners;
}

Eigen::MatrixXd stiffnessOf(const SpringSystem& system, const std::vector<char>& pressed) {
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(system.size, system.size);
    for (std::size_t i = 0; i < system.springs.size(); ++i) {
        if (!pressed[i]) continue;
        const Spring& spring = system.springs[i];
        const Wrench force = spring.stiffness_n_m * spring.own;
        stiffness.topLeftCorner<6, 6>() += force * spring.own.transpose();
        if (!spring.partner) continue;
        const long place = spring.partner->place, count = spring.of_motions.size();
        stiffness.block(place, 0, count, 6) += spring.of_motions * force.transpose();
        stiffness.block(place, place, count, count) +=
            spring.stiffness_n_m * spring.of_motions * spring.of_motions.transpose();
    }
    return stiffness;  // its lower triangle
}

/// The rigid bodies' displacement by a unit strike, on those springs that are pressed.
struct Rest {
    Eigen::VectorXd displacement;
    double held = 0;
};

Rest restOn(const SpringSystem& system, const std::vector<char>& pressed, const Wrench& strike,
            double duration_s) {
    Eigen::MatrixXd modes = stiffnessOf(system, pressed);
    Eigen::VectorXd squared(system.size);
    Rest rest{Eigen::VectorXd::Zero(system.size), 0};
    if (!symmetricEigenvectors(modes.data(), static_cast<int>(system.size), squared.data())) return rest;
    double free = 0, left = 0;
    for (long k = 0; k < system.size; ++k) {
        const double omega = std::sqrt(std::max(0.0, squared[k])), part = modes.col(k).head<6>().dot(strike);
        const double answered = springShare(omega, duration_s);
        const double moved = answered > 0 ? answered / (omega * omega) : travel(duration_s);
        rest.displacement += moved * part * modes.col(k);
        free += part * part;
        left += part * part * (1 - answered);
    }
    rest.held = free > 0 ? 1 - left / free : 0;
    return rest;
}

}  // namespace

double springShare(double omega_rad_s, double duration_s) {
    constexpr double slow = 1e-3;       // of a swing in the pulse: no answer, to rounding
    constexpr double statical = 0.643;  // r at which D is 1 for the first time
    if (omega_rad_s * duration_s < slow) return 0;
    const double r = pi / (omega_rad_s * duration_s);
    if (r <= statical) return 1;
    constexpr double near_one = 1e-4;  // where both sides of the quotient vanish
    if (std::abs(r - 1) < near_one) return 0.5;
    return (1 - r * std::sin(pi / (2 * r))) / (1 - r * r);
}

double waveShare(double delay_s, double duration_s) {
    return delay_s < duration_s / 2 ? std::min(1.0, 2 * std::cos(pi * delay_s / duration_s)) : 0;
}

double movingShare(const ContactBody& body, double duration_s) {
    const Material& m = body.material;
    const double wall = body.wall_thickness_m, nu = m.poisson_ratio;
    const double bending = m.youngs_modulus_pa * std::pow(wall, 3) / (12 * (1 - nu * nu));
    const double damping = 8 * std::sqrt(bending * m.density_kg_m3 * wall);
    return std::min(1.0, damping * duration_s / pi * body.mobility.inverse_mass);
}

SupportAnswer supportAnswer(const ContactBody& body, const std::vector<Foundation>& foundations,
                            const std::vector<PointForce>& unit_strike, double duration_s) {
    SupportAnswer answer;
    SpringSystem system;
    system.struck_root = body.mobility.root() / std::sqrt(movingShare(body, duration_s));
    for (const Foundation& foundation : foundations) addSprings(body, foundation, duration_s, system);
    const std::vector<Spring>& springs = system.springs;
    if (springs.empty()) return answer;
    findMotions(system);
    Wrench wrench = Wrench::Zero();
    for (const PointForce& force : unit_strike) wrench += body.mobility.wrench(force.position, force.force);
    const Wrench strike = system.struck_root * wrench;

    // Springs that would pull let go, and those that are pressed after all come back, until it stays so. The
    // bound is for the few arrangements that go round in circles.
    constexpr int most_rounds = 30;
    std::vector<char> pressed(springs.size(), 1), next(springs.size());
    Rest rest;
    for (int round = 0; round < most_rounds; ++round) {
        rest = restOn(system, pressed, strike, duration_s);
        for (std::size_t i = 0; i < springs.size(); ++i)
            next[i] = -system.stretch(springs[i], rest.displacement) > 0;
        if (next == pressed) break;
        pressed = next;
    }
    answer.held = rest.held;
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const double force = -springs[i].stiffness_n_m * system.stretch(springs[i], rest.displacement);
        if (!pressed[i] || !(force > 0)) continue;
        answer.forces.push_back({springs[i].position, force * springs[i].push});
        answer.sum_n += force;
    }
    return answer;
}

}  // namespace sherd
