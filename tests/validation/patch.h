#pragma once

#include "validation/closed_form.h"

namespace sherd::validation {

// sigma = const solves the equations without body force, with u linear. A form that passes gives it back to
// rounding on any particles in any solid.
inline const Mat3 patch_gradient = (Mat3() << 1, 2, -0.5, 0.3, -1, 0.7, 0.2, 0.4, 0.6).finished() * 1e-4;

inline std::vector<TriangleMesh> cutSolids() {
    return {shapes::moved(shapes::slab({1, 0.7, 0.4}), someRotation()), shapes::icosphere(0.5, 3),
            shapes::tube(0.5, 0.3, 0.6, 48)};
}

}  // namespace sherd::validation
