#include "cli/report.h"

#include <algorithm>
#include <fstream>

#include "cli/form_names.h"

namespace sherd::cli {

namespace {

using nlohmann::ordered_json;

ordered_json describe(const Settings& settings) {
    const SamplingSettings& sampling = settings.sampling;
    const StressSettings& stress = settings.stress;
    ordered_json used;
    used["spacing_m"] = sampling.spacing_m;
    used["layers_across_wall"] = sampling.layers_across_wall;
    used["smallest_count"] = sampling.smallest_count;
    used["largest_count"] = sampling.largest_count;
    used["cells_per_spacing"] = sampling.cells_per_spacing;
    used["moment_order"] = sampling.moment_order;
    used["smallest_fill"] = sampling.smallest_fill;
    used["test_function"] = nameOf(test_names, stress.test_function);
    used["trial_function"] = nameOf(trial_names, stress.trial_function);
    used["basis"] = nameOf(basis_names, stress.basis);
    used["support_radius"] = stress.support_radius;
    used["resampling_rounds"] = stress.resampling_rounds;
    used["resampling_margin"] = stress.resampling_margin;
    used["largest_factor_millions"] = sampling.largest_factor_millions;
    used["largest_factor_if_thin_millions"] = sampling.largest_factor_if_thin_millions;
    return used;
}

ordered_json milliseconds(const StressModelReport& made, const StressField& field) {
    return {{"sample", made.sample_ms},
            {"assemble", made.assemble_ms},
            {"factor", made.factor_ms},
            {"solve", field.solve_ms},
            {"recovery", field.recovery_ms}};
}

}  // namespace

ordered_json makeReport(const Arguments& arguments, const StressCase& problem, const StressModel& model,
                        const StressField& field) {
    const StressModelReport made = model.report();
    ordered_json report;
    report["case"] = problem.name;
    report["quality"] = arguments.quality;
    report["particles"] = made.particles;
    report["surface_points"] = made.surface_points;
    report["unknowns"] = made.unknowns;
    report["factor_entries"] = made.factor_entries;
    report["resampling_entries"] = field.resampling_entries;
    report["factor_bytes"] = made.factor_bytes;
    report["reciprocal_condition"] = made.reciprocal_condition;
    report["spacing_m"] = made.spacing_m;
    report["wall_thickness_m"] = made.wall_thickness_m;
    report["residual_rel"] = field.residual_rel;
    report["imbalance_rel"] = field.imbalance_rel;
    report["strain_energy_j"] = field.strain_energy_j;
    report["settings"] = describe(model.settings());
    report["ms"] = milliseconds(made, field);
    report["warnings"] = made.warnings;
    for (const std::string& warning : field.warnings)  // which hold those of the solver again
        if (std::find(made.warnings.begin(), made.warnings.end(), warning) == made.warnings.end())
            report["warnings"].push_back(warning);
    return report;
}

Status writeReport(const ordered_json& report, const std::string& path) {
    std::ofstream out(path);
    out << report.dump(2) << "\n";
    out.flush();
    if (!out) return Error{"Cannot write " + path + "; does the folder exist, and is there room?"};
    return success();
}

}  // namespace sherd::cli
