"""docs/hard-cases.md and its charts, from what build/release/bin/hard_cases found and nothing else.

usage: page.py FOUND.json PAGE.md
"""

import json
import math
import pathlib
import platform
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench"))
from harness import charts  # noqa: E402  (lies beside, not in a package)

POINTS_IN_CHART = 12

HEAD = """# Hard cases

Each row is a figure of a case that breaks simulators: what a naive form of it does, what ours does, and the bar. `./run hard-cases` runs them all, writes this page and
`build/release/hard-cases.json`, and ends with an error where a figure fails. A figure holds if ours is at most the bar and the naive form, where there is one, misses it: a case in which nothing is hard shows nothing. Some figures of a case have no naive form of their own (–). H16 to H19, friction and impacts, are runs of `gauss-sim`, with compiling in their times.
"breaks down" is NaN, overflow, or a step that cannot be taken. Times are of computing, of all that a figure measures, so that both forms compare; what runs for several figures is
shown with each. `./run hard-cases --long` takes whole durations (10^6 s), some minutes. The cases are in `hard_cases/`, one file each,
with their models in `hard_cases/models/`; each short one is a test (`./run test -R hard_cases`).
`build/release/bin/hard_cases --only H08` runs one of them and writes nothing, once this is built.

"""


def number(value):
    if value is None:
        return "–"
    if isinstance(value, str):
        return value
    # What is counted is shown whole.
    return f"{value:.0f}" if float(value).is_integer() and abs(value) < 1e6 else f"{value:.2g}"


def with_unit(value, unit):
    text = number(value)
    return text if unit == "1" or value is None or isinstance(value, str) else f"{text} {unit}"


def seconds(value):
    """Of computing time, in two digits."""
    for size, unit in ((1, "s"), (1e-3, "ms"), (1e-6, "µs")):
        if value >= size:
            return f"{float(f'{value / size:.2g}'):g} {unit}"
    return ""


def grown(series):
    """The largest so far at a few times, where a logarithm has it."""
    largest, points = 0.0, []
    for t, value in zip(series["t"], series["values"]):
        if value is None or not math.isfinite(value):
            break
        largest = max(largest, abs(value))
        if t > 0 and largest > 0:
            points.append((t, largest))
    if len(points) <= POINTS_IN_CHART:
        return points
    first, last = math.log(points[0][0]), math.log(points[-1][0])
    wanted = [first + (last - first) * i / (POINTS_IN_CHART - 1) for i in range(POINTS_IN_CHART)]
    chosen = {min(range(len(points)), key=lambda k: abs(math.log(points[k][0]) - w)) for w in wanted}
    return [points[k] for k in sorted(chosen)]


def chart_of(row):
    lines = [(series["name"], grown(series)) for series in row["charts"]]
    # Times of all lines are one grid.
    lines = [(name, points) for name, points in lines if len(points) > 1]
    return charts.lines_chart(f"{row['id']}: {row['quantity']}", "time / s", row["unit"], lines) if lines else None


def groups(rows):
    result = []
    for row in rows:
        case = row["id"].split(".")[0]
        if not result or result[-1][0] != case:
            result.append((case, row["title"], []))
        result[-1][2].append(row)
    return result


def section(case, title, rows, folder):
    lines = [f"## {case}: {title}\n", "| figure | | naive | ours | bar | | time of naive | of ours |", "|---|---|---|---|---|---|---|---|"]
    for row in rows:
        about = row["quantity"] + (f" ({row['remark']})" if row["remark"] else "")
        verdict = row["status"] if row["status"] == "holds" else f"**{row['status']}**"
        lines.append(f"| {row['id']} | {about} | {with_unit(row['naive'], row['unit'])} | {with_unit(row['ours'], row['unit'])} "
                     f"| {with_unit(row['bar'], row['unit'])} | {verdict} | {seconds(row['seconds_naive'])} | {seconds(row['seconds_ours'])} |")
    text = "\n".join(lines) + f"\n\nAll of it takes {seconds(rows[0]['seconds_case'])}.\n\n"
    for row in rows:
        chart = chart_of(row)
        if chart is None:
            continue
        name = row["id"].replace(".", "-").lower() + ".svg"
        (folder / name).write_text(chart, encoding="utf-8")
        text += f"![{row['quantity']} over time]({folder.name}/{name})\n\n"
    return text


def machine():
    model = platform.machine()
    for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            model = line.split(":", 1)[1].strip()
            break
    compiler = subprocess.run(["c++", "--version"], capture_output=True, text=True, check=True).stdout.splitlines()[0]
    return f"{model}, {compiler}, -O2"


def main():
    found, page = sys.argv[1], pathlib.Path(sys.argv[2])
    rows = json.loads(pathlib.Path(found).read_text(encoding="utf-8"))
    folder = page.with_suffix("")
    folder.mkdir(exist_ok=True)
    failing = [row["id"] for row in rows if row["status"] != "holds"]
    text = HEAD + f"The figures below: {machine()}. {len(rows) - len(failing)} of {len(rows)} hold"
    text += f"; these do not: {', '.join(failing)}.\n\n" if failing else ".\n\n"
    for case, title, of_case in groups(rows):
        text += section(case, title, of_case, folder)
    page.write_text(text.rstrip() + "\n", encoding="utf-8")


main()
