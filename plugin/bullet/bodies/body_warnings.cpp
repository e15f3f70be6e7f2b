#include "bullet/bodies/body_warnings.h"

#include <cmath>
#include <sstream>

#include "bullet/bodies/breakable.h"
#include "bullet/shapes/shapes.h"
#include "bullet/world/conversions.h"

namespace sherd {

namespace {

std::string ofPreparation(const Breakable& breakable) {
    if (!breakable.prepared_free || breakable.asset.prepared()) return {};
    return "the asset was prepared, but not as supports hold this body, so that its first blow takes long: "
           "prepare what BreakableAsset::anchored makes of it, and add bodies of that";
}

std::string ofCentre(const Breakable& breakable) {
    const BreakableSolid& solid = *breakable.asset.solid();
    const double off_m = (breakable.body_from_asset * toBullet(solid.moments().centroid)).length();
    constexpr double far = 0.02;  // of its radius
    const bool turns = breakable.isDynamic() && !breakable.body->getAngularFactor().isZero();
    if (breakable.ownedHere() || !turns || off_m <= far * solid.boundingRadius()) return {};
    return "the body turns about a point that is " + std::to_string(std::lround(1000 * off_m)) +
           " mm from the centre of its solid, about which its pieces turn: they fall and spin otherwise than "
           "it did; in a btCompoundShape the shape can be shifted so that both are one";
}

/// Of a body of an asset: a program may give it another shape, but this is that of all bodies of the asset.
std::string ofScaling(const Breakable& breakable) {
    const bool is_scaled = breakable.ownedHere() && isScaled(*breakable.owned.shape->shape) &&
                           breakable.body->getCollisionShape() == breakable.owned.shape->shape.get();
    if (!is_scaled) return {};
    return "the collision shape of this body was scaled (setLocalScaling), and with it that of all bodies of "
           "its asset; the body breaks as its asset is, unscaled: scale the mesh instead (Repair::scale), "
           "and "
           "add bodies of that";
}

/// Of a body of the program's own, whose shape is what breaks.
std::string ofShape(const Breakable& breakable) {
    const btVector3 was = breakable.extent_when_made, is = extentOf(*breakable.body);
    constexpr btScalar alike = btScalar(1e-3);  // of its size
    if (breakable.ownedHere() || (is - was).length() <= alike * was.length()) return {};
    std::ostringstream text;
    text << "the collision shape of this body was changed after makeBreakable: it was " << was.x() << " x "
         << was.y() << " x " << was.z() << " m in size and is " << is.x() << " x " << is.y() << " x "
         << is.z()
         << " m; the body breaks as it was: call remove() and makeBreakable() again after such a change";
    return text.str();
}

/// Pieces keep what the whole had.
std::string ofMass(const Breakable& breakable) {
    if (!breakable.isDynamic() || !breakable.came_of.empty()) return {};
    const double of_asset = breakable.asset.mass(), of_body = 1 / double(breakable.body->getInvMass());
    constexpr double alike = 1e-3;
    if (std::abs(of_body / of_asset - 1) <= alike) return {};
    std::ostringstream text;
    text << "the mass of this body was set to " << of_body
         << " kg (setMassProps), but how it breaks is decided "
         << "with the " << of_asset << " kg ";
    if (breakable.ownedHere())
        text << "of its asset: give that another density instead (Material::withDensity)";
    else
        text
            << "that it had when it was made breakable: call remove() and makeBreakable() again after such a "
               "change";
    return text.str();
}

}  // namespace

std::vector<std::string> warningsOf(const Breakable& breakable) {
    std::vector<std::string> warnings = breakable.asset.warnings();
    for (const auto warning : {ofPreparation, ofCentre, ofScaling, ofShape, ofMass})
        if (std::string sentence = warning(breakable); !sentence.empty())
            warnings.push_back(std::move(sentence));
    return warnings;
}

}  // namespace sherd
