"""The printed table of examples/turntable.cpp against the closed form of Earnshaw (1844)."""

import math
import subprocess
import sys
import unittest

PROGRAM = sys.argv.pop()

# models/sphere_turntable.yaml
M, OMEGA, G = 0.7, 3, 9.81
X, Y = 0.5, 0.1
V_X, V_Y = 0.3, 0.8

RATE = 2 / 7 * OMEGA  # of the centre on its circle: a = RATE * e_z x v
PRINTED = 0.51e-4  # half of the last digit


def centre_and_velocity(t):
    c, s = math.cos(RATE * t), math.sin(RATE * t)
    return (X + (V_X * s - V_Y * (1 - c)) / RATE, Y + (V_Y * s + V_X * (1 - c)) / RATE), (V_X * c - V_Y * s, V_X * s + V_Y * c)


class Turntable(unittest.TestCase):
    def test_the_ball_runs_along_a_circle_and_friction_points_to_its_centre(self):
        run = subprocess.run([PROGRAM], capture_output=True, text=True, check=True, timeout=60)
        rows = [[float(cell) for cell in line.split()] for line in run.stdout.splitlines()[1:]]
        # Longer than one turn.
        self.assertGreater(rows[-1][0] * RATE, 2 * math.pi)
        for t, *printed in rows:
            (x, y), (v_x, v_y) = centre_and_velocity(t)
            exact = (x, y, -M * RATE * v_y, M * RATE * v_x, M * G)
            for value, expected in zip(printed, exact, strict=True):
                self.assertAlmostEqual(value, expected, delta=PRINTED, msg=f"t = {t}: {printed}, exact {exact}")


if __name__ == "__main__":
    unittest.main()
