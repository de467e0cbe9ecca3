#!/usr/bin/env python3
"""What gauss-sim's driver costs beside a loop by hand over Boost.Odeint, per call of the right-hand side.

    ninja -C build/release gauss-gen bench_driver
    bench/driver.py [--bin build/release/bin] [--rounds 31] [--write]

The double pendulum (4 states, compiled engine) for 10 s. "hand" measures errors as gauss-sim does, so that both take the same steps and calls, which is
asserted; gauss-sim has up to two calls more for each step that it refuses. "usual" has the checker of Odeint. Both are compiled with the options that gauss-sim compiles models with. Prints ratios, and with --write also
bench/results/driver.json, from which `./run bench --report` writes docs/performance.md. Instructions are callgrind's, of one run each.
"""

import argparse
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

MODEL = ROOT / "models/double_pendulum.yaml"
FLAGS = "-std=c++17 -O2 -march=native -ffp-contract=off -fno-tree-slp-vectorize -funroll-loops -fPIC -shared -w".split()
END = 10
SETTINGS = {"fehlberg78": 1e-9, "prince87": 1e-9, "dopri5": 1e-9, "rk4": 1e-3}
TARGET = 1.10


class Pair:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.environment = dict(os.environ, XDG_CACHE_HOME=str(folder))
        self.when_counting = dict(self.environment, CXX=simulation.counting_compiler(folder))
        self.library, self.counted_library = folder / "by_hand.so", folder / "by_hand_counted.so"

    def build(self, gauss_gen):
        subprocess.run([gauss_gen, MODEL, "--outputs", "rhs,initial_state", "-o", self.folder], check=True, capture_output=True)
        sources = ["-I", ROOT / "src", "-I", self.folder, ROOT / "bench/drivers/driver_by_hand.cpp"]
        compiler = os.environ.get("CXX", "g++")
        subprocess.run([compiler, *FLAGS, *sources, "-o", self.library], check=True)
        subprocess.run([compiler, *FLAGS, f"-march={simulation.AVX2}", *sources, "-o", self.counted_library], check=True)

    def command(self, method, what, library=None):
        return list(map(str, [self.program, MODEL, library or self.library, method, SETTINGS[method], END, what]))

    def run(self, method, rounds):
        done = subprocess.run(self.command(method, rounds), env=self.environment, check=True, capture_output=True, text=True)
        return json.loads(done.stdout)

    def instructions(self, method, what):
        out = self.folder / "callgrind.out"
        counted = "*counted_ours*" if what == "ours" else "*counted_hand*"
        words = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", f"--toggle-collect={counted}", *self.command(method, what, self.counted_library)]
        subprocess.run(words, env=self.when_counting, check=True, capture_output=True)
        return int(re.search(r"^(?:summary|totals): (\d+)", out.read_text(), re.MULTILINE).group(1))


def assert_same(method, ours, hand):
    for number in ("steps", "rejected"):
        assert ours[number] == hand[number], (method, number, ours[number], hand[number])
    # Two calls after a step that is refused find out what rounding changes rates by.
    assert 0 <= ours["calls"] - hand["calls"] <= 2 * ours["rejected"], (method, ours["calls"], hand["calls"])
    # Sums are rounded otherwise where a compiler makes vectors of them.
    off = max(abs(a - b) for a, b in zip(ours["last"], hand["last"]))
    assert off < 1e-9, (method, off)


def measured(pair, method, rounds):
    found = pair.run(method, rounds)
    assert_same(method, found["ours"]["result"], found["hand"]["result"])
    row = {"setting": SETTINGS[method], **{key: found["ours"]["result"][key] for key in ("steps", "rejected", "calls")}}
    for who in found:
        calls = found[who]["result"]["calls"]
        row[who] = {"calls": calls, "ns_per_call": 1e9 * min(found[who]["seconds"]) / calls}
        if shutil.which("valgrind"):
            row[who]["instructions_per_call"] = pair.instructions(method, who) / calls
    rounds_of = zip(found["ours"]["seconds"], found["hand"]["seconds"])
    row["time_of_run_to_hand"] = statistics.median(ours / hand for ours, hand in rounds_of)
    row["time_per_call_to_hand"] = row["time_of_run_to_hand"] * row["hand"]["calls"] / row["ours"]["calls"]
    for number in ("ns_per_call", "instructions_per_call"):
        if number in row["hand"]:
            row[f"{number}_to_hand"] = row["ours"][number] / row["hand"][number]
            if "usual" in row:
                row[f"{number}_to_usual"] = row["ours"][number] / row["usual"][number]
    return row


def line(method, row):
    text = f"{method:11} {row['calls']} calls: {row['time_per_call_to_hand']:.3f} of the time by hand per call"
    text += f" (least times {row['ns_per_call_to_hand']:.3f}; whole run {row['time_of_run_to_hand']:.3f})"
    if "instructions_per_call_to_hand" in row:
        of = {who: row[who]["instructions_per_call"] for who in ("ours", "hand", "usual") if who in row}
        text += f", {row['instructions_per_call_to_hand']:.3f} of its instructions ("
        text += ", ".join(f"{who} {count:.0f}" for who, count in of.items()) + " per call)"
    if "ns_per_call_to_usual" in row:
        text += f"; {row['ns_per_call_to_usual']:.3f} of the time per call with Odeint's checker"
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", default=ROOT / "build/release/bin", type=pathlib.Path)
    parser.add_argument("--rounds", default=31, type=int)
    parser.add_argument("--write", action="store_true", help="write bench/results/driver.json")
    arguments = parser.parse_args()
    results = {"flags": " ".join(FLAGS), "target": TARGET, "methods": {}}
    with tempfile.TemporaryDirectory() as name:
        pair = Pair(arguments.bin / "bench_driver", pathlib.Path(name))
        pair.build(arguments.bin / "gauss-gen")
        for method in SETTINGS:
            results["methods"][method] = measured(pair, method, arguments.rounds)
            print(line(method, results["methods"][method]), flush=True)
    if arguments.write:
        simulation.write(simulation.DRIVER, results)


if __name__ == "__main__":
    main()
