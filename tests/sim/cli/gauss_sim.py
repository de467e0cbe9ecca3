"""Runs gauss-sim as a user would. $GAUSS_SIM is the program, $GAUSS_SOURCE_DIR the checkout."""

import csv
import json
import math
import os
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

PROGRAM = os.environ["GAUSS_SIM"]
MODELS = Path(os.environ["GAUSS_SOURCE_DIR"]) / "models"

# A ball on a spring: x = cos(w t), in one coordinate, so that it compiles at once.
SPRING = """gauss: 1
name: spring
parameters:
  m: {value: 2, unit: kg}
  k: {value: 8, unit: N/m}
coordinates:
  x: {unit: m, initial: 1}
particles:
  bob: {mass: m, position: [x, 0, 0]}
forces:
  pull: {potential: k*x^2/2}
"""

# A body that friction stops, at v0^2/(2 mu 9.81): the force jumps there.
SLIDE = """gauss: 1
name: slide
parameters: {m: 1, mu: 0.3, v0: 2}
coordinates: {x: {initial: 0, initial_rate: v0}}
particles: {p: {mass: m, position: [x, 0, 0]}}
forces: {friction: {generalized: {x: "piecewise(dot(x) > 0, -mu*m*9.81, 0)"}}}
"""

# A push that is shorter than steps of a motion at rest: x(10) = 6.7 w sqrt(pi).
PUSHED = """gauss: 1
name: pushed
parameters: {w: 0.02, m: 1}
coordinates: {x: {initial: 0, initial_rate: 0}}
particles: {p: {mass: m, position: [x, 0, 0]}}
forces: {push: {generalized: {x: "exp(-((t - 3.3)/w)^2)"}}}
"""

# A weight on a spring that is hit for 1.4 ms each second, at its quarter.
HAMMER = """gauss: 1
name: hammer
parameters: {m: 2, k: 30, c: 0.3, F: 500, th: 0.99999, x0: 0.01}
coordinates: {x: {initial: x0}}
particles: {p: {mass: m, position: [x, 0, 0]}}
forces: {s: {generalized: {x: "-k*x - c*dot(x) + piecewise(sin(2*pi*t) > th, F, 0)"}}}
"""


def hammered(t, blows=10):
    """Where it is: what is left of the start, and the answers to steps of the force, up and down again."""
    d, stiffness, force, half = 0.3 / 4, 30, 500, math.acos(0.99999) / (2 * math.pi)
    w = math.sqrt(stiffness / 2 - d * d)

    def left(t):
        return math.exp(-d * t) * (math.cos(w * t) + d / w * math.sin(w * t)) if t > 0 else 1

    edges = [(sign, n + 0.25 + sign * half) for n in range(blows) for sign in (-1, 1)]
    return 0.01 * left(t) - sum(sign * force / stiffness * (1 - left(t - edge)) for sign, edge in edges)


class Program(unittest.TestCase):
    """Each test has an empty working folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="gauss sim ")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_it(self, *arguments, **more):
        more.setdefault("timeout", 120)
        more.setdefault("cwd", self.folder)
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False, **more)

    def ok(self, *arguments, **more):
        result = self.run_it(*arguments, **more)
        self.assertEqual(result.returncode, 0, (arguments, result.stderr))
        return result.stdout

    def refused(self, code, *arguments, **more):
        """Standard error of a run that ends with `code` and leaves nothing behind."""
        before = self.files()
        result = self.run_it(*arguments, **more)
        self.assertEqual(result.returncode, code, (arguments, result.stdout, result.stderr))
        self.assertEqual(self.files(), before)
        return result.stderr

    def wait_for_processor(self, process, seconds):
        """Until it has computed for so long, without those that it has started."""
        deadline = time.monotonic() + 100
        while time.monotonic() < deadline and process.poll() is None:
            fields = Path(f"/proc/{process.pid}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()
            if (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK") > seconds:
                return
            time.sleep(0.01)

    def stopped_while_writing(self, pattern, *arguments):
        """Exit status and standard error of a run that gets Ctrl-C once a file of this pattern has some rows."""
        process = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 60
        while not [path for path in self.folder.glob(pattern) if path.stat().st_size > 4096] and time.monotonic() < deadline:
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        said = process.communicate(timeout=60)[1]
        return process.returncode, said

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    def table(self, name):
        """Columns by their headers."""
        with open(self.folder / name, encoding="utf-8", newline="") as file:
            rows = list(csv.reader(file))
        return {header: [float(row[i]) for row in rows[1:]] for i, header in enumerate(rows[0])}

    def summary(self, name):
        return json.loads((self.folder / name).read_text(encoding="utf-8"))


class Regimes(Program):
    """Motions through contacts, dry friction and links that break."""

    # Compiling a regime takes longer than most of these motions. Both engines have the same bits: scenes that are shipped are compiled, and with
    # `./run test --thorough` all of these, too.
    INTERPRETED = () if os.environ.get("GAUSS_ALL_MODELS") == "1" else ("--engine", "interpreted")

    def go(self, text, *arguments, name="x", timeout=7):
        """Columns of the table by their names without units, and events."""
        self.write("model.yaml", text)
        if "--engine" not in arguments:
            arguments += self.INTERPRETED
        self.ok("run", "model.yaml", "-q", "-o", f"{name}.csv", *arguments, timeout=timeout)
        table = self.table(f"{name}.csv")
        return {header.split(" ")[0]: column for header, column in table.items()}, self.events(f"{name}.events.csv")

    def events(self, name):
        """Instant, words and impulse of each."""
        with open(self.folder / name, encoding="utf-8", newline="") as file:
            rows = list(csv.reader(file))
        self.assertEqual([head.split(" ")[0] for head in rows[0]], ["t", "event", "impulse"])
        return [(float(t), what, float(impulse)) for t, what, impulse in rows[1:]]

    def instants(self, events, what):
        return [t for t, words, _ in events if words == what]
