#pragma once

#include "core/archive/indices.h"
#include "core/sampling/discretisation.h"

namespace sherd {

// A sampling as breaking a solid needs it: without the moments of cut cells, the surface points and the faces
// inside sub-domains, which only stress problems and their full solves read. `order` of its parts is 0 then,
// and no stress problem can be made of it.

template <class Archive>
void archiveFields(Archive& archive, Moments& moments) {
    auto& [volume, centroid, second] = moments;
    archiveAll(archive, volume, centroid, second);
}

template <class Archive>
void archiveFields(Archive& archive, Particle& particle) {
    auto& [position, volume, spacing] = particle;
    archiveAll(archive, position, volume, spacing);
}

/// Of the second moment the diagonal, which boxes are fitted with.
template <class Archive>
void archiveCell(Archive& archive, int particle_count, IntegrationCell& cell) {
    auto& [moments, particle] = cell;
    auto& [volume, centroid, second] = moments;
    Vec3 diagonal = second.diagonal();
    archiveAll(archive, volume, centroid, diagonal);
    if constexpr (Archive::reads) second = diagonal.asDiagonal();
    archiveIndex(archive, particle, particle_count);
}

/// Nearly all faces lie across an axis. The centroid is left out.
template <class Archive>
void archiveFace(Archive& archive, int cell_count, IntegrationFace& face) {
    auto& [cells, area, centroid] = face;
    for (int& cell : cells) archiveIndex(archive, cell, cell_count);
    int axis = 3;  // across none
    if constexpr (Archive::reads) {
        centroid.setZero();
        area.setZero();
    } else {
        for (int d = 0; d < 3; ++d)
            if (area[(d + 1) % 3] == 0 && area[(d + 2) % 3] == 0) axis = d;
    }
    archiveIndex(archive, axis, 4);
    if (axis == 3)
        sherd::archive(archive, area);
    else
        sherd::archive(archive, area[axis]);
}

template <class Archive>
void archiveFields(Archive& archive, CellPart& part) {
    auto& [cell, fill, moments, voxels] = part;
    static_cast<void>(cell);     // follows from the parts of each cell
    static_cast<void>(moments);  // left out
    archiveAll(archive, fill, voxels);
}

template <class Archive>
void archiveFields(Archive& archive, CellParts& solid) {
    auto& [origin, edges, count, voxels_per_cell, order, parts, neighbours, first_part] = solid;
    static_cast<void>(order);
    archiveAll(archive, origin, edges, count, voxels_per_cell, parts);
    archiveIndices(archive, neighbours, static_cast<int>(parts.size()));
    std::vector<std::uint8_t> parts_of_cell;
    if constexpr (!Archive::reads)
        for (std::size_t c = 0; c + 1 < first_part.size(); ++c)
            parts_of_cell.push_back(static_cast<std::uint8_t>(first_part[c + 1] - first_part[c]));
    sherd::archive(archive, parts_of_cell);
    constexpr int most = 1 << 20;  // so that products do not overflow
    archive.require((count.array() >= 0).all() && (count.array() <= most).all() && voxels_per_cell > 0 &&
                    edges.minCoeff() > 0 && neighbours.size() == parts.size());
    if (archive.good()) archive.require(count.cast<double>().prod() == double(parts_of_cell.size()));
    if constexpr (Archive::reads) {
        order = 0;
        first_part.assign(1, 0);
        for (std::size_t c = 0; c < parts_of_cell.size() && archive.good(); ++c) {
            const int cell = static_cast<int>(c), first = first_part.back(), next = first + parts_of_cell[c];
            archive.require(next <= static_cast<int>(parts.size()));
            for (int p = first; p < next && archive.good(); ++p)
                parts[p].cell = {cell % count.x(), cell / count.x() % count.y(),
                                 cell / count.x() / count.y()};
            first_part.push_back(next);
        }
    }
    archive.require(first_part.back() == static_cast<int>(parts.size()));
}

template <class Archive>
void archiveVoxel(Archive& archive, const Eigen::Vector3i& count, int cell_count,
                  Discretisation::Voxel& voxel) {
    auto& [index, cell, fill] = voxel;
    for (int d = 0; d < 3; ++d) archiveIndex(archive, index[d], count[d]);
    archiveIndex(archive, cell, cell_count);
    sherd::archive(archive, fill);
}

template <class Archive>
void archiveSymmetric(Archive& archive, Mat3& m) {
    archiveAll(archive, m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2));
    m(1, 0) = m(0, 1);
    m(2, 0) = m(0, 2);
    m(2, 1) = m(1, 2);
}

/// `surface` and its points are left out.
template <class Archive>
void archiveFields(Archive& archive, Discretisation& solid) {
    auto& [spacing, cell_size, particles, cells, faces, surface_points, facing, neighbours, particle_cells,
           surface, parts, grid_origin, voxels] = solid;
    static_cast<void>(surface_points), static_cast<void>(surface);
    archiveAll(archive, spacing, cell_size, particles, parts, grid_origin);
    const auto particle_count = static_cast<int>(particles.size());
    archiveIndices(archive, neighbours, particle_count);
    archiveList(archive, facing, 6 * sizeof(double), [&](Mat3& m) { archiveSymmetric(archive, m); });
    archive.require(neighbours.size() == particles.size() && facing.size() == particles.size());
    archiveList(archive, cells, sizeof(double) * 7,
                [&](IntegrationCell& cell) { archiveCell(archive, particle_count, cell); });
    const auto cell_count = static_cast<int>(cells.size());

    std::vector<IntegrationFace> between;  // particles
    if constexpr (!Archive::reads)
        for (const IntegrationFace& face : faces)
            if (cells[face.cells[0]].particle != cells[face.cells[1]].particle) between.push_back(face);
    archiveList(archive, between, sizeof(double),
                [&](IntegrationFace& face) { archiveFace(archive, cell_count, face); });
    Eigen::Vector3i count = Eigen::Vector3i::Zero();
    if constexpr (!Archive::reads)
        for (const Discretisation::Voxel& voxel : voxels)
            count = count.cwiseMax(voxel.index + Eigen::Vector3i::Ones());
    sherd::archive(archive, count);
    archiveList(archive, voxels, sizeof(double),
                [&](Discretisation::Voxel& voxel) { archiveVoxel(archive, count, cell_count, voxel); });
    if constexpr (Archive::reads) {
        faces = std::move(between);
        particle_cells.assign(particles.size(), {});
        for (int c = 0; c < cell_count && archive.good(); ++c) particle_cells[cells[c].particle].push_back(c);
    }
}

}  // namespace sherd
