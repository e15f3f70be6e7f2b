#include "core/loads/support_answer.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "core/numerics/pi.h"

namespace sherd {

namespace {

/// What a mass moves under a half sine wave until its peak, over force / mass: (pi / 2 - 1) (T / pi)^2.
double travel(double duration_s) {
    return (pi / 2 - 1) * duration_s * duration_s / (pi * pi);
}

/// The part of the mass that a strike sets going while it lasts, 0 to 1.
double movingShare(const ContactBody& body, double duration_s) {
    const Material& m = body.material;
    const double wall = body.wall_thickness_m, nu = m.poisson_ratio;
    const double bending = m.youngs_modulus_pa * std::pow(wall, 3) / (12 * (1 - nu * nu));
    const double damping = 8 * std::sqrt(bending * m.density_kg_m3 * wall);
    return std::min(1.0, damping * duration_s / pi * body.mobility.inverse_mass);
}

/// The struck body and what stands under it, in coordinates in which all masses are 1: six a body.
struct Bodies {
    const Mobility& struck;
    Eigen::Matrix<double, 6, 6> struck_root;
    std::map<int, std::pair<Mobility, Eigen::Matrix<double, 6, 6>>> partners;  // those that give way
    long count() const { return 6 * (1 + static_cast<long>(partners.size())); }
};

Bodies bodiesOf(const ContactBody& body, const std::vector<Foundation>& foundations, double duration_s) {
    Bodies bodies{body.mobility, body.mobility.root() / std::sqrt(movingShare(body, duration_s)), {}};
    for (const Foundation& foundation : foundations)
        if (!foundation.partner.fixed())
            bodies.partners[foundation.partner_number] = {foundation.partner, foundation.partner.root()};
    return bodies;
}

struct Spring {
    Vec3 position, push;
    double stiffness_n_m;
    Eigen::VectorXd stretch;  ///< by the displacements: how far body and partner part there
};

std::vector<Spring> springsOf(const ContactBody& body, const Bodies& bodies,
                              const std::vector<Foundation>& foundations, double duration_s) {
    const double speed = std::sqrt(body.material.youngs_modulus_pa / body.material.density_kg_m3);
    std::vector<Spring> springs;
    for (const Foundation& foundation : foundations) {
        const double reached = waveShare(foundation.distance_m / speed, duration_s);
        if (!(reached > 0)) continue;
        for (const FoundationPoint& point : foundation.points) {
            Spring spring{point.position, foundation.push, point.share * reached * foundation.stiffness_n_m,
                          Eigen::VectorXd::Zero(bodies.count())};
            const auto stretch = [&](const Mobility& m) { return m.wrench(point.position, foundation.push); };
            spring.stretch.head<6>() = bodies.struck_root * stretch(bodies.struck);
            const auto partner = bodies.partners.find(foundation.partner_number);
            if (partner != bodies.partners.end()) {
                const auto& [mobility, root] = partner->second;
                const long place = 6 * (1 + std::distance(bodies.partners.begin(), partner));
                spring.stretch.segment<6>(place) = -root * stretch(mobility);
            }
            springs.push_back(std::move(spring));
        }
    }
    return springs;
}

/// The rigid bodies' displacement by a unit strike, on those springs that are pressed.
struct Rest {
    Eigen::VectorXd displacement;
    double held = 0;
};

Rest restOn(const std::vector<Spring>& springs, const std::vector<char>& pressed,
            const Eigen::VectorXd& strike, double duration_s) {
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(strike.size(), strike.size());
    for (std::size_t i = 0; i < springs.size(); ++i)
        if (pressed[i])
            stiffness += springs[i].stiffness_n_m * springs[i].stretch * springs[i].stretch.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness);
    Rest rest{Eigen::VectorXd::Zero(strike.size()), 0};
    double free = 0, left = 0;
    for (long k = 0; k < strike.size(); ++k) {
        const auto mode = modes.eigenvectors().col(k);
        const double omega = std::sqrt(std::max(0.0, modes.eigenvalues()[k])), part = mode.dot(strike);
        const double answered = springShare(omega, duration_s);
        const double moved = answered > 0 ? answered / (omega * omega) : travel(duration_s);
        rest.displacement += moved * part * mode;
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

SupportAnswer supportAnswer(const ContactBody& body, const std::vector<Foundation>& foundations,
                            const std::vector<PointForce>& unit_strike, double duration_s) {
    SupportAnswer answer;
    const Bodies bodies = bodiesOf(body, foundations, duration_s);
    const std::vector<Spring> springs = springsOf(body, bodies, foundations, duration_s);
    if (springs.empty()) return answer;
    Wrench wrench = Wrench::Zero();
    for (const PointForce& force : unit_strike) wrench += body.mobility.wrench(force.position, force.force);
    Eigen::VectorXd strike = Eigen::VectorXd::Zero(bodies.count());
    strike.head<6>() = bodies.struck_root * wrench;

    // Springs that would pull let go, and those that are pressed after all come back, until it stays so. The
    // bound is for the few arrangements that go round in circles.
    constexpr int most_rounds = 30;
    std::vector<char> pressed(springs.size(), 1), next(springs.size());
    Rest rest;
    for (int round = 0; round < most_rounds; ++round) {
        rest = restOn(springs, pressed, strike, duration_s);
        for (std::size_t i = 0; i < springs.size(); ++i)
            next[i] = -springs[i].stretch.dot(rest.displacement) > 0;
        if (next == pressed) break;
        pressed = next;
    }
    answer.held = rest.held;
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const double force = -springs[i].stiffness_n_m * springs[i].stretch.dot(rest.displacement);
        if (!pressed[i] || !(force > 0)) continue;
        answer.forces.push_back({springs[i].position, force * springs[i].push});
        answer.sum_n += force;
    }
    return answer;
}

}  // namespace sherd
