#!/usr/bin/env python3
"""What contacts cost that are called for and never act, beside MuJoCo with a floor that is never reached.

    ninja -C build/release gauss-sim
    bench/effects.py [--bin build/release/bin] [--rounds 15] [--write]

A chain of ten bars with elastic hinges for 60 s by prince87 (compiled), with and without ten contacts 100 m below, in turns; both take the same steps, which is
asserted. MuJoCo (libmujoco-dev) takes 20 000 steps of its RK4 with and without a floor, in the same run. With --write also bench/results/effects.json.
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

MODEL = ROOT / "bench/models/chain_over_floor.yaml"
TARGET = 1.10


def ours(program, folder, effects):
    table = folder / f"{effects}.csv"
    words = [program, "run", MODEL, f"--effects={effects}", "--method", "prince87", "--duration", "60", "--samples", "61", "--outputs", "state",
             "-q", "-o", table]
    subprocess.run(list(map(str, words)), env=dict(os.environ, XDG_CACHE_HOME=str(folder)), check=True, capture_output=True)
    return json.loads(table.with_suffix(".json").read_text(encoding="utf-8"))


def by_gauss(program, folder, rounds):
    found = {"none": [], "all": []}
    for _ in range(rounds):
        for effects, runs in found.items():
            runs.append(ours(program, folder, effects))
    steps = {effects: runs[0]["steps"] for effects, runs in found.items()}
    assert steps["none"] == steps["all"], steps
    least = {effects: min(run["seconds"]["run_cpu"] for run in runs) for effects, runs in found.items()}
    return {"steps": steps["all"], "seconds_without": least["none"], "seconds_with": least["all"], "ratio": least["all"] / least["none"]}


def by_mujoco(folder, rounds):
    program = folder / "mujoco_floor"
    built = subprocess.run(["g++", "-std=c++17", "-O3", "-march=native", ROOT / "bench/drivers/mujoco_floor.cpp", "-o", program, "-lmujoco"],
                           capture_output=True, text=True, check=False)
    if built.returncode != 0:
        return {"skipped": "MuJoCo (libmujoco-dev) is not installed"}
    done = subprocess.run([program, "10", "20000", str(rounds)], check=True, capture_output=True, text=True)
    without, with_floor = map(float, done.stdout.split())
    return {"ns_of_step_without": without, "ns_of_step_with": with_floor, "ratio": with_floor / without}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", default=ROOT / "build/release/bin", type=pathlib.Path)
    parser.add_argument("--rounds", default=15, type=int)
    parser.add_argument("--write", action="store_true")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="gauss effects ") as name:
        folder = pathlib.Path(name)
        result = {"gauss": by_gauss(given.bin / "gauss-sim", folder, given.rounds),
                  "mujoco": by_mujoco(folder, max(3, given.rounds // 3))}
    print(f"contacts that never act, chain of 10: {result['gauss']['ratio']:.3f} times as long as without them (goal: {TARGET})")
    if "ratio" in result["mujoco"]:
        print(f"MuJoCo with a floor that is never reached: {result['mujoco']['ratio']:.3f} times")
    if given.write:
        simulation.write(simulation.EFFECTS, result)


if __name__ == "__main__":
    main()
