#include "prototype/level.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "generators/mesh_store.h"
#include "prototype/looks.h"
#include "scenes/box_mesh.h"

namespace prototype {
namespace {

using render::Vec3;
using sherd::BoxRegion;

// Kinds, in the order in which they are made.
constexpr std::size_t cup = 0, plate = 1, pane = 2, wall = 3;

constexpr float half_width = 1.8f, back = 1.6f, front = -0.2f, height = 2.35f, thickness = 0.1f;
constexpr float pane_width = 1, pane_height = 0.9f, pane_thickness = 0.014f, pane_foot = 0.95f;
constexpr float wall_width = 0.6f, wall_height = 0.75f, wall_thickness = 0.06f;
constexpr float shelf_x = 1.2f, shelf_width = 1, shelf_depth = 0.26f, board = 0.03f;
constexpr float plate_foot_to_rim = 0.14f;  ///< half of a plate's width, with the scale below
constexpr double cup_scale = 1.7, plate_scale = 1.5;

/// What a step of 1/60 s has time for: few pieces, one hull each, that break no further.
sherd::Settings gameSettings(int pieces, double spacing_m, double smallest_m3) {
    sherd::Settings settings = sherd::Settings::forQuality(sherd::Quality::preview);
    settings.sampling.spacing_m = spacing_m;
    settings.fracture.largest_fragment_count = pieces;
    settings.fracture.largest_generation = 1;
    settings.fracture.smallest_fragment_m3 = smallest_m3;
    settings.fracture.debris = sherd::Debris::merged;
    settings.fracture.collision_shape = sherd::CollisionShape::hull;
    return settings;
}

sherd::TriangleMesh box(const Vec3& size, double edge_m) {
    return demo::boxMesh(demo::Box{size.cast<double>(), edge_m});
}

Kind paneKind() {
    const double x = pane_width / 2, y = pane_thickness, z = pane_height / 2, rim = 0.03;
    Kind kind{"pane",
              box(Vec3(pane_width, pane_thickness, pane_height), 0.1),
              sherd::Material::glass(),
              gameSettings(12, 0.055, 2e-4),
              {},
              Timbre::glass,
              2};
    kind.settings.fracture.guide.kind = sherd::GuideField::Kind::radial;
    kind.settings.fracture.guide.cost_along = 0.1;
    kind.supports = {BoxRegion{{-x, -y, -z}, {rim - x, y, z}}, BoxRegion{{x - rim, -y, -z}, {x, y, z}},
                     BoxRegion{{-x, -y, -z}, {x, y, rim - z}}, BoxRegion{{-x, -y, z - rim}, {x, y, z}}};
    return kind;
}

Kind wallKind() {
    const double z = wall_height / 2;
    Kind kind{"wall",
              box(Vec3(wall_width, wall_thickness, wall_height), 0.06),
              sherd::Material::plaster(),
              gameSettings(10, 0.045, 8e-4),
              {},
              Timbre::plaster,
              1};
    kind.settings.fracture.largest_generation = 2;  // large pieces fall, and are struck, once more
    kind.supports = {BoxRegion{{-wall_width, -wall_thickness, -z}, {wall_width, wall_thickness, -z}}};
    return kind;
}

/// Crockery in few triangles: cutting takes its time for each.
sherd::Result<Kind> crockery(const std::string& name, double scale, double smallest_m3,
                             const std::string& meshes) {
    auto mesh = demo::storedMesh("coffee_" + name, 3000, meshes, [](const std::string&) {});
    if (!mesh) return sherd::Error{mesh.error()};
    for (sherd::Vec3& vertex : mesh.value().vertices) vertex *= scale;
    return Kind{name,
                std::move(mesh).value(),
                sherd::Material::ceramic(),
                gameSettings(8, 0.017, smallest_m3),
                {},
                Timbre::ceramic,
                5};
}

sherd::Status addKinds(Level& level, const std::string& meshes) {
    auto cups = crockery("cup", cup_scale, 2e-5, meshes),
         plates = crockery("plate", plate_scale, 1.5e-5, meshes);
    if (!cups) return sherd::Error{cups.error()};
    if (!plates) return sherd::Error{plates.error()};
    level.kinds = {std::move(cups).value(), std::move(plates).value(), paneKind(), wallKind()};
    return sherd::success();
}

void addBlock(Level& level, const Vec3& lo, const Vec3& hi, const render::Material& look) {
    level.blocks.push_back({(lo + hi) / 2, hi - lo, look});
}

void addFloor(Level& level) {
    constexpr float plank = 0.2f, top = 0.003f;  // a little above the ground, which is drawn as well
    int number = 0;
    for (float y = front - 0.6f; y < back - 0.01f; y += plank, ++number)
        addBlock(level, {-half_width - thickness, y, -0.1f},
                 {half_width + thickness, std::min(y + 0.985f * plank, back), top}, plankWood(number));
}

void addHall(Level& level) {
    addFloor(level);
    const render::Material plaster = paintedWall();
    const float x = pane_width / 2, lo = pane_foot, hi = pane_foot + pane_height, end = back + thickness;
    addBlock(level, {-half_width, back, 0}, {-x, end, height}, plaster);
    addBlock(level, {x, back, 0}, {half_width, end, height}, plaster);
    addBlock(level, {-x, back, 0}, {x, end, lo}, plaster);
    addBlock(level, {-x, back, hi}, {x, end, height}, plaster);
    addBlock(level, {-half_width - thickness, front, 0}, {-half_width, end, height}, plaster);
    addBlock(level, {half_width, front, 0}, {half_width + thickness, end, height}, plaster);
    // The frame of the window, a little before the wall.
    const float rim = 0.05f, near = back - 0.03f;
    const render::Material wood = darkWood();
    addBlock(level, {-x - rim, near, lo - rim}, {x + rim, back, lo}, wood);
    addBlock(level, {-x - rim, near, hi}, {x + rim, back, hi + rim}, wood);
    addBlock(level, {-x - rim, near, lo}, {-x, back, hi}, wood);
    addBlock(level, {x, near, lo}, {x + rim, back, hi}, wood);
}

btTransform standing(float x, float y, float z, float about_z = 0) {
    return btTransform(btQuaternion(btVector3(0, 0, 1), about_z), btVector3(x, y, z));
}

/// A plate on its edge that leans against the wall.
btTransform leaning(float x, float shelf) {
    constexpr float upright = 1.28f;  // radians, of the plate's plane against the shelf
    const float z = shelf + plate_foot_to_rim * std::sin(upright) + 0.012f;
    return btTransform(btQuaternion(btVector3(1, 0, 0), upright), btVector3(x, back - 0.075f, z));
}

void addShelves(Level& level) {
    int number = 0;
    for (const float middle : {-shelf_x, shelf_x})
        for (const float top : {0.85f, 1.27f, 1.69f}) {
            const float x = middle - shelf_width / 2;
            addBlock(level, {x, back - shelf_depth, top - board}, {x + shelf_width, back, top}, darkWood());
            for (int i = 0; i < 3; ++i, ++number) {
                const float at = middle + 0.33f * float(i - 1);
                const bool is_plate = number % 2 == 1;
                const btTransform home =
                    is_plate ? leaning(at, top)
                             : standing(at, back - 0.13f, top + 0.001f, 0.9f * float(number % 5) - 2.4f);
                level.props.push_back({is_plate ? plate : cup, home, glaze(number)});
            }
        }
}

void addHeldThings(Level& level) {
    level.props.push_back({pane, standing(0, back + 0.02f, pane_foot + pane_height / 2), windowGlass()});
    for (const float side : {-1.0f, 0.0f, 1.0f}) {
        const float y = side == 0 ? 0.95f : 0.55f;
        level.props.push_back(
            {wall, standing(1.15f * side, y, wall_height / 2, -0.35f * side), rawPlaster()});
    }
}

}  // namespace

sherd::Result<Level> makeLevel(const std::string& meshes) {
    Level level;
    const sherd::Status made = addKinds(level, meshes);
    if (!made) return sherd::Error{made.error()};
    addHall(level);
    addShelves(level);
    addHeldThings(level);
    return level;
}

}  // namespace prototype
