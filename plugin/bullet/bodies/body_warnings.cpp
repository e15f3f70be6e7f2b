#include "bullet/bodies/body_warnings.h"

#include <cmath>
#include <sstream>
#include <utility>

#include "bullet/bodies/breakable.h"
#include "bullet/shapes/shapes.h"
#include "bullet/world/conversions.h"

namespace sherd {

namespace {

std::string ofPreparation(const Breakable& breakable) {
    if (!breakable.prepared_free || breakable.asset.prepared()) return {};
    return "The asset was prepared, but not as supports hold this body, so that its first blow takes long: "
           "prepare what BreakableAsset::anchored makes of it, and add bodies of that.";
}

std::string ofCentre(const Breakable& breakable) {
    const BreakableSolid& solid = *breakable.asset.solid();
    const double off_m = (breakable.body_from_asset * toBullet(solid.moments().centroid)).length();
    constexpr double far = 0.02;  // of its radius
    const bool turns = breakable.isDynamic() && !breakable.body->getAngularFactor().isZero();
    if (breakable.ownedHere() || !turns || off_m <= far * solid.boundingRadius()) return {};
    return "The body turns about a point that is " + std::to_string(std::lround(1000 * off_m)) +
           " mm from the centre of its solid, about which its pieces turn: they fall and spin otherwise than "
           "it did; in a btCompoundShape the shape can be shifted before makeBreakable, so that "
           "both are one.";
}

/// Of a body of an asset: a program may give it another shape, but this is that of all bodies of the asset.
std::string ofSharedShape(const Breakable& breakable) {
    const btCollisionShape& shared = *breakable.owned.shape->shape;
    if (breakable.body->getCollisionShape() != &shared || !isScaled(shared)) return {};
    return "The collision shape of this body was scaled (setLocalScaling), and with it that of all bodies of "
           "its asset; the body breaks as its asset is, unscaled: scale the mesh instead (Repair::scale), "
           "and add bodies of that.";
}

/// Of a body of the program's own, whose shape is what breaks.
std::string ofOwnShape(const Breakable& breakable) {
    const auto parts = convexParts(*breakable.body->getCollisionShape());
    if (parts && parts.value() == *breakable.made_of) return {};
    return "The collision shape of this body was scaled, moved or replaced after makeBreakable, and it "
           "breaks as it was: call remove() and makeBreakable() again after such a change.";
}

std::string ofShape(const Breakable& breakable) {
    return breakable.ownedHere() ? ofSharedShape(breakable) : ofOwnShape(breakable);
}

/// Pieces keep what the whole had.
std::string ofMass(const Breakable& breakable) {
    if (!breakable.isDynamic() || !breakable.came_of.empty()) return {};
    const double decided_with = breakable.asset.mass(), of_body = 1 / double(breakable.body->getInvMass());
    constexpr double alike = 0.01;
    if (std::abs(of_body / decided_with - 1) <= alike) return {};
    std::ostringstream text;
    text << "The mass of this body was set to " << of_body << " kg (setMassProps), but how it breaks is "
         << "decided with " << decided_with << " kg: "
         << (breakable.ownedHere() ? "give its asset another density instead (Material::withDensity)."
                                   : "call remove() and makeBreakable() again after such a change.");
    return text.str();
}

/// Whether there is a sentence to add.
bool addTo(std::vector<std::string>& warnings, std::string sentence) {
    if (sentence.empty()) return false;
    warnings.push_back(std::move(sentence));
    return true;
}

}  // namespace

std::vector<std::string> warningsOfMaking(const Breakable& breakable) {
    std::vector<std::string> warnings = breakable.asset.warnings();
    addTo(warnings, ofPreparation(breakable));
    addTo(warnings, ofCentre(breakable));
    return warnings;
}

std::vector<std::string> warningsOfChanges(Breakable& breakable) {
    std::vector<std::string> warnings;
    if (!breakable.told_shape) breakable.told_shape = addTo(warnings, ofShape(breakable));
    if (!breakable.told_mass) breakable.told_mass = addTo(warnings, ofMass(breakable));
    return warnings;
}

}  // namespace sherd
