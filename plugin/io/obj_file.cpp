#include "io/obj_file.h"

#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "geometry/merge_vertices.h"
#include "geometry/mesh_frame.h"

namespace sherd {
namespace {

/// As many digits as it takes to read the same bits back.
void append(std::string& text, double value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value);
    text.append(digits, end.ptr);
}

template <class Vector>
void appendNumbers(std::string& text, const Vector& values) {
    for (const double value : values) append(text += ' ', value);
}

/// Writes every value once and returns the number, from 1, of each corner's.
template <class Vector>
std::vector<std::array<int, 3>> appendValues(std::string& text, const char* record,
                                             const std::vector<std::array<Vector, 3>>& of_corners) {
    std::map<std::vector<double>, int> number_of;
    std::vector<std::array<int, 3>> numbers(of_corners.size());
    for (std::size_t t = 0; t < of_corners.size(); ++t)
        for (int i = 0; i < 3; ++i) {
            const Vector& value = of_corners[t][i];
            const auto [entry, is_new] = number_of.try_emplace(
                std::vector<double>(value.begin(), value.end()), static_cast<int>(number_of.size()) + 1);
            numbers[t][i] = entry->second;
            if (!is_new) continue;
            appendNumbers(text += record, value);
            text += '\n';
        }
    return numbers;
}

std::string formatObj(const TriangleMesh& mesh) {
    std::string text;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        appendNumbers(text += 'v', mesh.vertices[v]);
        if (!mesh.colours.empty()) appendNumbers(text, mesh.colours[v]);
        text += '\n';
    }
    const auto textures = appendValues(text, "vt", mesh.texture_coordinates);
    const auto normals = appendValues(text, "vn", mesh.normals);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!mesh.kinds.empty() && (t == 0 || mesh.kinds[t] != mesh.kinds[t - 1]))
            text += mesh.kinds[t] == SurfaceKind::crack ? "g crack\n" : "g original\n";
        if (!mesh.material.empty() && (t == 0 || mesh.material[t] != mesh.material[t - 1]))
            text += "usemtl " + mesh.materials[mesh.material[t]] + '\n';
        text += 'f';
        for (int i = 0; i < 3; ++i) {
            (text += ' ') += std::to_string(mesh.triangles[t][i] + 1);
            if (!textures.empty()) (text += '/') += std::to_string(textures[t][i]);
            if (!normals.empty()) (text += textures.empty() ? "//" : "/") += std::to_string(normals[t][i]);
        }
        text += '\n';
    }
    return text;
}

}  // namespace

Result<TriangleMesh> readObj(const std::string& path, double scale, UpAxis up_axis) {
    if (const Status valid = checkScale(scale); !valid) return Error{path + ": " + valid.error()};
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        return Error{path + " is a folder; name an OBJ file in it."};
    std::ifstream file(path, std::ios::binary);
    if (!file) return Error{path + " cannot be opened; check that the file is there and may be read."};
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (file.bad()) return Error{path + " cannot be read to its end; check the disk."};
    Result<TriangleMesh> mesh = parseObj(text, path);
    if (!mesh) return mesh;
    return placed(mergeEqualVertices(mesh.value()), scale, up_axis);
}

Status writeObj(const TriangleMesh& mesh, const std::string& path) {
    std::ofstream file(path, std::ios::binary);
    if (!file)
        return Error{path +
                     " cannot be opened for writing; check that the folder is there and may be written."};
    const std::string text = formatObj(mesh);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    if (!file) return Error{path + " could not be written to its end; check the space on the disk."};
    return success();
}

}  // namespace sherd
