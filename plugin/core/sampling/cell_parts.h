#pragma once

#include <sherd/types.h>

#include <vector>

namespace sherd {

/// A part of the solid that is connected inside one cell of the particle grid.
struct CellPart {
    Eigen::Vector3i cell = Eigen::Vector3i::Zero();
    double fill = 0;  ///< part of the cell that is solid, 0 to 1
    /// Integrals of xi^a eta^b zeta^c, a fastest, a, b, c = 0 .. order, with (xi, eta, zeta) from the middle
    /// of the cell in edges, and the cell of volume 1. Empty: the whole cell is solid.
    std::vector<double> moments;
    std::vector<Eigen::Vector3i>
        voxels;  ///< on the integration grid; empty if it is the only part of its cell
};

/// The solid as parts of grid cells with their moments, and which parts touch. Products of trial functions
/// that are polynomials on every cell are integrated exactly with exact moments (see MomentRule).
struct CellParts {
    Vec3 origin = Vec3::Zero();  ///< lower corner of cell (0, 0, 0), m
    Vec3 edges = Vec3::Zero();   ///< of a cell, m
    Eigen::Vector3i count = Eigen::Vector3i::Zero();
    int voxels_per_cell = 1;                   ///< along one edge
    int order = 0;                             ///< of the moments, a direction
    std::vector<CellPart> parts;               ///< ascending in (z, y, x) of the cell
    std::vector<std::vector<int>> neighbours;  ///< per part: those it touches, ascending
    std::vector<int> first_part;               ///< per cell and one more: its first part

    int cellIndex(const Eigen::Vector3i& cell) const {
        return (cell.z() * count.y() + cell.y()) * count.x() + cell.x();
    }
    /// Coordinates of x from the middle of a cell, in edges.
    Vec3 toCell(const Vec3& x, const Eigen::Vector3i& cell) const {
        return (x - origin).cwiseQuotient(edges) - cell.cast<double>() - Vec3::Constant(0.5);
    }
    Vec3 centroid(const CellPart& part) const;  ///< m
    /// The part that x lies in, else the nearest one in its cell and the 26 around it; -1 if there is none.
    int partAt(const Vec3& x) const;
};

}  // namespace sherd
