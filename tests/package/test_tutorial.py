"""docs/tutorial.md from its first command to its last, with gauss installed as the page says."""

import math
import os
import re
import shutil
import tempfile
import unittest
from pathlib import Path

import page
from installed import install

PAGE = (Path(os.environ["GAUSS_SOURCE_DIR"]) / "docs/tutorial.md").read_text(encoding="utf-8")
SETUP = ("./run build                                      # in the checkout of gauss\n"
         "cmake --install build/release --prefix ~/gauss\n"
         "export PATH=~/gauss/bin:$PATH CMAKE_PREFIX_PATH=~/gauss\n")  # what setUpClass does


class Tutorial(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        home = tempfile.TemporaryDirectory(prefix="gauss tutorial ")
        cls.addClassCleanup(home.cleanup)
        prefix = Path(home.name) / "gauss"
        install(prefix)
        folder = Path(home.name) / "work"
        folder.mkdir()
        environment = {**os.environ, "PATH": f"{prefix}/bin:{os.environ['PATH']}", "CMAKE_PREFIX_PATH": str(prefix),
                       "CXX": os.environ["GAUSS_CXX"], "LC_ALL": "C.UTF-8",
                       "CMAKE_GENERATOR": "Unix Makefiles" if shutil.which("make") else "Ninja"}
        cls.steps = list(page.follow(PAGE, folder, environment))

    def rows(self, program):
        """Numbers that the page shows of a program, row by row."""
        shown = next(shown for command, shown, _ in self.steps if command == program)
        return [[float(cell) for cell in line.split()] for line in shown[1:]]

    def test_the_way_to_install_is_the_one_that_this_test_goes(self):
        self.assertEqual([content for language, _, content in page.blocks(PAGE) if language == "sh"], [SETUP])

    def test_every_block_is_a_file_or_a_command(self):
        for language, place, content in page.blocks(PAGE):
            self.assertTrue(place or language in ("console", "sh"), content)

    def test_each_file_is_named_in_the_text_before_it(self):
        """Where the page is shown, the first line of a block is not."""
        for match in page.FENCE.finditer(PAGE):
            name = match[2].removeprefix(">>").partition(":")[0]
            if name:
                self.assertIn(f"`{name}`", PAGE[:match.start()].rstrip().rpartition("\n\n")[2])

    def test_every_command_prints_what_the_page_shows(self):
        self.assertGreater(len(self.steps), 15)
        for command, shown, printed in self.steps:
            with self.subTest(command):
                self.assertTrue(page.matches(shown, printed), "\n".join(["", "shown:", *shown, "", "printed:", *printed]))

    def test_what_the_page_says_of_its_numbers_holds(self):
        text = "\n".join(line for _, shown, _ in self.steps for line in shown)

        def number(name):
            return float(re.search(rf"^ *{re.escape(name)} +(\S+)", text, re.M)[1])

        m, l, g = 1, 0.8, 9.81
        expected = {"theta_ddot": -g / l * math.sin(0.5), "s": -m * g * math.cos(0.5), "x_ddot": 20 / (10 + 2 * 0.006 / 0.1**2),
                    "floor.force.z": 10 * g, "floor.moment.y": -8 * 0.1 * g + 2}
        for name, value in expected.items():
            self.assertTrue(math.isclose(number(name), value, rel_tol=1e-14), name)
        self.assertIn(f"-{m*g + m*l*2**2:.2f}", text)
        yaw_dot = float(re.findall(r"yaw_dot +(\S+)", text)[-1])
        self.assertTrue(math.isclose(yaw_dot, math.tan(0.3 * math.sin(0.4)) / 0.8, rel_tol=1e-14))

    def test_the_cart_settles_on_a_circle(self):
        _, _, _, v, a, first, second, sideways = self.rows("build/cart")[-1]
        self.assertAlmostEqual(sideways, 10 * a, delta=1e-3)
        yaw_dot = a / v
        self.assertAlmostEqual(first + second, -8 * 0.1 * yaw_dot**2, delta=1e-3)


if __name__ == "__main__":
    unittest.main()
