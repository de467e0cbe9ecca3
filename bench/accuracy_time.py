#!/usr/bin/env python3
"""Time to a delivered error, gauss-sim beside MuJoCo: the double pendulum to 1e-6 rad, the ball in the cylinder to 1e-9 in every output, 10 s each.

    ninja -C build/release gauss-gen gauss-sim bench_sampling
    bench/accuracy_time.py [--bin build/release/bin] [--rounds 31] [--write]

Of each method the cheapest setting counts that delivers the error. References are gauss-sim's own in float128, whose two runs (order 36 and another tolerance) agree
to more digits than are shown. Of the pendulum, errors are those of both angles in rad; of the ball, of all columns relative to what they range over. Times are processor time of the
integration with all its samples, the least of the rounds, with nothing written; MuJoCo's RK4 (libmujoco-dev) has all off that a chain does not need. With --write also
bench/results/accuracy_time.json, from which `./run bench --report` writes docs/performance.md.
"""

import argparse
import csv
import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench"))

from harness import simulation  # noqa: E402

PENDULUM = ROOT / "models/double_pendulum.yaml"
BALLS = {"quaternion": ROOT / "models/sphere_in_cylinder_quaternion.yaml", "Euler angles": ROOT / "models/sphere_in_cylinder.yaml",
         "Euler angles, reduced": ROOT / "bench/models/sphere_in_cylinder_reduced.yaml"}
END = 10
METHODS = ("taylor", "prince87", "fehlberg78", "dopri5")


class Bench:
    def __init__(self, binaries, folder, rounds):
        self.binaries, self.folder, self.rounds = binaries, folder, rounds
        self.environment = dict(os.environ, XDG_CACHE_HOME=str(folder))
        self.when_counting = dict(self.environment, CXX=simulation.counting_compiler(folder))

    def table(self, model, outputs, samples, *more):
        out = self.folder / "table.csv"
        words = [self.binaries / "gauss-sim", "run", model, "--outputs", outputs, "--samples", samples, "--duration", END, "-q", "-o", out, *more]
        subprocess.run(list(map(str, words)), env=self.environment, check=True, stderr=subprocess.DEVNULL)
        with open(out, encoding="utf-8", newline="") as file:
            rows = list(csv.reader(file))
        return [[float(value) for value in row[1:]] for row in rows[1:]]

    def reference(self, model, outputs, samples):
        return self.table(model, outputs, samples, "--method", "taylor", "--number", "float128", "--tolerance", "1e-26")

    def seconds(self, model, outputs, method, setting, samples, rounds=None):
        words = [self.binaries / "bench_sampling", model, outputs, method, setting, END, ",".join(map(str, samples)), rounds or self.rounds]
        done = subprocess.run(list(map(str, words)), env=self.environment, check=True, capture_output=True, text=True)
        return json.loads(done.stdout)


    def instructions(self, model, outputs, setting, samples):
        """Of the integration with its samples, for processors with AVX2, by callgrind."""
        if not shutil.which("valgrind"):
            return None
        out = self.folder / "callgrind.out"
        tool = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", "--toggle-collect=*Run::counted*"]
        words = [*tool, self.binaries / "bench_sampling", model, outputs, "taylor", setting, END, samples, "once"]
        subprocess.run(list(map(str, words)), env=self.when_counting, check=True, capture_output=True)
        return int(re.search(r"^(?:summary|totals): (\d+)", out.read_text(), re.MULTILINE).group(1))


def absolute(rows, reference):
    return max(abs(a - b) for row, exact in zip(rows, reference) for a, b in zip(row, exact))


def relative(rows, reference):
    """To what each column ranges over; to its size, where it does not change."""
    worst = 0
    for column, exact in zip(zip(*rows), zip(*reference)):
        extent, size = max(exact) - min(exact), max(map(abs, exact))
        scale = extent if extent > 1e-6 * size else size
        error = max(abs(a - b) for a, b in zip(column, exact))
        # What is zero in the exact motion, as slip, has no scale of its own.
        worst = max(worst, error / scale if scale > 1e-12 else error)
    return worst


def tolerances():
    return [f"{mantissa}e-{power}" for power in range(6, 15) for mantissa in ("5", "2", "1")]


def cheapest(bench, model, outputs, method, error_of, goal, samples):
    """Tolerances from loose to tight; errors do not go down with each, so some more are looked at after the first that delivers."""
    best, looked = None, 0
    for tolerance in tolerances():
        error = error_of(bench.table(model, outputs, samples, "--method", method, "--tolerance", tolerance))
        if error > goal:
            continue
        found = bench.seconds(model, outputs, method, tolerance, [samples])
        row = {"method": method, "tolerance": float(tolerance), "error": error, "seconds": found["seconds"][0], "steps": found["steps"],
               "calls": found["calls"], "columns": found["columns"]}
        best = row if best is None or row["seconds"] < best["seconds"] else best
        looked += 1
        if looked == 3:
            break
    return best


def by_mujoco(bench, reference, samples, goal):
    program = bench.folder / "mujoco_pendulum"
    built = subprocess.run(["g++", "-std=c++17", "-O3", "-march=native", ROOT / "bench/drivers/mujoco_pendulum.cpp", "-o", program, "-lmujoco"],
                           capture_output=True, check=False)
    if built.returncode != 0:
        return {"skipped": "MuJoCo (libmujoco-dev) is not installed"}
    tried = []
    for between in (10, 15, 18, 20, 22, 24, 26, 28, 30, 35, 40, 50, 60, 70, 80, 90, 100, 120, 140, 160, 200, 300):
        words = [program, END, samples, between, 1]
        rounds = 1
        for rounds in (1, max(3, bench.rounds // 3)):
            words[-1] = rounds
            lines = subprocess.run(list(map(str, words)), check=True, capture_output=True, text=True).stdout.split("\n")
            rows = [[float(value) for value in line.split()[1:]] for line in lines[1:] if line]
            error = absolute(rows, reference)
            if error > goal:
                break
        tried.append({"step": END / (samples - 1) / between, "error": error, "seconds": float(lines[0])})
        if error <= goal:
            return {"delivers": tried[-1], "tried": tried}
    return {"delivers": None, "tried": tried}


def pendulum(bench, samples=501, goal=1e-6):
    outputs = "pivot,elbow"
    reference = bench.reference(PENDULUM, outputs, samples)
    result = {"goal": goal, "samples": samples, "mujoco": by_mujoco(bench, reference, samples, goal), "gauss": {}}
    for method in METHODS:
        result["gauss"][method] = cheapest(bench, PENDULUM, outputs, method, lambda rows: absolute(rows, reference), goal, samples)
    found = [row for row in result["gauss"].values() if row]
    result["best"] = min(found, key=lambda row: row["seconds"])
    result["mujoco_to_best"] = in_turns(bench, result["best"], result["mujoco"].get("delivers"), outputs, samples)
    return result


def in_turns(bench, ours, theirs, outputs, samples):
    """The median of ratios of times that are taken one right after the other."""
    if not theirs:
        return None
    between = round(END / (samples - 1) / theirs["step"])
    words = list(map(str, [bench.folder / "mujoco_pendulum", END, samples, between, 3]))
    ratios = []
    for _ in range(15):
        first_line = subprocess.run(words, check=True, capture_output=True, text=True).stdout.split("\n")[0]
        found = bench.seconds(PENDULUM, outputs, ours["method"], ours["tolerance"], [samples], 31)
        ratios.append(float(first_line) / found["seconds"][0])
        theirs["seconds"], ours["seconds"] = min(theirs["seconds"], float(first_line)), min(ours["seconds"], found["seconds"][0])
    return statistics.median(ratios)


def ball(bench, samples=501, goal=1e-9):
    result = {"goal": goal, "samples": samples, "outputs": "state,reactions", "forms": {}}
    for form, model in BALLS.items():
        reference = bench.reference(model, result["outputs"], samples)
        best = cheapest(bench, model, result["outputs"], "taylor", lambda rows: relative(rows, reference), goal, samples)
        if best:
            numbers = [2, 51, samples, 5001]
            found = bench.seconds(model, result["outputs"], "taylor", best["tolerance"], numbers)
            best["seconds_by_samples"] = dict(zip(map(str, numbers), found["seconds"]))
            best["ns_per_sample"] = 1e9 * (found["seconds"][-1] - found["seconds"][0]) / (numbers[-1] - numbers[0])
            best["seconds"] = min(best["seconds"], found["seconds"][2])
            counts = [bench.instructions(model, result["outputs"], best["tolerance"], count) for count in (2, samples)]
            if counts[0]:
                best["instructions"], best["instructions_per_sample"] = counts[1], (counts[1] - counts[0]) / (samples - 2)
        result["forms"][form] = best
    return result


def sampling(bench):
    """All reactions of the ball, interpolation included, without other columns."""
    numbers, rows = [2, 20002], {}
    for form, model in BALLS.items():
        found = bench.seconds(model, "reactions", "taylor", 1e-9, numbers)
        rows[form] = {"columns": found["columns"], "ns_per_sample": 1e9 * (found["seconds"][1] - found["seconds"][0]) / (numbers[1] - numbers[0])}
        counts = [bench.instructions(model, "reactions", 1e-9, count) for count in numbers]
        if counts[0]:
            rows[form]["instructions_per_sample"] = (counts[1] - counts[0]) / (numbers[1] - numbers[0])
    return rows


def tell(results):
    of = results["double_pendulum"]
    best, theirs = of["best"], of["mujoco"].get("delivers")
    print(f"double pendulum, {of['goal']:g} rad: {best['method']} {1e3 * best['seconds']:.3f} ms (tolerance {best['tolerance']:g}, error {best['error']:.2g})")
    for method, row in of["gauss"].items():
        print(f"    {method:11}", f"{1e3 * row['seconds']:.3f} ms, {row['steps']} steps, error {row['error']:.2g}" if row else "-")
    if theirs:
        print(f"    MuJoCo RK4  {1e3 * theirs['seconds']:.1f} ms (step {theirs['step']:.3g}, error {theirs['error']:.2g}): {of['mujoco_to_best']:.0f} times as long")
    print(f"ball, {results['ball']['goal']:g} in {results['ball']['outputs']}, {results['ball']['samples']} samples:")
    for form, row in results["ball"]["forms"].items():
        print(f"    {form:22}", f"{1e3 * row['seconds']:.3f} ms, {row['steps']} steps, tolerance {row['tolerance']:g}, {row['columns']} columns, "
              f"{row['ns_per_sample']:.0f} ns a sample, {1e3 * row['seconds_by_samples']['2']:.3f} ms with two" if row else "not delivered")
    for form, row in results["sampling_reactions"].items():
        print(f"    reactions alone, {form:22} {row['ns_per_sample']:.0f} ns a sample of {row['columns']} columns, {row.get('instructions_per_sample', 0):.0f} instructions")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", default=ROOT / "build/release/bin", type=pathlib.Path)
    parser.add_argument("--rounds", default=31, type=int)
    parser.add_argument("--write", action="store_true", help="write bench/results/accuracy_time.json")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        bench = Bench(arguments.bin, pathlib.Path(name), arguments.rounds)
        results = {"double_pendulum": pendulum(bench), "ball": ball(bench), "sampling_reactions": sampling(bench)}
    tell(results)
    if arguments.write:
        simulation.write(simulation.ACCURACY, results)


if __name__ == "__main__":
    main()
