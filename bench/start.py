"""From a command to its first result: a whole `gauss-sim run` of the ball in the cylinder, 10 s by default, as a shell sees it.

    bench/start.py [--gauss-sim build/release/bin/gauss-sim] [--rounds N] [--write]

Interpreted, compiled for the first time (an empty cache), and compiled before. Seconds of the clock, medians; with --write they go to bench/results/start.json.
"""

import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench"))
from harness import simulation  # noqa: E402
MODEL = ROOT / "models/sphere_in_cylinder.yaml"


def seconds_of(gauss_sim, folder, cache, *options):
    """Of the clock."""
    begin = time.monotonic()
    subprocess.run([gauss_sim, "run", MODEL, "-q", *options], cwd=folder, check=True, stderr=subprocess.DEVNULL, env={**os.environ, "XDG_CACHE_HOME": str(cache)})
    return time.monotonic() - begin


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--gauss-sim", default=ROOT / "build/release/bin/gauss-sim", type=pathlib.Path)
    parser.add_argument("--rounds", default=11, type=int)
    parser.add_argument("--write", action="store_true", help="write bench/results/start.json")
    arguments = parser.parse_args()
    gauss_sim = arguments.gauss_sim.resolve()
    times = {"interpreted": [], "compiled the first time": [], "compiled before": []}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for k in range(arguments.rounds):
            cache = folder / f"cache{k}"
            times["interpreted"].append(seconds_of(gauss_sim, folder, cache, "--engine", "interpreted"))
            times["compiled the first time"].append(seconds_of(gauss_sim, folder, cache))
            times["compiled before"].append(seconds_of(gauss_sim, folder, cache))
    medians = {way: statistics.median(all_of_it) for way, all_of_it in times.items()}
    for way, median in medians.items():
        print(f"{way}: {median:.3f} s")
    if arguments.write:
        simulation.write(simulation.START, {"rounds": arguments.rounds, "seconds": medians})


if __name__ == "__main__":
    main()
