"""Tetrahedral meshes of the public cases by gmsh, and sums over their elements and faces.

Corner nodes come first, then those on the edges 01 12 02 03 13 23 (faces: 01 12 02), as CalculiX has them."""
import subprocess

import numpy as np

CORNER_PAIRS = np.array([(0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)])
OUTWARD_FACES = np.array([(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])

# The bodies as in the cases' descriptions.
BODIES = {
    "slab_centre": "Box(1) = {-0.5, -0.5, -0.045, 1, 1, 0.09};",
    "cantilever": "Box(1) = {0, -0.1, -0.1, 1, 0.2, 0.2};",
    "sphere_squeezed": "Sphere(1) = {0, 0, 0, 0.5};",
    "thick_cylinder": """Cylinder(2) = {0, 0, 0, 0, 0, 0.2, 0.2}; Cylinder(3) = {0, 0, 0, 0, 0, 0.2, 0.1};
        BooleanDifference(1) = {Volume{2}; Delete;}{Volume{3}; Delete;};""",
    "dish_rim": """Sphere(2) = {0, 0, -0.35, 0.373}; Sphere(3) = {0, 0, -0.35, 0.367};
        Cone(4) = {0, 0, -0.35, 0, 0, 0.5, 0, 0.5 * 0.12 / 0.35};
        BooleanDifference(5) = {Volume{2}; Delete;}{Volume{3}; Delete;};
        BooleanIntersection(1) = {Volume{5}; Delete;}{Volume{4}; Delete;};""",
}


class Mesh:
    """nodes: #nodes x 3, elements: #elements x 4 or 10, faces (of the surface, seen from outside): #faces x 3 or 6."""

    def __init__(self, nodes, elements):
        used, renumbered = np.unique(elements, return_inverse=True)
        self.nodes, self.elements = nodes[used], renumbered.reshape(elements.shape)
        self.faces = surface_faces(self.elements)

    @property
    def quadratic(self):
        return self.elements.shape[1] == 10


def surface_faces(elements):
    """Faces that only one element has."""
    corners = elements[:, OUTWARD_FACES].reshape(-1, 3)
    _, first, count = np.unique(np.sort(corners, axis=1), axis=0, return_index=True, return_counts=True)
    lonely = first[count == 1]
    if elements.shape[1] == 4:
        return corners[lonely]
    pairs = [[next(4 + e for e, pair in enumerate(CORNER_PAIRS) if {*pair} == {face[i], face[(i + 1) % 3]})
              for i in range(3)] for face in OUTWARD_FACES]
    return np.hstack([corners, elements[:, pairs].reshape(-1, 3)])[lonely]


def finer_near_loads(case, size, ratio):
    """gmsh fields: elements of size / ratio around load patches and supports, growing to `size`."""
    fields = []
    for region in [entry["region"] for entry in case.data["loads"] + case.data["supports"]]:
        if "sphere" in region:
            radius, centre = region["sphere"]["radius"], region["sphere"]["centre"]
            shape = {"Radius": 1.5 * radius, "Thickness": (size - size / ratio) / 0.25}
            shape.update({axis + "Center": value for axis, value in zip("XYZ", centre)})
            kind = "Ball"
        elif "box" in region:
            low, high = np.array(region["box"]["lo"]), np.array(region["box"]["hi"])
            reach = 0.25 * np.max(high - low)
            shape = {"Thickness": reach}
            for axis, lowest, highest in zip("XYZ", low - reach, high + reach):
                shape.update({axis + "Min": lowest, axis + "Max": highest})
            kind = "Box"
        else:
            continue  # a whole face
        shape.update(VIn=size / ratio, VOut=size)
        name = f"Field[{len(fields) + 1}]"
        fields.append(f"{name} = {kind};\n" + "".join(f"{name}.{key} = {value};\n" for key, value in shape.items()))
    if not fields:
        return ""
    numbers = ", ".join(str(1 + i) for i in range(len(fields)))
    return "".join(fields) + f"Field[9] = Min;\nField[9].FieldsList = {{{numbers}}};\nBackground Field = 9;\n"


def make_mesh(case, size, order, work, ratio=2):
    """gmsh's mesh of elements of about `size` (m); raises CalledProcessError where gmsh fails."""
    geometry, result = work / "body.geo", work / "body.msh"
    geometry.write_text(f'SetFactory("OpenCASCADE");\n{BODIES[case.name]}\nPhysical Volume(1) = {{1}};\n'
                        f"Mesh.CharacteristicLengthMax = {size};\nMesh.CharacteristicLengthExtendFromBoundary = 0;\n"
                        + finer_near_loads(case, size, ratio))
    subprocess.run(["gmsh", "-3", "-order", str(order), "-format", "msh2", "-v", "1", "-nt", "1",
                    "-o", str(result), str(geometry)], check=True, capture_output=True, timeout=300)
    return read_mesh(result)


def read_mesh(path):
    lines = path.read_text().splitlines()
    start = lines.index("$Nodes") + 2
    nodes = np.array([line.split()[1:] for line in lines[start:start + int(lines[start - 1])]], float)
    start = lines.index("$Elements") + 2
    rows = [line.split() for line in lines[start:start + int(lines[start - 1])]]
    elements = np.array([row[3 + int(row[2]):] for row in rows if row[1] in ("4", "11")], int) - 1
    if elements.shape[1] == 10:
        elements[:, [8, 9]] = elements[:, [9, 8]]  # gmsh has 23 before 13
    return Mesh(nodes, elements)


def shape_functions(barycentric, quadratic):
    """At #points x 3 (faces) or x 4 (elements) barycentric coordinates: #points x #nodes."""
    if not quadratic:
        return barycentric
    first, second = CORNER_PAIRS[CORNER_PAIRS.max(axis=1) < barycentric.shape[1]].T
    return np.hstack([barycentric * (2 * barycentric - 1), 4 * barycentric[:, first] * barycentric[:, second]])


def shape_slopes(barycentric, quadratic):
    """Derivatives along the edges from the last corner to the others: #points x #nodes x #(corners - 1)."""
    corners = barycentric.shape[1]
    to_edges = np.vstack([np.eye(corners - 1), -np.ones(corners - 1)])
    if not quadratic:
        return np.broadcast_to(to_edges, (len(barycentric), corners, corners - 1))
    first, second = CORNER_PAIRS[CORNER_PAIRS.max(axis=1) < corners].T
    at_corners = (4 * barycentric - 1)[:, :, None] * to_edges
    on_edges = 4 * (barycentric[:, first, None] * to_edges[second] + barycentric[:, second, None] * to_edges[first])
    return np.concatenate([at_corners, on_edges], axis=1)


def stress_at(points, mesh, nodal):
    """Nodal values (#nodes x #columns) between the nodes. Points just outside, near a curved surface, take the
    nearest place of their element."""
    corners = mesh.nodes[mesh.elements[:, :4]]
    centres = corners.mean(axis=1)
    values = []
    for point in points:
        distance = ((centres - point) ** 2).sum(axis=1)
        near = np.argpartition(distance, 48)[:48] if len(centres) > 48 else np.arange(len(centres))
        edges = (corners[near, :3] - corners[near, 3:]).transpose(0, 2, 1)
        inner = np.linalg.solve(edges, (point - corners[near, 3])[:, :, None])[:, :, 0]
        weights = np.hstack([inner, 1 - inner.sum(axis=1, keepdims=True)])
        best = weights.min(axis=1).argmax()
        inside = np.maximum(weights[best], 0)
        shape = shape_functions(inside[None] / inside.sum(), mesh.quadratic)[0]
        values.append(shape @ nodal[mesh.elements[near[best]]])
    return np.array(values)
