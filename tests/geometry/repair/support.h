#pragma once

#include <gtest/gtest.h>
#include <sherd/repair.h>

#include <algorithm>
#include <string>

#include "core/numerics/mesh_measures.h"
#include "geometry/surface_checks.h"
#include "support/shapes.h"

namespace sherd::repair_tests {

constexpr double pi = 3.14159265358979323846;
inline const TriangleMesh unit_box = shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1));

inline Repair mendOnly() {
    Repair repair;
    repair.mode = Repair::Mode::mend;
    return repair;
}

/// The mesh as the repair leaves it, which has to be sound, and wrapped only if that was asked for.
inline RepairedMesh repaired(const TriangleMesh& mesh, const Repair& repair = mendOnly()) {
    auto result = repairMesh(mesh, repair);
    EXPECT_TRUE(result.ok()) << result.error();
    if (!result) return {};
    EXPECT_EQ(checkSurface(result.value().mesh).error(), "");
    EXPECT_EQ(result.value().report.wrapped,
              result.value().report.wrapped && repair.mode != Repair::Mode::mend);
    EXPECT_EQ(result.value().report.changed(), !result.value().report.sentences().empty());
    return std::move(result).value();
}

inline double volumeOf(const TriangleMesh& mesh) {
    return mesh.vertices.empty() ? 0 : enclosedVolume(mesh.vertices, mesh.triangles, mesh.vertices[0]);
}

inline void expectRefusedUntouched(const TriangleMesh& mesh, const std::string& words) {
    const std::string sentence = repairMesh(mesh, {}).error();
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("Repair::automatic()"), std::string::npos) << sentence;
}

/// Vertices of the second mesh that are at the place of one of the first become that one.
inline TriangleMesh sharing(const TriangleMesh& a, const TriangleMesh& b) {
    TriangleMesh mesh = shapes::joined(a, b);
    for (auto& triangle : mesh.triangles)
        for (int& corner : triangle)
            corner = static_cast<int>(
                std::find(mesh.vertices.begin(), mesh.vertices.end(), mesh.vertices[corner]) -
                mesh.vertices.begin());
    return mesh;
}

}  // namespace sherd::repair_tests
