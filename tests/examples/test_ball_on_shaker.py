"""What examples/ball_on_shaker.cpp prints, against closed forms: when the table throws the ball, and when the parabola meets the table again."""

import math
import subprocess
import sys
import unittest

PROGRAM = sys.argv.pop()
MASS, AMPLITUDE, W, G = 0.01, 0.01, 35, 9.81  # of examples/ball_on_shaker.yaml


def table(t):
    return AMPLITUDE * math.sin(W * t), AMPLITUDE * W * math.cos(W * t)


def next_throw(t):
    """Where the table falls as fast as the ball would, for the first time from t on: A w^2 sin(w t) = g, and rising before."""
    first = math.asin(G / (AMPLITUDE * W**2)) / W
    return first + 2 * math.pi / W * math.ceil((t - first) * W / (2 * math.pi))


def landing(t0):
    """The first time at which the parabola from the throw at t0 meets the table, by bisection after a search in steps of 1e-4 s."""
    z0, v0 = table(t0)

    def gap(t):
        return z0 + v0 * (t - t0) - G * (t - t0)**2 / 2 - table(t)[0]

    low = t0 + 1e-3
    while gap(low + 1e-4) > 0:
        low += 1e-4
    high = low + 1e-4
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if gap(middle) > 0 else (low, middle)
    return high, v0 - G * (high - t0)


class Shaker(unittest.TestCase):
    def test_throws_and_landings_are_those_of_the_closed_form(self):
        run = subprocess.run([PROGRAM], capture_output=True, text=True, check=True, timeout=60)
        rows = [line.split() for line in run.stdout.splitlines()[1:]]
        self.assertGreaterEqual(len(rows), 4)
        self.assertEqual([row[1] for row in rows], ["leaves", "lands"] * (len(rows) // 2))
        thrown = 0
        for t, event, z, z_dot, impulse in rows:
            if event == "leaves":
                expected = next_throw(thrown)
                self.assertEqual(float(impulse), 0)
            else:
                expected, before = landing(thrown)
                # It takes the velocity of the table at once.
                self.assertAlmostEqual(float(impulse), MASS * (table(expected)[1] - before), delta=1e-10)
                self.assertGreater(float(impulse), 1e-4)
            self.assertAlmostEqual(float(t), expected, delta=1e-9)
            self.assertAlmostEqual(float(z), table(expected)[0], delta=1e-9)
            self.assertAlmostEqual(float(z_dot), table(expected)[1], delta=1e-7)
            thrown = expected


if __name__ == "__main__":
    unittest.main()
