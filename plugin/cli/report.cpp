#include "cli/report.h"

#include <algorithm>
#include <fstream>

namespace sherd::cli {

namespace {

using nlohmann::ordered_json;

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
    report["moment_order"] = model.settings().sampling.moment_order;
    report["wall_thickness_m"] = made.wall_thickness_m;
    report["residual_rel"] = field.residual_rel;
    report["imbalance_rel"] = field.imbalance_rel;
    report["strain_energy_j"] = field.strain_energy_j;
    report["material"] = ordered_json::parse(problem.material.toJson());
    report["settings"] = ordered_json::parse(model.settings().toJson());
    report["ms"] = milliseconds(made, field);
    report["repairs"] = made.repairs.sentences();
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
