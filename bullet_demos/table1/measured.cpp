#include "table1/measured.h"

#include <fstream>
#include <nlohmann/json.hpp>

sherd::Result<Measured> readMeasured(const std::string& folder) {
    const std::string report_path = folder + "/report.json", seconds_path = folder + "/after.seconds";
    Measured row;
    try {
        std::ifstream in(report_path);
        const nlohmann::json report = nlohmann::json::parse(in), first = report.at("ms").at("first_break");
        if (first.is_null())
            return sherd::Error{report_path + " says that nothing broke, so there is no row of the table."};
        row.bodies_after = report.at("bodies_after_first_break");
        row.triangles_before = report.at("triangles_before");
        row.triangles_after = report.at("triangles_after_first_break");
        row.particles = report.at("particles");
        row.grid_ms = first.at("sample");
        row.dynamics_ms = report.at("ms").at("step_total_median");
        row.stress_s = first.at("stress").get<double>() / 1000;
        row.fragmentation_ms = first.at("fragmentation");
    } catch (const nlohmann::json::exception& failure) {
        return sherd::Error{report_path + " cannot be read: " + failure.what() +
                            ". Run bullet_demos/run table1."};
    }
    std::ifstream seconds(seconds_path);
    if (!(seconds >> row.render_s))
        return sherd::Error{seconds_path + " cannot be read. Run bullet_demos/run table1."};
    return row;
}
