#include "core/mlpg/reduced/damage_reader.h"

#include <algorithm>

#include "core/mlpg/splines/monomials.h"
#include "core/mlpg/splines/spline_field.h"
#include "core/mlpg/splines/volumetric_projection.h"

namespace sherd {

namespace {

constexpr double far_beyond = 3;   // overstress up to which it steers cracks
constexpr double much_more = 1.5;  // times as much matters beyond

}  // namespace

DamageReader::DamageReader(const DamageSource& source, const PartDisplacement& displacement,
                           const ContactReading& contact, double scale, const Strength& strength,
                           const Damage& before)
    : source_(source),
      displacement_(displacement),
      projected_share_(static_cast<float>(projectedShare(source.problem.elasticity))),
      contact_(contact),
      scale_(scale),
      strength_(strength),
      bound_(strength.criterion, strength.material),
      per_edge_(source.problem.parts().edges.cwiseInverse().cast<float>()),
      overstress_(before.overstress),
      tension_(scale > 0 ? before.largest_stress_pa / scale : 0) {}

bool DamageReader::mayFindMore(int part, double bound, double wanted) const {
    if (bound < wanted) return false;
    for (int at = source_.points.starts[part]; at < source_.points.starts[part + 1]; ++at)
        if (bound >= leastThatMatters(source_.points.points[at].particle, wanted)) return true;
    return false;
}

void DamageReader::read(int part, double wanted) {
    takeCoefficients(part);
    const double near = contact_.hasNearField() ? contact_.nearBound(part) : 0;
    const int end = source_.points.starts[part + 1];
    for (int first = source_.points.starts[part]; first < end; first += GradientLanes::count) {
        const int count = std::min(GradientLanes::count, end - first);
        GradientLanes::Lane is_on_surface = {};
        for (int l = 0; l < count; ++l) {
            const ReadingPoint& point = source_.points.points[first + l];
            setPoint(l, point.xi);
            is_on_surface[l] = point.normal.isZero(0) ? 0 : 1;
        }
        readGradients(part, count);
        StressBounds::RangeLanes ranges;
        source_.bounds.rangesAt(gradients_, is_on_surface, ranges);
        for (int l = 0; l < count; ++l) {
            if (doesNotMatter(ranges.smallest[l] - near, ranges.largest[l] + near, wanted, first + l))
                continue;
            const ReadingPoint& point = source_.points.points[first + l];
            const Vec3 x = ReadingPoints::position(source_.problem.parts(), part, point);
            wait(l, {x, point.normal, first + l, wanted, SymmetricTensor::Zero()});
        }
    }
}

void DamageReader::readPlaces() {
    const std::vector<ContactReading::Place>& places = contact_.places();
    for (std::size_t first = 0; first < places.size();) {
        const int part = places[first].where.part;
        takeCoefficients(part);
        int count = 0;
        for (; count < GradientLanes::count && first + count < places.size(); ++count) {
            if (places[first + count].where.part != part) break;
            setPoint(count, places[first + count].where.xi.cast<float>());
        }
        readGradients(part, count);
        for (int l = 0; l < count; ++l, ++first) {
            const ContactReading::Place& place = places[first];
            wait(l, {place.position, place.normal, place.nearest, near_to_failure, place.unresolved});
        }
    }
}

void DamageReader::finish() {
    StressLanes stress;
    PlaceLanes::Lane smallest, largest;
    stressOf(source_.problem.elasticity, waiting_.gradient, stress);
    contact_.addNearStress(waiting_.at, stress);
    for (int i = 0; i < 6; ++i)
        for (int l = 0; l < PlaceLanes::count; ++l) stress.s[i][l] += waiting_.unresolved.s[i][l];
    applyTraction(waiting_.surface, source_.problem.elasticity, stress);
    boundPrincipal(stress, smallest, largest);
    for (int l = 0; l < waiting_.count; ++l)
        if (!doesNotMatter(smallest[l], largest[l], waiting_.wanted[l], waiting_.point[l]))
            include(stress.at(l), waiting_.point[l]);
    waiting_.count = 0;
}

void DamageReader::takeCoefficients(int part) {
    const std::vector<int>& functions = source_.problem.space->raw_of[part];
    for (std::size_t f = 0; f < functions.size(); ++f)
        std::copy_n(displacement_.raw.col(functions[f]).data(), 4, coefficients_.of_function[f]);
}

void DamageReader::setPoint(int lane, const Eigen::Vector3f& xi) {
    for (int d = 0; d < 3; ++d) gradients_.xi[d][lane] = xi[d];
}

void DamageReader::readGradients(int part, int count) {
    const int degree = source_.problem.space->degree;
    findGradients(degree, source_.powers, coefficients_, per_edge_, gradients_);
    const Eigen::MatrixXf& dilatation = displacement_.dilatation;
    if (dilatation.size() == 0) return;
    for (int l = 0; l < count; ++l) {
        const Eigen::Vector3f xi(gradients_.xi[0][l], gradients_.xi[1][l], gradients_.xi[2][l]);
        Eigen::Matrix3f gradient = Eigen::Matrix3f::Zero();
        for (int d = 0; d < 3; ++d) gradient(d, d) = gradients_.gradient[d][d][l];
        projectTrace(gradient, polynomialAt(dilatationDegree(degree), dilatation.col(part), xi),
                     projected_share_);
        for (int d = 0; d < 3; ++d) gradients_.gradient[d][d][l] = gradient(d, d);
    }
}

void DamageReader::wait(int lane, const Spot& spot) {
    const int to = waiting_.count++;
    const bool is_known = !spot.normal.isZero(0) && !contact_.isLoaded(spot.x);
    waiting_.surface.is_known[to] = is_known ? 1 : 0;
    const Vec3 normal = spot.normal.cast<double>();
    const Vec3 traction = is_known ? contact_.tractionAt(spot.x, normal.normalized()) : Vec3(Vec3::Zero());
    for (int i = 0; i < 3; ++i) {
        waiting_.at.x[i][to] = spot.x[i];
        waiting_.surface.normal[i][to] = normal[i];
        waiting_.surface.traction_pa[i][to] = traction[i];
        for (int d = 0; d < 3; ++d) waiting_.gradient[i][d][to] = gradients_.gradient[i][d][lane];
    }
    for (int i = 0; i < 6; ++i) waiting_.unresolved.s[i][to] = spot.unresolved[i];
    waiting_.point[to] = spot.point;
    waiting_.wanted[to] = spot.wanted;
    if (waiting_.count == PlaceLanes::count) finish();
}

void DamageReader::include(const SymmetricTensor& stress, int point) {
    const PrincipalStresses principal = principalStresses(stress);
    const double equivalent = strength_.criterion.equivalent_stress_pa(principal, strength_.material);
    const int particle = source_.points.points[point].particle;
    const double own = scale_ / strength_.at_points[point] * equivalent;
    if (own > overstress_[particle]) {
        overstress_[particle] = own;
        found_.push_back({particle, own, scale_ * stress});
    }
    tension_ = std::max(tension_, principal.largest);
}

double DamageReader::leastThatMatters(int particle, double wanted) const {
    const double known = overstress_[particle];
    return std::max(wanted, known > far_beyond ? much_more * known : known);
}

bool DamageReader::doesNotMatter(double smallest_pa, double largest_pa, double wanted, int point) const {
    const double least = leastThatMatters(source_.points.points[point].particle, wanted);
    return largest_pa <= tension_ &&
           scale_ * bound_(smallest_pa, largest_pa) < least * strength_.at_points[point];
}

}  // namespace sherd
