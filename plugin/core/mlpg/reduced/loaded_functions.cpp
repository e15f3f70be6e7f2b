#include "core/mlpg/reduced/loaded_functions.h"

#include "core/mlpg/splines/b_spline.h"

namespace sherd {

Result<LoadedFunctions> loadedFunctions(const SplineProblem& problem, const std::vector<PointForce>& loads) {
    const SplineSpace& space = *problem.space;
    LoadedFunctions loaded;
    Eigen::Matrix<double, 6, Eigen::Dynamic> resultants;
    resultants.setZero(6, problem.motions.componentCount());
    std::vector<double> values;
    for (const PointForce& load : loads) {
        const GridPoint place = locate(problem.parts(), load.position);
        if (place.part < 0 || !load.force.allFinite())
            return Error{
                "A load is not finite, or more than a particle spacing outside the body; give it in the "
                "asset's frame."};
        splineValues(space.degree, place.xi, values);
        const std::vector<int>& raw = space.raw_of[place.part];
        for (std::size_t a = 0; a < raw.size(); ++a)
            for (const SplineTies::Term& term : space.termsOf(raw[a])) {
                const Vec3 force = values[a] * term.factor * load.force;
                loaded.forces.push_back({term.function, force});
                resultants.col(space.component[term.function]) +=
                    problem.motions.coefficients.middleRows<3>(3L * term.function).transpose() * force;
            }
    }
    clearHeld(problem, resultants);
    loaded.acceleration = problem.inertia.accelerationOf(resultants);
    return loaded;
}

}  // namespace sherd
