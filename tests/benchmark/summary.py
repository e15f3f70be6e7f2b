"""The results as a table: what the presets reach, and what finite elements take for the same error."""
import numpy as np

from sherd_runs import PLAIN, PRESETS


def time_at(error, rows):
    """Time (ms) at which rows of finer and finer meshes reach an error, on straight lines between their logarithms;
    whether that lies beyond them. Beyond them a line fitted to all goes on."""
    rows = sorted(rows, key=lambda row: row["first_ms"])
    times = np.log([row["first_ms"] for row in rows])
    errors = np.minimum.accumulate(np.log([row["error_interior"] for row in rows]))
    wanted = np.log(error)
    if errors[-1] <= wanted <= errors[0]:
        return float(np.exp(np.interp(-wanted, -errors, times))), False
    slope, offset = np.polyfit(times, errors, 1)
    return float(np.exp((wanted - offset) / slope)), True


def duration(ms):
    if ms < 1000:
        return f"{ms:.0f} ms"
    return f"{ms / 1000:.1f} s" if ms < 1e5 else f"{ms / 1000:.0f} s"


def ratio(value):
    return f"{value:.1f}" if value < 10 else f"{value:.0f}"


def comparison(row, tets):
    """Time of finite elements at the row's error, and how much longer that is than its first and further blow."""
    if len(tets) < 2:
        return "-"
    tets_ms, beyond = time_at(row["error_interior"], tets)
    longest_ms = max(other["first_ms"] for other in tets)
    mark = "~" if beyond else ""
    if tets_ms > 30 * longest_ms:
        tets_ms, mark = longest_ms, ">"
    return f"{mark}{duration(tets_ms)} ({mark}{ratio(tets_ms / row['first_ms'])}, {mark}{ratio(tets_ms / row['further_ms'])})"


def table(rows):
    lines = ["| case | preset | error inside | on the surface | first blow | further blow | linear tets | quadratic tets |",
             "|---|---|---|---|---|---|---|---|"]
    for row in rows:
        if row["form"] not in (*PRESETS, *PLAIN):
            continue
        tets = [comparison(row, [other for other in rows if (other["case"], other["form"]) == (row["case"], form)])
                for form in ("tets linear", "tets quadratic")]
        lines.append(f"| {row['case']} | {row['form']} | {row['error_interior']:.1%} | {row['error_surface']:.1%} | "
                     f"{duration(row['first_ms'])} | {duration(row['further_ms'])} | {' | '.join(tets)} |")
    return "\n".join(lines) + """

Tets: time of finite elements at the same error inside (times that of a first blow, of a further blow); ~ extrapolated
beyond the meshes that were run; > longer than the finest mesh that was run, and by too much to extrapolate."""
