#include "viewer/overlays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "viewer/conversions.h"
#include "viewer/shape_lines.h"

namespace demo {
namespace {

using render::Marks;
using render::Vec3;

Vec3 colourOf(const BlowStress& stress, const BlowStress::Particle& particle, ParticleColour by) {
    if (by == ParticleColour::stress)
        return stressColour(float(particle.stress_pa / std::max(stressScale(stress), 1.0)));
    if (by == ParticleColour::pieces) return pieceColour(particle.piece);
    const bool failed = by == ParticleColour::damage && particle.stress_pa > stress.strength_pa;
    return failed ? Vec3(0.95f, 0.12f, 0.05f) : Vec3(0.25f, 0.45f, 0.62f);
}

/// Each particle where the piece that it went to is now; those of pieces that broke in turn are left out.
void addParticles(Marks& marks, const BlowStress& stress, ParticleColour by, PlacedScene& scene) {
    std::map<const sherd::TriangleMesh*, render::Mat4> places;
    for (const btRigidBody* body : scene.fracture().bodies())
        places[&scene.fracture().asset(body)->surface()] = toRender(scene.fracture().renderTransform(body));
    for (const BlowStress::Particle& particle : stress.particles) {
        if (particle.piece < 0) continue;
        const auto place = places.find(&stress.pieces[std::size_t(particle.piece)].surface());
        if (place == places.end()) continue;
        const Vec3 local = particle.position.cast<float>();
        marks.points.push_back({(place->second * local.homogeneous()).head<3>(),
                                colourOf(stress, particle, by), 0.8f * float(particle.radius_m)});
    }
}

/// The points where bodies touch, and a line along the normal that is longer the harder they press.
void addContacts(Marks& marks, btDiscreteDynamicsWorld& world) {
    btDispatcher& dispatcher = *world.getDispatcher();
    for (int m = 0; m < dispatcher.getNumManifolds(); ++m) {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(m);
        for (int i = 0; i < manifold.getNumContacts(); ++i) {
            const btManifoldPoint& contact = manifold.getContactPoint(i);
            if (contact.getDistance() > 0) continue;
            const Vec3 at = toRender(contact.getPositionWorldOnB());
            const float length = 0.02f + 0.02f * std::log1p(10 * float(contact.getAppliedImpulse()));
            marks.line(at, at + length * toRender(contact.m_normalWorldOnB), Vec3(1.0f, 0.75f, 0.1f));
            marks.points.push_back({at, Vec3(1.0f, 0.75f, 0.1f), 0.003f});
        }
    }
}

/// Where the last blow fell, and which way it pushed.
void addBlow(Marks& marks, const sherd::BlowEvent& event) {
    const Vec3 at = event.position.cast<float>(), towards = event.normal.cast<float>();
    marks.line(at - 0.2f * towards, at, Vec3(1.0f, 0.2f, 0.1f));
    marks.points.push_back({at, Vec3(1.0f, 0.2f, 0.1f), 0.006f});
}

}  // namespace

render::Vec3 pieceColour(int number) {
    const float turn = std::fmod(0.61803f * float(number + 1), 1.0f) * 6.28318f;
    return (render::Vec3::Constant(0.42f) +
            0.34f * render::Vec3(std::cos(turn), std::cos(turn - 2.0944f), std::cos(turn + 2.0944f)))
        .eval();
}

render::Vec3 stressColour(float share) {
    static const std::array<render::Vec3, 6> stops = {
        render::Vec3(0.03f, 0.08f, 0.35f), render::Vec3(0.02f, 0.35f, 0.75f),
        render::Vec3(0.05f, 0.65f, 0.50f), render::Vec3(0.60f, 0.75f, 0.08f),
        render::Vec3(0.95f, 0.50f, 0.04f), render::Vec3(0.75f, 0.03f, 0.02f)};
    const float at = std::clamp(share, 0.0f, 1.0f) * float(stops.size() - 1);
    const auto low = std::min(std::size_t(at), stops.size() - 2);
    return stops[low] + (at - float(low)) * (stops[low + 1] - stops[low]);
}

double stressScale(const BlowStress& stress) {
    return std::min(stress.largest_pa, 4 * stress.strength_pa);  // right at a contact it has no limit
}

render::Marks overlayMarks(const Overlays& overlays, Simulation& simulation, const BlowStress* stress) {
    render::Marks marks;
    if (overlays.particles != ParticleColour::hidden && stress)
        addParticles(marks, *stress, overlays.particles, simulation.placed());
    if (overlays.contacts) {
        addContacts(marks, simulation.world());
        if (simulation.lastBlow()) addBlow(marks, simulation.lastBlow()->event);
    }
    if (overlays.collision_shapes) addShapeLines(marks, simulation.world(), simulation.placed().fracture());
    return marks;
}

}  // namespace demo
