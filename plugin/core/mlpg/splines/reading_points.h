#pragma once

#include <vector>

#include "core/mlpg/splines/spline_field.h"
#include "core/sampling/discretisation.h"

namespace sherd {

/// A place where stress is read: a particle, or a point of the surface.
struct ReadingPoint {
    Eigen::Vector3f xi = Eigen::Vector3f::Zero();      ///< in the cell of its part, edges from the middle
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< of the surface, outward; zero: none is known
    Eigen::Vector3f area = Eigen::Vector3f::Zero();    ///< m^2, outward, as SurfacePoint has it
    int particle = 0;                                  ///< that the stress counts for

    /// Coordinates and normals are multiples of this, so that three of them fit into 64 bits.
    static constexpr float step = 0x1p-19f;
    static constexpr float limit = 2 - step;  ///< of their sizes
};

/// Those of a solid, sorted by the parts that they lie in.
struct ReadingPoints {
    std::vector<int> starts;           ///< per part and one more, into `points`
    std::vector<ReadingPoint> points;  ///< of a part by their particles

    ReadingPoints() = default;
    /// `samples`: where the particles lie, then the surface points. Those in no part are left out.
    ReadingPoints(const Discretisation& solid, const std::vector<GridPoint>& samples);

    /// Where a point of a part is, m.
    static Vec3 position(const CellParts& solid, int part, const ReadingPoint& point);
    /// The nearest point of its part, by its number; -1 if there is none.
    int nearestTo(const GridPoint& place) const;
};

/// The surface in a part, as far as it faces one way: its points together.
struct SurfaceFace {
    Eigen::Vector3f xi = Eigen::Vector3f::Zero();    ///< its middle, as a reading point's
    Eigen::Vector3f area = Eigen::Vector3f::Zero();  ///< m^2, outward
};

/// Those of a solid. What changes slowly over a cell is integrated over a few of them instead of over all
/// points.
struct SurfaceFaces {
    std::vector<int> starts;  ///< per part and one more, into `faces`
    std::vector<SurfaceFace> faces;

    SurfaceFaces() = default;
    explicit SurfaceFaces(const ReadingPoints& points);
};

}  // namespace sherd
