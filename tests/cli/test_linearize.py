"""`gauss-gen linearize`, against eigenvalues and matrices that were published or are worked out by hand."""

import cmath
import json
import math
import unittest

from gauss_gen import MODELS, SOURCE, Program

G = 9.81
PENDULUM = """gauss: 1
name: pendulum
parameters: {m: {value: 2, unit: kg}, l: {value: 0.8, unit: m}, g: {value: 9.81, unit: m/s^2}, c: {value: 0, unit: N*m*s}}
inputs: {T: {unit: N*m}}
coordinates: {theta: {unit: rad, initial: 0, initial_rate: 0}}
particles: {bob: {mass: m, position: [l*sin(theta), 0, -l*cos(theta)]}}
forces: {gravity: {uniform: [0, 0, -g]}, drive: {generalized: {theta: T - c*dot(theta)}}}
"""
# A pole of mass m on a cart of mass M, at an angle from upright, driven by a force F on the cart.
CART = """gauss: 1
name: cart_pole
parameters: {M: 1.5, m: 0.3, l: 0.6, g: 9.81}
inputs: {F: {}}
coordinates: {x: {initial: 0, initial_rate: 0}, theta: {initial: 0, initial_rate: 0}}
particles:
  cart: {mass: M, position: [x, 0, 0]}
  pole: {mass: m, position: [x + l*sin(theta), 0, l*cos(theta)]}
forces: {gravity: {uniform: [0, 0, -g]}, push: {generalized: {x: F}}}
"""
# The same pendulum in two coordinates and a constraint: dependent ones follow, also where the rope is not vertical.
ROPE = """gauss: 1
name: rope
parameters: {m: 2, l: 0.8, g: 9.81, F: 5}
coordinates: {x: {initial: 0, initial_rate: 0}, z: {initial_guess: -1}}
particles: {bob: {mass: m, position: [x, 0, z]}}
points: {top: {at: [0, 0, 0]}}
constraints: {rope: {distance: [bob, top], is: l}}
forces: {gravity: {uniform: [0, 0, -g]}, wind: {generalized: {x: F}}}
"""
DRIFTING = """gauss: 1
name: drifting
parameters: {m: 2, k: 30}
coordinates: {a: {initial: 0, initial_rate: 1}, b: {initial: 1, initial_rate: 1}}
particles: {one: {mass: m, position: [a, 0, 0]}, two: {mass: m, position: [b, 0, 0]}}
forces: {spring: {potential: "k*(b - a - 1)^2/2"}}
"""


class Linearize(Program):
    def linear(self, model, *more, stderr=""):
        is_text = isinstance(model, str)
        result = self.run_it("linearize", "-" if is_text else model, "--format=json", *more, stdin=model if is_text else None)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(stderr, result.stderr)
        if not stderr:
            self.assertEqual(result.stderr, "")
        found = json.loads(result.stdout)
        self.assertEqual(found["status"], "ok")
        self.names = [state["name"] for state in found["states"]]
        return found

    def eigenvalues(self, found):
        return [complex(float(e["real"]), float(e["imaginary"])) for e in found["eigenvalues"]]

    def others_than_zero(self, found):
        return [e for e in self.eigenvalues(found) if e != 0]

    def entry(self, found, matrix, rate, by):
        columns = self.names if matrix == "A" else found["inputs"]
        return float(found[matrix][self.names.index(rate)][columns.index(by)])

    def check_eigenvalues(self, found, expected, relative=1e-14):
        """Each of `expected` is there, and nothing else but zeros."""
        others = self.others_than_zero(found)
        self.assertEqual(len(others), len(expected), others)
        for value in expected:
            nearest = min(others, key=lambda e: abs(e - value))
            self.assertLess(abs(nearest - value), relative * abs(value), (value, others))
            others.remove(nearest)

    def test_the_bicycle_of_carvallo_and_whipple_at_every_speed(self):
        reference = json.loads((SOURCE / "tests/reference/bicycle_whipple_linear.json").read_text())
        speeds = reference["expected"]["eigenvalues"]
        self.assertEqual([entry["v"] for entry in speeds], list(range(11)))
        for entry in speeds:
            found = self.linear(MODELS / "bicycle.yaml", "--set", "lean=0", "--set", "steer=0", "--set", f"v={entry['v']}")
            self.assertEqual(found["motion"], "steady" if entry["v"] else "equilibrium")
            # Where the wheels are, how far they have turned, and how fast it runs, makes no difference.
            self.assertEqual(found["cyclic"], ["x", "y", "yaw", "rear_turn", "front_turn"])
            self.assertEqual(self.eigenvalues(found).count(0), 6)
            published = [complex(float(real), float(imaginary)) for real, imaginary in entry["eigenvalues_re_im"]]
            self.check_eigenvalues(found, published, 1e-14)

    def test_the_matrices_of_the_bicycle(self):
        reference = json.loads((SOURCE / "tests/reference/bicycle_whipple_linear.json").read_text())
        exact = {name: [[float(e) for e in row] for row in rows]
                 for name, rows in reference["expected"]["high_precision"].items()}
        v = 4.6
        found = self.linear(MODELS / "bicycle.yaml", "--set", "lean=0", "--set", "steer=0", "--set", f"v={v}")
        M, (lean, steer) = exact["M"], ("lean", "steer")
        for i in range(2):
            # M q'' = -v C1 q' - (g K0 + v^2 K2) q + [0, steer torque]
            def times_mass(matrix, by):
                return M[i][0] * self.entry(found, matrix, "lean_dot", by) + M[i][1] * self.entry(found, matrix, "steer_dot", by)
            for k, by in enumerate((lean, steer)):
                self.assertAlmostEqual(times_mass("A", by), -G * exact["K0"][i][k] - v * v * exact["K2"][i][k], 9)
                self.assertAlmostEqual(times_mass("A", by + "_dot"), -v * exact["C1"][i][k], 10)
            self.assertAlmostEqual(times_mass("B", "steer_torque"), i, 12)

    def test_a_pendulum_hangs_and_stands(self):
        w = math.sqrt(G / 0.8)
        found = self.linear(PENDULUM)
        self.assertEqual(found["motion"], "equilibrium")
        self.check_eigenvalues(found, [1j * w, -1j * w])
        self.assertAlmostEqual(float(found["eigenvalues"][0]["frequency"]), w / (2 * math.pi), 14)
        self.assertEqual(float(found["eigenvalues"][0]["damping_ratio"]), 0)
        self.assertAlmostEqual(self.entry(found, "B", "theta_dot", "T"), 1 / (2 * 0.8**2), 14)
        self.assertEqual([found["A"][0], found["B"][0]], [["0", "1.0000000000000000"], ["0"]])
        self.check_eigenvalues(self.linear(PENDULUM, "--set", "theta=pi"), [w, -w])

    def test_damping_ratio_and_time_constant(self):
        c, inertia = 0.9, 2 * 0.8**2
        found = self.linear(PENDULUM, "--set", f"c={c}")
        decay, w = c / inertia / 2, math.sqrt(G / 0.8)
        self.check_eigenvalues(found, [complex(-decay, s * math.sqrt(w * w - decay * decay)) for s in (1, -1)])
        self.assertAlmostEqual(float(found["eigenvalues"][0]["damping_ratio"]), decay / w, 14)
        self.assertAlmostEqual(float(found["eigenvalues"][0]["time_constant"]), 1 / decay, 14)

    def test_a_cart_with_a_pole(self):
        M, m, l = 1.5, 0.3, 0.6
        found = self.linear(CART)
        self.assertEqual(found["cyclic"], ["x"])
        self.assertAlmostEqual(self.entry(found, "A", "x_dot", "theta"), -m * G / M, 14)
        self.assertAlmostEqual(self.entry(found, "A", "theta_dot", "theta"), (M + m) * G / (M * l), 13)
        self.assertAlmostEqual(self.entry(found, "B", "x_dot", "F"), 1 / M, 14)
        self.assertAlmostEqual(self.entry(found, "B", "theta_dot", "F"), -1 / (M * l), 14)
        s = math.sqrt((M + m) * G / (M * l))
        self.check_eigenvalues(found, [s, -s])
        # The cart follows the pole: M x'' = -m g theta, x'' = s^2 x.
        mode = found["eigenvalues"][0]["mode"]
        self.assertAlmostEqual(float(mode["x"][0]) / float(mode["theta"][0]), -m * G / M / s**2, 14)
        self.assertEqual(float(mode["theta_dot"][0]), 1)

    def test_frequencies_of_a_double_pendulum(self):
        m1, m2, l1, l2 = 1, 0.7, 1, 0.8
        found = self.linear(MODELS / "double_pendulum_points.yaml", *[word for name in ("theta1", "theta2", "theta2_dot")
                                                                     for word in ("--set", f"{name}=0")])
        # det(K - w^2 M) = 0
        a = m1 * l1**2 * m2 * l2**2
        b = -((m1 + m2) * l1**2 * m2 * G * l2 + m2 * l2**2 * (m1 + m2) * G * l1)
        c = (m1 + m2) * G * l1 * m2 * G * l2
        squares = [(-b + s * math.sqrt(b * b - 4 * a * c)) / (2 * a) for s in (1, -1)]
        self.check_eigenvalues(found, [s * 1j * math.sqrt(w2) for w2 in squares for s in (1, -1)])

    def test_an_equilibrium_is_found_first(self):
        # The wind holds the rope at tan(alpha) = F/(m g); gravity and wind are one force then.
        found = self.linear(ROPE, "--at", "equilibrium")
        self.assertEqual((self.names, found["dependent"]), (["x", "x_dot"], ["z", "z_dot"]))
        w2 = math.hypot(G, 5 / 2) / 0.8
        self.check_eigenvalues(found, [1j * math.sqrt(w2), -1j * math.sqrt(w2)])
        self.assertAlmostEqual(float(found["states"][0]["value"]), 0.8 * (5 / 2) / math.hypot(G, 5 / 2), 14)

    def test_a_disc_that_rolls_upright_falls_below_its_critical_speed(self):
        R = 0.5
        critical = math.sqrt(G / (3 * R))
        for spin in (0, 0.9 * critical, 1.1 * critical, 7):
            found = self.linear(MODELS / "rolling_disc.yaml", "--set", "theta=pi/2", "--set", "dot(theta)=0", "--set",
                                "dot(psi)=0", "--set", f"dot(phi)={spin!r}")
            self.assertEqual(found["motion"], "steady" if spin else "equilibrium")
            s = cmath.sqrt(4 / 5 * (G / R - 3 * spin**2))
            self.check_eigenvalues(found, [s, -s], 1e-13)
            self.assertEqual(s.real > 0, spin < critical)

    def test_a_sleeping_top_wakes_below_its_critical_spin(self):
        m, l, A, C = 0.5, 0.1, 0.006, 0.0008
        critical = math.sqrt(4 * A * m * G * l) / C
        for spin in (0.8 * critical, 1.01 * critical, 150):
            found = self.linear(MODELS / "lagrange_top.yaml", "--set", "tilt=0", "--set", f"w3={spin!r}")
            self.assertEqual(found["motion"], "steady")
            # A z'' - i C w z' - m g l z = 0 of the tip in space; the axes of the top, in which the speeds are, turn with it.
            roots = [(1j * C * spin + s * cmath.sqrt(4 * A * m * G * l - (C * spin)**2)) / (2 * A) - 1j * spin for s in (1, -1)]
            self.check_eigenvalues(found, roots + [root.conjugate() for root in roots], 1e-13)
            self.assertEqual(max(e.real for e in self.eigenvalues(found)) > 0, spin < critical)

    def test_a_sleigh_steers_or_turns_over(self):
        m, J, a = 2, 0.3, 0.25
        for u in (1.5, -1.5):
            found = self.linear(MODELS / "chaplygin_sleigh_speeds.yaml", "--set", "dot(theta)=0", "--set", f"u={u}")
            self.assertEqual((found["motion"], found["dependent"]), ("steady", ["w"]))
            # With the mass centre in front of the blade it runs straight: (J + m a^2) w' = -m a u w.
            self.check_eigenvalues(found, [-m * a * u / (J + m * a * a)])

    def test_a_steady_motion_is_found_with_what_is_set_left_as_it_is(self):
        l, theta = 1.2, 0.6
        found = self.linear(MODELS / "spherical_pendulum_angles.yaml", "--at", "steady", "--set", f"theta={theta}")
        self.assertEqual((found["motion"], found["cyclic"]), ("steady", ["phi"]))
        turning = math.sqrt(G / (l * math.cos(theta)))
        values = {state["name"]: float(state["value"]) for state in found["states"]}
        self.assertEqual(values["theta"], theta)
        self.assertAlmostEqual(values["phi_dot"], turning, 14)
        # A conical pendulum nods with this frequency.
        nod = turning * math.sqrt(1 + 3 * math.cos(theta)**2)
        self.check_eigenvalues(found, [1j * nod, -1j * nod], 1e-13)

    def test_a_bicycle_in_a_steady_turn(self):
        found = self.linear(MODELS / "bicycle.yaml", "--at", "steady", "--set", "lean=0.1")
        self.assertEqual((found["motion"], found["changing"]), ("steady", []))
        values = {state["name"]: float(state["value"]) for state in found["states"]}
        rates = {state["name"]: float(state["rate"]) for state in found["states"]}
        self.assertEqual(values["lean"], 0.1)
        self.assertGreater(abs(rates["yaw"]), 0.1)
        self.assertLess(max(abs(rates[name]) for name in ("lean", "steer", "lean_dot", "steer_dot", "rear_turn_dot")), 1e-25)
        # Along the family of such turns nothing happens, and to first order nothing grows along it.
        self.assertEqual(len(self.others_than_zero(found)), 4)

    def test_what_moves_together_has_zeros_without_rounding(self):
        found = self.linear(DRIFTING)
        self.assertEqual((found["motion"], found["cyclic"], found["changing"]), ("steady", [], []))
        w = math.sqrt(2 * 30 / 2)
        self.check_eigenvalues(found, [1j * w, -1j * w])
        self.assertEqual(self.eigenvalues(found).count(0), 2)

    def test_what_is_no_larger_than_its_rounding_is_nothing_in_steady_motion(self):
        for model in ("bicycle", "chaplygin_sleigh_speeds", "free_top", "rattleback"):
            found = json.loads(self.run_it("linearize", MODELS / f"{model}.yaml", "--at", "steady", "--format", "json").stdout)
            for state in found["states"]:
                self.assertTrue(float(state["value"]) == 0 or abs(float(state["value"])) > 1e-9, (model, state))

    def test_what_neither_grows_nor_decays_is_called_neutral(self):
        swing = """gauss: 1
name: swing
coordinates: {x: {}, y: {}}
particles: {p: {mass: 2, position: [x, y, 0]}}
forces: {s: {spring: x, stiffness: 8}}
"""
        said = self.ok("linearize", "-", stdin=swing)
        self.assertRegex(said, r"1 +0 +\+-2\.00000 .* neutral\n")
        self.assertIn("2 are 0 (neutral)", said)

    def test_what_is_no_steady_motion_says_what_changes(self):
        found = self.linear(PENDULUM, "--set", "theta=0.3", stderr="neither an equilibrium nor a steady motion")
        self.assertEqual((found["motion"], found["changing"]), ("neither", ["theta_dot"]))
        self.assertAlmostEqual(float(found["states"][1]["rate"]), -G / 0.8 * math.sin(0.3), 14)
        table = self.run_it("linearize", "-", "--set", "theta=0.3", stdin=PENDULUM).stdout
        self.assertIn("neither an equilibrium nor steady; these change:\n  d/dt theta_dot = -3.62", table)

    def test_a_law_in_time_is_said(self):
        self.linear(MODELS / "pendulum_varying_length.yaml", "--at", "equilibrium", stderr="does not go on as it is")

    def test_where_there_is_none(self):
        falling = PENDULUM.replace("l*sin(theta), 0, -l*cos(theta)", "0, 0, l*theta")
        self.assertIn("no equilibrium", self.refused(1, "linearize", "-", "--at", "equilibrium", stdin=falling))
        self.assertIn("no steady motion", self.refused(1, "linearize", "-", "--at", "steady", stdin=falling))
        held = "gauss: 1\nname: held\ncoordinates: {x: {held_at: 1}}\nparticles: {p: {mass: 1, position: [x, 0, 0]}}\n"
        self.assertIn("no coordinate is free", self.refused(1, "linearize", "-", stdin=held))

    def test_options(self):
        self.assertIn("choose from initial, equilibrium, steady", self.refused(2, "linearize", "-", "--at", "rest", stdin=PENDULUM))
        self.assertIn("1 to 17", self.refused(2, "linearize", "-", "--digits", "18", stdin=PENDULUM))
        table = self.ok("linearize", "-", "--digits", "3", stdin=PENDULUM)
        self.assertIn("d/dt theta_dot  -12.3          0", table)
        self.assertIn("0     +-3.50", table)


if __name__ == "__main__":
    unittest.main()
