#include <cmath>
#include <deque>
#include <optional>

#include "geometry/mesh_attributes.h"
#include "geometry/sentences.h"
#include "geometry/triangulate_polygon.h"
#include "io/obj_file.h"
#include "io/obj_words.h"

namespace sherd {
namespace {

/// A corner of a face: numbers of its vertex, texture coordinates and normal, -1 for none.
struct Corner {
    int vertex = -1, texture = -1, normal = -1;
};

/// Reads records line by line; keeps the first fault and the lines of all.
class ObjParser {
  public:
    explicit ObjParser(const std::string& name) : name_(name) {}

    Result<TriangleMesh> parse(std::string_view text) {
        for (int next_number = 1; !text.empty();) {
            line_number_ = next_number;
            const std::string_view record = takeRecord(text, next_number);
            line_is_faulty_ = false;
            parseLine(record.substr(0, record.find('#')));
        }
        if (!fault_.empty()) return Error{fault_ + furtherFaults()};
        if (mesh_.triangles.empty())
            return Error{name_ +
                         ": there are no faces in this file; export the surface of a solid as polygons ('v' "
                         "and 'f' records)."};
        if (!any_crack_) mesh_.kinds.clear();
        addAttributes();
        return std::move(mesh_);
    }

  private:
    /// Takes a record, usually one line; counts its lines.
    std::string_view takeRecord(std::string_view& text, int& lines) {
        std::string_view line = takeLine(text);
        ++lines;
        if (!goesOn(line)) return line;
        std::string whole;
        for (; goesOn(line) && !text.empty(); ++lines) {
            whole.append(line.substr(0, line.rfind('\\'))).append(" ");
            line = takeLine(text);
        }
        continued_.push_back(whole.append(line));
        return continued_.back();
    }

    void parseLine(std::string_view line) {
        const std::string_view record = takeWord(line);
        if (record == "v") parseVertex(line);
        if (record == "vt") parseTextureCoordinates(line);
        if (record == "vn") parseNormal(line);
        if (record == "f") parseFace(line);
        if (record == "g") kind_ = takeWord(line) == "crack" ? SurfaceKind::crack : SurfaceKind::original;
        if (record == "usemtl") material_name_ = trimmed(line);
    }

    void parseVertex(std::string_view line) {
        constexpr const char* form = "a vertex is 'v x y z'";
        Vec3 position;
        for (int axis = 0; axis < 3; ++axis)
            position[axis] = number(line, std::string("the ") + "xyz"[axis] + " coordinate ", form, "vertex");
        mesh_.vertices.push_back(position);
        std::string_view rest = line;
        int more = 0;
        while (!takeWord(rest).empty()) ++more;
        if (more == 3) parseColour(line);
    }

    void parseColour(std::string_view line) {
        constexpr const char* names[] = {"the red component ", "the green component ", "the blue component "};
        Vec3 colour;
        for (int channel = 0; channel < 3; ++channel) {
            colour[channel] =
                number(line, names[channel], "a vertex with a colour is 'v x y z r g b'", "colour");
            if (colour[channel] < 0 || colour[channel] > 1)
                return fail(names[channel] +
                            std::string("of a colour is not between 0 and 1; divide colours by their "
                                        "largest value."));
        }
        mesh_.colours.resize(mesh_.vertices.size(), Vec3::Ones());
        mesh_.colours.back() = colour;
    }

    void parseTextureCoordinates(std::string_view line) {
        constexpr const char* form = "texture coordinates are 'vt u v'";
        const double u = number(line, "the u coordinate ", form, "record");
        std::string_view rest = line;
        const bool is_line = takeWord(rest).empty();  // one-dimensional textures have no v
        texture_coordinates_.emplace_back(u, is_line ? 0 : number(line, "the v coordinate ", form, "record"));
    }

    void parseNormal(std::string_view line) {
        Vec3 normal;
        for (int axis = 0; axis < 3; ++axis)
            normal[axis] = number(line, std::string("the ") + "xyz"[axis] + " component ",
                                  "a normal is 'vn x y z'", "normal");
        normals_.push_back(normal);
    }

    void parseFace(std::string_view line) {
        face_.clear();
        ++face_count_;
        for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
            const std::string_view whole = word;
            Corner corner;
            corner.vertex = index(takeIndex(word), whole, mesh_.vertices.size(), "vertex", "vertices");
            if (!word.empty() && word.front() != '/')
                corner.texture = index(takeIndex(word), whole, texture_coordinates_.size(),
                                       "texture coordinate", "texture coordinates");
            else if (!word.empty())
                word.remove_prefix(1);
            if (!word.empty()) corner.normal = index(word, whole, normals_.size(), "normal", "normals");
            if (line_is_faulty_) return;
            face_.push_back(corner);
        }
        if (face_.size() < 3)
            return fail("a face has " + std::to_string(face_.size()) + " corners; it needs 3 or more.");
        std::vector<Vec3> corners;
        for (const Corner& corner : face_) corners.push_back(mesh_.vertices[corner.vertex]);
        for (const auto& [a, b, c] : triangulatePolygon(corners)) addTriangle({face_[a], face_[b], face_[c]});
    }

    void addTriangle(const std::array<Corner, 3>& corners) {
        mesh_.triangles.push_back({corners[0].vertex, corners[1].vertex, corners[2].vertex});
        mesh_.kinds.push_back(kind_);
        mesh_.file_faces.push_back(face_count_);
        any_crack_ = any_crack_ || kind_ == SurfaceKind::crack;
        corners_.push_back(corners);
        material_names_.push_back(material_name_);
    }

    // Only once all is read it is known which attributes there are.
    void addAttributes() {
        if (!mesh_.colours.empty()) mesh_.colours.resize(mesh_.vertices.size(), Vec3::Ones());
        if (!texture_coordinates_.empty())
            addCorners(&Corner::texture, texture_coordinates_, mesh_.texture_coordinates);
        if (!normals_.empty()) addCorners(&Corner::normal, normals_, mesh_.normals);
        addMaterials();
    }

    template <class Vector>
    void addCorners(int Corner::*index, const std::vector<Vector>& values,
                    std::vector<std::array<Vector, 3>>& attribute) const {
        bool any = false;
        for (const auto& corners : corners_) {
            attribute.push_back({Vector::Zero(), Vector::Zero(), Vector::Zero()});
            for (int i = 0; i < 3; ++i) {
                if (corners[i].*index < 0) continue;
                attribute.back()[i] = values[corners[i].*index];
                any = true;
            }
        }
        if (!any) attribute.clear();
    }

    void addMaterials() {
        const auto is_named = [](std::string_view name) { return !name.empty(); };
        if (std::none_of(material_names_.begin(), material_names_.end(), is_named)) return;
        for (const std::string_view name : material_names_)
            mesh_.material.push_back(
                findOrAddMaterial(mesh_, is_named(name) ? std::string(name) : "original"));
    }

    double number(std::string_view& line, const std::string& subject, const char* form, const char* record) {
        const std::string_view word = takeWord(line);
        const auto value = parseNumber<double>(word);
        if (!value) fail(subject + quoted(word) + " is not a number; " + form + ".");
        if (value && !std::isfinite(*value))
            fail(subject + quoted(word) + " is not a finite number; correct this " + record + ".");
        return value.value_or(0);
    }

    /// From 0; negative numbers in the file count back from the newest.
    int index(std::string_view text, std::string_view word, std::size_t size, const std::string& one,
              const std::string& many) {
        const auto given = parseNumber<long long>(text);
        const long long count = static_cast<long long>(size);
        const long long found = !given ? -1 : *given < 0 ? count + *given : *given - 1;
        if (!given) fail("the " + one + " number " + quoted(word) + " is not a whole number.");
        if (given && (found < 0 || found >= count))
            fail("the face names " + one + " " + std::string(text) + ", but " + std::to_string(count) + " " +
                 many + " precede it; correct the number.");
        return static_cast<int>(found);
    }

    static std::string quoted(std::string_view word) { return "'" + std::string(word) + "'"; }

    void fail(const std::string& sentence) {
        if (line_is_faulty_) return;
        line_is_faulty_ = true;
        if (fault_.empty())
            fault_ = name_ + ":" + std::to_string(line_number_) + ": " + sentence;
        else
            further_faulty_lines_.push_back(line_number_);
    }

    std::string furtherFaults() const {
        if (further_faulty_lines_.empty()) return "";
        const bool one = further_faulty_lines_.size() == 1;
        return " " + std::to_string(further_faulty_lines_.size()) +
               (one ? " more line is" : " more lines are") + " faulty: " + firstOf(further_faulty_lines_) +
               ".";
    }

    std::string name_, fault_;
    std::deque<std::string> continued_;  // records of several lines; none moves when one is added
    TriangleMesh mesh_;
    std::vector<Vec2> texture_coordinates_;
    std::vector<Vec3> normals_;
    std::vector<Corner> face_;
    std::vector<std::array<Corner, 3>> corners_;    // of every triangle
    std::vector<std::string_view> material_names_;  // of every triangle, in the text or `continued_`
    std::string_view material_name_;
    SurfaceKind kind_ = SurfaceKind::original;
    bool any_crack_ = false;
    int line_number_ = 0, face_count_ = 0;
    bool line_is_faulty_ = false;
    std::vector<int> further_faulty_lines_;
};

}  // namespace

Result<TriangleMesh> parseObj(std::string_view text, const std::string& name) {
    constexpr std::size_t head = 1000;  // bytes
    if (text.substr(0, head).find('\0') != std::string_view::npos)
        return Error{
            name +
            ": this is no plain text, as an OBJ file is: it is binary, or UTF-16; export it as an OBJ "
            "file, or save it as UTF-8."};
    return ObjParser(name).parse(text);
}

}  // namespace sherd
