#pragma once

#include <sherd/material.h>
#include <sherd/settings.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/loads/blow.h"
#include "support/shapes.h"

namespace sherd::fracture_tests {

struct Shape {
    const char* name;
    TriangleMesh mesh;
    Material material;
};

inline std::vector<Shape> tenShapes() {
    return {{"block", shapes::slab(Vec3(0.2, 0.15, 0.1), 3, 3, 3), Material::brick()},
            {"rod", shapes::slab(Vec3(1, 0.01, 0.01), 20, 1, 1), Material::plaster()},
            {"wall", shapes::slab(Vec3(1, 0.09, 1), 6, 1, 6), Material::plaster()},
            {"pane", shapes::slab(Vec3(0.5, 0.01, 0.4), 8, 1, 8), Material::glass()},
            {"ball", shapes::icosphere(0.05, 2), Material::stone()},
            {"hollow ball", shapes::hollowSphere(0.1, 0.09, 2), Material::ceramic()},
            {"tube", shapes::tube(0.05, 0.04, 0.3, 16), Material::concrete()},
            {"cup", shapes::cup(0.04, 0.1, 0.005, 16, 4), Material::ceramic()},
            {"bowl", shapes::bowl(0.12, 0.006, 16, 4), Material::glass()},
            {"channel", shapes::uShape(0.02, 0.1, 0.1, 0.3), Material::wood()}};
}

/// Blows by one partner at up to four points, in half of the cases with up to four points of support.
class RandomBlows {
  public:
    RandomBlows(const TriangleMesh& mesh, unsigned seed) : mesh_(mesh), random_(seed) {}

    Blow next() {
        Blow blow;
        const double speed = logarithmic(0.05, 50);
        const double radius = chance(0.5) ? logarithmic(1e-3, 0.1) : 0, modulus = logarithmic(1e8, 2e11);
        const ContactImpulse first = somewhere();
        for (int i = 0, count = upTo(4); i < count; ++i) {
            ContactImpulse contact = i == 0 ? first : somewhere();
            contact.normal = first.normal;
            contact.impulse = logarithmic(1e-3, 1e3) * contact.normal;
            contact.approach_m_s = speed * uniform(0.5, 1);
            contact.slip_m_s = speed * uniform(0, 1) * contact.normal.unitOrthogonal();
            contact.friction = chance(0.5) ? uniform(0, 1) : -1;
            contact.touched_s = chance(0.5) ? 0 : -logarithmic(1e-6, 1e-3);
            contact.partner_radius_m = radius;
            contact.partner_youngs_modulus_pa = modulus;
            contact.partner_poisson_ratio = 0.2;
            blow.contacts.push_back(contact);
        }
        for (ContactImpulse& contact : blow.contacts) contact.friction = blow.contacts[0].friction;
        for (int i = 0, count = chance(0.5) ? upTo(4) : 0; i < count; ++i) {
            ContactImpulse contact = somewhere();
            contact.partner = 1;
            blow.contacts.push_back(contact);
        }
        for (int partner = 0; partner < 2; ++partner)
            blow.partners.push_back(chance(0.3) ? Mobility{} : Mobility::ofPoint(logarithmic(1e-3, 100)));
        return blow;
    }

  private:
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
    }
    double logarithmic(double low, double high) { return low * std::pow(high / low, uniform(0, 1)); }
    bool chance(double share) { return uniform(0, 1) < share; }
    int upTo(int most) { return 1 + static_cast<int>(uniform(0, most - 1e-9)); }

    /// Presses on a point of the surface, more or less at right angles to it.
    ContactImpulse somewhere() {
        const auto& [a, b, c] = mesh_.triangles[random_() % mesh_.triangles.size()];
        const Vec3 &p = mesh_.vertices[a], &q = mesh_.vertices[b], &r = mesh_.vertices[c];
        const double s = std::sqrt(uniform(0, 1)), t = uniform(0, 1);
        const Vec3 inward = -(q - p).cross(r - p).normalized();
        ContactImpulse contact;
        contact.point = (1 - s) * p + s * (1 - t) * q + s * t * r;
        contact.normal = (inward + 0.5 * Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1))).normalized();
        contact.impulse = contact.normal;
        return contact;
    }

    const TriangleMesh& mesh_;
    std::mt19937_64 random_;
};

/// A few dozen particles a body: blows by the thousand are solved in seconds.
inline Settings coarselySampled() {
    Settings settings;
    settings.sampling.smallest_count = 60;
    settings.sampling.largest_factor_millions = 0.1;
    settings.sampling.largest_factor_if_thin_millions = 0.2;
    return settings;
}

}  // namespace sherd::fracture_tests
