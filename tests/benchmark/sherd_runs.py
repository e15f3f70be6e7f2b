"""Runs of `sherd stress` on the public cases, in several forms and spacings."""
import json
import subprocess

import numpy as np

from stress_case import TENSOR, read_columns

PRESETS = ("preview", "game", "film")
# As blows in a world are solved: the settings of a preset, the grid as it is around the contact.
PLAIN = {"preview, no zoom": "preview", "game, no zoom": "game"}

# Name of a form: the options that make it, and its spacings as powers of sqrt(2) of the game preset's.
FORMS = {
    "spline linear": (["--basis", "linear"], (-2, -1, 0, 1, 2)),
    "spline quadratic": (["--basis", "quadratic"], (-1, 0, 1, 2)),
    "spline cubic": (["--basis", "cubic", "--rounds", "3"], (-1, 0, 1, 2)),
    "mls linear": (["--trial", "mls", "--basis", "linear"], (-1, 0, 1)),
    "mls quadratic": (["--trial", "mls", "--basis", "quadratic"], (0, 1, 2)),
    "gmls": (["--trial", "gmls", "--basis", "linear"], (0, 1, 2)),
    "mls heaviside": (["--trial", "mls", "--basis", "linear", "--test-function", "heaviside"], (-1, 0, 1)),
    "paper": (["--trial", "mls", "--basis", "linear", "--test-function", "heaviside_paper"], (-1, 0, 1)),
}


def known_forms(binary):
    """All but those that this build of the command does not list."""
    listed = subprocess.run([binary, "stress", "--help"], capture_output=True, text=True, check=True).stdout
    return [form for form in FORMS if form != "paper" or "heaviside_paper" in listed]


def write_points(case, path):
    np.savetxt(path, case.points, delimiter=",", header="x,y,z", comments="", fmt="%.12g")


def run(binary, case_file, options, work, limit_s):
    """The report of one run; its stresses are in work/stress.csv. None where it fails or takes too long."""
    report = work / "report.json"
    command = [binary, "stress", case_file, "--out", work / "stress.csv", "--report", report, *options]
    try:
        subprocess.run(command, check=True, capture_output=True, timeout=limit_s)
    except (subprocess.CalledProcessError, subprocess.TimeoutExpired) as trouble:
        sentence = getattr(trouble, "stderr", None) or b"took too long"
        print("  skipped:", sentence.decode().strip().splitlines()[-1], flush=True)
        return None
    return json.loads(report.read_text())


def times_of(report):
    """(first blow, further blow) in ms."""
    ms = report["ms"]
    further = ms["solve"] + ms["recovery"]
    return ms["sample"] + ms["assemble"] + ms["factor"] + further, further


def measure(binary, case, form, options, work, limit_s=60, repeats=3):
    """One row of the results; the smallest of the times, as those of quick runs vary."""
    report = run(binary, case.file, ["--points", work / "points.csv", *options], work, limit_s)
    if not report:
        return None
    times = [times_of(report)]
    while len(times) < repeats and sum(first for first, _ in times) < 3000:
        again = run(binary, case.file, ["--points", work / "points.csv", *options], work, limit_s)
        if not again:
            break
        times.append(times_of(again))
    interior, surface = case.errors(read_columns(work / "stress.csv", TENSOR))
    return {"case": case.name, "form": form, "spacing": report["spacing_m"], "particles": report["particles"],
            "error_interior": interior, "error_surface": surface,
            "first_ms": min(first for first, _ in times), "further_ms": min(further for _, further in times),
            "factor_entries": report["factor_entries"], "resampling_entries": report["resampling_entries"]}


def rows_of(binary, case, work, quick):
    """Presets and forms; the larger a run, the later, so that a form ends with the first that takes too long."""
    write_points(case, work / "points.csv")
    game = None
    for preset in PRESETS:
        row = measure(binary, case, preset, ["--quality", preset], work, limit_s=180, repeats=1 if quick else 3)
        if row:
            game = row["spacing"] if preset == "game" else game
            yield row
    for form, preset in PLAIN.items():
        row = measure(binary, case, form, ["--quality", preset, "--rounds", "0"], work, repeats=1 if quick else 3)
        if row:
            yield row
    for form in known_forms(binary):
        options, powers = FORMS[form]
        for power in sorted(powers[-2:] if quick else powers, reverse=True):
            spacing = ["--spacing", repr(game * 2 ** (power / 2))]
            row = measure(binary, case, form, options + spacing, work, limit_s=10 if quick else 60,
                          repeats=1 if quick else 3)
            if not row:
                break
            yield row
