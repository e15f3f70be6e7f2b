#include <sherd/repair.h>

#include <cmath>

#include "core/numerics/mesh_measures.h"
#include "geometry/mesh_frame.h"
#include "geometry/repair/mend_surface.h"
#include "geometry/sentences.h"

namespace sherd {
namespace {

constexpr double largest_usual_m = 15, smallest_usual_m = 0.01;
constexpr double rounding = 1e-9;  // of the size: a distance below it is none

}  // namespace

Repair Repair::automatic() {
    Repair repair;
    repair.mode = Mode::automatic;
    return repair;
}

Status Repair::validate() const {
    if (Status valid = checkScale(scale); !valid) return valid;
    if (!std::isfinite(shell_thickness_m) || shell_thickness_m < 0)
        return Error{"Repair::shell_thickness_m is " + threeDigits(shell_thickness_m) +
                     "; it must be a length in m, or 0 for a solid body."};
    if (!(wrap_detail >= 0.001 && wrap_detail <= 0.1))
        return Error{"Repair::wrap_detail is " + threeDigits(wrap_detail) +
                     "; it must be a fraction of the mesh's diagonal between 0.001 and 0.1."};
    return success();
}

bool RepairReport::changed() const {
    return merged_vertices || doubled_triangles || flat_triangles || turned_triangles || parted_places ||
           filled_holes || crossings || united_parts || empty_parts || wrapped || hollowed || thickened;
}

std::vector<std::string> RepairReport::sentences() const {
    std::vector<std::string> said;
    const auto say = [&](int count, const char* one, const char* many, const std::string& done) {
        if (count > 0) said.push_back(counted(static_cast<std::size_t>(count), one, many) + " " + done + ".");
    };
    say(merged_vertices, "vertex", "vertices", "merged with others at the same place");
    say(doubled_triangles, "doubled or inner triangle", "doubled or inner triangles", "taken out");
    say(flat_triangles, "triangle", "triangles", "without area removed");
    say(turned_triangles, "triangle", "triangles", "turned to face outward");
    say(parted_places, "edge or vertex", "edges and vertices",
        "where the surface touched itself parted by a thousandth of an edge");
    say(filled_holes, "hole", "holes",
        "filled; the box around the largest has a diagonal of " + threeDigits(largest_hole_m) + " m");
    if (largest_hole_m > smallest_opening * size_m && !hollowed && !thickened)
        said.push_back(
            "A vessel whose opening was filled is solid; with Repair::shell_thickness_m it gets walls, and "
            "stays open.");
    say(crossings, "crossing of triangles", "crossings of triangles", "undone");
    say(united_parts, "part", "parts", "united with others that it overlapped or lay in");
    say(empty_parts, "part", "parts", "without volume left out");
    if (wrapped)
        said.push_back(
            "The surface was wrapped in a closed one, since what is wrong with it could not be "
            "mended face by face.");
    if (hollowed) said.push_back("The solid was made hollow.");
    if (thickened) said.push_back("The sheet became walls; its openings stay open.");
    const double distance_m = largest_distance_m > rounding * size_m ? largest_distance_m : 0;
    if (distance_m == 0 && (crossings > 0 || united_parts > 0))
        said.push_back("The new surface lies on the old one.");
    else if (wrapped || crossings > 0 || united_parts > 0)
        said.push_back("The new surface is up to " + threeDigits(distance_m) + " m from the old one (" +
                       threeDigits(100 * distance_m / size_m) + " % of its size).");
    return said;
}

std::string withNames(std::string sentence, const std::vector<std::pair<std::string, std::string>>& names) {
    for (const auto& [field, name] : names)
        for (std::size_t at = 0; (at = sentence.find(field, at)) != std::string::npos; at += name.size())
            sentence.replace(at, field.size(), name);
    return sentence;
}

std::string sizeWarning(const TriangleMesh& mesh) {
    const double length = mesh.triangles.empty() ? 0 : boundingBox(mesh).sizes().maxCoeff();
    if (length > largest_usual_m)
        return "The body is " + threeDigits(length) +
               " m long, and lengths are in metres: if its file is in centimetres or millimetres, read it "
               "with a "
               "scale of 0.01 or 0.001 (Repair::scale).";
    if (length > 0 && length < smallest_usual_m)
        return "The body is only " + threeDigits(length) +
               " m long, and lengths are in metres: if its file is in decimetres or larger units, read it "
               "with a "
               "scale of 10, 100 or 1000 (Repair::scale).";
    return "";
}

}  // namespace sherd
