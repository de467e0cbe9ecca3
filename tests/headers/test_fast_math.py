"""Every header refuses -ffast-math and what is part of it, unless it is asked for; then, too, values that are not finite have a status.

    test_fast_math.py HEADER...
"""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
HEADERS = []
COMPILERS = [compiler for compiler in ("g++", "clang++") if shutil.which(compiler)]
ALLOWED = "-DGAUSS_ALLOW_FAST_MATH"
PARTS = ["-ffast-math", "-Ofast", "-ffinite-math-only"]
# g++ has a macro for each of these. clang++ has none, and no header can tell.
PARTS_WITH_MACRO = {"g++": ["-funsafe-math-optimizations", "-freciprocal-math", "-fno-signed-zeros"], "clang++": []}
UNSEEN = {"g++": [], "clang++": ["-funsafe-math-optimizations", "-fassociative-math -fno-signed-zeros -fno-trapping-math"]}


def compiled(compiler, *options):
    """What the compiler says of mistakes: nothing where there are none."""
    return subprocess.run([compiler, "-std=c++17", *options], capture_output=True, text=True, check=False)


class FastMath(unittest.TestCase):
    def assert_refused(self, compiler, option, header):
        result = compiled(compiler, option, "-x", "c++", "-E", "-o", "/dev/null", header)
        self.assertNotEqual(result.returncode, 0, (compiler, option, header))
        self.assertIn("exact floating-point semantics", result.stderr)
        self.assertEqual(compiled(compiler, option, ALLOWED, "-x", "c++", "-E", "-o", "/dev/null", header).returncode, 0)

    def test_every_header_refuses_it(self):
        for header in HEADERS:
            for compiler in COMPILERS:
                self.assert_refused(compiler, "-ffast-math", header)

    def test_its_parts_are_refused(self):
        for compiler in COMPILERS:
            for part in PARTS + PARTS_WITH_MACRO[compiler]:
                self.assert_refused(compiler, part, HEADERS[0])

    def test_values_that_are_not_finite_are_found_with_it(self):
        folder = next(Path(header).parent for header in HEADERS if Path(header).name == "double_pendulum.hpp")
        for compiler in COMPILERS:
            ways = [f"{part} {ALLOWED}" for part in PARTS] + UNSEEN[compiler]
            for way in ["", *ways]:
                with self.subTest(compiler, way=way), tempfile.TemporaryDirectory() as at:
                    program = Path(at) / "finite"
                    result = compiled(compiler, "-O2", *way.split(), f"-I{folder}", HERE / "finite_by_bits.cpp", "-o", program)
                    self.assertEqual(result.returncode, 0, result.stderr)
                    said = subprocess.run([program], capture_output=True, text=True, check=False)
                    self.assertEqual((said.returncode, said.stdout), (0, ""))


if __name__ == "__main__":
    HEADERS = sys.argv[1:]
    unittest.main(argv=sys.argv[:1])
