#include "scenes/support_regions.h"

namespace demo {
namespace {

using sherd::BoxRegion;
using sherd::CylinderRegion;
using sherd::SphereRegion;
using sherd::Vec3;

constexpr Range place_range = Range::between(-1000, 1000, "m");
constexpr Range radius_range = Range::between(1e-6, 1000, "m");

template <class Value>
void readNeeded(Fields& fields, const Field& field, Value& value) {
    if (!fields.has(field.name)) fields.fail(field.name, std::string("is missing; it is ") + field.meaning);
    fields.read(field, value);
}

SphereRegion readSphere(Fields& fields) {
    SphereRegion sphere;
    readNeeded(fields, {"centre_m", "the middle of the ball", place_range}, sphere.centre);
    readNeeded(fields, {"radius_m", "the radius of the ball", radius_range}, sphere.radius_m);
    return sphere;
}

BoxRegion readBox(Fields& fields) {
    BoxRegion box;
    readNeeded(fields, {"lo_m", "the corner of least x, y and z", place_range}, box.lo);
    readNeeded(fields, {"hi_m", "the opposite corner", place_range}, box.hi);
    return box;
}

CylinderRegion readCylinder(Fields& fields) {
    CylinderRegion cylinder;
    readNeeded(fields, {"point_m", "any point of the axis", place_range}, cylinder.point);
    readNeeded(fields, {"axis", "its direction", Range::between(-1000, 1000)}, cylinder.axis);
    readNeeded(fields, {"radius_m", "the radius of the cylinder", radius_range}, cylinder.radius_m);
    return cylinder;
}

void readRegion(Fields& fields, sherd::SurfaceRegion& region) {
    if (fields.has("sphere") + fields.has("box") + fields.has("cylinder") != 1)
        throw BadKey{fields.path() + " must have one of sphere, box and cylinder."};
    fields.object("sphere", [&](Fields& part) { region = readSphere(part); });
    fields.object("box", [&](Fields& part) { region = readBox(part); });
    fields.object("cylinder", [&](Fields& part) { region = readCylinder(part); });
}

}  // namespace

void readSupports(Fields& body, std::vector<sherd::SurfaceRegion>& supports) {
    body.list("supports", [&](Fields& item) { readRegion(item, supports.emplace_back()); });
}

}  // namespace demo
