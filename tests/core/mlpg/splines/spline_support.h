#pragma once

#include <gtest/gtest.h>

#include "core/sampling/sample_solid.h"
#include "support/shapes.h"

namespace sherd {

inline Mat3 someRotation() {
    return (Eigen::AngleAxisd(0.4, Vec3::UnitX()) * Eigen::AngleAxisd(0.7, Vec3::UnitY())).toRotationMatrix();
}

inline TriangleMesh tiltedBox() {
    return shapes::moved(shapes::slab({1, 0.6, 0.4}), someRotation());
}

inline CellParts partsOf(const TriangleMesh& mesh, double spacing, int degree) {
    SamplingSettings settings;
    settings.moment_order = 2 * degree;
    const Result<Discretisation> solid = sampleSolid(mesh, spacing, settings);
    EXPECT_TRUE(solid.ok()) << solid.error();
    return solid.value().parts;
}

}  // namespace sherd
