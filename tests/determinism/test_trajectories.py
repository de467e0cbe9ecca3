"""Same states, bit for bit, whatever compiles an emitted model (hard case H25): both compilers, four levels, with and without FMA.

Where fast-math is asked for, states are another's to rounding only. `test_trajectories.py --json` writes what was found instead of judging it.
"""

import itertools
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
HEADERS = Path(os.environ["GAUSS_TRAJECTORY_HEADERS"])
COMPILERS = [compiler for compiler in ("g++", "clang++") if shutil.which(compiler)]
LEVELS = ("-O0", "-O1", "-O2", "-O3")
WITH_FMA = "-march=x86-64-v3"
EXACT = ("-ffp-contract=off",)
CONTRACTED = ("-ffp-contract=fast",)
FAST = ("-ffast-math", "-ffp-contract=off", "-DGAUSS_ALLOW_FAST_MATH")
# Their motions enlarge differences: one rounding for a product and a sum, with no fast-math, moves the four-bar by 4e-11, too.
SENSITIVE = ("double_pendulum", "four_bar")


def processors():
    """The instruction sets that this machine runs."""
    flags = Path("/proc/cpuinfo").read_text(encoding="utf-8") if Path("/proc/cpuinfo").exists() else ""
    return ("", WITH_FMA) if " avx2 " in flags and " fma " in flags else ("",)


class Runs:
    """Programs, each by other options, and what they print."""

    def __init__(self, folder):
        self.folder = Path(folder)

    def run(self, options):
        """By model, the hash of all states and the last one."""
        with tempfile.TemporaryDirectory(dir=self.folder) as folder:
            program = Path(folder) / "trajectory_hash"
            subprocess.run([*options, "-std=c++17", f"-I{HEADERS}", HERE / "trajectory_hash.cpp", "-o", program],
                           check=True)
            said = subprocess.run([program], check=True, capture_output=True, text=True).stdout
        words = [line.split() for line in said.splitlines()]
        return {model: (found, [float(number) for number in state]) for model, found, *state in words}

    def run_all(self, variants):
        with ThreadPoolExecutor(max_workers=2) as pool:
            return dict(zip(variants, pool.map(self.run, variants)))


def variants(*more):
    every = itertools.product(COMPILERS, LEVELS, processors())
    return [tuple(filter(None, (*one, *more))) for one in every]


def differing(found):
    """Models whose states have other bits in some variant than in the first."""
    first = next(iter(found.values()))
    return sorted({model for run in found.values() for model in first if run[model][0] != first[model][0]})


def distance(found, exact):
    """The largest component of a last state that is another, by the size of that state; of motions that keep differences small."""
    worst = 0.0
    for model, (_, state) in exact.items():
        if model in SENSITIVE:
            continue
        size = max(abs(x) for x in state)
        worst = max(worst, *(abs(x - y) / size for x, y in zip(found[model][1], state)))
    return worst


class Trajectories(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.runs = Runs(folder.name)

    def test_bits_do_not_depend_on_compilers_levels_and_processors(self):
        found = self.runs.run_all(variants(*EXACT))
        self.assertEqual(differing(found), [], {options: run for options, run in found.items()})

    @unittest.skipUnless(WITH_FMA in processors(), "needs a processor with FMA")
    def test_the_hash_sees_a_product_and_a_sum_in_one_rounding(self):
        found = self.runs.run_all([(COMPILERS[0], "-O2", WITH_FMA, *more) for more in (EXACT, CONTRACTED)])
        self.assertIn("double_pendulum", differing(found))

    def test_fast_math_that_was_asked_for_stays_near(self):
        exact = self.runs.run((COMPILERS[0], "-O2", *EXACT))
        for compiler in COMPILERS:
            with self.subTest(compiler):
                self.assertLess(distance(self.runs.run((compiler, "-O2", *FAST)), exact), 1e-12)


def report():
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(folder)
        found = runs.run_all(variants(*EXACT))
        exact = next(iter(found.values()))
        as_usual = runs.run_all([(compiler, level, one) for compiler in COMPILERS for level in LEVELS for one in processors() if one])
        fast = max(distance(runs.run((compiler, "-O2", *FAST)), exact) for compiler in COMPILERS)
        json.dump({"variants": len(found), "models": len(exact), "differing": len(differing(found)),
                   "differing_as_usual": len(differing({**found, **as_usual})), "fast_math": fast}, sys.stdout)


if __name__ == "__main__":
    if sys.argv[1:] == ["--json"]:
        report()
    else:
        unittest.main()
