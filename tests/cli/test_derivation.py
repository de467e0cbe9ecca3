"""gauss-gen derivation: the paper's objects as formulas."""

import unittest

from gauss_gen import MODELS, NO_UNITS, SKEW, SPHERE, Program


class Derivation(Program):
    def test_markdown_is_the_default(self):
        self.assertEqual(self.ok("derivation", SPHERE), self.ok("derivation", SPHERE, "--format", "markdown"))
        self.assertTrue(self.ok("derivation", SPHERE).startswith("# "))

    def test_latex_is_a_whole_document(self):
        text = self.ok("derivation", SPHERE, "--format", "latex")
        self.assertTrue(text.lstrip().startswith(("\\documentclass", "%")))
        self.assertTrue(text.rstrip().endswith("\\end{document}"))
        self.assertEqual(text.count("{"), text.count("}"))
        self.assertEqual(text.count("\\begin{"), text.count("\\end{"))

    def test_every_model_has_one(self):
        for model in sorted(MODELS.glob("*.yaml")):  # those of families are too large for the paper's route
            for form in ("markdown", "latex"):
                self.assertGreater(len(self.ok("derivation", model, "--format", form)), 1000)

    def test_speeds_of_the_models_own_are_told_by_the_rates_in_which_it_is_written(self):
        text = self.ok("derivation", MODELS / "chaplygin_sleigh_speeds.yaml")
        self.assertIn("w = -\\dot{x}\\,\\sin{\\theta} + \\dot{y}\\,\\cos{\\theta}", text)

    def test_numbers_are_decimals_where_the_model_writes_decimals(self):
        model = NO_UNITS + "forces: {weight: {potential: 9.81*m*x + 1/5*y}, wind: {uniform: [0, 0.2, 0]}}\n"
        text = self.ok("derivation", "-", stdin=model)
        for formula in ("Q_{x} = -9.81\\,m", "\\frac{m\\,\\left(9.81 + a^{x}\\right)^{2}}{2}", "Q_{y} = -0.2 + 0.2\\,m"):
            self.assertIn(formula, text)
        self.assertNotIn("981", text.replace("9.81", ""))

    def test_numbers_are_fractions_elsewhere(self):
        model = NO_UNITS.replace("m: 2", "m: 0.3") + "forces: {f: {potential: 3/10*x + 0.5*y}}\n"
        text = self.ok("derivation", "-", stdin=model)
        for formula in ("Q_{x} = -\\frac{3}{10}", "Q_{y} = -\\frac{1}{2}"):
            self.assertIn(formula, text)

    def test_it_can_be_written_to_a_file(self):
        self.ok("derivation", SKEW, "-o", "a b/skew.md")
        self.assertEqual((self.folder / "a b/skew.md").read_text(), self.ok("derivation", SKEW))
        self.assertEqual(self.ok("derivation", SKEW, "-o", "-"), self.ok("derivation", SKEW))
        self.assertEqual(self.files(), ["a b", "a b/skew.md"])


if __name__ == "__main__":
    unittest.main()
