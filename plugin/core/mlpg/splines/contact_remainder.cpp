#include "core/mlpg/splines/contact_remainder.h"

#include "core/mlpg/splines/b_spline.h"

namespace sherd {

Result<Eigen::VectorXd> contactRemainder(const SplineProblem& problem, const ReadingPoints& points,
                                         const ContactField& contact) {
    Eigen::Matrix3Xd raw = Eigen::Matrix3Xd::Zero(3, problem.space->raw_count);
    std::vector<double> values;
    for (std::size_t part = 0; part + 1 < points.starts.size(); ++part) {
        const std::vector<int>& functions = problem.space->raw_of[part];
        for (int at = points.starts[part]; at < points.starts[part + 1]; ++at) {
            const ReadingPoint& point = points.points[at];
            if (point.area.isZero(0)) continue;
            const Vec3 x = ReadingPoints::position(problem.parts(), static_cast<int>(part), point);
            const double share = 1 - contact.near.closeShare(x);
            if (!(share > 0)) continue;
            const Vec3 area = share * point.area.cast<double>();
            const double size = area.norm();
            const Vec3 force =
                size * contact.near.tractionAt(x, area / size) - contact.near.stressAt(x) * area;
            splineValues(problem.space->degree, point.xi.cast<double>(), values);
            for (std::size_t a = 0; a < functions.size(); ++a) raw.col(functions[a]) += values[a] * force;
        }
    }
    std::vector<PointForce> forces = contact.close;
    forces.insert(forces.end(), contact.others.begin(), contact.others.end());
    const auto others = forcesAt(problem, forces);
    if (!others) return others;
    return Eigen::VectorXd(problem.space->gather(raw) + others.value());
}

}  // namespace sherd
