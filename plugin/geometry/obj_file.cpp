#include "geometry/obj_file.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <type_traits>

#include "geometry/merge_vertices.h"

namespace sherd {
namespace {

constexpr std::string_view blanks = " \t\r";

/// Takes the next word off the front of `line`; empty at the end.
std::string_view takeWord(std::string_view& line) {
    const std::size_t begin = std::min(line.find_first_not_of(blanks), line.size());
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

/// The whole word as a number, whatever the locale; infinite where a double cannot hold it.
template <class Number>
std::optional<Number> parseNumber(std::string_view word) {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    Number value{};
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if constexpr (std::is_floating_point_v<Number>)
        if (fault == std::errc::result_out_of_range) return std::numeric_limits<Number>::infinity();
    if (fault != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
}

/// Reads records line by line and keeps the first fault.
class ObjParser {
  public:
    explicit ObjParser(const std::string& name) : name_(name) {}

    Result<TriangleMesh> parse(std::string_view text) {
        while (!text.empty() && fault_.empty()) {
            const std::size_t end = std::min(text.find('\n'), text.size());
            std::string_view line = text.substr(0, end);
            text.remove_prefix(std::min(end + 1, text.size()));
            ++line_number_;
            parseLine(line.substr(0, line.find('#')));
        }
        if (!fault_.empty()) return Error{fault_};
        if (mesh_.triangles.empty())
            return Error{name_ +
                         ": there are no faces in this file; export the surface of a solid as polygons ('v' "
                         "and 'f' records)."};
        if (!any_crack_) mesh_.kinds.clear();
        return std::move(mesh_);
    }

  private:
    void parseLine(std::string_view line) {
        const std::string_view record = takeWord(line);
        if (record == "v") parseVertex(line);
        if (record == "f") parseFace(line);
        if (record == "g") kind_ = takeWord(line) == "crack" ? SurfaceKind::crack : SurfaceKind::original;
    }

    void parseVertex(std::string_view line) {
        Vec3 position = Vec3::Zero();
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = takeWord(line);
            const auto value = parseNumber<double>(word);
            const std::string subject = std::string("the ") + "xyz"[axis] + " coordinate " + quoted(word);
            if (!value) return fail(subject + " is not a number; a vertex is 'v x y z'.");
            if (!std::isfinite(*value))
                return fail(subject + " is not a finite number; correct this vertex.");
            position[axis] = *value;
        }
        mesh_.vertices.push_back(position);
    }

    void parseFace(std::string_view line) {
        corners_.clear();
        for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
            const std::string_view index_text = word.substr(0, word.find('/'));
            const auto index = parseNumber<long long>(index_text);
            if (!index) return fail("the vertex number " + quoted(word) + " is not a whole number.");
            const long long count = static_cast<long long>(mesh_.vertices.size());
            // Negative numbers count back from the newest vertex.
            const long long corner = *index < 0 ? count + *index : *index - 1;
            if (corner < 0 || corner >= count)
                return fail("the face names vertex " + std::string(index_text) + ", but " +
                            std::to_string(count) + " vertices precede it; correct the number.");
            corners_.push_back(static_cast<int>(corner));
        }
        if (corners_.size() < 3)
            return fail("a face has " + std::to_string(corners_.size()) + " corners; it needs 3 or more.");
        for (std::size_t i = 2; i < corners_.size(); ++i) {
            mesh_.triangles.push_back({corners_[0], corners_[i - 1], corners_[i]});
            mesh_.kinds.push_back(kind_);
        }
        any_crack_ = any_crack_ || kind_ == SurfaceKind::crack;
    }

    static std::string quoted(std::string_view word) { return "'" + std::string(word) + "'"; }

    void fail(const std::string& sentence) {
        fault_ = name_ + ":" + std::to_string(line_number_) + ": " + sentence;
    }

    std::string name_, fault_;
    TriangleMesh mesh_;
    std::vector<int> corners_;
    SurfaceKind kind_ = SurfaceKind::original;
    bool any_crack_ = false;
    int line_number_ = 0;
};

/// As many digits as it takes to read the same bits back.
void append(std::string& text, double value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value);
    text.append(digits, end.ptr);
}

std::string formatObj(const TriangleMesh& mesh) {
    std::string text;
    for (const Vec3& vertex : mesh.vertices) {
        text += 'v';
        for (int axis = 0; axis < 3; ++axis) append(text += ' ', vertex[axis]);
        text += '\n';
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!mesh.kinds.empty() && (t == 0 || mesh.kinds[t] != mesh.kinds[t - 1]))
            text += mesh.kinds[t] == SurfaceKind::crack ? "g crack\n" : "g original\n";
        text += 'f';
        for (const int corner : mesh.triangles[t]) (text += ' ') += std::to_string(corner + 1);
        text += '\n';
    }
    return text;
}

}  // namespace

Result<TriangleMesh> parseObj(std::string_view text, const std::string& name) {
    return ObjParser(name).parse(text);
}

Result<TriangleMesh> readObj(const std::string& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        return Error{path + " is a folder; name an OBJ file in it."};
    std::ifstream file(path, std::ios::binary);
    if (!file) return Error{path + " cannot be opened; check that the file is there and may be read."};
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (file.bad()) return Error{path + " cannot be read to its end; check the disk."};
    Result<TriangleMesh> mesh = parseObj(text, path);
    if (!mesh) return mesh;
    return mergeEqualVertices(mesh.value());
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
