#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

#include <string>
#include <utility>
#include <vector>

namespace sherd {

/// How a mesh is taken in: units, axes, and what may be changed to make it the surface of a solid.
struct Repair {
    enum class Mode {
        off,        ///< nothing is changed; a mesh that is not sound is refused with all its faults
        mend,       ///< faults are mended one by one; what cannot be mended is refused
        automatic,  ///< the same, and a closed wrap around the mesh where mending is not enough
        wrap,       ///< always a wrap
    };
    Mode mode = Mode::off;
    /// Multiplies the coordinates, so that they are metres: 0.001 for a mesh in millimetres.
    double scale = 1;
    /// The axis of the mesh that points up; the mesh is turned so that it is z.
    UpAxis up_axis = UpAxis::z;
    /// Above 0 the solid gets one cavity that leaves walls of this thickness, m (after scaling): ceramic
    /// figures are hollow. Parts that are thinner than two walls stay solid. With a mode other than `off` a
    /// mesh that is open (a rim of more than 0.15 of its diagonal) is taken for a vessel that is modelled as
    /// a sheet: it becomes walls of this thickness on its inner side, and stays open. Where these would
    /// cross, the sheet is wrapped, with half of the thickness on either side (`Mode::automatic`).
    double shell_thickness_m = 0;
    /// Of the wrap, as a fraction of the mesh's diagonal, 0.001 to 0.1: openings and creases narrower than
    /// this are closed, triangles are about as large.
    double wrap_detail = 0.006;

    /// Mends, and wraps where that is not enough: for meshes as they come.
    static Repair automatic();

    Status validate() const;
};

/// What was changed in a mesh.
struct RepairReport {
    /// At one position, or on borders within a hundred-thousandth of the diagonal.
    int merged_vertices = 0;
    int doubled_triangles = 0;  ///< copies of others, and walls inside
    int flat_triangles = 0;     ///< without area
    int turned_triangles = 0;   ///< that ran against their neighbours or faced inward
    /// Edges and vertices in which the surface touched itself; parts are pulled apart there.
    int parted_places = 0;
    int filled_holes = 0;
    double largest_hole_m = 0;  ///< diagonal of the box around the largest filled hole
    int crossings = 0;          ///< pairs of crossing triangles that were undone within a part
    int united_parts = 0;       ///< that overlapped others or lay inside them
    int empty_parts = 0;        ///< without volume, left out
    bool wrapped = false;
    bool hollowed = false;
    bool thickened = false;  ///< a sheet became walls
    double size_m = 0;       ///< diagonal of the result's box
    /// Largest distance of a point of the repaired surface from the mesh as it was, filled holes counted as
    /// part of that and a cavity left out; within a thousandth of `size_m`.
    double largest_distance_m = 0;
    /// Largest distance of a point of the mesh as it was from the repaired surface: large where something
    /// inside was given up.
    double largest_loss_m = 0;

    bool changed() const;
    /// What was changed, a sentence each; empty if nothing was.
    std::vector<std::string> sentences() const;
};

/// A sound mesh, and what it took.
struct RepairedMesh {
    TriangleMesh mesh;
    RepairReport report;
};

/// Makes the surface of a solid of a mesh: closed, oriented outward, a manifold, without self-intersection.
/// Triangles that stay keep their normals, texture coordinates and material; new ones take them, and
/// vertices take their colour, from the nearest point of the mesh as it was. Deterministic.
/// The error says every fault that is left, or which figure of `repair` is out of range.
Result<RepairedMesh> repairMesh(const TriangleMesh& mesh, const Repair& repair);

/// A sentence of the library, which calls what to change by its field (`Repair::scale`), as a program says it
/// to users who know that by another name (`--scale`): `names` has the field first.
std::string withNames(std::string sentence, const std::vector<std::pair<std::string, std::string>>& names);

/// A warning if a body of that surface is so large or so small that its file is probably not in metres;
/// empty otherwise.
std::string sizeWarning(const TriangleMesh& mesh);

}  // namespace sherd
