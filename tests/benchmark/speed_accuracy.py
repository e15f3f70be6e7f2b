"""Errors and times of `sherd stress` and of finite elements on the public stress cases.

Writes results.json and the series of the chart (plot/*.dat) into a folder, and prints a summary in markdown."""
import argparse
import json
import subprocess
import tempfile
from pathlib import Path

import calculix
import sherd_runs
import stress_case
import summary
import tetrahedra

# Case: (sizes of linear, sizes of quadratic tetrahedra in m, how much finer at loads and supports), coarse to fine.
FINITE_ELEMENTS = {
    "slab_centre": ((0.06, 0.04, 0.025, 0.017), (0.09, 0.06, 0.045), 2),
    "sphere_squeezed": ((0.2, 0.12, 0.08, 0.05), (0.4, 0.3, 0.2), 6),
    "thick_cylinder": ((0.04, 0.028, 0.02, 0.014), (0.06, 0.04, 0.028), 1),
    "cantilever": ((0.06, 0.04, 0.03, 0.02), (0.1, 0.07, 0.045), 2),
    "dish_rim": ((0.006, 0.004, 0.003, 0.0022), (0.012, 0.008, 0.005), 3),
}


def finite_element_rows(case, work, quick):
    linear, quadratic, ratio = FINITE_ELEMENTS[case.name]
    for order, sizes in ((1, linear), (2, quadratic)):
        for size in sizes[:-1] if quick else sizes:
            try:
                mesh = tetrahedra.make_mesh(case, size, order, work, ratio)
                stress, taken_ms = calculix.solve(case, mesh, work, limit_s=120, repeats=1 if quick else 3)
            except (subprocess.CalledProcessError, subprocess.TimeoutExpired) as trouble:
                print(f"  skipped: {trouble}", flush=True)
                break
            interior, surface = case.errors(stress)
            # It assembles and factors anew for every load: a further blow takes as long as the first.
            yield {"case": case.name, "form": ("tets linear", "tets quadratic")[order - 1], "spacing": size,
                   "particles": len(mesh.nodes), "error_interior": interior, "error_surface": surface,
                   "first_ms": taken_ms, "further_ms": taken_ms}


def measure_all(binary, cases, quick):
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name in cases:
            case = stress_case.Case(name)
            for source in (finite_element_rows(case, Path(folder), quick),
                           sherd_runs.rows_of(binary, case, Path(folder), quick)):
                for row in source:
                    row["place"] = len(rows)
                    rows.append(row)
                    print("{case:16s} {form:16s} {particles:6d} nodes  {error_interior:8.2%} inside  {error_surface:8.2%} "
                          "surface  first {first_ms:9.1f} ms  further {further_ms:9.1f} ms".format(**row), flush=True)
    return rows


def write_series(rows, folder):
    """A file per case and form: first and further blow (ms), error inside (percent), letter of a preset."""
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.dat"):
        old.unlink()
    forms = [*sherd_runs.FORMS, "presets", "tets linear", "tets quadratic"]
    for name in stress_case.names:
        for form in forms:
            mine = [row for row in rows if row["case"] == name
                    and (row["form"] in sherd_runs.PRESETS if form == "presets" else row["form"] == form)]
            lines = ["{} {} {} {}\n".format(row["first_ms"], row["further_ms"], 100 * row["error_interior"],
                                            row["form"][0].upper()) for row in mine]
            # A form that was not run is left out of the plot by a point that is not there.
            (folder / f"{name} {form}.dat".replace(" ", "-")).write_text("".join(lines) or "NaN NaN NaN -\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("binary", help="the command sherd")
    parser.add_argument("folder", type=Path, help="where the results go")
    parser.add_argument("cases", nargs="*", metavar="CASE", help=", ".join(stress_case.names))
    parser.add_argument("--quick", action="store_true", help="fewer and coarser runs, each once")
    arguments = parser.parse_intermixed_args()
    for name in arguments.cases:
        if name not in stress_case.names:
            parser.error(f"there is no case {name}; known are {', '.join(stress_case.names)}")
    rows = measure_all(arguments.binary, arguments.cases or stress_case.names, arguments.quick)
    arguments.folder.mkdir(parents=True, exist_ok=True)
    (arguments.folder / "results.json").write_text(json.dumps(rows, indent=1) + "\n")
    write_series(rows, arguments.folder / "plot")
    print("\n" + summary.table(rows))


if __name__ == "__main__":
    main()
