#include "cli/csv_file.h"

#include <sherd/stress_field.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>

namespace sherd::cli {

namespace {

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r\"");
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

std::vector<std::string> fields(const std::string& line) {
    std::vector<std::string> parts;
    for (std::size_t start = 0, end = 0; end != std::string::npos; start = end + 1) {
        end = line.find(',', start);
        parts.push_back(trimmed(line.substr(start, end == std::string::npos ? end : end - start)));
    }
    return parts;
}

/// A finite number and nothing after it; not dependent on the locale.
bool readNumber(const std::string& text, double& number) {
    const char* begin = text.data() + (!text.empty() && text[0] == '+');
    const auto [end, trouble] = std::from_chars(begin, text.data() + text.size(), number);
    return trouble == std::errc() && end == text.data() + text.size() && std::isfinite(number);
}

/// Where x, y and z stand in the header; -1 for one that is not there.
std::array<int, 3> coordinateColumns(const std::string& header) {
    const std::vector<std::string> names = fields(header);
    std::array<int, 3> columns;
    for (int k = 0; k < 3; ++k) {
        const auto found = std::find(names.begin(), names.end(), std::string(1, "xyz"[k]));
        columns[k] = found == names.end() ? -1 : static_cast<int>(found - names.begin());
    }
    return columns;
}

void append(std::string& row, double number) {
    char digits[32];
    row.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
    row += ',';
}

}  // namespace

Result<std::vector<Vec3>> readPoints(const std::string& path) {
    std::ifstream in(path);
    std::string line;
    if (!std::getline(in, line)) return Error{path + ": the file of points cannot be read, or is empty."};
    if (line.rfind("\xEF\xBB\xBF", 0) == 0) line.erase(0, 3);  // a byte order mark
    const std::array<int, 3> columns = coordinateColumns(line);
    for (int k = 0; k < 3; ++k)
        if (columns[k] < 0)
            return Error{path + ": the first line must name the columns x, y and z, and " + "xyz"[k] +
                         " is not among \"" + trimmed(line) + "\"."};
    std::vector<Vec3> points;
    for (int number = 2; std::getline(in, line); ++number) {
        if (trimmed(line).empty()) continue;
        const std::vector<std::string> values = fields(line);
        Vec3 point;
        for (int k = 0; k < 3; ++k) {
            const auto column = static_cast<std::size_t>(columns[k]);
            if (column >= values.size() || !readNumber(values[column], point[k]))
                return Error{path + ", line " + std::to_string(number) + ": " + "xyz"[k] +
                             " is not a finite number."};
        }
        points.push_back(point);
    }
    if (points.empty()) return Error{path + ": there are no points below the header."};
    return points;
}

Status writeStress(const StressTable& table, const std::string& path) {
    std::ofstream out(path);
    out << "x,y,z,s_xx,s_yy,s_zz,s_xy,s_yz,s_zx,s_max_principal"
        << (table.spacings.empty() ? "" : ",spacing_m") << (table.kinds.empty() ? "\n" : ",kind\n");
    for (std::size_t i = 0; i < table.positions.size(); ++i) {
        std::string row;
        for (int k = 0; k < 3; ++k) append(row, table.positions[i][k]);
        for (int k = 0; k < 6; ++k) append(row, table.stresses[i][k]);
        append(row, largestPrincipal(table.stresses[i]));
        if (!table.spacings.empty()) append(row, table.spacings[i]);
        if (table.kinds.empty())
            row.back() = '\n';
        else
            row += std::string(table.kinds[i]) + '\n';
        out << row;
    }
    out.flush();
    if (!out) return Error{"Cannot write " + path + "; does the folder exist, and is there room?"};
    return success();
}

}  // namespace sherd::cli
