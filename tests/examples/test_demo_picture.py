"""docs/demo.svg is what `./run demo --svg` draws, and small enough for a page."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
from pathlib import Path

PROGRAM = sys.argv.pop()
PICTURE = Path(os.environ["GAUSS_SOURCE_DIR"]) / "docs/demo.svg"
NUMBER = re.compile(r"-?\d+\.?\d*")
PIXEL = 0.11  # one digit of what is written: compilers may round otherwise


class Picture(unittest.TestCase):
    def test_the_picture_is_current(self):
        with tempfile.TemporaryDirectory() as folder:
            drawn = Path(folder) / "demo.svg"
            subprocess.run([PROGRAM, "--svg", drawn], stdout=subprocess.DEVNULL, check=True, timeout=60)
            now = drawn.read_text(encoding="utf-8")
        kept = PICTURE.read_text(encoding="utf-8")
        hint = "run ./run demo --svg docs/demo.svg"
        self.assertEqual(NUMBER.sub("#", now), NUMBER.sub("#", kept), hint)
        for a, b in zip(NUMBER.findall(now), NUMBER.findall(kept), strict=True):
            self.assertAlmostEqual(float(a), float(b), delta=PIXEL, msg=hint)

    def test_the_picture_is_small_and_well_formed(self):
        self.assertLess(PICTURE.stat().st_size, 60_000)
        self.assertTrue(xml.etree.ElementTree.parse(PICTURE).getroot().tag.endswith("svg"))

    def test_other_arguments_and_folders_that_are_not_there_are_refused(self):
        for code, arguments in [(2, ["--sgv", "x"]), (2, ["--svg"]), (3, ["--svg", "/nowhere/at/all.svg"])]:
            result = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False, timeout=60)
            self.assertEqual(result.returncode, code)
            self.assertNotEqual(result.stderr, "")


if __name__ == "__main__":
    unittest.main()
