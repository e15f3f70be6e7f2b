#include "generators/generators.h"

#include <utility>

#include "generators/coffee_cup.h"
#include "generators/coffee_plate.h"
#include "generators/plane.h"

namespace sherd::generators {
namespace {

const std::vector<std::pair<std::string, ImplicitSolid>>& solids() {
    static const std::vector<std::pair<std::string, ImplicitSolid>> all = {
        {"coffee_cup", coffeeCup({})}, {"coffee_plate", coffeePlate({})}, {"plane", plane({})}};
    return all;
}

}  // namespace

std::vector<std::string> generatorNames() {
    std::vector<std::string> names;
    for (const auto& [name, solid] : solids()) names.push_back(name);
    return names;
}

Result<TriangleMesh> generate(const std::string& name, int triangles) {
    for (const auto& [known, solid] : solids())
        if (known == name) return meshWithCount(solid, triangles);
    return Error{"There is no generator '" + name + "'."};
}

}  // namespace sherd::generators
