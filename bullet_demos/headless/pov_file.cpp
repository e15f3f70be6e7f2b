#include "headless/pov_file.h"

#include <algorithm>
#include <fstream>
#include <ostream>

#include "headless/camera_fit.h"
#include "headless/corner_normals.h"

namespace demo {
namespace {

constexpr double aspect = 16.0 / 10;
constexpr double crease_deg = 40;

struct Pov {
    const Vec3& v;
};
std::ostream& operator<<(std::ostream& out, const Pov& p) {
    return out << '<' << p.v.x() << ',' << p.v.y() << ',' << p.v.z() << '>';
}

std::vector<Vec3> worldVertices(const BodyState& state) {
    std::vector<Vec3> vertices;
    for (const Vec3& vertex : state.asset->surface().vertices) vertices.push_back(state.placed * vertex);
    return vertices;
}

/// Of every breakable body.
std::vector<std::vector<Vec3>> pointsToShow(const std::vector<BodyState>& states) {
    std::vector<std::vector<Vec3>> bodies;
    for (const BodyState& state : states)
        if (state.asset) bodies.push_back(worldVertices(state));
    return bodies;
}

/// Camera, and the box that the lights are scaled to.
void writeLightsAndCamera(std::ostream& out, const Camera& camera,
                          const std::vector<std::vector<Vec3>>& bodies) {
    Vec3 low = bodies.front().front(), high = low;
    for (const auto& body : bodies) {
        for (const Vec3& point : body) {
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
        }
    }
    const Viewpoint view = fitCamera(camera, bodies, aspect);
    const Vec3 centre = (low + high) / 2;
    out << "#declare Stage_Centre = " << Pov{centre} << ";\n#declare Stage_Size = " << (high - low).norm()
        << ";\n"
        << "#include \"look.inc\"\n"
        << "camera { location " << Pov{view.position} << " up " << Pov{Vec3(Vec3::UnitY())}
        << " right -x*image_width/image_height sky " << Pov{view.up} << " angle " << view.width_deg
        << " look_at " << Pov{view.look_at} << " }\n";
}

template <class Items, class Write>
void writeList(std::ostream& out, const char* name, const Items& items, Write write) {
    out << name << " { " << items.size();
    for (const auto& item : items) {
        out << ",\n";
        write(item);
    }
    out << " }\n";
}

void writeFaces(std::ostream& out, const sherd::TriangleMesh& mesh) {
    out << "face_indices { " << mesh.triangles.size();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const bool crack = !mesh.kinds.empty() && mesh.kinds[t] == sherd::SurfaceKind::crack;
        out << ",\n<" << a << ',' << b << ',' << c << ">," << (crack ? 1 : 0);
    }
    out << " }\nnormal_indices { " << mesh.triangles.size();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        out << ",\n<" << 3 * t << ',' << 3 * t + 1 << ',' << 3 * t + 2 << '>';
    }
    out << " }\n";
}

void writeMesh(std::ostream& out, const BodyState& state) {
    const sherd::TriangleMesh& mesh = state.asset->surface();
    std::vector<Vec3> normals;
    for (const auto& corners : cornerNormals(mesh, crease_deg)) {
        for (const Vec3& normal : corners) normals.push_back(state.placed.linear() * normal);
    }
    const auto write = [&out](const Vec3& v) { out << Pov{v}; };
    out << "mesh2 {\n";
    writeList(out, "vertex_vectors", worldVertices(state), write);
    writeList(out, "normal_vectors", normals, write);
    const bool is_clear = isClear(state.asset->material());
    if (is_clear)
        out << "texture_list { 2, texture { Clear_Face() }, texture { Clear_Face() } }\n";
    else
        out << "texture_list { 2, texture { Outside(rgb " << Pov{state.look.outside} << ", "
            << state.look.gloss << ") }, texture { Crack(rgb " << Pov{state.look.crack} << ") } }\n";
    writeFaces(out, mesh);
    if (is_clear)
        out << "inside_vector z\nClear_Inside(rgb " << Pov{state.look.outside.cwiseSqrt()}
            << ", Stage_Size / 15)\n";
    out << "}\n";
}

}  // namespace

void writePovStage(std::ostream& out, const std::vector<BodyState>& states, const Camera& camera,
                   PovStyle style) {
    out << "#version 3.7;\n";
    if (style == PovStyle::film) out << "#declare Film = true;\n";
    const bool has_glass = std::any_of(states.begin(), states.end(), [](const BodyState& state) {
        return state.asset && isClear(state.asset->material());
    });
    if (has_glass) out << "#declare Clear = true;\n";
    writeLightsAndCamera(out, camera, pointsToShow(states));
}

void writePovBody(std::ostream& out, const BodyState& state) {
    if (state.asset) return writeMesh(out, state);
    out << "sphere { " << Pov{Vec3(state.placed.translation())} << ", " << state.ball_diameter_m / 2
        << " texture { Steel } }\n";
}

sherd::Status writePov(const std::vector<BodyState>& states, const Camera& camera, const std::string& path) {
    if (pointsToShow(states).empty())
        return sherd::Error{"There is no breakable body to draw in " + path + "."};
    std::ofstream out(path);
    out.precision(9);
    writePovStage(out, states, camera, PovStyle::still);
    for (const BodyState& state : states) writePovBody(out, state);
    out.flush();
    if (!out) return sherd::Error{"Cannot write " + path + "; is the disk full or the folder read-only?"};
    return sherd::success();
}

}  // namespace demo
