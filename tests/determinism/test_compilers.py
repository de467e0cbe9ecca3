"""Same bytes from a generator that clang++ has built: the instrumented one in build/fuzz, so its sanitizers see every model."""

import os
import sys
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import same_bytes

sys.path.append(str(Path(__file__).resolve().parents[1] / "fuzz"))
import run_fuzzers  # noqa: E402


class Compilers(unittest.TestCase):
    def test_a_generator_by_clang_prints_the_same_bytes(self):
        if not run_fuzzers.has_libfuzzer():
            self.skipTest("no clang++ with its sanitizers here")
        run_fuzzers.build("gauss-gen")
        with ThreadPoolExecutor(2) as pool:
            expected = same_bytes.hashes(each=pool.map)
            same_bytes.PROGRAM = run_fuzzers.BUILD / "bin" / "gauss-gen"
            found = same_bytes.hashes(each=pool.map, env=run_fuzzers.environment())
        self.assertEqual(same_bytes.differences(expected, found), [])


if __name__ == "__main__":
    unittest.main()
