#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <vector>

#include "core/loads/foundation.h"

namespace sherd {

/// A partner that gives way.
struct Partner {
    Mobility mobility;
    Eigen::Matrix<double, 6, 6> root;
    /// Orthonormal columns: the motions that stretch its springs; in the others it stays as it is.
    Eigen::Matrix<double, 6, Eigen::Dynamic> motions = {};
    long place = 0;  ///< of the first of them in the system
};

/// By a partner's motions, of which there are six at most.
using Motions = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>;

/// What a spring does to a partner, in coordinates in which all masses are 1.
struct SpringEnd {
    const Partner* partner = nullptr;  ///< none: it does not give way
    Wrench stretch = Wrench::Zero();
    Motions of_motions = {};  ///< stretch by the partner's `motions`
};

/// A spring between the struck body and a partner, or between two partners.
struct Spring {
    Vec3 position, push;
    double stiffness_n_m = 0;
    bool is_own = true;             ///< one end is at the struck body
    Wrench own = Wrench::Zero();    ///< stretch by the struck body's motions
    std::array<SpringEnd, 2> ends;  ///< the second is that of springs between two partners
};

/// Rigid bodies with springs between them: six displacements of the struck body, then those of the partners.
struct SpringSystem {
    SpringSystem() = default;
    SpringSystem(SpringSystem&&) = default;  // moved only: springs point to partners
    SpringSystem& operator=(SpringSystem&&) = default;

    Eigen::Matrix<double, 6, 6> struck_root;
    std::map<int, Partner> partners;  ///< by their numbers
    std::vector<Spring> springs;
    Wrench strike = Wrench::Zero();  ///< of 1 N, on the struck body
    SpringEnd distant;               ///< the same on a partner
    long size = 6;

    double stretch(const Spring& spring, const Eigen::VectorXd& displacement) const;
    /// The partner of that number; nullptr if it does not give way.
    const Partner* partner(int number, const Mobility& mobility);
};

/// The system of a struck body, its foundations and its stack, under a strike of 1 N: `unit_strike`, or
/// without forces in that the stack's own. Springs count as far as a wave has come to them.
SpringSystem springSystemOf(const ContactBody& body, const std::vector<Foundation>& foundations,
                            const std::vector<PointForce>& unit_strike, double duration_s,
                            const Stack& stack);

/// What the springs do when those that would pull have let go.
struct Pressed {
    std::vector<double> forces_n;  ///< of the springs
    double held = 0;            ///< share of the struck body's mobility under the strike that they take away
    std::vector<char> pressed;  ///< which of them are
};

/// Springs that would pull let go, and those that are pressed after all come back, until what is on the wrong
/// side counts for less than 0.5 % of the strike; after two rounds with the bodies' inertia none comes back.
/// `pressed_before` is a guess, those of much the same strike: it saves time, and changes little.
Pressed pressedSprings(const SpringSystem& system, double duration_s,
                       const std::vector<char>& pressed_before = {});

}  // namespace sherd
