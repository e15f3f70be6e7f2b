#pragma once

#include <sherd/material.h>
#include <sherd/types.h>

namespace sherd {

/// Hooke's law of an isotropic material: sigma = lambda tr(eps) I + 2 mu eps, Pa.
struct Elasticity {
    double lambda_pa = 0;
    double mu_pa = 0;

    explicit Elasticity(const Material& material) {
        const double e = material.youngs_modulus_pa, nu = material.poisson_ratio;
        lambda_pa = e * nu / ((1 + nu) * (1 - 2 * nu));
        mu_pa = e / (2 * (1 + nu));
    }

    /// From a displacement gradient about the rest position. Only its symmetric part counts, so a small
    /// rotation makes no stress; displacements in a body that is solved as rigid are small, so this does what
    /// the co-rotation of the paper's section 4.1 is for.
    Mat3 stress(const Mat3& gradient) const {
        return lambda_pa * gradient.trace() * Mat3::Identity() + mu_pa * (gradient + gradient.transpose());
    }

    /// The least energy density, J/m^3, of all principal stresses s (in any order) with `weights` . s =
    /// `value_pa`. The energy density is s . C^-1 s / 2 with C = lambda (1 1^T) + 2 mu I, so that the least
    /// is at s = C weights value / (weights . C weights), and is value^2 / (2 weights . C weights).
    double leastEnergyDensity(const Vec3& weights, double value_pa) const {
        const double stiffness =
            lambda_pa * weights.sum() * weights.sum() + 2 * mu_pa * weights.squaredNorm();
        return value_pa * value_pa / (2 * stiffness);
    }
};

inline SymmetricTensor toSymmetricTensor(const Mat3& s) {
    SymmetricTensor v;
    v << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(2, 0);
    return v;
}

inline Mat3 toMatrix(const SymmetricTensor& v) {
    Mat3 s;
    s << v[0], v[3], v[5], v[3], v[1], v[4], v[5], v[4], v[2];
    return s;
}

}  // namespace sherd
