#include "core/mlpg/splines/contact_remainder.h"

#include <algorithm>

#include "core/mlpg/splines/b_spline.h"
#include "core/numerics/parallel_chunks.h"

namespace sherd {

namespace {

/// What the near field leaves on the surface of one part after the other.
class RemainderOfParts {
  public:
    RemainderOfParts(const SplineProblem& problem, const NearField& near) : problem_(problem), near_(near) {}

    /// Whether the near field changes little over the part, and no disc is in it.
    bool isFar(int part) const {
        constexpr double cells = 3;
        const CellParts& parts = problem_.parts();
        const Vec3 middle = positionIn(part, Vec3::Zero());
        const double diagonal = parts.edges.norm();
        return std::all_of(near_.discs().begin(), near_.discs().end(), [&](const ContactDisc& disc) {
            return (middle - disc.centre).norm() > close_reach * disc.radius + cells * diagonal;
        });
    }

    /// Adds what is at the points of a part to `forces`, one for each function of the part.
    template <class Points>
    void add(int part, const std::vector<int>& starts, const Points& points,
             Eigen::Ref<Eigen::Matrix3Xd> forces) const {
        for (int at = starts[part]; at < starts[part + 1]; ++at)
            addPoint(part, points[at].xi.template cast<double>(), points[at].area.template cast<double>(),
                     forces);
    }

  private:
    Vec3 positionIn(int part, const Vec3& xi) const {
        const CellParts& parts = problem_.parts();
        const Vec3 cells = parts.parts[part].cell.cast<double>() + Vec3::Constant(0.5) + xi;
        return parts.origin + cells.cwiseProduct(parts.edges);
    }

    void addPoint(int part, const Vec3& xi, Vec3 area, Eigen::Ref<Eigen::Matrix3Xd> forces) const {
        if (area.isZero(0)) return;
        const Vec3 x = positionIn(part, xi);
        const double share = 1 - near_.closeShare(x);
        if (!(share > 0)) return;
        area *= share;
        const double size = area.norm();
        const Vec3 force = size * near_.tractionAt(x, area / size) - near_.stressAt(x) * area;
        thread_local std::vector<double> values;  // of one point after the other
        splineValues(problem_.space->degree, xi, values);
        for (std::size_t a = 0; a < values.size(); ++a) forces.col(a) += values[a] * force;
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
    Eigen::Matrix3Xd of_parts = Eigen::Matrix3Xd::Zero(3, Eigen::Index(per_part) * part_count);
    forEachChunk(chunks, [&](int chunk) {
        const int end = chunkBegin(chunk + 1, chunks, part_count);
        for (int part = chunkBegin(chunk, chunks, part_count); part < end; ++part) {
            auto own = of_parts.middleCols(Eigen::Index(per_part) * part, per_part);
            if (remainder.isFar(part))
                remainder.add(part, faces.starts, faces.faces, own);
            else
                remainder.add(part, points.starts, points.points, own);
        }
    });
    Eigen::Matrix3Xd raw = Eigen::Matrix3Xd::Zero(3, problem.space->raw_count);
    for (int part = 0; part < part_count; ++part)
        for (int a = 0; a < per_part; ++a)
            raw.col(problem.space->raw_of[part][a]) += of_parts.col(Eigen::Index(per_part) * part + a);
    std::vector<PointForce> forces = contact.close;
    forces.insert(forces.end(), contact.others.begin(), contact.others.end());
    const auto others = forcesAt(problem, forces);
    if (!others) return others;
    return Eigen::VectorXd(problem.space->gather(raw) + others.value());
}

}  // namespace sherd
