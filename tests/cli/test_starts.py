"""Where the searches of `gauss-gen evaluate` for a state begin, and where they end."""

import json
import math
import os
import re
import subprocess
import unittest

from gauss_gen import SOURCE, Evaluate


class Starts(Evaluate):
    def test_a_frame_that_lends_its_axes_does_not_move_to_close_a_loop(self):
        bars = """gauss: 1
name: bars
joints:
  a: {type: revolute, child: one, initial: 1.2}
  b: {type: revolute, parent: one, child: two, at: [1, 0, 0], initial_guess: -1}
  c: {type: revolute, child: three, at: [2.2, 0, 0], initial_guess: 1.5}
  w: {type: revolute, child: wheel, coordinates: psi, initial_guess: 0.7}
bodies:
  one: {mass: 1, inertia: 0.1}
  two: {mass: 2, inertia: 0.3}
  three: {mass: 3, inertia: 0.2}
  wheel: {mass: 0.01, inertia: 0.001}
points: {p: {on: two, at: [2, 0, 0]}, q: {on: three, at: [1.2, 0, 0]}}
constraints: {close: {coincide: [p, q], in: wheel}}
"""
        found = self.document("-", stdin=bars)
        self.assertEqual(found["status"], "ok")
        self.close(found["state"]["psi"]["value"], "0.7")
        self.close(found["state"]["b"]["value"], self.document("-", stdin=bars.replace(", in: wheel", ""))["state"]["b"]["value"])

    def test_a_search_that_ran_away_has_found_nothing(self):
        # From 3e7 rad a sine has lost digits, but not all: a distance of 4 is not 2.
        circle = """gauss: 1
name: circle
coordinates: {x: {initial: 3}, y: {initial: 4}, a: {initial_guess: 0.3}}
particles: {p: {mass: 1, position: [x, y, 0]}, q: {mass: 1, position: [cos(a), sin(a), 0]}}
constraints: {d: {distance: [p, q], is: 2}}
"""
        done = self.run_it("evaluate", "-", "--assemble", "--format=json", stdin=circle)
        state = {name: float(entry["value"]) for name, entry in json.loads(done.stdout)["state"].items()}
        self.assertEqual(json.loads(done.stdout)["status"], "ok")
        self.assertLess(abs(state["a"]), 4)
        self.assertAlmostEqual(math.dist((state["x"], state["y"]), (math.cos(state["a"]), math.sin(state["a"]))), 2, 12)
        done = self.run_it("evaluate", "-", "--set", "a=3e7", "--set", "x=1", "--set", "y=1", stdin=circle)
        self.assertIn("not to be trusted: violated_constraints", done.stdout)

    def test_a_guess_of_a_speed_chooses_among_two(self):
        for guess in (3, -3):
            model = """
gauss: 1
name: two
coordinates: {x: {}, y: {}}
speeds: {u: {is: dot(x) + dot(y), initial_guess: GUESS}, w: {is: dot(x) - dot(y), initial: 1}}
particles: {p: {mass: 1, position: [x, y, 0]}}
constraints: {c: {velocity: u^2 + w^2 - 5}}
"""
            out = self.ok("evaluate", "-", "--format=json", stdin=model.replace("GUESS", str(guess)))
            self.assertAlmostEqual(float(json.loads(out)["state"]["u"]["value"]), 2 if guess > 0 else -2, 14)

    def test_a_start_that_newton_finds_to_all_digits_has_a_value(self):
        # A slotted lever, turned by a pin on a crank: the last steps of the search are nothing but rounding, at each instant another
        # way.
        lever = """
gauss: 1
name: lever
parameters: {r: 0.1, d: 0.25}
coordinates: {phi: {held_at: 6*t}}
joints:
  crank: {type: revolute, child: crank, axis: -y, at: [0, 0, d], coordinates: phi}
  pin: {type: revolute, parent: crank, at: [r, 0, 0], child: block, axis: -y, coordinates: beta}
  lever: {type: revolute, child: lever, axis: -y, coordinates: a, initial_guess: 1.2}
  ram: {type: prismatic, child: ram, at: [0, 0, 0.5], axis: x, coordinates: x}
bodies: {lever: {mass: 0, inertia: 0.05}, block: {mass: 0.3, inertia: 0}, ram: {mass: 5, inertia: 0}}
constraints:
  slot: {equation: block.x*sin(a) - block.z*cos(a)}
  turn: {equation: phi + beta - a}
  top: {equation: ram.x*sin(a) - ram.z*cos(a)}
quantities: {rate: dot(a), form: 6*(r^2 + r*d*sin(phi))/(r^2 + d^2 + 2*r*d*sin(phi))}
"""
        for time in ("0.3", "0.3102", "1.0857", "1/2"):
            found = self.document("-", "--time", time, stdin=lever)
            self.assertEqual(found["status"], "ok", time)
            self.close(found["quantities"]["rate"]["value"], found["quantities"]["form"]["value"])

    def test_where_two_roots_are_one_a_start_is_in_all_digits(self):
        toggle = """gauss: 1
name: toggle
coordinates: {x: {initial_guess: 1.1}, z: {initial_guess: 0.3}}
particles: {p: {mass: 1, position: [x, 0, z]}}
points: {A: {at: [0, 0, 0]}, B: {at: [SPAN, 0, 0]}}
constraints: {c: {distance: [p, A], is: 1}, d: {distance: [p, B], is: 1}}
forces: {gravity: {uniform: [0, 0, -9.81]}}
"""
        # Stretched, the rods say the same of the height, and no force in them holds the weight.
        done = self.run_it("evaluate", "-", stdin=toggle.replace("SPAN", "2"))
        self.assertIn("not to be trusted: dependent_constraints", done.stdout)
        self.assertIn("constraint 'd' follows from constraint 'c' here", done.stderr)
        found = self.document("-", stdin=toggle.replace("SPAN", "1.99"))
        self.assertEqual(found["status"], "ok")
        self.close(found["multipliers"]["c"]["value"], 9.81 / 2 / math.sqrt(1 - 0.995**2), 12)

    def test_a_crank_starts_at_its_dead_centre(self):
        # Angles follow from the place of the slider, which is as far out as it gets: x is stationary there, and 0 = a q' + b (q' + p').
        dead = """gauss: 1
name: dead
parameters: {a: 0.3, b: 0.8, F: 2}
coordinates: {x: {initial: a + b, initial_rate: 0}}
joints:
  c: {type: revolute, child: crank, axis: z, coordinates: q, initial_guess: 0.3, initial_rate: 2}
  r: {type: revolute, parent: crank, child: rod, at: [a, 0, 0], axis: z, coordinates: p, initial_guess: -0.4}
  s: {type: prismatic, child: slider, axis: x, coordinates: x}
bodies:
  crank: {mass: 1, inertia: 0.01, centre: [a/2, 0, 0]}
  rod: {mass: 1, inertia: 0.05, centre: [b/2, 0, 0]}
  slider: {mass: 1}
points: {e: {on: rod, at: [b, 0, 0]}}
constraints: {pin: {coincide: [e, slider]}}
forces: {push: {force: [-F, 0, 0], on: slider}}
"""
        found = json.loads(self.run_it("evaluate", "-", "--format=json", stdin=dead).stdout)
        self.assertEqual(found["status"], "ok")
        for name, value in (("q", 0), ("p", 0), ("q_dot", 2), ("p_dot", -2.75)):
            self.assertEqual(float(found["state"][name]["value"]), value, name)
        # x'' = -a q'^2 - b (q' + p')^2 = -1.2 - 0.45
        self.close(found["accelerations"]["x_ddot"]["value"], -1.65)
        said = self.run_it("-", "-o", ".", stdin=dead)
        self.assertEqual(said.returncode, 0, said.stderr)

    def test_a_dead_centre_of_one_angle_is_one(self):
        for length in (1, 1000):
            dead = f"""gauss: 1
name: dead
parameters: {{r: {0.3 * length}, l: {0.8 * length}}}
coordinates: {{phi: {{initial_guess: 0.3, initial_rate: 2}}, s: {{initial: r + l, initial_rate: 0}}}}
bodies: {{crank: {{mass: 1, inertia: {0.01 * length**2}, position: [0, 0, 0], orientation: {{axis: z, angle: phi}}}}}}
particles: {{slider: {{mass: 1, position: [s, 0, 0]}}}}
points: {{pin: {{on: crank, at: [r, 0, 0]}}}}
constraints: {{rod: {{distance: [pin, slider], is: l}}}}
forces: {{push: {{force: [-2, 0, 0], on: slider}}}}
"""
            found = json.loads(self.run_it("evaluate", "-", "--format=json", stdin=dead).stdout)
            self.assertEqual((found["status"], float(found["state"]["phi"]["value"])), ("ok", 0))
            # s'' = -r w^2 - (r w)^2/l
            self.close(found["accelerations"]["s_ddot"]["value"], -1.65 * length)

    def test_a_square_that_holds_nothing_is_not_trusted(self):
        for law in ("(x - 0.5)^2", "(x - 0.5)^3", "(x - 0.5)^2 + (y - 0.5)^2"):
            wall = f"""gauss: 1
name: wall
coordinates: {{x: {{initial_guess: 0.4}}, y: {{initial_guess: 0.3}}}}
particles: {{p: {{mass: 1, position: [x, y, 0]}}}}
constraints: {{c: {{equation: "{law}"}}}}
forces: {{push: {{force: [3, 3, 0], on: p}}}}
"""
            done = self.run_it("evaluate", "-", stdin=wall)
            self.assertIn("not to be trusted: dependent_constraints", done.stdout, law)
            self.assertIn("'c' holds nothing", done.stderr)
            self.run_it("-", "-o", ".", stdin=wall)
            program = self.folder / "rates.cpp"
            program.write_text("""#include <cstdio>
#include "wall.hpp"
int main() {
  using namespace gauss::wall;
  const auto prepared = prepare(Parameters<double>{});
  State<double> state;
  Derivative<double> derivative;
  (void)initial_state(prepared, state);
  std::puts(gauss::name(rhs(0.0, state, {}, prepared, derivative)));
}
""")
            subprocess.run([*os.environ["GAUSS_CXX"].split(), "-std=c++17", "-o", "rates", program.name], cwd=self.folder, check=True)
            self.assertEqual(subprocess.run([self.folder / "rates"], capture_output=True, text=True, check=True).stdout, "dependent constraints\n", law)

    def test_angular_velocities_that_constraints_move_begin_where_they_are(self):
        # In the metric of these inertias; what is not in the constraint stays. From 0 the search has no way to go.
        turning = """gauss: 1
name: turning
orientations:
  att: {quaternion: [e0, e1, e2, e3], angular_velocity: [wx, wy, wz], initial_angular_velocity: {STATED}}
bodies: {b: {mass: 0.6, position: [0, 0, 0], inertia: [0.2, 0.25, 0.3], orientation: att}}
constraints: {c: {velocity: wy^2 + 0.95*wz^2 - 0.74}}
"""
        done = self.run_it("evaluate", "-", "--assemble", "--format=json", stdin=turning.replace("{STATED}", "[-0.97, -0.54, -0.10]"))
        self.assertEqual(re.findall(r"assembled (\w+):", done.stderr), ["wy", "wz"])
        found = json.loads(done.stdout)
        self.assertEqual(found["status"], "ok")
        wx, wy, wz = (float(found["state"][name]["value"]) for name in ("wx", "wy", "wz"))
        self.assertEqual(wx, -0.97)
        self.assertAlmostEqual(wy**2 + 0.95 * wz**2, 0.74, 15)
        self.assertLess(math.dist((wy, wz), (-0.85, -0.15)), 0.01)
        refused = self.refused(1, "-", "--check", stdin=turning.replace("{STATED}", "{wx: 1, wz: 0}"))
        self.assertIn("hint: wy is open: state about what it is in 'initial_angular_velocity', and let 'gauss-gen --assemble' move it from there", refused)

    def pasted(self, text):
        """Hints of W068 in the place of the guesses of coordinates or joints."""
        said = self.run_it("--check", "-", stdin=text).stderr
        found = re.findall(r"'initial_guess: ([^']*)' at (?:coordinate|joint) '(\w+)'", said)
        self.assertTrue(found, said)
        for value, name in found:
            text = re.sub(rf"(\b{name}: {{[^}}]*initial_guess: )[^,}}]*", rf"\g<1>{value}", text)
        return text, said

    def test_what_w068_prints_is_taken_when_it_is_written_down(self):
        # A place that two bars of 1 m hold, 2000 km off the origin: with six digits it is another one.
        for origin in (0, 1e3, 1e6, 1e9):
            far = f"""gauss: 1
name: far
coordinates: {{x: {{initial_guess: {origin + 1}}}, y: {{initial_guess: {2 * origin}}}}}
particles: {{p: {{mass: 1, position: [x, y, 0]}}}}
points: {{A: {{at: [{origin}, {2 * origin}, 0]}}, B: {{at: [{origin + 1.5}, {2 * origin}, 0]}}}}
constraints: {{c: {{distance: [p, A], is: 1}}, d: {{distance: [p, B], is: 1}}}}
"""
            text, said = self.pasted(far)
            self.assertIn("W068", said)
            self.assertNotIn("W068", self.run_it("--check", "-", stdin=text).stderr, text)
            first, second = (json.loads(self.run_it("evaluate", "-", "--format=json", stdin=model).stdout)["state"] for model in (far, text))
            for name in "xy":
                self.assertAlmostEqual(float(first[name]["value"]), float(second[name]["value"]), 6 if origin > 1e6 else 8)

    def test_angles_come_back_by_the_whole_turns_that_a_search_has_wound_them(self):
        arm = """gauss: 1
name: arm
joints:
  a: {type: revolute, child: one, initial_guess: 1.2}
  b: {type: revolute, parent: one, child: two, at: [1, 0, 0], initial_guess: 0.002}
bodies: {one: {mass: 1, inertia: 0.1}, two: {mass: 2, inertia: 0.3}}
points: {p: {on: two, at: [1, 0, 0]}}
constraints: {px: {equation: p.x - 1}, py: {equation: p.y - 0.7}}
"""
        done = self.run_it("evaluate", "-", "--format=json", stdin=arm)
        self.assertIn("whole turns on", done.stderr)
        state = {name: float(entry["value"]) for name, entry in json.loads(done.stdout)["state"].items()}
        for name, guess in (("a", 1.2), ("b", 0.002)):
            self.assertLess(abs(state[name] - guess), math.pi)
        self.assertAlmostEqual(math.cos(state["a"]) + math.cos(state["a"] + state["b"]), 1, 13)
        self.assertAlmostEqual(math.sin(state["a"]) + math.sin(state["a"] + state["b"]), 0.7, 13)
        self.assertNotIn("W068", self.run_it("--check", "-", stdin=self.pasted(arm)[0]).stderr)

    def test_angles_are_within_half_a_turn_of_their_guesses(self):
        loop = """gauss: 1
name: loop
joints:
  slide: {type: prismatic, child: slider, axis: x, coordinates: s, initial: 1}
  hinge: {type: revolute, parent: slider, child: rod, axis: z, coordinates: q, initial_guess: Q}
  crank: {type: revolute, child: arm, axis: z, coordinates: p, initial_guess: P}
bodies: {slider: {mass: 1}, rod: {mass: 1, inertia: 0.1}, arm: {mass: 1, inertia: 0.1}}
points: {a: {on: rod, at: [0.9, 0, 0]}, b: {on: arm, at: [0.6, 0, 0]}}
constraints: {close: {coincide: [a, b]}}
"""
        for q in (0.5, 2, 4):
            for p in (-1, 0.8, 1, 2, 3):
                done = self.run_it("evaluate", "-", "--format=json", stdin=loop.replace("Q", str(q)).replace("P", str(p)))
                state = {name: float(entry["value"]) for name, entry in json.loads(done.stdout)["state"].items()}
                self.assertLess(abs(state["q"] - q), math.pi, (q, p))
                self.assertLess(abs(state["p"] - p), math.pi, (q, p))
                self.assertAlmostEqual(1 + 0.9 * math.cos(state["q"]), 0.6 * math.cos(state["p"]), 13)
                self.assertAlmostEqual(0.9 * math.sin(state["q"]), 0.6 * math.sin(state["p"]), 13)

    def test_a_wheel_that_has_to_turn_many_times_does(self):
        rack = """gauss: 1
name: rack
coordinates: {x: {initial: 3}, a: {initial_guess: 0}}
particles: {p: {mass: 1, position: [x, 0, 0]}, q: {mass: 1, position: [cos(a), sin(a), 0]}}
constraints: {mesh: {equation: x - 0.1*a}}
"""
        self.close(self.document("-", stdin=rack)["state"]["a"]["value"], "30")

    def test_guesses_of_rates_are_asked_for_when_positions_fit(self):
        text = (SOURCE / "tests" / "diagnostics" / "e070_positions_first.yaml").read_text(encoding="utf-8")
        self.assertNotIn("initial_rate_guess", self.refused(1, "-", "--check", stdin=text))
        self.assertIn("initial_rate_guess", self.refused(1, "-", "--check", stdin=text.replace("at: [9, 0, 0]", "at: [4, 0, 0]")))


if __name__ == "__main__":
    unittest.main()
