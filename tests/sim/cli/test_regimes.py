"""Dry friction, contacts that rest and links that break: each motion against its closed form or an integration of its own."""

import math
import unittest

from gauss_sim import Regimes

G = 9.81

BLOCK = """gauss: 1
name: block
parameters: {m: 2, mu: 0.5, alpha: pi/9, g: 9.81, v0: 0}
coordinates: {x: {initial: 0, initial_rate: v0}, z: {initial: 0}}
particles: {block: {mass: m, position: [x, 0, z]}}
contacts: {plane: {gap: z}}
forces:
  gravity: {uniform: [g*sin(alpha), 0, -g*cos(alpha)]}
  friction: {friction: dot(x), limit: mu*plane.reaction}
"""

# Pulled more and more: it holds until 2 t = F_s, and slides against F_d from then on.
PULLED = """gauss: 1
name: pulled
parameters: {m: 2, k: 2, Fs: 5, Fd: 3}
coordinates: {x: {initial: 0}}
particles: {block: {mass: m, position: [x, 0, 0]}}
forces:
  pull: {generalized: {x: k*t}}
  friction: {friction: dot(x), limit: Fd, static_limit: Fs}
"""

OSCILLATOR = """gauss: 1
name: oscillator
parameters: {m: 2, k: 50, F: 3.5, x0: 1}
coordinates: {x: {initial: x0}}
particles: {block: {mass: m, position: [x, 0, 0]}}
forces:
  spring: {potential: k*x^2/2}
  friction: {friction: dot(x), limit: F}
"""

ROD = """gauss: 1
name: rod
parameters: {m: 1, l: 1, mu: 0.3, theta0: 0.46, u0: 3, g: 9.81}
coordinates:
  x: {initial_rate: u0}
  z: {initial: l*cos(theta0)}
  theta: {initial: theta0}
frames: {body: {position: [x, 0, z], orientation: {axis: y, angle: -theta}}}
bodies: {rod: {frame: body, mass: m, inertia: [m*l^2/3, m*l^2/3, m*l^2/3]}}
points: {tip: {on: body, at: [0, 0, -l]}}
contacts: {floor: {gap: tip.z}}
forces:
  gravity: {uniform: [0, 0, -g]}
  friction: {friction: dot(tip.x), limit: mu*floor.reaction}
"""

POOL = """gauss: 1
name: pool
parameters: {m: 0.17, r: 0.0286, g: 9.81, mu: 0.2, e: 0.5, vx: 2, vy: 0.3, vz: 0, w: -40, h: r}
coordinates: {x: {initial_rate: vx}, y: {initial_rate: vy}, z: {initial: h, initial_rate: vz}}
orientations:
  attitude: {quaternion: [e0, e1, e2, e3], angular_velocity: [wx, wy, wz], frame: space, initial_angular_velocity: [0, w, 5]}
bodies: {ball: {mass: m, inertia: 2/5*m*r^2, position: [x, y, z], orientation: attitude}}
contacts: {cloth: {gap: z - r, restitution: e}}
forces:
  gravity: {uniform: [0, 0, -g]}
  friction: {slides: ball, at: [x, y, z - r], directions: [x, y], limit: mu*cloth.reaction}
"""


# On a floor, in two directions: pulled more and more towards (3, 4).
PUCK = """gauss: 1
name: puck
parameters: {m: 1, g: 9.81, mu: 0.3, k: 1, u: 0}
coordinates: {x: {initial_rate: 3*u}, y: {initial_rate: 4*u}, z: {}}
particles: {p: {mass: m, position: [x, y, z]}}
contacts: {floor: {gap: z}}
forces:
  gravity: {uniform: [0, 0, -g]}
  pull: {generalized: {x: 0.6*k*t, y: 0.8*k*t}}
  friction: {friction: [dot(x), dot(y)], limit: mu*floor.reaction}
"""

# On two feet, of which the front one carries more while it slides.
BOX = """gauss: 1
name: box
parameters: {m: 1, a: 0.5, h: 0.3, mu: 0.4, g: 9.81}
coordinates: {x: {initial_rate: 2}, z: {initial: h}, phi: {}}
frames: {f: {position: [x, 0, z], orientation: {axis: y, angle: phi}}}
bodies: {box: {frame: f, mass: m, inertia: [1, "m*(a^2 + h^2)/3", 1]}}
points: {l: {on: box, at: [-a, 0, -h]}, r: {on: box, at: [a, 0, -h]}}
contacts: {left: {gap: l.z}, right: {gap: r.z}}
forces:
  gravity: {uniform: [0, 0, -g]}
  rl: {friction: dot(l.x), limit: mu*left.reaction}
  rr: {friction: dot(r.x), limit: mu*right.reaction}
"""


def rod_accelerations(theta, rate, sense, mu):
    """Of the rod's middle and its angle, and the force of the floor: Newton and Euler, with J = m l^2/3, m = l = 1."""
    sine, cosine = math.sin(theta), math.cos(theta)
    press = (G - cosine * rate**2) / (1 + 3 * sine * (sine - mu * sense * cosine))
    return -mu * sense * press, 3 * press * (sine - mu * sense * cosine), press


def rod_until_it_stops(mu, theta=0.46, u=3.0, step=1e-3):
    """When the tip that slides forwards stands still, with the angle then: steps of Runge and Kutta, then Newton's."""

    def rates(y):
        ax, angular, _ = rod_accelerations(y[1], y[3], 1, mu)
        return (y[2], y[3], ax, angular)

    def after(y, h):
        k1 = rates(y)
        k2 = rates([a + h / 2 * b for a, b in zip(y, k1)])
        k3 = rates([a + h / 2 * b for a, b in zip(y, k2)])
        k4 = rates([a + h * b for a, b in zip(y, k3)])
        return [a + h / 6 * (b + 2 * c + 2 * d + e) for a, b, c, d, e in zip(y, k1, k2, k3, k4)]

    def slip(y):
        return y[2] + math.cos(y[1]) * y[3]

    t, y = 0.0, [0.0, theta, u, 0.0]
    while slip(after(y, step)) > 0:
        t, y = t + step, after(y, step)
    h = step / 2
    for _ in range(8):
        d = step * 1e-3
        h -= slip(after(y, h)) / ((slip(after(y, h + d)) - slip(after(y, h - d))) / (2 * d))
    return t + h, after(y, h)


class Friction(Regimes):
    def test_a_block_that_friction_holds_stays_at_zero_for_a_thousand_seconds(self):
        table, events = self.go(BLOCK, "--duration", "1000")
        self.assertEqual(table["t"][-1], 1000)
        for column in ("x", "z", "x_dot", "z_dot"):
            self.assertEqual(set(table[column]), {0.0}, column)
        self.assertEqual([(t, words) for t, words, _ in events if "friction" in words], [(0, "friction sticks")])

    def test_slip_begins_within_1e_9_of_the_tangent(self):
        steep = BLOCK.replace("mu: 0.5", "mu: tan(alpha)*(1 + d), d: 1e-9")
        held, _ = self.go(steep, "--duration", "10")
        self.assertEqual(set(held["x"]), {0.0})
        table, events = self.go(steep, "--duration", "10", "--set", "d=-1e-9")
        self.assertEqual(self.instants(events, "friction forwards"), [0])
        way = 1e-9 * G * math.sin(math.pi / 9) * 10**2 / 2
        self.assertAlmostEqual(table["x"][-1] / way, 1, delta=1e-6)  # of the rounding of the difference, 1e-16/1e-9

    def test_a_block_slides_with_the_acceleration_that_is_left(self):
        table, _ = self.go(BLOCK, "--duration", "2", "--set", "mu=0.2")
        a = G * (math.sin(math.pi / 9) - 0.2 * math.cos(math.pi / 9))
        for t, x, v in zip(table["t"], table["x"], table["x_dot"]):
            self.assertAlmostEqual(x, a * t * t / 2, delta=1e-12)
            self.assertAlmostEqual(v, a * t, delta=1e-12)

    def test_a_block_thrown_uphill_stops_and_stays_where_friction_holds_it(self):
        table, events = self.go(BLOCK, "--duration", "1", "--set", "v0=-3")
        up = G * (math.sin(math.pi / 9) + 0.5 * math.cos(math.pi / 9))
        stops = 3 / up
        (found,) = self.instants(events, "friction sticks")
        self.assertAlmostEqual(found, stops, delta=1e-12)
        after = [(x, v) for t, x, v in zip(table["t"], table["x"], table["x_dot"]) if t > stops]
        self.assertGreater(len(after), 100)
        self.assertEqual(len({x for x, _ in after}), 1)
        self.assertEqual({v for _, v in after}, {0.0})
        self.assertAlmostEqual(after[0][0], -9 / (2 * up), delta=1e-12)

    def test_a_block_thrown_uphill_comes_back_where_friction_does_not_hold_it(self):
        table, events = self.go(BLOCK, "--duration", "2", "--set", "v0=-3", "--set", "mu=0.3")
        sine, cosine = math.sin(math.pi / 9), math.cos(math.pi / 9)
        up, down = G * (sine + 0.3 * cosine), G * (sine - 0.3 * cosine)
        turns = 3 / up
        self.assertAlmostEqual(self.instants(events, "friction forwards")[0], turns, delta=1e-12)
        self.assertEqual(self.instants(events, "friction sticks"), [])
        self.assertAlmostEqual(table["x"][-1], -9 / (2 * up) + down * (2 - turns) ** 2 / 2, delta=1e-11)

    def test_static_friction_holds_longer_than_that_of_sliding(self):
        table, events = self.go(PULLED, "--duration", "4")
        (found,) = self.instants(events, "friction forwards")
        self.assertAlmostEqual(found, 2.5, delta=1e-10)
        for t, x in zip(table["t"], table["x"]):
            if t < 2.5:
                self.assertEqual(x, 0.0)
            else:  # 2 x'' = 2 t - 3
                self.assertAlmostEqual(x, (t**3 - 2.5**3) / 6 - 0.75 * (t**2 - 2.5**2) - (t - 2.5) * (2.5**2 / 2 - 3.75), delta=1e-9)

    def test_dry_friction_takes_the_same_from_each_swing(self):
        table, events = self.go(OSCILLATOR, "--duration", "6")
        half = math.pi / 5
        turns = [t for t, words, _ in events if t > 0]
        self.assertEqual(len(turns), 7)  # 1 - 2 n F/k with F/k = 0.07: 0.02 at the seventh, which friction holds
        for n, t in enumerate(turns, start=1):
            self.assertAlmostEqual(t, n * half, delta=1e-9)
        self.assertEqual(events[-1][1], "friction sticks")
        for t, x in zip(table["t"], table["x"]):
            n = min(int(t / half), 7)
            sign = (-1) ** n
            if n == 7:
                self.assertAlmostEqual(x, -0.02, delta=1e-9)
            else:
                middle = 0.07 * sign
                self.assertAlmostEqual(x, middle + (sign * (1 - 0.14 * n) - middle) * math.cos(5 * (t - n * half)), delta=1e-8)
        rest = [(x, v) for t, x, v in zip(table["t"], table["x"], table["x_dot"]) if t > 7 * half + 1e-6]
        self.assertGreater(len(rest), 100)
        self.assertEqual(len({x for x, _ in rest}), 1)
        self.assertEqual({v for _, v in rest}, {0.0})

    def test_steps_and_methods_find_the_same_instants(self):
        expected = [n * math.pi / 5 for n in range(1, 8)]
        for how in (["--tolerance", "1e-12"], ["--method", "dopri5", "--tolerance", "1e-11"], ["--method", "fehlberg78"],
                    ["--longest-step", "0.003"], ["--samples", "3"], ["--engine", "interpreted"]):
            _, events = self.go(OSCILLATOR, "--duration", "6", *how)
            found = [t for t, _, _ in events if t > 0]
            self.assertEqual(len(found), 7, how)
            for one, other in zip(found, expected):
                self.assertAlmostEqual(one, other, delta=1e-9, msg=how)

    def test_a_pool_ball_slides_and_then_rolls(self):
        for vx, vy, w in ((2, 0.3, -40), (2, 0, -200), (1, 0, 300), (0.5, -1, 0)):
            with self.subTest(vx=vx, vy=vy, w=w):
                table, events = self.go(POOL, "--duration", "3", "--set", f"vx={vx}", "--set", f"vy={vy}", "--set", f"w={w}")
                r, braking = 0.0286, 0.2 * G
                ux, uy = vx - r * w, vy
                slip = math.hypot(ux, uy)
                rolls = slip / (3.5 * braking)
                (found,) = self.instants(events, "friction sticks")
                self.assertAlmostEqual(found, rolls, delta=1e-10)
                for i, t in enumerate(table["t"]):
                    s = min(t, rolls)
                    for name, v0, u in (("x", vx, ux), ("y", vy, uy)):
                        v = v0 - braking * s * u / slip
                        x = v0 * s - braking * s * s / 2 * u / slip + v * (t - s)
                        self.assertAlmostEqual(table[f"{name}_dot"][i], v, delta=1e-10)
                        self.assertAlmostEqual(table[name][i], x, delta=1e-10)
                self.assertAlmostEqual(table["wy"][-1], table["x_dot"][-1] / r, delta=1e-9)
                self.assertAlmostEqual(table["wx"][-1], -table["y_dot"][-1] / r, delta=1e-9)
                self.assertAlmostEqual(table["wz"][-1], 5, delta=1e-12)  # nothing turns it about the normal

    def test_impacts_of_a_spinning_ball_take_no_more_than_their_friction(self):
        # Down with 2 m/s: m (1 + e) 2 along the normal; what stops slip is 2/7 m u.
        for mu in (0.05, 0.5):
            with self.subTest(mu=mu):
                table, events = self.go(POOL, "--duration", "0.25", "--set", f"mu={mu}", "--set", "vz=-2", "--set", "vy=0",
                                        "--set", "h=0.1286", "--set", "g=0")
                hits = [(t, impulse) for t, words, impulse in events if words == "cloth hits"]
                self.assertEqual(len(hits), 1)
                self.assertAlmostEqual(hits[0][0], 0.05, delta=1e-12)
                self.assertAlmostEqual(hits[0][1], 0.17 * 3, delta=1e-12)
                u = 2 + 40 * 0.0286
                change = min(mu * 3, 2 / 7 * u)
                self.assertAlmostEqual(table["x_dot"][-1], 2 - change, delta=1e-12)
                self.assertAlmostEqual(table["wy"][-1], -40 + 2.5 * change / 0.0286, delta=1e-10)
                self.assertAlmostEqual(table["z_dot"][-1], 1, delta=1e-12)
                self.assertAlmostEqual(table["y_dot"][-1], 0, delta=1e-12)

    def test_a_box_that_slides_on_two_feet_presses_the_front_one_more(self):
        table, _ = self.go(BOX, "--duration", "0.5", "--outputs", "state,reactions")
        for i, t in enumerate(table["t"]):
            self.assertAlmostEqual(table["x"][i], 2 * t - 0.2 * G * t * t, delta=1e-10)
            # Moments about the middle: a (R - L) = h mu (R + L)
            left, right = table["reactions.left.multiplier"][i], table["reactions.right.multiplier"][i]
            self.assertAlmostEqual(left + right, G, delta=1e-9)
            self.assertAlmostEqual(right - left, 0.3 * 0.4 * G / 0.5, delta=1e-9)

    def test_a_box_on_two_feet_stops_and_stays(self):
        table, _ = self.go(BOX, "--duration", "2")
        rest = [x for t, x in zip(table["t"], table["x"]) if t > 2 / (0.4 * G)]
        self.assertAlmostEqual(rest[-1], 2 / (0.4 * G), delta=1e-10)
        self.assertEqual(len(set(rest)), 1)

    def test_slip_in_two_directions_begins_along_the_pull(self):
        table, events = self.go(PUCK, "--duration", "3.5", timeout=20)
        (begins,) = self.instants(events, "friction slides")
        limit = 0.3 * G
        self.assertAlmostEqual(begins, limit, delta=1e-10)
        for t, x, y in zip(table["t"], table["x"], table["y"]):
            if t < limit:
                self.assertEqual((x, y), (0, 0))
                continue
            way = (t**3 - limit**3) / 6 - limit * (t**2 - limit**2) / 2 + (t - limit) * limit**2 / 2
            self.assertAlmostEqual(x, 0.6 * way, delta=1e-8)
            self.assertAlmostEqual(y, 0.8 * way, delta=1e-8)

    def test_slip_in_two_directions_does_not_need_many_steps(self):
        self.go(PUCK, "--duration", "3.5", timeout=20)
        self.assertLess(self.summary("x.json")["steps"], 5000)

    def test_slip_on_what_turns_begins_where_friction_cannot_carry_along_and_takes_few_steps(self):
        """On a table that begins to turn with al: r sqrt(al^2 + (al t)^4) = mu g."""
        text = """gauss: 1
name: turntable
parameters: {m: 1, g: 9.81, mu: 0.2, al: 0.5}
coordinates: {x: {initial: 0.5}, y: {}, z: {}}
particles: {p: {mass: m, position: [x, y, z]}}
contacts: {floor: {gap: z}}
forces:
  gravity: {uniform: [0, 0, -g]}
  f: {friction: [dot(x) + al*t*y, dot(y) - al*t*x], limit: mu*floor.reaction}
"""
        begins = ((0.2 * G / 0.5) ** 2 - 0.25) ** 0.25 / 0.5
        ends = []
        for tolerance in ("1e-9", "1e-12"):
            table, events = self.go(text, "--duration", "4.2", "--samples", "43", "--tolerance", tolerance, timeout=20)
            self.assertAlmostEqual(self.instants(events, "f slides")[0], begins, delta=1e-8)
            self.assertLess(self.summary("x.json")["steps"], 3000)
            ends.append([table[name][-1] for name in ("x", "y", "x_dot", "y_dot")])
        for one, other in zip(*ends):
            self.assertAlmostEqual(one, other, delta=1e-7)

    def test_slip_in_two_directions_ends_in_rest(self):
        table, events = self.go(PUCK, "--duration", "3", "--set", "k=0", "--set", "u=1")
        (stops,) = self.instants(events, "friction sticks")
        self.assertAlmostEqual(stops, 5 / (0.3 * G), delta=1e-10)
        self.assertAlmostEqual(table["x"][-1], 0.6 * 25 / (0.6 * G), delta=1e-10)
        self.assertEqual((table["x_dot"][-1], table["y_dot"][-1]), (0, 0))

    def test_painleves_rod_has_no_motion_and_says_so(self):
        self.write("rod.yaml", ROD)
        result = self.run_it("run", "rod.yaml", "--duration", "1", "--set", "mu=2")
        self.assertEqual(result.returncode, 5, result.stderr)
        self.assertIn("leave no motion", result.stderr)
        self.assertNotIn("nan", (result.stdout + result.stderr).lower())
        for name in self.files():
            self.assertNotIn("nan", (self.folder / name).read_text(encoding="utf-8").lower())

    def test_a_rod_that_comes_near_painleves_paradox_has_numbers_in_all_rows(self):
        # 1 + 3 sin(theta) (sin(theta) - mu cos(theta)) falls through 0 at theta = 0.927..., 0.08 s from here.
        self.write("rod.yaml", ROD)
        result = self.run_it("run", "rod.yaml", "--duration", "2", "--set", "mu=2", "--set", "theta0=1.1", "--set", "theta_dot=-2",
                             "--set", "u0=30", "-o", "x.csv")
        self.assertIn(result.returncode, (0, 5), result.stderr)
        table = self.table("x.csv")
        self.assertGreater(len(table["x"]), 10)
        for name, column in table.items():
            self.assertTrue(all(math.isfinite(value) for value in column), name)

    def test_a_rod_slides_until_it_stands_as_newton_and_euler_have_it(self):
        for mu in (0.3, 1.0):
            with self.subTest(mu=mu):
                _, events = self.go(ROD, "--duration", "2", "--set", f"mu={mu}")
                self.assertEqual([(t, words) for t, words, _ in events[:2]], [(0, "floor closed"), (0, "friction forwards")])
                expected, _ = rod_until_it_stops(mu)
                self.assertAlmostEqual(events[2][0], expected, delta=1e-9)


if __name__ == "__main__":
    unittest.main()
