#include "cli/stress_command.h"

#include <sherd/stress_model.h>

#include <iostream>

#include "cli/case_file.h"
#include "cli/csv_file.h"
#include "cli/mesh_options.h"
#include "cli/report.h"
#include "cli/vtk_file.h"
#include "core/stress/principal_stresses.h"

namespace sherd::cli {

namespace {

template <class T>
void append(std::vector<T>& list, const std::vector<T>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

template <class T>
std::vector<T> firstOf(const std::vector<T>& list, std::size_t count) {
    return {list.begin(), list.begin() + std::ptrdiff_t(count)};
}

Result<StressModel> makeModel(const StressCase& problem, const Arguments& arguments) {
    const Result<TriangleMesh> surface = readObj(problem.mesh);
    if (!surface) return Error{surface.error()};
    auto model = StressModel::make(surface.value(), problem.material, arguments.settings, problem.supports,
                                   arguments.repair);
    if (!model) return Error{problem.mesh + ": " + model.error()};
    return model;
}

/// The wanted points, which were solved for first; without any, particles and surface points.
StressTable tableOf(const StressModel& model, const StressField& field, const std::vector<Vec3>& wanted) {
    if (!wanted.empty())
        return {
            wanted, firstOf(field.points, wanted.size()), {}, firstOf(field.point_spacing_m, wanted.size())};
    StressTable table{model.particlePositions(), field.particles, {}, {}};
    append(table.positions, model.surfacePositions());
    append(table.stresses, field.surface);
    table.kinds.assign(field.particles.size(), "particle");
    table.kinds.resize(table.positions.size(), "surface");
    return table;
}

/// The surface's vertices were solved for after the wanted points.
StressPicture pictureOf(const StressModel& model, const StressField& field, std::size_t wanted) {
    return {model.particlePositions(),
            model.particleVolumes(),
            field.particles,
            model.surface(),
            {field.points.begin() + std::ptrdiff_t(wanted), field.points.end()}};
}

/// A line on where the table is, and where the largest tension in it.
void tell(const StressTable& table, const std::string& path, std::ostream& out) {
    std::size_t most = 0;
    std::vector<double> tensions;
    for (const SymmetricTensor& stress : table.stresses)
        tensions.push_back(principalStresses(stress).largest);
    for (std::size_t i = 0; i < tensions.size(); ++i)
        if (tensions[i] > tensions[most]) most = i;
    out << path << ": stress at " << tensions.size() << " points";
    if (!tensions.empty())
        out << "; the largest tension is " << 1e-6 * tensions[most] << " MPa, at ("
            << table.positions[most].transpose().format(Eigen::IOFormat(6, Eigen::DontAlignCols, ", ", ", "))
            << ") m";
    out << "\n";
}

Status writeAll(const Arguments& arguments, const StressCase& problem, const StressModel& model,
                const StressField& field, const std::vector<Vec3>& wanted, std::ostream& out) {
    const StressTable table = tableOf(model, field, wanted);
    Status status = writeStress(table, arguments.out);
    if (status) tell(table, arguments.out, out);
    const auto report = makeReport(arguments, problem, model, field);
    if (status && !arguments.report.empty()) status = writeReport(report, arguments.report);
    if (status && !arguments.vtk.empty())
        status = writeVtk(pictureOf(model, field, wanted.size()), arguments.vtk);
    for (const std::string& key : problem.unknown_keys)
        std::cerr << "warning: " << arguments.case_file << ": the key \"" << key
                  << "\" is not known and was passed over\n";
    for (const std::string repair : report["repairs"]) std::cerr << "note: " << withOptions(repair) << "\n";
    for (const std::string warning : report["warnings"])
        std::cerr << "warning: " << withOptions(warning) << "\n";
    return status;
}

}  // namespace

Status runStress(const Arguments& arguments, std::ostream& out) {
    const Result<StressCase> problem = readCase(arguments.case_file);
    if (!problem) return Error{problem.error()};
    std::vector<Vec3> wanted;
    if (!arguments.points.empty()) {
        auto points = readPoints(arguments.points);
        if (!points) return Error{points.error()};
        wanted = std::move(points).value();
    }

    const Result<StressModel> model = makeModel(problem.value(), arguments);
    if (!model) return Error{model.error()};
    std::vector<Vec3> points = wanted;
    if (!arguments.vtk.empty()) append(points, model.value().surface().vertices);
    const auto field = model.value().solve(problem.value().loads, points, problem.value().spin_rad_s);
    if (!field) return Error{arguments.case_file + ": " + field.error()};
    return writeAll(arguments, problem.value(), model.value(), field.value(), wanted, out);
}

}  // namespace sherd::cli
