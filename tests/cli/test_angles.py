"""Sines and cosines of angles that are there at the same time are asked for by one call."""

import re
import unittest

from gauss_gen import MODELS, Program

CALL = re.compile(r"Angles<S>::sincos\((.*?)\);", re.S)


class Angles(Program):
    def rhs(self, model, *arguments):
        text = self.ok(MODELS / model, *arguments, "--outputs", "rhs", "-o", "-")
        return text[text.index("GAUSS_FUNCTION StatusOf<S> rhs("):], text

    def angles(self, body):
        """Of each call its angles, in order."""
        return [[word.strip() for word in call.split(",")][::3] for call in CALL.findall(body)]

    def test_a_chain_asks_for_all_at_once_sixteen_at_most(self):
        body, text = self.rhs("families/planar_chain_relative.yaml", "--count", "n=20", "--fold")
        calls = self.angles(body)
        self.assertEqual([len(call) for call in calls], [16, 4])
        self.assertEqual([angle for call in calls for angle in call], [f"q_{i}" for i in range(20, 0, -1)])  # as they are needed
        self.assertEqual(re.search(r"^//   rhs .* (\d+)$", text, re.M)[1], "40")

    def test_every_sine_is_declared_before_the_call(self):
        body, _ = self.rhs("families/spatial_chain.yaml", "--count", "n=3")
        call = CALL.search(body)
        words = [word.strip() for word in call[1].split(",")]
        for sine, cosine in zip(words[1::3], words[2::3]):
            self.assertIn(f"  S {sine}, {cosine};\n", body[:call.start()])

    def test_one_angle_is_asked_for_by_itself(self):
        body, _ = self.rhs("pendulum_varying_length.yaml")
        self.assertIn("Math<S>::sincos(", body)
        self.assertEqual(CALL.findall(body), [])

    def test_an_angle_that_contains_a_sine_of_another_comes_after_it(self):
        model = """gauss: 1
name: nested
coordinates: {a: {}, b: {}}
quantities:
  innermost: {value: "sin(b + sin(a + sin(a))) + cos(b + sin(a + sin(a)))"}
  outer: {value: "sin(a + sin(a)) + cos(a + sin(a)) + cos(a) + sin(b) + cos(b) + sin(b + cos(b)) + cos(b + cos(b))"}
particles: {p: {mass: 1, position: [a, b, 0]}}
"""
        text = self.ok(self.write("nested.yaml", model), "--outputs", "quantities", "-o", "-")
        known = set()
        for call in re.finditer(r"(?:Angles|Math)<S>::sincos\((.*?)\);", text[text.index("StatusOf<S> quantities("):], re.S):
            words = [word.strip() for word in call[1].split(",")]
            for angle in words[::3]:
                self.assertFalse([name for name in re.findall(r"\w+", angle) if name in words[1::3] + words[2::3]], call[0])
                self.assertTrue(all(name in known for name in re.findall(r"(?:sin|cos)_\w+", angle)), call[0])
            known.update(words)
        self.assertEqual(len(known), 15)


if __name__ == "__main__":
    unittest.main()
