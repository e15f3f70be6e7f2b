#pragma once

#include <sherd/triangle_mesh.h>

#include <algorithm>
#include <limits>

#include "core/archive/indices.h"

namespace sherd {

/// A surface with all that a renderer wants to know.
template <class Archive>
void archiveFields(Archive& to_or_from, TriangleMesh& mesh) {
    auto& [vertices, triangles, kinds, file_faces, texture_coordinates, normals, material, materials,
           colours] = mesh;
    archiveAll(to_or_from, vertices, texture_coordinates, normals, materials, colours);
    const auto vertex_count = static_cast<int>(vertices.size());
    archiveList(to_or_from, triangles, 3 * detail::bytesFor(static_cast<std::uint32_t>(vertex_count)),
                [&](std::array<int, 3>& corners) {
                    archiveIndices(to_or_from, corners.data(), corners.size(), vertex_count);
                });
    archiveList(to_or_from, kinds, 1, [&](SurfaceKind& kind) { archiveEnum(to_or_from, kind, 2); });
    archiveIndices(to_or_from, material, static_cast<int>(materials.size()));
    int last_face = file_faces.empty() ? 0 : *std::max_element(file_faces.begin(), file_faces.end());
    archive(to_or_from, last_face);
    const bool is_possible = 0 <= last_face && last_face < std::numeric_limits<int>::max();
    to_or_from.require(is_possible);
    archiveIndices(to_or_from, file_faces, is_possible ? last_face + 1 : 1);

    const auto isNoneOr = [&](std::size_t size, std::size_t all) {
        to_or_from.require(size == 0 || size == all);
    };
    isNoneOr(kinds.size(), triangles.size());
    isNoneOr(file_faces.size(), triangles.size());
    isNoneOr(texture_coordinates.size(), triangles.size());
    isNoneOr(normals.size(), triangles.size());
    isNoneOr(material.size(), triangles.size());
    isNoneOr(colours.size(), vertices.size());
}

}  // namespace sherd
