"""The ensemble begins as narrow as it is set, and a double pendulum swung from the horizontal is chaotic: it does not stay so."""

import math
import subprocess
import sys

lines = subprocess.run(sys.argv[1:], check=True, capture_output=True, text=True).stdout.splitlines()
spread = {int(time): float(value) for time, value in (line.split() for line in lines[2:])}
assert int(lines[0].split()[0]) >= 1, lines[0]
assert sorted(spread) == list(range(0, 21, 2)), spread
# 1.7e-5 rad, uniformly.
assert math.isclose(spread[0], 1.7e-5 / math.sqrt(12), rel_tol=1e-2), spread
assert spread[4] < 1e-4 and spread[20] > 0.1, spread
