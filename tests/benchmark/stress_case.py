"""The public stress cases: their points, reference stresses and the error of computed ones."""
import json
from pathlib import Path

import numpy as np

folder = Path(__file__).resolve().parents[1] / "data" / "cases"
names = ("slab_centre", "sphere_squeezed", "thick_cylinder", "cantilever", "dish_rim")

TENSOR = ("s_xx", "s_yy", "s_zz", "s_xy", "s_yz", "s_zx")
SHEAR_COUNTS_TWICE = np.array([1, 1, 1, 2, 2, 2])


def read_columns(path, columns):
    """Rows of a CSV file, #rows x #columns, in the order asked for."""
    with open(path) as lines:
        header = [name.strip() for name in next(lines).split(",")]
        return np.loadtxt(lines, delimiter=",", usecols=[header.index(name) for name in columns], ndmin=2)


class Case:
    """A body under a load, and what its stress should be inside and on its surface."""

    def __init__(self, name):
        self.name = name
        self.file = folder / name / "case.json"
        self.data = json.loads(self.file.read_text())
        tables = [folder / name / file for file in ("reference.csv", "reference_surface.csv")]
        self.points = np.vstack([read_columns(table, "xyz") for table in tables])
        self.stress = np.vstack([read_columns(table, TENSOR) for table in tables])
        self.far = np.concatenate([read_columns(table, ["far"])[:, 0] > 0 for table in tables])
        self.inside = np.arange(len(self.points)) < len(read_columns(tables[0], ["far"]))

    def errors(self, stress):
        """Relative L2 error at the far points (inside, on the surface) of stresses at `points` (#points x 6)."""
        # Squeezed from two sides, a sphere has next to no tension: its whole stress is compared.
        compared = scaled_tensor if self.name == "sphere_squeezed" else largest_principal
        return tuple(relative_l2(compared(stress[chosen]), compared(self.stress[chosen]))
                     for chosen in (self.far & self.inside, self.far & ~self.inside))


def relative_l2(found, reference):
    return float(np.linalg.norm(found - reference) / np.linalg.norm(reference))


def scaled_tensor(stress):
    """So that a plain norm over the six columns is that of the tensors."""
    return stress * np.sqrt(SHEAR_COUNTS_TWICE)


def largest_principal(stress):
    xx, yy, zz, xy, yz, zx = stress.T
    tensors = np.stack([xx, xy, zx, xy, yy, yz, zx, yz, zz], axis=1).reshape(-1, 3, 3)
    return np.linalg.eigvalsh(tensors)[:, 2]
