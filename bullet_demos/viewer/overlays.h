#pragma once

#include "render/marks.h"
#include "viewer/simulation.h"
#include "viewer/stress_view.h"

namespace demo {

/// What the particles of the last struck body are coloured by.
enum class ParticleColour { hidden, plain, stress, damage, pieces };

/// What is drawn over the scene.
struct Overlays {
    ParticleColour particles = ParticleColour::hidden;
    bool coloured_pieces = false;  ///< every body in a colour of its own
    bool contacts = false;
    bool collision_shapes = false;

    /// Bodies are drawn as of glass, so that one sees into them.
    bool seeThrough() const { return particles != ParticleColour::hidden || collision_shapes; }
};

/// A colour for each number, far from those of its neighbours.
render::Vec3 pieceColour(int number);
/// From blue at 0 to red at 1.
render::Vec3 stressColour(float share);
/// The stress that the colours end at.
double stressScale(const BlowStress& stress);

/// Points and lines for what is chosen; `stress` may be missing.
render::Marks overlayMarks(const Overlays& overlays, Simulation& simulation, const BlowStress* stress);

}  // namespace demo
