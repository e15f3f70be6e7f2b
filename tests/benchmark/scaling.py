"""How times and memory of `sherd stress` grow with the number of particles, in the slab.

Writes scaling.json and the series of the chart (plot/scaling-*.dat) into a folder, and prints a table in markdown."""
import argparse
import json
import tempfile
from pathlib import Path

import sherd_runs
import stress_case

COUNTS = (1000, 3000, 10000, 30000)
BASES = ("linear", "quadratic")


def measure(binary, case, basis, count, work, repeats):
    """Smallest times (ms) of a few runs; without refinement around the load, so that all solve one system."""
    options = ["--points", work / "points.csv", "--rounds", "0", "--basis", basis, "--particles", str(count)]
    reports = []
    while len(reports) < repeats and sum(sherd_runs.times_of(report)[0] for report in reports) < 15000:
        report = sherd_runs.run(binary, case.file, options, work, limit_s=240)
        if not report:
            return None
        reports.append(report)
    row = {"basis": basis, "particles": report["particles"], "unknowns": report["unknowns"],
           "factor_entries": report["factor_entries"], "factor_bytes": report["factor_bytes"]}
    for step in ("sample", "assemble", "factor", "solve"):
        row[step + "_ms"] = min(report["ms"][step] for report in reports)
    row["assemble_us_a_particle"] = 1000 * row["assemble_ms"] / row["particles"]
    return row


def table(rows):
    lines = ["| splines | particles | sample | assemble | assemble / particle | factor | solve | factor's memory |",
             "|---|---|---|---|---|---|---|---|"]
    for row in rows:
        lines.append("| {basis} | {particles} | {sample_ms:.0f} ms | {assemble_ms:.0f} ms | {assemble_us_a_particle:.1f} us | "
                     "{factor_ms:.0f} ms | {solve_ms:.0f} ms | {megabytes:.0f} MB |".format(
                         megabytes=row["factor_bytes"] / 1e6, **row))
    for basis in BASES:
        each = [row["assemble_us_a_particle"] for row in rows if row["basis"] == basis]
        if each:
            lines.append(f"\nAssembly per particle, {basis}: largest / smallest = {max(each) / min(each):.2f}")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("binary", help="the command sherd")
    parser.add_argument("folder", type=Path, help="where the results go")
    parser.add_argument("--quick", action="store_true", help="without the largest, each once")
    arguments = parser.parse_args()
    case = stress_case.Case("slab_centre")
    rows = []
    with tempfile.TemporaryDirectory() as work:
        (Path(work) / "points.csv").write_text("x,y,z\n0.2,0.1,0\n")
        for basis in BASES:
            for count in COUNTS[:-1] if arguments.quick else COUNTS:
                row = measure(arguments.binary, case, basis, count, Path(work), 1 if arguments.quick else 5)
                if not row:
                    break
                rows.append(row)
    (arguments.folder / "plot").mkdir(parents=True, exist_ok=True)
    (arguments.folder / "scaling.json").write_text(json.dumps(rows, indent=1) + "\n")
    for basis in BASES:
        lines = ["{particles} {sample_ms} {assemble_ms} {factor_ms} {solve_ms} {factor_bytes}\n".format(**row)
                 for row in rows if row["basis"] == basis]
        (arguments.folder / "plot" / f"scaling-{basis}.dat").write_text("".join(lines))
    print("\n" + table(rows))


if __name__ == "__main__":
    main()
