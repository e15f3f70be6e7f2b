#pragma once

#include <sherd/sherd.h>

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace demo {

using sherd::Vec3;

/// A surface from a Wavefront OBJ.
struct ObjFile {
    std::string path;
    sherd::Repair repair = {};
};

/// The surface of a box, centred on the origin, in triangles with legs of about `edge_m`.
struct Box {
    Vec3 size_m = Vec3::Ones();
    double edge_m = 0.1;
};

/// A surface that a generator makes (generators/generators.h), in so many triangles within 1 %.
struct Generated {
    std::string name;
    int triangles = 20000;
};

using Shape = std::variant<ObjFile, Box, Generated>;

/// How a body touches others. Bullet multiplies the figures of the two: here friction 0.64, restitution 0.09.
struct Touch {
    double friction = 0.8;
    double restitution = 0.3;
};

/// Colours are linear RGB from 0 to 1. `gloss` is the share of light that the glaze mirrors, 0 to 1.
struct Look {
    Vec3 outside = Vec3(0.8, 0.8, 0.8);
    Vec3 crack = Vec3(0.9, 0.9, 0.9);
    double gloss = 0;
};

/// The colours of a material that no scene says anything of.
Look lookOf(const sherd::Material& material);
/// Whether light goes through it.
bool isClear(const sherd::Material& material);

/// What the strength is multiplied with where a mesh is painted black and where white
/// (sherd::strengthFromColours).
struct PaintedStrength {
    double black = 0.3;
    double white = 1;
};

/// A body that can break. World frame: z up, floor at z = 0, SI units.
struct BreakableBody {
    Shape shape;
    sherd::Material material;
    sherd::Settings settings;
    /// None: the mesh's colours say nothing about its strength.
    std::optional<PaintedStrength> painted_strength;
    /// Parts of the surface that the world holds, in the shape's own coordinates; none: the body moves
    /// freely.
    std::vector<sherd::SurfaceRegion> supports;
    Touch touch;
    Look look;
    Vec3 turn_deg = Vec3::Zero();  ///< about the world's x, then y, then z axis
    /// x and y of the shape's origin; z: height of its lowest point over the floor, m.
    Vec3 position = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();  ///< m/s
    Vec3 spin = Vec3::Zero();      ///< rad/s, about the world's axes
};

/// A steel ball that strikes.
struct Ball {
    double diameter_m = 0.2;
    double density_kg_m3 = 7850;
    Touch touch;
    Vec3 position = Vec3::Zero();  ///< of its centre, m
    Vec3 velocity = Vec3::Zero();  ///< m/s
};

/// From where the pictures are taken; how far away follows from what there is to see.
struct Camera {
    Vec3 towards = Vec3(0, 1, -0.4);  ///< viewing direction
    double width_deg = 30;            ///< horizontal opening
};

/// Everything a run needs, as data.
struct Scene {
    std::string name;
    std::string summary;               ///< one sentence for --list
    std::vector<std::string> presets;  ///< names of those that its file has
    std::vector<BreakableBody> bodies;
    std::vector<Ball> balls;
    Touch floor;
    Camera camera;
    Vec3 gravity = Vec3(0, 0, -9.81);  ///< m/s^2
    double duration_s = 2;
    double after_picture_s = 0;  ///< from the first break to what after.png shows; 0: the end
    double time_step_s = 1.0 / 240;
};

}  // namespace demo
