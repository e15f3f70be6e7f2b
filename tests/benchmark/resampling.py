"""Particles of a section through the squeezed sphere, with and without resampling, and their stress: data for
resampling.gp."""
import argparse
from pathlib import Path

import numpy as np

import sherd_runs
import stress_case

ROUNDS = (0, 1, 2)


def section(spacing, extent):
    """Middles of the cells in the plane y = 0 of a grid that halves `extent` evenly."""
    count = max(1, round(2 * extent / spacing))
    middles = (np.arange(count) + 0.5) * (2 * extent / count) - extent
    x, z = np.meshgrid(middles, middles)
    points = np.column_stack([x.ravel(), np.zeros(x.size), z.ravel()])
    return points[np.linalg.norm(points, axis=1) < extent]


def particles(binary, case, rounds, spacing, extent, work):
    """x, z, spacing, largest compressive stress (Pa) of the particles: at each place those of the finest grid there."""
    found, refined = [], None  # cells of the level before that hold finer particles
    for level in range(rounds + 1):
        points = section(spacing / 2**level, extent)
        np.savetxt(work / "points.csv", points, delimiter=",", header="x,y,z", comments="")
        sherd_runs.run(binary, case.file, ["--points", work / "points.csv", "--rounds", str(rounds), "--spacing", repr(spacing)], work, 120)
        columns = stress_case.read_columns(work / "stress.csv", ("x", "z", "spacing_m", *stress_case.TENSOR))
        cells = {tuple(cell) for cell in np.floor((columns[columns[:, 2] * 2**level < 0.7 * spacing, :2] + extent)
                                                  / spacing * 2**level).astype(int)}
        is_here = columns[:, 2] * 2**level > 0.7 * spacing
        if refined is not None:
            parents = np.floor((columns[:, :2] + extent) / spacing * 2**(level - 1)).astype(int)
            is_here &= [tuple(parent) in refined for parent in parents]
        refined, here = cells, columns[is_here]
        xx, yy, zz, xy, yz, zx = here[:, 3:].T
        tensors = np.stack([xx, xy, zx, xy, yy, yz, zx, yz, zz], axis=1).reshape(-1, 3, 3)
        found.append(np.column_stack([here[:, :3], -np.linalg.eigvalsh(tensors)[:, 0]]))
    return np.vstack(found)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("binary", help="the command sherd")
    parser.add_argument("folder", type=Path, help="where the data goes")
    arguments = parser.parse_args()
    folder = arguments.folder / "plot"
    folder.mkdir(parents=True, exist_ok=True)
    case = stress_case.Case("sphere_squeezed")
    extent = float(np.abs(case.points).max())
    spacing = 2 * extent / 10
    for rounds in ROUNDS:
        np.savetxt(folder / f"resampling-{rounds}.dat",
                   particles(arguments.binary, case, rounds, spacing, extent, arguments.folder))


if __name__ == "__main__":
    main()
