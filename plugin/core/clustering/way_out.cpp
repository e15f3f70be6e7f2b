#include "core/clustering/way_out.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/fibonacci_sphere.h"

namespace sherd {

bool hasWayOut(const std::vector<Vec3>& normals) {
    constexpr int directions = 300;
    const auto isFree = [&](const Vec3& direction) {
        return std::all_of(normals.begin(), normals.end(),
                           [&](const Vec3& normal) { return normal.dot(direction) <= most_facing; });
    };
    // Along two of the cracks, as in walls; the widest way out is often between them.
    for (std::size_t a = 0; a < normals.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const Vec3 along = normals[a].cross(normals[b]);
            if (!along.isZero(1e-6) && (isFree(along.normalized()) || isFree(-along.normalized())))
                return true;
        }
    for (int k = 0; k < directions; ++k)
        if (isFree(fibonacciDirection(k, directions))) return true;
    return false;
}

}  // namespace sherd
