#include "core/mlpg/splines/spline_motions.h"

namespace sherd {
namespace {

/// Volume, centroid and second moment of one part.
Moments partMoments(const CellParts& solid, const CellPart& part) {
    const Vec3 middle =
        solid.origin + (part.cell.cast<double>() + Vec3::Constant(0.5)).cwiseProduct(solid.edges);
    const double cell = solid.edges.prod();
    if (part.moments.empty()) {
        const Mat3 second = (solid.edges.cwiseAbs2() / 12).asDiagonal();
        return {cell, middle, cell * second};
    }
    const int n = solid.order + 1;
    const auto moment = [&](int a, int b, int c) { return part.moments[(c * n + b) * n + a]; };
    const double fill = moment(0, 0, 0);
    const Vec3 first = Vec3(moment(1, 0, 0), moment(0, 1, 0), moment(0, 0, 1)) / fill;
    Mat3 second;
    second << moment(2, 0, 0), moment(1, 1, 0), moment(1, 0, 1), moment(1, 1, 0), moment(0, 2, 0),
        moment(0, 1, 1), moment(1, 0, 1), moment(0, 1, 1), moment(0, 0, 2);
    second -= fill * first * first.transpose();
    return {cell * fill, middle + first.cwiseProduct(solid.edges),
            cell * (solid.edges.asDiagonal() * second * solid.edges.asDiagonal())};
}

std::vector<Moments> componentMoments(const CellParts& solid, const SplineSpace& space) {
    std::vector<Moments> sums(space.component_count);
    std::vector<Moments> parts;
    for (size_t p = 0; p < solid.parts.size(); ++p) {
        parts.push_back(partMoments(solid, solid.parts[p]));
        Moments& sum = sums[space.component_of_part[p]];
        sum.volume += parts[p].volume;
        sum.centroid += parts[p].volume * parts[p].centroid;
    }
    for (Moments& sum : sums) sum.centroid /= sum.volume;
    for (size_t p = 0; p < parts.size(); ++p) {
        Moments& sum = sums[space.component_of_part[p]];
        const Vec3 offset = parts[p].centroid - sum.centroid;
        sum.second += parts[p].second + parts[p].volume * offset * offset.transpose();
    }
    return sums;
}

}  // namespace

RigidMotions splineMotions(const CellParts& solid, const SplineSpace& space) {
    return splineMotions(space, componentMoments(solid, space));
}

RigidMotions splineMotions(const SplineSpace& space, std::vector<Moments> component_moments) {
    RigidMotions motions(space.component, std::move(component_moments), 3);
    for (int f = 0; f < space.function_count; ++f)
        motions.coefficients.middleRows<3>(3L * f) = motions.at(space.greville_points[f], space.component[f]);
    return motions;
}

}  // namespace sherd
