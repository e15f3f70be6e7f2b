#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "validation/known_fields.h"

/// A sweep solves one problem while one thing about it gets worse. Tests say what Sherd does there; with the
/// environment variable SHERD_TABLES set they also print the rows of the tables in README.md beside this
/// file.
namespace sherd::stability {

using namespace validation;

class Table {
  public:
    explicit Table(const std::string& head) { print(head); }

    template <class... Values>
    void row(const char* format, Values... values) {
        char text[200];
        std::snprintf(text, sizeof text, format, values...);
        print(text);
    }

  private:
    static void print(const std::string& text) {
        if (std::getenv("SHERD_TABLES")) std::printf("| %s |\n", text.c_str());
    }
};

struct Outcome {
    double error = 0;  // relative L2 of the stress tensor at the particles; infinite if there was no result
    double reciprocal_condition = 0;
    size_t warnings = 0;
    std::string trouble;  // the sentence, if there was no result
};

/// Solves a closed form on a given sampling. Whatever comes out, it must be finite or a sentence.
inline Outcome solveOn(const ClosedForm& form, std::shared_ptr<const Discretisation> solid,
                       const StressSettings& settings) {
    Outcome outcome;
    outcome.error = std::numeric_limits<double>::infinity();
    const auto solver = StressSolver::build(solid, form.material, settings);
    if (!solver) {
        EXPECT_GT(solver.error().size(), 20u);
        outcome.trouble = solver.error();
        return outcome;
    }
    outcome.reciprocal_condition = solver.value().report().reciprocal_condition;
    const bool exact_loads = settings.trial_function == TrialFunction::spline;
    const auto field = exact_loads ? solver.value().solve(tractions(form, *solid))
                                   : solver.value().solveTraction([&](const Vec3& x, const Vec3& normal) {
                                         return Vec3(form.stress(x) * normal);
                                     });
    if (!field) {
        outcome.trouble = field.error();
        return outcome;
    }
    outcome.warnings = field.value().warnings.size();
    Squares squares;
    for (size_t i = 0; i < solid->particles.size(); ++i) {
        EXPECT_TRUE(field.value().particles[i].allFinite());
        squares.add(toMatrix(field.value().particles[i]), form.stress(solid->particles[i].position),
                    solid->particles[i].volume);
    }
    outcome.error = squares.ratio();
    return outcome;
}

inline Outcome solveAt(const ClosedForm& form, double spacing, const StressSettings& settings) {
    SamplingSettings sampling;
    if (settings.trial_function == TrialFunction::spline)
        sampling.moment_order = 2 * splineDegree(settings.basis);
    auto solid = sampleSolid(form.surface, spacing, sampling);
    if (!solid) {
        Outcome outcome;
        outcome.error = std::numeric_limits<double>::infinity();
        outcome.trouble = solid.error();
        return outcome;
    }
    return solveOn(form, std::make_shared<Discretisation>(std::move(solid).value()), settings);
}

inline StressSettings withRadius(StressSettings settings, double support_radius) {
    settings.support_radius = support_radius;
    return settings;
}

inline const StressSettings quadratic_splines = splines(Basis::quadratic);

}  // namespace sherd::stability
