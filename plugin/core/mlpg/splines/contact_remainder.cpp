#include "core/mlpg/splines/contact_remainder.h"

#include <algorithm>

#include "core/mlpg/splines/b_spline.h"
#include "core/numerics/parallel_chunks.h"

namespace sherd {

namespace {

/// A point of a part's surface, with what acts there besides the near field.
struct Place {
    int part;
    Vec3 xi, position, area;
    Vec3 traction;  ///< times the area, N
};

/// What the near field leaves on the surface of one part after the other.
class RemainderOfParts {
  public:
    RemainderOfParts(const SplineProblem& problem, const NearField& near) : problem_(problem), near_(near) {}

    /// Whether the near field changes little over the part, and no disc is in it or near to it.
    bool isFar(int part) const {
        constexpr double cells = 3;
        const CellParts& parts = problem_.parts();
        const Vec3 middle = positionIn(part, Vec3::Zero());
        const double diagonal = parts.edges.norm();
        return std::all_of(near_.discs().begin(), near_.discs().end(), [&](const ContactDisc& disc) {
            return (middle - disc.centre).norm() > close_reach * disc.radius + cells * diagonal;
        });
    }

    /// Adds the faces of a part that is far.
    void addFaces(int part, const SurfaceFaces& faces, std::vector<Place>& places) const {
        for (int at = faces.starts[part]; at < faces.starts[part + 1]; ++at) {
            const Vec3 xi = faces.faces[at].xi.cast<double>(), area = faces.faces[at].area.cast<double>();
            if (!area.isZero(0)) places.push_back({part, xi, positionIn(part, xi), area, Vec3::Zero()});
        }
    }

    /// Adds the points of a part, each with what of it is not close to the discs.
    void addPoints(int part, const ReadingPoints& points, std::vector<Place>& places) const {
        for (int at = points.starts[part]; at < points.starts[part + 1]; ++at) {
            const Vec3 xi = points.points[at].xi.cast<double>();
            Vec3 area = points.points[at].area.cast<double>();
            if (area.isZero(0)) continue;
            const Vec3 x = positionIn(part, xi);
            const double share = 1 - near_.closeShare(x);
            if (!(share > 0)) continue;
            area *= share;
            const double size = area.norm();
            places.push_back({part, xi, x, area, size * near_.tractionAt(x, area / size)});
        }
    }

    /// The forces at the functions of each part, one part's after the other.
    void addForces(const std::vector<Place>& places, RowsOf3& of_parts) const {
        const auto count = static_cast<Eigen::Index>(places.size());
        SurfacePieces pieces{RowsOf3(count, 3), RowsOf3(count, 3)};
        for (Eigen::Index i = 0; i < count; ++i) {
            pieces.places.row(i) = places[i].position.transpose();
            pieces.areas.row(i) = places[i].area.transpose();
        }
        const RowsOf3 near = near_.forcesOn(pieces);
        std::vector<double> values;
        for (Eigen::Index i = 0; i < count; ++i) {
            splineValues(problem_.space->degree, places[i].xi, values);
            const Vec3 force = places[i].traction - near.row(i).transpose();
            const Eigen::Map<const Eigen::VectorXd> shares(values.data(), problem_.space->perPart());
            auto own = of_parts.middleRows(shares.size() * places[i].part, shares.size());
            for (int k = 0; k < 3; ++k) own.col(k) += force[k] * shares;
        }
    }

  private:
    Vec3 positionIn(int part, const Vec3& xi) const {
        const CellParts& parts = problem_.parts();
        const Vec3 cells = parts.parts[part].cell.cast<double>() + Vec3::Constant(0.5) + xi;
        return parts.origin + cells.cwiseProduct(parts.edges);
    }

    const SplineProblem& problem_;
    const NearField& near_;
};

}  // namespace

Result<Eigen::VectorXd> contactRemainder(const SplineProblem& problem, const ReadingPoints& points,
                                         const SurfaceFaces& faces, const ContactField& contact) {
    constexpr int chunks = 32;
    const RemainderOfParts remainder(problem, contact.near);
    const int part_count = static_cast<int>(points.starts.size()) - 1, per_part = problem.space->perPart();
    RowsOf3 of_parts = RowsOf3::Zero(Eigen::Index(per_part) * part_count, 3);
    forEachChunk(chunks, [&](int chunk) {
        std::vector<Place> places;
        const int end = chunkBegin(chunk + 1, chunks, part_count);
        for (int part = chunkBegin(chunk, chunks, part_count); part < end; ++part)
            if (remainder.isFar(part))
                remainder.addFaces(part, faces, places);
            else
                remainder.addPoints(part, points, places);
        remainder.addForces(places, of_parts);
    });
    Eigen::Matrix3Xd raw = Eigen::Matrix3Xd::Zero(3, problem.space->raw_count);
    for (int part = 0; part < part_count; ++part)
        for (int a = 0; a < per_part; ++a)
            raw.col(problem.space->raw_of[part][a]) +=
                of_parts.row(Eigen::Index(per_part) * part + a).transpose();
    std::vector<PointForce> forces = contact.close;
    forces.insert(forces.end(), contact.others.begin(), contact.others.end());
    const auto others = forcesAt(problem, forces);
    if (!others) return others;
    return Eigen::VectorXd(problem.space->gather(raw) + others.value());
}

}  // namespace sherd
