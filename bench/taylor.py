"""Time to a delivered error: power series (the output `taylor`) against Runge-Kutta methods of Boost.Odeint.

    bench/taylor.py --gauss-gen build/release/bin/gauss-gen [--order N] [--write]

Prints seconds and ratios, and with --write also bench/results/taylor.json. The error is the largest over all components of the state and eight times of
a run, each relative to what the component ranges over; of each method the cheapest tolerance counts that delivers it. References are
computed in __float128 with order 30. Nobody projects.
"""

import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench"))
from harness import simulation  # noqa: E402
MODELS = ["sphere_in_cylinder", "sphere_in_cylinder_quaternion", "double_pendulum", "lagrange_top_euler", "lagrange_top", "kepler"]
COMMON = ["-std=gnu++17", "-O3", "-march=native", "-DNDEBUG", "-Wno-maybe-uninitialized"]
FLAGS = {
    "contract off": ["-ffp-contract=off"],
    "contract fast": ["-ffp-contract=fast"],
    "fast math": ["-ffast-math", "-DGAUSS_ALLOW_FAST_MATH"],
}


def measured(gauss_gen, flags, order, folder):
    program = folder / "taylor"
    command = ["g++", *COMMON, *flags, "-I", ROOT / "src", "-I", folder, ROOT / "bench/drivers/taylor.cpp", "-o", program, "-lquadmath"]
    subprocess.run(command, check=True)
    return json.loads(subprocess.run([program, str(order)], check=True, capture_output=True, text=True).stdout)


def ratios(problems, method):
    """Of the times to each error, fehlberg78 = 1; None where one of the two does not deliver it."""
    result = {}
    for name, methods in problems.items():
        for error, mine in methods[method].items():
            theirs = methods["fehlberg78"][error]["seconds"]
            delivered = mine["seconds"] > 0 and theirs > 0
            result.setdefault(error, {})[name] = mine["seconds"] / theirs if delivered else None
    return result


def mean(values):
    values = list(values)
    return None if None in values else math.exp(sum(map(math.log, values)) / len(values))


def report(title, problems):
    print(title)
    summary = {}
    for method in ("taylor", "dopri5"):
        table = ratios(problems, method)
        summary[method] = {error: mean(of.values()) for error, of in table.items()}
        for error, of in table.items():
            row = "  ".join(f"{name} {value:.2f}" if value else f"{name} -" for name, value in of.items())
            geometric = summary[method][error]
            print(f"  {method:8} {error}: {f'{geometric:.3f}' if geometric else '-':6} of fehlberg78   ({row})")
    return summary


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--gauss-gen", default=ROOT / "build/release/bin/gauss-gen", type=pathlib.Path)
    parser.add_argument("--order", type=int, default=0, help="0: by the tolerance")
    parser.add_argument("--write", action="store_true", help="write bench/results/taylor.json")
    arguments = parser.parse_args()
    results = {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for model in MODELS:
            outputs = ["--outputs", "rhs,taylor,initial_state", "-o", folder]
            subprocess.run([arguments.gauss_gen, ROOT / f"models/{model}.yaml", *outputs], check=True, capture_output=True)
        for title, flags in FLAGS.items():
            problems = measured(arguments.gauss_gen, flags, arguments.order, folder)
            results[title] = {"flags": " ".join([*COMMON, *flags]), "ratios to fehlberg78": report(title, problems), "problems": problems}
    if arguments.write:
        simulation.write(simulation.TAYLOR, results)


if __name__ == "__main__":
    main()
