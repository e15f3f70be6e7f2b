#include "core/mlpg/splines/contact_remainder.h"

#include <algorithm>

#include "core/mlpg/splines/b_spline.h"

namespace sherd {

namespace {

/// Sums up what the near field leaves on the surface in one part after the other.
class RemainderSum {
  public:
    RemainderSum(const SplineProblem& problem, const NearField& near)
        : problem_(problem),
          near_(near),
          raw_(Eigen::Matrix3Xd::Zero(3, problem.space->raw_count)),
          of_part_(3, problem.space->perPart()) {}

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

    template <class Points>
    void add(int part, const std::vector<int>& starts, const Points& points) {
        if (starts[part] == starts[part + 1]) return;
        of_part_.setZero();
        for (int at = starts[part]; at < starts[part + 1]; ++at)
            addPoint(part, points[at].xi.template cast<double>(), points[at].area.template cast<double>());
        const std::vector<int>& functions = problem_.space->raw_of[part];
        for (std::size_t a = 0; a < functions.size(); ++a) raw_.col(functions[a]) += of_part_.col(a);
    }

    Eigen::VectorXd forces() const { return problem_.space->gather(raw_); }

  private:
    Vec3 positionIn(int part, const Vec3& xi) const {
        const CellParts& parts = problem_.parts();
        const Vec3 cells = parts.parts[part].cell.cast<double>() + Vec3::Constant(0.5) + xi;
        return parts.origin + cells.cwiseProduct(parts.edges);
    }

    void addPoint(int part, const Vec3& xi, Vec3 area) {
        if (area.isZero(0)) return;
        const Vec3 x = positionIn(part, xi);
        const double share = 1 - near_.closeShare(x);
        if (!(share > 0)) return;
        area *= share;
        const double size = area.norm();
        const Vec3 force = size * near_.tractionAt(x, area / size) - near_.stressAt(x) * area;
        splineValues(problem_.space->degree, xi, values_);
        for (std::size_t a = 0; a < values_.size(); ++a) of_part_.col(a) += values_[a] * force;
    }

    const SplineProblem& problem_;
    const NearField& near_;
    Eigen::Matrix3Xd raw_, of_part_;
    std::vector<double> values_;
};

}  // namespace

Result<Eigen::VectorXd> contactRemainder(const SplineProblem& problem, const ReadingPoints& points,
                                         const SurfaceFaces& faces, const ContactField& contact) {
    RemainderSum sum(problem, contact.near);
    for (int part = 0; part + 1 < static_cast<int>(points.starts.size()); ++part) {
        if (sum.isFar(part))
            sum.add(part, faces.starts, faces.faces);
        else
            sum.add(part, points.starts, points.points);
    }
    std::vector<PointForce> forces = contact.close;
    forces.insert(forces.end(), contact.others.begin(), contact.others.end());
    const auto others = forcesAt(problem, forces);
    if (!others) return others;
    return Eigen::VectorXd(sum.forces() + others.value());
}

}  // namespace sherd
