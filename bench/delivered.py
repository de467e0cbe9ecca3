"""What `gauss-sim run --error` delivers, and what it costs beside the best of a study, on all shipped models.

    bench/delivered.py [--gauss-sim build/release/bin/gauss-sim] [--models NAME...] [--budget S] [--write]

For each model and each error from 1e-3 to 1e-10: the error of the table against a run that the search has not seen (power series in float128, tolerance
1e-24; extrapolation where a model has none), relative to the range of each column; and the time of the run over that of the
cheapest point of a study that delivers the error: both of the integration with its samples in memory, since writing them costs the same for each setting. With --write the rows
go to bench/results/delivered.json, from which `./run bench --report` writes docs/performance.md; with --models, those of other models stay.
"""

import argparse
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench"))
from harness import simulation  # noqa: E402
ERRORS = [10.0 ** -k for k in range(3, 11)]
# Seconds of motions that end: the skater falls into a place where his blade is upright, and the wagon of functions.yaml sticks, held by a friction that jumps. The arm, whose
# motors nobody controls, turns over and over: each second of its motion takes about nine more digits, and ten seconds more than float128 has.
ENDS = {"functions": 2, "skater_quaternion": 0.4, "robot_arm": 1}
CONSTANT = 1e-12  # what changes by less than this part of its size, or of the range of its unit, has no range along a reference in float128


def table(path):
    with open(path, encoding="utf-8", newline="") as file:
        head, *rows = list(csv.reader(file))
    return head, [[float(cell) for cell in row] for row in rows]


def scales(head, rows):
    columns = list(zip(*rows))
    ranges = [max(c) - min(c) for c in columns]
    sizes = [max(map(abs, c)) for c in columns]
    units = [name[name.rfind("["):] if "[" in name else "" for name in head]
    by_unit = {}
    for unit, extent in zip(units[1:], ranges[1:]):
        by_unit[unit] = max(by_unit.get(unit, 0), extent)
    result = []
    for extent, size, unit in zip(ranges, sizes, units):
        whole = max(size, by_unit.get(unit, 0))
        result.append((extent if extent > CONSTANT * whole else whole) or 1)
    return result


def error_of(mine, reference):
    head, rows = reference
    worst = 0
    for i, scale in list(enumerate(scales(head, rows)))[1:]:
        for a, b in zip(mine[1], rows):
            miss = abs(a[i] - b[i])
            if miss > 0:
                worst = max(worst, miss / scale if scale > 0 else math.inf)
    return worst


class Model:
    def __init__(self, program, path, folder, budget):
        self.program, self.path, self.folder, self.budget = program, path, folder, budget
        self.file = path
        if path.stem in ENDS:
            self.file = folder / "scene.yaml"
            self.file.write_text(f"gauss: 1\nscene: {path.stem}\nmodel: {path}\nduration: {ENDS[path.stem]}\n", encoding="utf-8")

    def run(self, name, *options):
        done = subprocess.run([self.program, "run", self.file, "-q", "-o", self.folder / f"{name}.csv", *map(str, options)],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            return None, done.stderr.strip().splitlines()[-1] if done.stderr.strip() else str(done.returncode)
        return table(self.folder / f"{name}.csv"), json.loads((self.folder / f"{name}.json").read_text(encoding="utf-8"))

    def reference(self):
        for options in (("--method", "taylor", "--number", "float128", "--tolerance", "1e-24"),
                        ("--method", "bulirsch_stoer", "--number", "float128", "--tolerance", "1e-22"),
                        ("--method", "prince87", "--number", "long-double", "--tolerance", "1e-16")):
            found, _ = self.run("reference", *options)
            if found:
                return found
        return None

    def best_times(self):
        subprocess.run([self.program, "study", self.file, "-q", "--budget", str(self.budget), "-o", self.folder / "study"], capture_output=True, check=False)
        file = self.folder / "study.json"
        problem = json.loads(file.read_text(encoding="utf-8"))["problems"][0] if file.exists() else {"points": []}
        points = [p for p in problem["points"] if p["status"] == "ok" and p["error"] is not None]
        return {error: min((p["time_s"] for p in points if p["error"] <= error), default=None) for error in ERRORS}

    def rows(self):
        reference, best = self.reference(), self.best_times()
        for error in ERRORS:
            found, said = self.run("run", "--error", error)
            row = {"model": self.path.stem, "asked": error, "best_s": best[error]}
            if found is None:
                yield {**row, "why": said}
                continue
            delivered = error_of(found, reference) if reference else None
            seconds = said["asked_for"]["seconds"]
            yield {**row, "delivered": delivered, "said": said["error_estimate"]["relative"], "seconds": seconds, "method": said["method"],
                   "number": said["number"], "tolerance": said.get("tolerance"), "ratio": seconds / best[error] if best[error] else None}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--gauss-sim", default=ROOT / "build/release/bin/gauss-sim", type=pathlib.Path)
    parser.add_argument("--models", nargs="*")
    parser.add_argument("--budget", type=float, default=10)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    paths = sorted((ROOT / "models").glob("*.yaml"))
    paths = [path for path in paths if not options.models or path.stem in options.models]
    rows = []
    for path in paths:
        with tempfile.TemporaryDirectory() as folder:
            for row in Model(options.gauss_sim.resolve(), path, pathlib.Path(folder), options.budget).rows():
                rows.append(row)
                late = "" if row.get("delivered") is None or row["delivered"] <= row["asked"] else "  NOT DELIVERED"
                ratio = f"{row['ratio']:.2f}" if row.get("ratio") else "-"
                print(f"{row['model']:32} {row['asked']:.0e}  " + (f"{row['delivered'] or 0:.1e}  {1e3 * row['seconds']:9.3f} ms  {ratio:>6}  "
                      f"{row['method']} {row['number']}{late}" if "seconds" in row else row["why"]), flush=True)
    if options.write:
        others = json.loads(simulation.DELIVERED.read_text(encoding="utf-8"))["rows"] if options.models else []
        measured = {path.stem for path in paths}
        rows = sorted([*rows, *(row for row in others if row["model"] not in measured)], key=lambda row: (row["model"], -row["asked"]))
        simulation.write(simulation.DELIVERED, {"budget": options.budget, "ends": ENDS, "rows": rows})


if __name__ == "__main__":
    main()
