#pragma once

#include <sherd/fields.h>

#include "scenes/scene.h"

namespace demo {

using sherd::Field;
using sherd::IfFieldsOf;
using sherd::Range;

// What a scene file can say of a scene's structs, one line a field, as in sherd/fields.h. Shapes, lists and
// presets are read by hand (scene_file.cpp).

inline constexpr Range place_range = Range::between(-1000, 1000, "m");
inline constexpr Range speed_range = Range::between(-1000, 1000, "m/s");

template <class Self, class Visitor>
IfFieldsOf<Self, Touch> visitFields(Self& t, Visitor&& visit) {
    visit(Field{"friction", "Bullet multiplies those of two bodies", Range::between(0, 10)}, t.friction);
    visit(Field{"restitution", "Bullet multiplies those of two bodies", Range::between(0, 1)}, t.restitution);
}

template <class Self, class Visitor>
IfFieldsOf<Self, Look> visitFields(Self& l, Visitor&& visit) {
    visit(Field{"outside", "colour, linear RGB", Range::between(0, 1)}, l.outside);
    visit(Field{"crack", "colour of crack faces, linear RGB", Range::between(0, 1)}, l.crack);
    visit(Field{"gloss", "share of light that the glaze mirrors", Range::between(0, 1)}, l.gloss);
}

template <class Self, class Visitor>
IfFieldsOf<Self, PaintedStrength> visitFields(Self& p, Visitor&& visit) {
    constexpr Range factor = Range::between(1e-3, 1e3);
    visit(Field{"black", "what the strength is multiplied with where the mesh is black", factor}, p.black);
    visit(Field{"white", "the same where it is white", factor}, p.white);
}

template <class Self, class Visitor>
IfFieldsOf<Self, BreakableBody> visitFields(Self& b, Visitor&& visit) {
    visit(Field{"material", "what it is made of"}, b.material);
    visit(Field{"settings", "how it breaks"}, b.settings);
    visit(Field{"touch", "how it touches others"}, b.touch);
    visit(Field{"look", "in pictures"}, b.look);
    visit(Field{"turn_deg", "turn about the world's x, then y, then z axis",
                Range::between(-360, 360, "degrees")},
          b.turn_deg);
    visit(Field{"position_m", "x and y of the shape's origin, height of its lowest point", place_range},
          b.position);
    visit(Field{"velocity_m_s", "velocity at the start", speed_range}, b.velocity);
    visit(Field{"spin_rad_s", "spin at the start, about the world's axes",
                Range::between(-1000, 1000, "rad/s")},
          b.spin);
}

template <class Self, class Visitor>
IfFieldsOf<Self, Ball> visitFields(Self& b, Visitor&& visit) {
    visit(Field{"diameter_m", "its diameter", Range::between(0.001, 10, "m")}, b.diameter_m);
    visit(Field{"density_kg_m3", "its density", Range::between(1, 1e5, "kg/m^3")}, b.density_kg_m3);
    visit(Field{"touch", "how it touches others"}, b.touch);
    visit(Field{"position_m", "where its centre is at the start", place_range}, b.position);
    visit(Field{"velocity_m_s", "velocity at the start", speed_range}, b.velocity);
}

template <class Self, class Visitor>
IfFieldsOf<Self, Camera> visitFields(Self& c, Visitor&& visit) {
    visit(Field{"towards", "viewing direction", Range::between(-1000, 1000)}, c.towards);
    visit(Field{"width_deg", "horizontal opening", Range::between(5, 120, "degrees")}, c.width_deg);
}

/// Goes into the settings of the bodies, but where these give a seed of their own.
inline const Field seed_field = {"seed", "another seed, another break", Range::between(0, 1e9)};

template <class Self, class Visitor>
IfFieldsOf<Self, Scene> visitFields(Self& s, Visitor&& visit) {
    visit(Field{"summary", "a sentence for --list"}, s.summary);
    visit(Field{"floor", "how it touches others"}, s.floor);
    visit(Field{"camera", "from where pictures are taken"}, s.camera);
    visit(Field{"gravity_m_s2", "gravity", Range::between(-1000, 1000, "m/s^2")}, s.gravity);
    visit(Field{"duration_s", "simulated time", Range::between(0.01, 60, "s")}, s.duration_s);
    visit(Field{"after_picture_s", "from the first break to what after.png shows",
                Range::between(0, 60, "s").orSpecial(0, "the end")},
          s.after_picture_s);
    visit(Field{"time_step_s", "Bullet's time step", Range::between(1e-4, 1.0 / 30, "s")}, s.time_step_s);
}

}  // namespace demo
