"""What examples/long_swing.cpp prints: bar and energy stay where they were, for a thousand seconds."""

import subprocess
import sys
import unittest

PROGRAM = sys.argv.pop()


class LongSwing(unittest.TestCase):
    def test_bar_and_energy_are_kept(self):
        run = subprocess.run([PROGRAM], capture_output=True, text=True, check=True, timeout=60)
        rows = [line.split() for line in run.stdout.splitlines()[1:11]]
        self.assertEqual([float(row[0]) for row in rows], [100.0 * k for k in range(1, 11)])
        for t, _, bar, _, energy, _ in rows:
            self.assertLess(abs(float(bar)), 1e-14, t)
            self.assertLess(abs(float(energy)), 1e-10, t)


if __name__ == "__main__":
    unittest.main()
