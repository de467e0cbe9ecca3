"""Same bytes from a generator that clang++ has built: the instrumented one in build/fuzz, so its sanitizers see every model."""

import os
import sys
import unittest
from pathlib import Path

import same_bytes

sys.path.append(str(Path(__file__).resolve().parents[1] / "fuzz"))
import run_fuzzers  # noqa: E402


class Compilers(unittest.TestCase):
    def test_a_generator_by_clang_prints_the_same_bytes(self):
        if not run_fuzzers.has_libfuzzer():
            self.skipTest("no clang++ with its sanitizers here")
        run_fuzzers.build("gauss-gen")
        expected = same_bytes.hashes()
        same_bytes.PROGRAM = run_fuzzers.BUILD / "bin" / "gauss-gen"
        self.assertEqual(same_bytes.differences(expected, same_bytes.hashes(env=run_fuzzers.environment())), [])


if __name__ == "__main__":
    unittest.main()
