#include "core/mlpg/splines/spline_field.h"

#include "core/mlpg/splines/b_spline.h"
#include "core/mlpg/splines/monomials.h"

namespace sherd {

Mat3 gradientOn(const SplineField& field, int part, const Vec3& xi) {
    thread_local std::vector<Vec3> gradients;
    splineGradients(field.space->degree, xi, gradients);
    Mat3 gradient = Mat3::Zero();
    const std::vector<int>& functions = field.space->raw_of[part];
    for (size_t a = 0; a < functions.size(); ++a)
        gradient += field.raw.col(functions[a]) * gradients[a].transpose();
    gradient = gradient * field.parts->edges.cwiseInverse().asDiagonal();
    if (field.dilatation.size() > 0)
        projectTrace(gradient,
                     polynomialAt(dilatationDegree(field.space->degree), field.dilatation.col(part), xi),
                     field.projected_share);
    return gradient;
}

GridPoint locate(const CellParts& solid, const Vec3& x) {
    const int part = solid.partAt(x);
    if (part < 0) return {};
    return {part, solid.toCell(x, solid.parts[part].cell)};
}

}  // namespace sherd
