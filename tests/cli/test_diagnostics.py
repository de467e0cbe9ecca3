"""Every faulty model of tests/diagnostics through the program: the exact text, its exit code, soon, small, and no file."""

import re
import unittest

from gauss_gen import SOURCE, Program
from test_limits import SECONDS, limit_memory, measured

FOLDER = "tests/diagnostics"
TOO_LARGE = {"E003", "E038"}


def exit_code(text):
    errors = set(re.findall(r": error\[(E\d+)\]: ", text))
    if not errors:
        return 0
    return 4 if errors <= TOO_LARGE else 1


class Diagnostics(Program):
    def test_every_faulty_model_is_refused_by_the_program_as_it_is_by_the_library(self):
        cases = sorted((SOURCE / FOLDER).glob("*.yaml"))
        self.assertGreaterEqual(len(cases), 250)
        for case in cases:
            with self.subTest(case.name):
                seconds, result = measured(lambda: self.run_it(f"{FOLDER}/{case.name}", "-o", f"{self.folder}/", cwd=SOURCE, text=False,
                                                               preexec_fn=limit_memory))
                self.assertLess(seconds, SECONDS)
                expected = case.with_suffix(".txt").read_bytes()
                self.assertEqual(result.stderr, expected)
                self.assertEqual(result.returncode, exit_code(expected.decode(errors="replace")))
                self.assertEqual(result.returncode == 0, case.name[0] == "w")
                self.assertEqual(result.stdout, b"")
                if result.returncode != 0:
                    self.assertEqual(self.files(), [])
                for file in self.folder.iterdir():
                    file.unlink()


if __name__ == "__main__":
    unittest.main()
