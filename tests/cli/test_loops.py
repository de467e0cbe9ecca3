"""Closed loops from guesses that are beside a solution: found, and closed by formulas that know nothing of the generator."""

import json
import math
import os
import random
import re
import subprocess
import unittest

from gauss_gen import MODELS, SOURCE, Evaluate

HARD = SOURCE / "hard_cases" / "models"
BARS = SOURCE / "tests" / "headers" / "rank" / "three_bars.yaml"
X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
SPACE = (X, Y, Z), (0, 0, 0)  # columns are axes, then the origin


def place(frame, at):
    axes, origin = frame
    return tuple(origin[i] + sum(axes[k][i] * at[k] for k in range(3)) for i in range(3))


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def hinge(frame, at, axis, angle):
    """The frame behind a hinge: Rodrigues' formula for each axis."""
    size = math.hypot(*axis)
    k = tuple(a / size for a in axis)

    def turned(v):
        along, across = sum(a * b for a, b in zip(k, v)), cross(k, v)
        return tuple(v[i] * math.cos(angle) + across[i] * math.sin(angle) + k[i] * along * (1 - math.cos(angle)) for i in range(3))

    axes, origin = frame
    zero = (axes, (0, 0, 0))
    return tuple(place(zero, turned(e)) for e in (X, Y, Z)), place((axes, origin), at)


def apart(a, b):
    return max(abs(p - q) for p, q in zip(a, b))


def bricard(q):
    bar = SPACE
    for i, angle in enumerate(q):
        bar = hinge(bar, (1 if i else 0, 0, 0), (0, -1, 0) if i % 2 else Z, angle)
    return max(apart(place(bar, (1, 0, 0)), (-1, 0, 0)), apart(place(bar, (1, -0.5, 0)), (-1, -0.5, 0)))


def bennett(q, u=0.5, d=0.5):
    v = math.asin(1.5 * math.sin(u))
    bar = hinge(SPACE, (0, 0, 0), Z, q[0])
    bar = hinge(bar, (1, 0, 0), (0, -math.sin(u), math.cos(u)), q[1])
    bar = hinge(bar, (1.5, 0, 0), (0, -math.sin(u + v), math.cos(u + v)), q[2])
    axis = place(bar, (1, -d * math.sin(2 * u + v), d * math.cos(2 * u + v)))
    return max(apart(place(bar, (1, 0, 0)), (-1.5, 0, 0)), apart(axis, (-1.5, d * math.sin(v), d * math.cos(v))))


def sarrus(q, l=0.5, r=0.3, d=0.2):
    plate = hinge(hinge(hinge(SPACE, (r, 0, 0), Y, q[0]), (l, 0, 0), Y, q[1]), (l, 0, 0), Y, q[2])
    leg = hinge(hinge(SPACE, (0, r, 0), X, q[3]), (0, l, 0), X, q[4])
    return max(apart(place(leg, (s * d, l, 0)), place(plate, (s * d - r, r, 0))) for s in (-1, 1))


def four_bar(q):
    coupler = hinge(hinge(SPACE, (0, 0, 0), Z, q[0]), (0.2, 0, 0), Z, q[1])
    return apart(place(coupler, (0.6, 0, 0)), place(hinge(SPACE, (0.55, 0, 0), Z, q[2]), (0.5, 0, 0)))


def slider_crank(q):
    rod = hinge(hinge(SPACE, (0, 0, 0), Z, q[0]), (0.1, 0, 0), Z, q[1])
    return apart(place(rod, (0.35, 0, 0)), (q[2], 0.02, 0))


LINKAGES = [(HARD, bricard, 5), (HARD, bennett, 3), (HARD, sarrus, 5), (MODELS, four_bar, 3), (MODELS, slider_crank, 3)]
# In space: a four-bar that a hinge closes, stated by two points on its axis, and a crank whose rod is a body of its own between a hinge and a ball.
HINGED = (("""gauss: 1
name: hinged
joints:
  O: {type: revolute, child: crank, axis: y, coordinates: a, initial: 0.6}
  A: {type: universal, parent: crank, child: coupler, at: [1, 0, 0], axes: [y, z], coordinates: [b, c]}
  C: {type: revolute, child: rocker, axis: y, at: [1.4, 0, 0], coordinates: d, initial_guess: 1.6}
bodies:
  k: {frame: crank, mass: 1, inertia: 0.1, centre: [0.5, 0, 0]}
  l: {frame: coupler, mass: 1, inertia: 0.1, centre: [0.5, 0, 0]}
  r: {frame: rocker, mass: 1, inertia: 0.1, centre: [0.5, 0, 0]}
points:
  B: {on: coupler, at: [1.3, 0, 0]}
  D: {on: rocker, at: [1.1, 0, 0]}
  on_axis: {on: coupler, at: [1.3, 0.2, 0]}
  on_other: {on: rocker, at: [1.1, 0.2, 0]}
constraints: {loop: {coincide: [B, D]}, axis: {coincide: [on_axis, on_other]}}
""", "mobility 1 (4 speeds, 6 constraints of rank 3)"), ("""gauss: 1
name: crank_with_rod
joints:
  O: {type: revolute, child: crank, axis: y, coordinates: a, initial: 0.6}
  P: {type: prismatic, child: slider, axis: x, coordinates: s, initial_guess: 1.5}
  free: {type: free, child: rod, coordinates: [x, y, z], initial_guess: [1, 0, -0.1]}
bodies:
  k: {frame: crank, mass: 1, inertia: 0.1}
  p: {frame: slider, mass: 1, inertia: 0.1}
  r: {frame: rod, mass: 1, inertia: [0.1, 0.2, 0.3]}
points:
  pin: {on: crank, at: [0.5, 0, 0]}
  pin_end: {on: crank, at: [0.5, 0.1, 0]}
  big: {on: rod, at: [-0.6, 0, 0]}
  big_end: {on: rod, at: [-0.6, 0.1, 0]}
  small: {on: rod, at: [0.6, 0, 0]}
  wrist: {on: slider, at: [0, 0, 0]}
constraints: {hinge: {coincide: [big, pin]}, axis: {coincide: [big_end, pin_end]}, ball: {coincide: [small, wrist]}}
""", "mobility 1 (8 speeds, 9 constraints of rank 7)"))
DOOR = """gauss: 1
name: leaning_door
frames: {post: {orientation: {axis: y, angle: LEAN}}}
joints: {ball: {type: spherical, parent: post, child: door}}
bodies: {leaf: {frame: door, mass: 20, inertia: [5, 7, 3], centre: [0.5, 0, 1]}}
points: {top: {on: door, at: [0, 0, 2]}, eye: {on: post, at: [0, 0, 2]}}
constraints: {pin: {coincide: [top, eye], in: post}}
forces: {gravity: {uniform: [0, 0, -9.81]}}
"""
AWAY = (1e-6, 1e-4, 0.01, 0.1, 0.3)
MAIN = """#include "NAME.hpp"
#include <cstdio>
int main() {
  gauss::NAME::State<double> state;
  if (initial_state(gauss::NAME::prepare(gauss::NAME::Parameters<double>{}), state) != gauss::Status::ok) return 1;
  for (const double value : state.values) std::printf("%.17g\\n", value);
}
"""


class Loops(Evaluate):
    def angles(self, text):
        done = self.run_it("evaluate", "-", stdin=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        return {name: float(value) for name, value in re.findall(r"(?m)^  (\w+) +(-?\d\S*) +(?:rad|m)$", done.stdout)}

    def test_guesses_beside_a_solution_lead_to_one(self):
        for folder, closure, count in LINKAGES:
            text = (folder / f"{closure.__name__}.yaml").read_text(encoding="utf-8")
            names = re.findall(r"coordinates: (\w+), initial", text)
            self.assertEqual(len(names), count)
            solved = self.angles(text)
            # As in the file, and with nothing given but guesses.
            for start in (text, re.sub(r"(coordinates: \w+, )initial:", r"\1initial_guess:", text)):
                for away in AWAY:
                    numbers = random.Random(f"{closure.__name__} {away}")

                    def beside(match):
                        return match[1] + f"{solved[match[2]] + away * numbers.uniform(-1, 1):.7f}"

                    with self.subTest(linkage=closure.__name__, away=away, all_open=start != text):
                        moved = re.sub(r"(coordinates: (\w+), initial_guess: )-?[\d.]+", beside, start)
                        checked = self.run_it("-", "--check", stdin=moved)
                        self.assertNotIn("error", checked.stderr)
                        found = self.angles(moved)
                        self.assertLess(closure([found[name] for name in names]), 1e-14)
                        # Near the guesses, and not somewhere along the motion.
                        if away <= 0.01:
                            self.assertLess(max(abs(found[name] - solved[name]) for name in names), 4 * away)

    # Which of equations that follow from others a step takes first is for rounding to decide, and far from a solution the place that it leads to.
    def test_emitted_code_starts_where_evaluate_says(self):
        for linkage, guesses, is_warned in (("bennett", "1 -2.5 -1", True), ("bennett", "1.7 -3.7 -1.7", True),
                                            ("bennett", "1.7270113 -3.7076231 -1.7270113", False), ("bricard", None, False)):
            text = (HARD / f"{linkage}.yaml").read_text(encoding="utf-8")
            for guess in (guesses or "").split():
                text = re.sub(r"initial_guess: -?[\d.]+", f"initial_GUESS: {guess}", text, count=1)
            text = text.replace("GUESS", "guess")
            with self.subTest(linkage=linkage, guesses=guesses):
                self.assert_starts_alike(linkage, text, is_warned)

    # Folded, its crank and its frame cover each other, and the other two bars turn as one: all places near may be those, where a constraint has one rank less.
    def test_a_kite_starts_on_the_branch_where_it_is_open(self):
        text = (MODELS / "four_bar.yaml").read_text(encoding="utf-8")
        for length, value in (("L1: {value: 0.2", 0.3), ("L2: {value: 0.6", 0.7), ("L3: {value: 0.5", 0.7), ("L4: {value: 0.55", 0.3)):
            self.assertIn(length, text)
            text = text.replace(length, f"{length.split()[0]} {{value: {value}")
        state = self.assert_starts_alike("four_bar", text, False)
        # Mirrored in the line from the coupler's joint with the rocker to the frame's with the crank.
        self.assertLess(abs(state["gamma"] + state["beta"]), 1e-12)

    def assert_starts_alike(self, name, text, is_warned):
        """Emitted code and evaluate; the state."""
        done = self.run_it("-", "-o", ".", "--outputs=initial_state", stdin=text)
        self.assertEqual((done.returncode, "W068" in done.stderr), (0, is_warned), done.stderr)
        source = self.write("main.cpp", MAIN.replace("NAME", name))
        subprocess.run([os.environ["GAUSS_CXX"], "-std=c++17", "-I.", source, "-o", "main"], cwd=self.folder, check=True)
        emitted = subprocess.run(["./main"], cwd=self.folder, check=True, capture_output=True, text=True).stdout.split()
        said = self.run_it("evaluate", "-", "--format=json", stdin=text)
        state = {name: float(of["value"]) for name, of in json.loads(said.stdout)["state"].items() if name != "t"}
        self.assertEqual(len(state), len(emitted))
        for (name, value), start in zip(state.items(), emitted):
            self.assertLess(abs(value - float(start)), 2e-12 * max(1, abs(value)), name)
        return state

    def test_a_loop_that_cannot_be_closed_is_refused(self):
        bennett_twisted = (HARD / "bennett.yaml").read_text(encoding="utf-8").replace("asin(1.5*sin(u))", "asin(1.5*sin(u)) + TWIST")
        for twist in ("0.1", "1e-3", "1e-6"):
            text = bennett_twisted.replace("TWIST", twist)
            self.assertRegex(self.refused(1, "-", "--check", stdin=text), r"error\[E0[78]0\]")
        # One that rounding of a double explains is none.
        self.assertNotIn("error", self.run_it("-", "--check", stdin=bennett_twisted.replace("TWIST", "1e-14")).stderr)
        four_bar_short = (MODELS / "four_bar.yaml").read_text(encoding="utf-8").replace("L2: {value: 0.6", "L2: {value: 3")
        self.assertRegex(self.refused(1, "-", "--check", stdin=four_bar_short), r"error\[E0[78]0\]")

    # A slab on three parallel bars, one constraint too many: it moves unless the middle pivot is out of place.
    def test_rank_is_the_same_wherever_a_loop_stands_and_whatever_its_units(self):
        text = BARS.read_text(encoding="utf-8")
        for at in ("[-h, 0, 0]}\n  A2", "[d, 0, 0]", "[h, 0, 0]}\n  B1"):
            self.assertIn(at, text)
            text = text.replace(at, at.replace("[", "[X + ", 1))
        text = text.replace("{unit: m, initial: 0}", "{unit: m, initial: X}")
        for metre in ("1e-9", "1", "1e9"):
            for away in ("0", "1e3", "1e4", "1e5", "1e6", "-1e8"):
                for d, found in (("0", "mobility 1 (3 speeds, 3 constraints of rank 2)"), ("1e-3", "mobility 0 (3 speeds, 3 constraints)")):
                    with self.subTest(metre=metre, away=away, d=d):
                        of_size = (text.replace("h: {value: 1,", f"h: {{value: {metre},")
                                   .replace("d: {value: 0, unit: m}", f"d: {{value: {d}*{metre}, unit: m}}\n  X: {{value: {away}*{metre}, unit: m}}")
                                   .replace("J: {value: 0.1,", f"J: {{value: 0.1*{metre}*{metre},"))
                        self.assertIn(found, self.run_it("-", "--check", stdin=of_size).stdout)

    # Grübler's count is 0 or less for both.
    def test_what_a_plane_holds_twice_moves(self):
        for text, found in HINGED:
            said = self.run_it("-", "--check", stdin=text)
            self.assertIn(found, said.stdout)
            self.assertNotIn("W057", said.stderr)

    # A ball and a pin on one line: the pin holds the door's distance from the ball only to second order.
    def test_a_door_on_a_leaning_post_swings(self):
        for lean in (0, 0.05, 0.1, 0.15, 0.3, math.pi / 6, 1):
            with self.subTest(lean=lean):
                said = self.run_it("-", "--check", stdin=DOOR.replace("LEAN", str(lean)))
                self.assertIn("mobility 1 (3 speeds, 3 constraints of rank 2)", said.stdout)
                self.assertNotIn("W057", said.stderr)
                self.assertIn("constraint 'pin_z' holds nothing", said.stderr)
                self.assertNotIn("square", said.stderr)

    def test_a_gradient_does_not_vanish_since_a_place_is_far_off(self):
        text = ("gauss: 1\nname: far\ncoordinates: {x: {initial: 1000001.5}, y: {initial: 0}}\n"
                "particles: {p: {mass: 1, position: [x, y, 0]}}\nconstraints: {rod: {equation: (x - 1e6)^2 + y^2 - 1}}\n")
        said = self.refused(1, "-", "--check", stdin=text)
        self.assertNotIn("W071", said)
        self.assertIn("violates constraint 'rod' by 1.25", said)


if __name__ == "__main__":
    unittest.main()
