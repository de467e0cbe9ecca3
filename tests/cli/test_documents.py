"""The complete models in the documents can be copied whole and do what is said of them."""

import json
import math
import textwrap
import unittest

from gauss_gen import SOURCE, Program


def models_in(page):
    """Indented blocks that begin with the version of the format, by name."""
    found, block = {}, []
    for line in [*page.read_text(encoding="utf-8").splitlines(), "end"]:
        if line.startswith("    ") or (block and not line.strip()):
            block.append(line)
            continue
        text = textwrap.dedent("\n".join(block)).strip() + "\n"
        if text.startswith("gauss: 1\nname: "):
            found[text.splitlines()[1].split()[1]] = text
        block = []
    return found


class Documents(Program):
    def setUp(self):
        super().setUp()
        self.models = {}
        for page in [SOURCE / "README.md", *sorted((SOURCE / "docs").rglob("*.md"))]:
            self.models.update(models_in(page))

    def test_every_model_is_right(self):
        self.assertGreaterEqual(self.models.keys(), {"pendulum", "ball_on_slope"})
        for name, text in self.models.items():
            with self.subTest(name):
                self.ok("-", "--check", stdin=text)

    def test_the_ball_on_the_slope_moves_as_stated(self):
        document = json.loads(self.ok("evaluate", "-", "--format=json", stdin=self.models["ball_on_slope"]))
        m, g, alpha = 0.5, 9.81, math.pi / 6
        stated = {("accelerations", "x_ddot"): 5 / 7 * g * math.sin(alpha),
                  ("multipliers", "rolling_x"): -2 / 7 * m * g * math.sin(alpha),
                  ("reactions", "z"): m * g * math.cos(alpha)}
        for (group, name), value in stated.items():
            self.assertAlmostEqual(float(document[group][name]["value"]), value, 12, name)


if __name__ == "__main__":
    unittest.main()
