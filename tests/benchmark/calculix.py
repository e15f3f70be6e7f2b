"""The public cases solved with finite elements by CalculiX (ccx), for comparison."""
import os
import subprocess
import time

import numpy as np

from tetrahedra import shape_functions, shape_slopes, stress_at


def in_region(region, points, corners):
    """Which of the faces' `points` (#faces x 3) lie in a region; `corners`: #faces x 3 x 3."""
    if "sphere" in region:
        sphere = region["sphere"]
        return np.linalg.norm(points - sphere["centre"], axis=-1) <= sphere["radius"]
    if "box" in region:
        low, high = np.array(region["box"]["lo"]), np.array(region["box"]["hi"])
        gap = 1e-6 * np.linalg.norm(high - low)
        return ((points >= low - gap) & (points <= high + gap)).all(axis=-1)
    cylinder = region["cylinder"]  # a face belongs to it if its corners do
    axis = np.array(cylinder["axis"]) / np.linalg.norm(cylinder["axis"])
    radii = np.linalg.norm(np.cross(corners - cylinder["point"], axis), axis=-1)
    return (np.abs(radii - cylinder["radius"]) < 1e-4 * cylinder["radius"]).all(axis=-1)


def scatter(forces, nodes, shape, vectors):
    """forces += sum of shape_i * vector, over faces or elements (`nodes`: # x #nodes each)."""
    for column, value in zip(nodes.T, shape):
        for axis in range(3):
            forces[:, axis] += np.bincount(column, value * vectors[:, axis], len(forces))


def surface_forces(mesh, load, subdivisions=16):
    """Consistent nodal forces of a uniform traction or pressure. Faces that the region's edge cuts are sampled."""
    corners = mesh.nodes[mesh.faces[:, :3]]
    steps = np.arange(subdivisions)
    upright = [(3 * i + 1, 3 * j + 1) for i in steps for j in steps if i + j < subdivisions]
    flipped = [(3 * i + 2, 3 * j + 2) for i in steps for j in steps if i + j < subdivisions - 1]
    places = np.array(upright + flipped) / (3 * subdivisions)  # centres of small triangles
    places = np.hstack([places, 1 - places.sum(axis=1, keepdims=True)])
    shapes, slopes = shape_functions(places, mesh.quadratic), shape_slopes(places, mesh.quadratic)
    forces, area = np.zeros_like(mesh.nodes), 0.0
    nodes = mesh.nodes[mesh.faces]
    for shape, slope in zip(shapes, slopes):
        chosen = in_region(load["region"], np.einsum("n,fnx->fx", shape, nodes), corners)
        edges = np.einsum("nd,fnx->fdx", slope, nodes[chosen])
        normals = np.cross(edges[:, 0], edges[:, 1]) / (2 * len(places))
        sizes = np.linalg.norm(normals, axis=1)
        area += sizes.sum()
        tractions = -load["pressure_pa"] * normals if "pressure_pa" in load else sizes[:, None] * load["force_n"]
        scatter(forces, mesh.faces[chosen], shape, tractions)
    return forces if "pressure_pa" in load else forces / area


def volume_points(mesh, order=3):
    """Gauss points: yields shape functions, positions and volumes (per element)."""
    place, weight = np.polynomial.legendre.leggauss(order)
    place, weight = (place + 1) / 2, weight / 2
    for u, wu in zip(place, weight):
        for v, wv in zip(place, weight):
            for w, ww in zip(place, weight):  # a cube folded into a tetrahedron
                corner = np.array([[u, v * (1 - u), w * (1 - u) * (1 - v)]])
                corner = np.hstack([corner, 1 - corner.sum(axis=1, keepdims=True)])
                shape = shape_functions(corner, mesh.quadratic)[0]
                slope = shape_slopes(corner, mesh.quadratic)[0]
                nodes = mesh.nodes[mesh.elements]
                volume = np.abs(np.linalg.det(np.einsum("nd,enx->edx", slope, nodes)))
                yield shape, np.einsum("n,enx->ex", shape, nodes), volume * wu * wv * ww * (1 - u) ** 2 * (1 - v)


def add_inertia_relief(forces, mesh):
    """Adds the body force -(a + alpha x r), per volume of density 1, that balances the forces."""
    volume, first, second = 0.0, np.zeros(3), np.zeros((3, 3))
    for _, x, dv in volume_points(mesh):
        volume += dv.sum()
        first += dv @ x
        second += (x * dv[:, None]).T @ x
    centre = first / volume
    second -= volume * np.outer(centre, centre)
    inertia = np.trace(second) * np.eye(3) - second
    a = forces.sum(axis=0) / volume
    alpha = np.linalg.solve(inertia, np.cross(mesh.nodes - centre, forces).sum(axis=0))
    for shape, x, dv in volume_points(mesh):
        scatter(forces, mesh.elements, shape, -dv[:, None] * (a + np.cross(alpha, x - centre)))


def held_degrees(mesh, supports):
    """(node, axis) where u = 0: all of the supports; for a free body six that only take its rigid motion away."""
    if supports:
        corners = np.zeros((len(mesh.nodes), 1, 3))
        held = np.any([in_region(support["region"], mesh.nodes, corners) for support in supports], axis=0)
        return [(node, axis) for node in np.flatnonzero(held) for axis in range(3)]
    first = mesh.nodes.sum(axis=1).argmin()
    second = np.linalg.norm(mesh.nodes - mesh.nodes[first], axis=1).argmax()
    along = mesh.nodes[second] - mesh.nodes[first]
    turning = np.cross(along, mesh.nodes - mesh.nodes[first])  # how nodes move when the body turns about `along`
    third, axis = np.unravel_index(np.abs(turning).argmax(), turning.shape)
    across = [other for other in range(3) if other != np.abs(along).argmax()]
    return [(first, 0), (first, 1), (first, 2)] + [(second, other) for other in across] + [(third, axis)]


def write_input(path, mesh, material, forces, held):
    with open(path, "w") as out:
        out.write("*NODE, NSET=ALL\n")
        np.savetxt(out, np.column_stack([np.arange(1, len(mesh.nodes) + 1), mesh.nodes]), "%d, %.9e, %.9e, %.9e")
        out.write(f"*ELEMENT, TYPE=C3D{mesh.elements.shape[1]}, ELSET=BODY\n")
        np.savetxt(out, np.column_stack([np.arange(1, len(mesh.elements) + 1), mesh.elements + 1]), "%d", ", ")
        out.write("*MATERIAL, NAME=M\n*ELASTIC\n"
                  f"{material['youngs_modulus_pa']}, {material['poisson_ratio']}\n"
                  "*SOLID SECTION, ELSET=BODY, MATERIAL=M\n*BOUNDARY\n")
        out.writelines(f"{node + 1}, {axis + 1}, {axis + 1}, 0\n" for node, axis in held)
        out.write("*STEP\n*STATIC\n*CLOAD\n")
        out.writelines(f"{node + 1}, {axis + 1}, {forces[node, axis]:.12e}\n" for node, axis in np.argwhere(forces))
        out.write("*EL FILE\nS\n*END STEP\n")


def read_stress(path, nodes):
    """Nodal stress of an .frd file, #nodes x 6 (xx yy zz xy yz zx)."""
    stress, reading = np.full((nodes, 6), np.nan), False
    for line in open(path):
        if line.startswith(" -4"):
            reading = "STRESS" in line
        elif reading and line.startswith(" -1"):
            stress[int(line[3:13]) - 1] = [float(line[at:at + 12]) for at in range(13, 85, 12)]
    return stress


def solve(case, mesh, work, limit_s, repeats):
    """Stress at the case's points and how long ccx took (ms): the smallest time of a few, where they are short."""
    forces = sum(surface_forces(mesh, load) for load in case.data["loads"])
    if not case.data["supports"]:
        add_inertia_relief(forces, mesh)
    write_input(work / "body.inp", mesh, case.data["material"], forces, held_degrees(mesh, case.data["supports"]))
    one_thread = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    times_ms = []
    while len(times_ms) < repeats and sum(times_ms) < 3000:
        start = time.perf_counter()
        subprocess.run(["ccx", "body"], cwd=work, env=one_thread, check=True, capture_output=True, timeout=limit_s)
        times_ms.append(1000 * (time.perf_counter() - start))
    nodal = read_stress(work / "body.frd", len(mesh.nodes))
    return stress_at(case.points, mesh, nodal), min(times_ms)
