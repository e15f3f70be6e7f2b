#include <sherd/repair.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/numerics/mesh_measures.h"
#include "geometry/mesh_attributes.h"
#include "geometry/mesh_frame.h"
#include "geometry/repair/align_diagonals.h"
#include "geometry/repair/carry_look.h"
#include "geometry/repair/cgal_mesh.h"
#include "geometry/repair/mend_surface.h"
#include "geometry/repair/part_touching.h"
#include "geometry/repair/soup_cleaning.h"
#include "geometry/repair/surface_distance.h"
#include "geometry/repair/thicken_sheet.h"
#include "geometry/repair/wrap_surface.h"
#include "geometry/sentences.h"
#include "geometry/surface_checks.h"

namespace sherd {
namespace {

constexpr double weld_tolerance = 1e-5;  // of the diagonal
constexpr int most_rounds = 3;  // what one step leaves, as the rounding of a union, the next round mends
constexpr double distance_tolerance = 1e-3;    // of the distance to the original
constexpr double wrap_offset = 0.1;            // of the wrap's detail: bodies
constexpr double wrap_offset_of_sheets = 0.5;  // of the wrap's detail: sheets become walls of twice that
constexpr double coarse = 4;                   // over the wrap's detail
constexpr std::size_t most_triangles = 3000000;
constexpr double thinnest_walls = 1e-4;  // over the mesh's diagonal

constexpr const char* hint = " Repair::automatic() mends such meshes, and wraps what it cannot mend.";

double diagonalOf(const TriangleMesh& mesh) {
    return boundingBox(mesh).diagonal().norm();
}

/// The triangles that have an area, with all that they have: what new triangles take their look from, and
/// distances are measured to.
TriangleMesh withArea(const TriangleMesh& mesh) {
    TriangleMesh result;
    result.vertices = mesh.vertices;
    result.colours = mesh.colours;
    result.materials = mesh.materials;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [a, b, c] = cornersOf(mesh, t);
        const Vec3 u = b - a, v = c - a;
        if (!(u.cross(v).norm() > 1e-12 * std::max(u.squaredNorm(), v.squaredNorm()))) continue;
        result.triangles.push_back(mesh.triangles[t]);
        copyCorners(mesh, static_cast<int>(t), result);
    }
    return result;
}

/// What mending came to: a surface that may still have faults, and with holes filled before anything was cut.
struct Mended {
    TriangleMesh mesh, filled, patches;
    RepairReport report;
    Status status = success();
};

/// Stitches and closes what is open, but no openings wider than `largest_m`. The result is a manifold; its
/// parts may cross.
void closeUp(Mended& mended, double size, int round,
             double largest_m = std::numeric_limits<double>::infinity()) {
    TriangleMesh& mesh = mended.mesh;
    RepairReport& report = mended.report;
    mesh = stitched(mesh, weld_tolerance * size, round > 0, report);
    alignDiagonals(mesh, weld_tolerance * size);
    dropDoubled(mesh, report);
    orientAlike(mesh, report);
    partTouching(mesh, report);
    removeFlat(mesh, report);
    append(fillHoles(mesh, largest_m, report), mended.patches);
    if (round == 0) mended.filled = mesh;
}

void fillAndUnite(Mended& mended, double size, Repair::Mode mode) {
    for (int round = 0; round < most_rounds; ++round) {
        closeUp(mended, size, round);
        if (mode == Repair::Mode::wrap) return;
        undoCrossings(mended.mesh, mended.report);
        mended.status = uniteParts(mended.mesh, mended.report);
        if (!mended.status) return;
        mended.status = checkSurface(mended.mesh);
        if (mended.status) return;
    }
}

/// CGAL throws where an assumption of its does not hold; the wrap needs none of them.
Mended tryToMend(const TriangleMesh& original, double size, Repair::Mode mode) {
    Mended mended;
    mended.mesh = original;
    try {
        fillAndUnite(mended, size, mode);
    } catch (const std::exception& fault) {
        mended.status = Error{std::string("Mending failed: ") + fault.what()};
    }
    return mended;
}

/// Triangles without area are left out where the rest is sound. Elsewhere they join others, as long as they
/// do no harm: without them there would be a slit.
Mended mend(const TriangleMesh& original, const TriangleMesh& with_area, double size, Repair::Mode mode) {
    const auto flat = static_cast<int>(original.triangles.size() - with_area.triangles.size());
    Mended mended;
    if (flat > 0 && checkSurface(with_area)) {
        std::vector<int> all(with_area.triangles.size());
        std::iota(all.begin(), all.end(), 0);
        mended.mesh = mended.filled = partOf(with_area, all);
        mended.report.flat_triangles = flat;
        return mended;
    }
    mended = tryToMend(original, size, mode);
    if (mended.status || flat == 0) return mended;
    mended = tryToMend(with_area, size, mode);
    mended.report.flat_triangles += flat;
    return mended;
}

/// How thick the walls of a solid are in the mean that is all walls, m.
double meanWall(const TriangleMesh& solid) {
    return 2 * enclosedVolume(solid.vertices, solid.triangles, solid.vertices[0]) / surfaceArea(solid);
}

bool isSheet(const TriangleMesh& wrap, double detail_m) {
    return !wrap.triangles.empty() && meanWall(wrap) <= detail_m;
}

/// Close around a body; with more room around sheets, and around a body that folds into sheets in a part of
/// it: the walls that the wrap makes of them would break at a touch. Most sheets show in a coarse wrap, which
/// is a small part of the work; it encloses more than the fine one.
TriangleMesh wrapClosely(const TriangleMesh& mesh, double detail_m) {
    const double close = wrap_offset * detail_m, roomy = wrap_offset_of_sheets * detail_m;
    if (isSheet(wrapped(mesh, coarse * detail_m, close), detail_m)) return wrapped(mesh, detail_m, roomy);
    TriangleMesh wrap = wrapped(mesh, detail_m, close);
    const double thickness = wallThickness(wrap);  // 0 if it is not known
    const bool has_sheets = isSheet(wrap, detail_m) || (thickness > 0 && thickness < 3 * close);
    return has_sheets ? wrapped(mesh, detail_m, roomy) : wrap;
}

/// Counts of what was mended before the wrap: holes, and what was stitched to find them.
RepairReport reportOfWrap(const RepairReport& mended) {
    RepairReport report;
    report.merged_vertices = mended.merged_vertices;
    report.filled_holes = mended.filled_holes;
    report.largest_hole_m = mended.largest_hole_m;
    report.wrapped = true;
    return report;
}

Status hollowOut(RepairedMesh& result, const Repair& repair, double size) {
    const double thickness = repair.shell_thickness_m;
    const double alpha = std::max(thickness / 2, repair.wrap_detail * size);
    TriangleMesh cavity = cavityOf(result.mesh, thickness, alpha);
    if (cavity.triangles.empty())
        return Error{"A Repair::shell_thickness_m of " + threeDigits(thickness) +
                     " leaves no cavity: the body is nowhere thick enough; choose a smaller one."};
    if (enclosedVolume(cavity.vertices, cavity.triangles, cavity.vertices[0]) > 0)
        for (auto& t : cavity.triangles) std::swap(t[1], t[2]);
    TriangleMesh hollow;  // without attributes, which `carryLook` gives to all triangles later
    append(result.mesh, hollow);
    append(cavity, hollow);
    result.mesh = std::move(hollow);
    result.report.hollowed = true;
    return checkSurface(result.mesh);
}

/// Of a vessel that is modelled as a sheet: its walls, with its openings left open. Nothing if it has none,
/// or if no such walls can be made.
std::optional<RepairedMesh> wallsOf(const TriangleMesh& with_area, const Repair& repair, double size) {
    const double thickness = repair.shell_thickness_m;
    Mended mended;
    mended.mesh = with_area;
    closeUp(mended, size, 0, std::max(smallest_opening * size, 4 * thickness));
    if (mended.mesh.triangles.empty() || !hasBorder(mended.mesh)) return {};
    RepairedMesh walls{{}, mended.report};
    if (repair.mode != Repair::Mode::wrap) walls.mesh = thickened(mended.mesh, thickness);
    const auto are_sound = [&] {
        if (walls.mesh.triangles.empty() || !checkSurface(walls.mesh)) return false;
        const double mean = meanWall(walls.mesh);  // more where a slit or a neck was filled up
        return mean > 0.5 * thickness && mean < 1.5 * thickness;
    };
    if (!are_sound()) {
        const double detail = repair.wrap_detail * size;
        const bool may_wrap = repair.mode != Repair::Mode::mend && thickness > wrap_offset * detail;
        if (!may_wrap) return {};
        walls.mesh = wrapped(mended.mesh, std::max(thickness, detail), thickness / 2);
        if (!are_sound()) return {};
        walls.report = reportOfWrap(mended.report);
        walls.report.largest_distance_m = largestDistance(walls.mesh, with_area, distance_tolerance * size);
    }
    walls.report.thickened = true;
    walls.report.largest_loss_m = largestDistance(with_area, walls.mesh, distance_tolerance * size);
    return walls;
}

/// The same; CGAL throws where an assumption of its does not hold.
std::optional<RepairedMesh> wallsIfAny(const TriangleMesh& with_area, const Repair& repair, double size) {
    try {
        return wallsOf(with_area, repair, size);
    } catch (const std::exception&) {
        return {};
    }
}

Result<RepairedMesh> mendOrWrap(const TriangleMesh& original, const TriangleMesh& with_area,
                                const Repair& repair, double size) {
    Mended mended = mend(original, with_area, size, repair.mode);
    const bool wrap =
        repair.mode == Repair::Mode::wrap || (repair.mode == Repair::Mode::automatic && !mended.status);
    if (!wrap && !mended.status)
        return Error{"The surface could not be mended, and this is left: " + mended.status.error() +
                     " Repair::automatic() wraps such a mesh."};
    RepairedMesh result;
    result.mesh = std::move(mended.mesh);
    result.report = mended.report;
    if (wrap) {
        const TriangleMesh& inside = mended.filled.triangles.empty() ? with_area : mended.filled;
        result.mesh = wrapClosely(inside, repair.wrap_detail * size);
        result.report = reportOfWrap(mended.report);
        if (Status sound = checkSurface(result.mesh); !sound)
            return Error{"The wrap of the surface is not sound: " + sound.error() +
                         " Try another Repair::wrap_detail."};
    }
    TriangleMesh reference = with_area;
    append(mended.patches, reference);
    const double tolerance = distance_tolerance * size;
    result.report.largest_distance_m = largestDistance(result.mesh, reference, tolerance);
    result.report.largest_loss_m = largestDistance(with_area, result.mesh, tolerance);
    return result;
}

Result<RepairedMesh> repairOrThrow(const TriangleMesh& given, const Repair& repair) {
    if (Status valid = repair.validate(); !valid) return Error{valid.error()};
    const TriangleMesh original = placed(given, repair.scale, repair.up_axis);
    if (Status numbers = checkNumbers(original); !numbers) return Error{numbers.error()};
    const bool off = repair.mode == Repair::Mode::off;
    const Status sound = checkSurface(original);
    if (off && !sound && repair.shell_thickness_m > 0)
        return Error{sound.error() +
                     " Repair::shell_thickness_m mends nothing by itself; Repair::automatic() "
                     "with it does."};
    if (off && !sound) return Error{sound.error() + hint};
    if (!off && original.triangles.size() > most_triangles)
        return Error{"The surface has " + std::to_string(original.triangles.size()) +
                     " triangles, too many to repair; reduce it to a few hundred thousand."};
    const double size = diagonalOf(original);
    if (repair.shell_thickness_m > 0 && repair.shell_thickness_m < thinnest_walls * size)
        return Error{"A Repair::shell_thickness_m of " + threeDigits(repair.shell_thickness_m) +
                     " is less than a ten-thousandth of the mesh's diagonal, " + threeDigits(size) +
                     "; give the thickness of its walls in m, after scaling."};
    RepairedMesh result;
    result.mesh = original;
    const TriangleMesh reference = withArea(original);
    if (!sound || repair.mode == Repair::Mode::wrap) {
        if (reference.triangles.empty())
            return Error{"No triangle of the surface has an area, so there is nothing to repair."};
        auto walls =
            !sound && repair.shell_thickness_m > 0 ? wallsIfAny(reference, repair, size) : std::nullopt;
        if (walls) {
            result = std::move(*walls);
        } else {
            auto repaired = mendOrWrap(original, reference, repair, size);
            if (!repaired) return repaired;
            result = std::move(repaired).value();
        }
    }
    if (repair.shell_thickness_m > 0 && !result.report.thickened)
        if (Status hollow = hollowOut(result, repair, size); !hollow) return Error{hollow.error()};
    result.report.size_m = diagonalOf(result.mesh);
    if (!result.report.changed()) return result;
    TriangleMesh bare;
    bare.vertices = std::move(result.mesh.vertices);
    bare.triangles = std::move(result.mesh.triangles);
    carryLook(reference, bare);
    result.mesh = std::move(bare);
    return result;
}

}  // namespace

Result<RepairedMesh> repairMesh(const TriangleMesh& mesh, const Repair& repair) {
    try {
        return repairOrThrow(mesh, repair);
    } catch (const std::exception& fault) {
        return Error{std::string("The surface could not be repaired: ") + fault.what() +
                     "; simplify it, or mend it by hand."};
    }
}

}  // namespace sherd
