"""Runs gauss-gen as a user would. $GAUSS_GEN is the program, $GAUSS_SOURCE_DIR the checkout."""

import json
import os
import re
import subprocess
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

PROGRAM = os.environ["GAUSS_GEN"]
SOURCE = Path(os.environ["GAUSS_SOURCE_DIR"])
MODELS = SOURCE / "models"
SPHERE = MODELS / "sphere_in_cylinder.yaml"
SKATER = MODELS / "skater_quaternion.yaml"
SKEW = MODELS / "skew_chart.yaml"

PARTICLE = """gauss: 1
name: particle
parameters:
  m: {value: 2, unit: kg}
coordinates:
  x: {unit: m, initial_rate: 1}
  y: {unit: m, initial_rate: 1}
particles:
  p: {mass: m, position: [x, y, 0]}
"""
NO_UNITS = PARTICLE.replace("{value: 2, unit: kg}", "2").replace("unit: m, ", "")
BROKEN = PARTICLE.replace("mass: m", "mass: mm")


def without_poles(text):
    """Of messages, those that are not W070: Euler's angles have their pole, which models here are rightly warned of, and test_charts.py
    looks at where."""
    return re.sub(r"(?m)^\S.*: warning\[W070\]: .*\n(?: .*\n)*\n?", "", text)


class Program(unittest.TestCase):
    """Each test has an empty working folder of its own, with a blank in its name."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="gauss cli ")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_it(self, *arguments, stdin=None, **more):
        more.setdefault("timeout", 60)
        more.setdefault("text", True)
        more.setdefault("cwd", self.folder)
        return subprocess.run([PROGRAM, *map(str, arguments)], input=stdin, capture_output=True, check=False,
                              **more)

    def ok(self, *arguments, **more):
        """Standard output of a run that must succeed and have nothing to say on standard error."""
        result = self.run_it(*arguments, **more)
        self.assertEqual((result.returncode, without_poles(result.stderr)), (0, ""), arguments)
        return result.stdout

    def refused(self, code, *arguments, **more):
        """Standard error of a run that must end with `code` and write nothing else."""
        before = self.files()
        result = self.run_it(*arguments, **more)
        self.assertEqual(result.returncode, code, (arguments, result.stderr))
        self.assertEqual(result.stdout, "", arguments)
        self.assertEqual(self.files(), before, arguments)
        self.assertNotEqual(result.stderr, "")
        return result.stderr

    def files(self):
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*"))

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path


class Evaluate(Program):
    """With the numbers of `gauss-gen evaluate`, which has a digit for each that it knows."""

    def document(self, *arguments, **more):
        return json.loads(self.ok("evaluate", "--format", "json", *arguments, **more))

    def value(self, group, name, *arguments):
        return Fraction(self.document(*arguments)[group][name]["value"])

    def close(self, a, b, digits=15):
        self.assertLessEqual(abs(Fraction(a) - Fraction(b)), abs(Fraction(b)) / 10**digits)
