#include "cli/vtk_file.h"

#include <sherd/stress_field.h>

#include <cmath>
#include <fstream>
#include <limits>

namespace sherd::cli {

namespace {

constexpr int vertex_cell = 1, triangle_cell = 5;  // VTK's numbers

/// Values at the points of the grid; 1 component each, or 9.
struct PointData {
    std::string name;
    int components;
    std::vector<double> values;
};

struct Grid {
    std::vector<Vec3> points;
    std::vector<std::vector<int>> cells;  ///< of one point or of three
    std::vector<PointData> data;
};

double vonMises(const SymmetricTensor& s) {
    const double direct = std::pow(s[0] - s[1], 2) + std::pow(s[1] - s[2], 2) + std::pow(s[2] - s[0], 2);
    return std::sqrt(0.5 * direct + 3 * s.tail<3>().squaredNorm());
}

Grid gridOf(const StressPicture& picture) {
    const int particles = static_cast<int>(picture.particles.size());
    Grid grid;
    grid.points = picture.particles;
    grid.points.insert(grid.points.end(), picture.surface.vertices.begin(), picture.surface.vertices.end());
    for (int i = 0; i < particles; ++i) grid.cells.push_back({i});
    for (const auto& t : picture.surface.triangles)
        grid.cells.push_back({particles + t[0], particles + t[1], particles + t[2]});

    std::vector<SymmetricTensor> stresses = picture.particle_stresses;
    stresses.insert(stresses.end(), picture.vertex_stresses.begin(), picture.vertex_stresses.end());
    PointData stress{"stress", 9, {}}, principal{"max_principal", 1, {}}, mises{"von_mises", 1, {}};
    for (const SymmetricTensor& s : stresses) {
        for (const int component : {0, 3, 5, 3, 1, 4, 5, 4, 2}) stress.values.push_back(s[component]);
        principal.values.push_back(largestPrincipal(s));
        mises.values.push_back(vonMises(s));
    }
    PointData volume{"volume", 1, picture.particle_volumes}, part{"part", 1, {}};
    volume.values.resize(grid.points.size(), 0);
    part.values.resize(picture.particles.size(), 0);
    part.values.resize(grid.points.size(), 1);
    grid.data = {stress, principal, mises, volume, part};
    return grid;
}

void writeValues(std::ostream& out, const std::vector<double>& values, int columns) {
    for (std::size_t i = 0; i < values.size(); ++i)
        out << values[i] << ((i + 1) % static_cast<std::size_t>(columns) == 0 ? '\n' : ' ');
}

void writePositions(std::ostream& out, const Grid& grid) {
    for (const Vec3& p : grid.points) out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
}

void writeLegacy(std::ostream& out, const Grid& grid) {
    std::size_t entries = 0;
    for (const auto& cell : grid.cells) entries += 1 + cell.size();
    out << "# vtk DataFile Version 3.0\nstress, SI units\nASCII\nDATASET UNSTRUCTURED_GRID\n";
    out << "POINTS " << grid.points.size() << " double\n";
    writePositions(out, grid);
    out << "CELLS " << grid.cells.size() << ' ' << entries << '\n';
    for (const auto& cell : grid.cells) {
        out << cell.size();
        for (const int point : cell) out << ' ' << point;
        out << '\n';
    }
    out << "CELL_TYPES " << grid.cells.size() << '\n';
    for (const auto& cell : grid.cells) out << (cell.size() == 1 ? vertex_cell : triangle_cell) << '\n';
    out << "POINT_DATA " << grid.points.size() << '\n';
    for (const PointData& data : grid.data) {
        if (data.components == 9)
            out << "TENSORS " << data.name << " double\n";
        else
            out << "SCALARS " << data.name << " double 1\nLOOKUP_TABLE default\n";
        writeValues(out, data.values, data.components);
    }
}

void writeXml(std::ostream& out, const Grid& grid) {
    const auto open = [&](const char* type, const std::string& name, int components) {
        out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\""
            << components << "\" format=\"ascii\">\n";
    };
    const char* close = "</DataArray>\n";
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" "
           "version=\"0.1\">\n<UnstructuredGrid>\n"
        << "<Piece NumberOfPoints=\"" << grid.points.size() << "\" NumberOfCells=\"" << grid.cells.size()
        << "\">\n<Points>\n";
    open("Float64", "position", 3);
    writePositions(out, grid);
    out << close << "</Points>\n<Cells>\n";
    open("Int64", "connectivity", 1);
    for (const auto& cell : grid.cells)
        for (const int point : cell) out << point << '\n';
    out << close;
    open("Int64", "offsets", 1);
    std::size_t end = 0;
    for (const auto& cell : grid.cells) out << (end += cell.size()) << '\n';
    out << close;
    open("UInt8", "types", 1);
    for (const auto& cell : grid.cells) out << (cell.size() == 1 ? vertex_cell : triangle_cell) << '\n';
    out << close << "</Cells>\n<PointData Tensors=\"stress\" Scalars=\"max_principal\">\n";
    for (const PointData& data : grid.data) {
        open("Float64", data.name, data.components);
        writeValues(out, data.values, data.components);
        out << close;
    }
    out << "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace

Status writeVtk(const StressPicture& picture, const std::string& path) {
    std::ofstream out(path);
    out.imbue(std::locale::classic());
    out.precision(std::numeric_limits<double>::max_digits10);
    const Grid grid = gridOf(picture);
    const bool xml = path.size() > 4 && path.substr(path.size() - 4) == ".vtu";
    xml ? writeXml(out, grid) : writeLegacy(out, grid);
    out.flush();
    if (!out) return Error{"Cannot write " + path + "; does the folder exist, and is there room?"};
    return success();
}

}  // namespace sherd::cli
