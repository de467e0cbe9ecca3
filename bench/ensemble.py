"""Ensembles on one machine: threads and SIMD lanes against one trajectory after the other on one thread.

    bench/ensemble.py [--gauss-sim build/release/bin/gauss-sim] [--for x86-64-v3 native] [--trajectories N] [--repeats N] [--write]

Of each model, initial speeds are drawn, so that trajectories take other steps. Each way is run `repeats` times, in turns, and the fastest run counts: time between
the first trajectory and the last, without generation and compilation. All ways are compiled for the same processors (-march): x86-64-v3 has AVX2, which
is 4 lanes of double. One trajectory at a time is run in two ways: as gauss-sim compiles it, with the sums of each series in vector registers, and "scalar",
where the compiler is told to make no vectors. Prints trajectories per second and ratios to one thread without lanes, as gauss-sim compiles it, and with
--write also bench/results/ensemble.json, from which `./run bench --report` writes docs/performance.md.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench"))
from harness import simulation  # noqa: E402

# Behind the options of gauss-sim, so that these count.
NO_VECTORS = "-fno-tree-vectorize", "-fno-tree-slp-vectorize"

# Model, what is drawn, duration.
PROBLEMS = [
    ("sphere_in_cylinder", "chi_dot: {uniform: [3.8, 4.2]}", 2),
    ("sphere_in_cylinder_quaternion", "chi_dot: {uniform: [3.8, 4.2]}", 5),
    ("double_pendulum", "elbow_dot: {uniform: [-0.1, 0.1]}", 5),
    ("lagrange_top_euler", "phi_dot: {uniform: [30, 40]}", 5),
    ("rolling_disc", "phi_dot: {uniform: [4, 6]}", 5),
    ("kepler", "x_dot: {uniform: [-0.01, 0.01]}", 20),
    ("pendulum_cartesian", "x_dot: {uniform: [-0.1, 0.1]}", 20),
    ("four_bar", "alpha_dot: {uniform: [7.8, 8.2]}", 1),
]


def scene(model, drawn, duration, trajectories, tolerance):
    return (f"gauss: 1\nscene: {model}\nmodel: {json.dumps(str(ROOT / 'models' / (model + '.yaml')))}\nduration: {duration}\ntolerance: {tolerance}\n"
            f"ensemble:\n  trajectories: {trajectories}\n  initial: {{{drawn}}}\n")


def run(gauss_sim, folder, file, threads, lanes, compiler):
    command = [gauss_sim, "ensemble", file, "--threads", str(threads), "--lanes", lanes, "-q", "-o", "table.csv"]
    subprocess.run(command, cwd=folder, check=True, capture_output=True, env={**os.environ, "CXX": compiler})
    return json.loads((folder / "table.json").read_text())


def measured(gauss_sim, folder, problem, options, threads, compiler, scalar_compiler):
    model, drawn, duration = problem
    path = folder / f"{model}.yaml"
    path.write_text(scene(model, drawn, duration, options.trajectories, options.tolerance))
    ways = [(1, "1", compiler), (1, "auto", compiler), (threads, "1", compiler), (threads, "auto", compiler), (1, "1", scalar_compiler)]
    best = {}
    for _ in range(options.repeats):
        for way in ways:
            summary = run(gauss_sim, folder, path, *way)
            if way not in best or summary["seconds"]["run"] < best[way]["seconds"]["run"]:
                best[way] = summary
    first = best[ways[0]]
    rows = []
    for way in ways:
        summary = best[way]
        rows.append({"lanes": summary["lanes"], "threads": way[0], "is_scalar": way[2] == scalar_compiler, "trajectories": summary["trajectories"],
                     "trajectories_per_s": round(summary["trajectories_per_s"], 1), "steps_per_s": round(summary["steps_per_s"]),
                     "left_lanes": summary.get("left_lanes", 0), "by_status": summary["by_status"], "cpu_s": summary["seconds"]["run_cpu"],
                     "ratio": round(summary["trajectories_per_s"] / first["trajectories_per_s"], 2)})
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--gauss-sim", default=ROOT / "build/release/bin/gauss-sim", type=pathlib.Path)
    parser.add_argument("--for", dest="processors", nargs="+", default=["x86-64-v3", "native"], help="what code is compiled for (-march)")
    parser.add_argument("--trajectories", type=int, default=2048)
    parser.add_argument("--tolerance", default="1e-9")
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--write", action="store_true", help="write bench/results/ensemble.json")
    options = parser.parse_args()
    threads = os.cpu_count()
    results = {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for processor in options.processors:
            compilers = simulation.compiler_for(folder, processor), simulation.compiler_for(folder, processor, *NO_VECTORS)
            for problem in PROBLEMS:
                rows = measured(options.gauss_sim.resolve(), folder, problem, options, threads, *compilers)
                results.setdefault(processor, {})[problem[0]] = {"drawn": problem[1], "duration": problem[2], "rows": rows}
                print(processor, problem[0])
                for row in rows:
                    scalar = ", scalar" if row["is_scalar"] else ""
                    print(f"  {row['lanes']} lanes, {row['threads']} threads{scalar}: {row['trajectories_per_s']:12.1f}/s  ratio {row['ratio']:5.2f}  "
                          f"left {row['left_lanes']}", flush=True)
    if options.write:
        simulation.write(simulation.ENSEMBLE, {"tolerance": float(options.tolerance), "repeats": options.repeats, "processors": results})


if __name__ == "__main__":
    main()
