#include "fracture/crack_reach.h"

#include <algorithm>
#include <cmath>

#include "core/clustering/connected_pieces.h"
#include "core/loads/contact_loads.h"
#include "core/numerics/hashed_random.h"
#include "core/numerics/pi.h"

namespace sherd {

namespace {

/// The larger one of the distances from the axis of a blow and along it: what is nearer than that to the
/// contact is a straight plug, which can be pushed out.
double distance(const BlowAxis& from, const Vec3& x) {
    const Vec3 offset = x - from.contact;
    const double along = offset.dot(from.direction);
    return std::max(std::abs(along), (offset - along * from.direction).norm());
}

/// Whether particles hang together and are most of the body.
bool areTheBody(const Discretisation& sampling, const std::vector<char>& marked) {
    std::vector<int> members;
    double own = 0, all = 0;
    for (std::size_t i = 0; i < marked.size(); ++i) {
        all += sampling.particles[i].volume;
        if (!marked[i]) continue;
        own += sampling.particles[i].volume;
        members.push_back(static_cast<int>(i));
    }
    return own > 0.5 * all && ConnectedPieces(sampling).of(members).size() == 1;
}

/// A prism about the axis whose faces are `reach` away from the contact or a little more, with a face across
/// the axis.
std::vector<CrackPlane> prism(const BlowAxis& from, double reach, std::uint64_t seed) {
    constexpr int sides = 8;
    constexpr double turned = 0.3, further = 0.1;  // of a side's angle, of the reach: no hole is even
    const Vec3 a = from.direction.unitOrthogonal(), b = from.direction.cross(a);
    std::vector<CrackPlane> planes;
    const auto add = [&](const Vec3& normal, double distance) {
        planes.push_back({normal, normal.dot(from.contact) + distance});
    };
    for (std::uint64_t side = 0; side < sides; ++side) {
        const double angle =
            2 * pi * (static_cast<double>(side) + turned * hashedRandom(seed, side, 0)) / sides;
        add(std::cos(angle) * a + std::sin(angle) * b,
            reach * (1 + further * (1 + hashedRandom(seed, side, 1))));
    }
    add(from.direction, reach);
    return planes;
}

}  // namespace

std::vector<CrackPlane> holeOf(const StrikeContext& struck, const Damage& damage, const BlowForces& forces) {
    constexpr double terminal_speed = 0.38;
    const Material& material = struck.solid.material();
    const BlowAxis from = axisOf(forces.strike);
    const auto& particles = struck.sampling.particles;
    const double sound_m_s = std::sqrt(material.youngs_modulus_pa / material.density_kg_m3);
    double reach = from.radius_m + terminal_speed * sound_m_s * forces.crack_time_s;
    if (!(reach < 2 * struck.solid.boundingRadius()) || from.direction.isZero()) return {};
    for (std::size_t i = 0; i < particles.size(); ++i)
        if (damage.damaged[i])
            reach = std::max(reach, distance(from, particles[i].position) + struck.sampling.spacing);
    const std::vector<CrackPlane> planes = prism(from, reach, struck.seed);
    std::vector<char> outside;
    for (const Particle& particle : particles)
        outside.push_back(std::any_of(planes.begin(), planes.end(), [&](const CrackPlane& plane) {
            return plane.distance(particle.position) > 0;
        }));
    return areTheBody(struck.sampling, outside) ? planes : std::vector<CrackPlane>{};
}

}  // namespace sherd
