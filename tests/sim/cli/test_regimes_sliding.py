"""Friction of several contacts that slides: loads that they share, and reactions that depend on each other through it."""

import itertools
import math
import unittest

from gauss_sim import Regimes

G = 9.81
A, B, H, M, MU = 0.4, 0.3, 0.1, 3, 0.3
CX, CY = 0.2, 0.1

CRATE = """gauss: 1
name: crate
parameters: {{m: 3, a: 0.4, b: 0.3, h: 0.1, g: 9.81, mu: 0.3, cx: {cx}, cy: {cy}, v: {v}, w: {w}}}
coordinates: {{x: {{initial_rate: v}}, y: {{}}, z: {{initial: h}}}}
orientations: {{q: {{quaternion: [e0, e1, e2, e3], angular_velocity: [wx, wy, wz], initial_angular_velocity: [0, 0, w]}}}}
bodies: {{box: {{mass: m, inertia: [m*b^2/3, m*a^2/3, m*(a^2+b^2)/3], position: [x, y, z], orientation: q}}}}
points:
  p1: {{on: box, at: [a-cx, b-cy, -h]}}
  p2: {{on: box, at: [a-cx, -b-cy, -h]}}
  p3: {{on: box, at: [-a-cx, b-cy, -h]}}
  p4: {{on: box, at: [-a-cx, -b-cy, -h]}}
contacts:
{contacts}forces:
  gravity: {{uniform: [0, 0, -g]}}
{frictions}"""

# A box with two feet on a box with two feet, which is pulled: four loads, each of which changes the other three.
STACK = """gauss: 1
name: stack
parameters: {m: 2, M: 6, a: 0.2, h: 0.15, A: 0.4, H: 0.1, g: 9.81, mu: 0.35, nu: 0.25, k: 10}
coordinates: {x: {}, z: {initial: 2*H + h}, p: {}, X: {}, Z: {initial: H}, P: {}}
bodies:
  top: {mass: m, inertia: [0, m*(a^2+h^2)/3, 0], position: [x, 0, z], orientation: {axis: y, angle: p}}
  low: {mass: M, inertia: [0, M*(A^2+H^2)/3, 0], position: [X, 0, Z], orientation: {axis: y, angle: P}}
points:
  t1: {on: top, at: [a, 0, -h]}
  t2: {on: top, at: [-a, 0, -h]}
  l1: {on: low, at: [A, 0, -H]}
  l2: {on: low, at: [-A, 0, -H]}
contacts:
  ct1: {gap: (t1.x - X)*sin(P) + (t1.z - Z)*cos(P) - H}
  ct2: {gap: (t2.x - X)*sin(P) + (t2.z - Z)*cos(P) - H}
  cl1: {gap: l1.z}
  cl2: {gap: l2.z}
forces:
  gravity: {uniform: [0, 0, -g]}
  pull: {force: [k*t, 0, 0], on: low}
  ft1: {slides: top, on: low, at: t1, directions: [x], limit: mu*ct1.reaction}
  ft2: {slides: top, on: low, at: t2, directions: [x], limit: mu*ct2.reaction}
  fl1: {slides: low, at: l1, directions: [x], limit: nu*cl1.reaction}
  fl2: {slides: low, at: l2, directions: [x], limit: nu*cl2.reaction}
"""

# On rails that follow from each other, of which friction knows one or the other.
SLEDGE = """gauss: 1
name: sledge
parameters: {m: 3, J: 30, g: 9.81, mu: 0.1, d: 0.05, h: 0.05, l: 1, c: 0.9}
coordinates: {x: {initial_rate: 2}, z: {initial: h}, p: {}}
bodies: {box: {mass: m, inertia: [0, J, 0], position: [x, 0, z], orientation: {axis: y, angle: p}}}
points:
  p1: {on: box, at: [-l-c, 0, -h]}
  p2: {on: box, at: [-c, 0, -h]}
  p3: {on: box, at: [l-c, 0, -h]}
contacts: {c1: {gap: p1.z}, c2: {gap: p2.z}, c3: {gap: p3.z}}
forces:
  gravity: {uniform: [0, 0, -g]}
  f1: {slides: box, at: p1, directions: [x], limit: (mu+d)*c1.reaction}
  f2: {slides: box, at: p2, directions: [x], limit: mu*c2.reaction}
  f3: {slides: box, at: p3, directions: [x], limit: (mu-d)*c3.reaction}
"""

CRANK = """gauss: 1
name: crank
parameters: {r: 0.1, l: 0.35, d: 0.04, J: 0.02, m: 0.8, M: 1.5, F: 2.5, g: 9.81}
coordinates: {a: {initial: 0.4, initial_rate: 15}, b: {initial_guess: 0.1}, x: {initial_guess: 0.4}, z: {held_at: d}}
bodies:
  crank: {mass: 1, inertia: [0, J, 0], position: [0, 0, 0], orientation: {axis: y, angle: -a}}
  rod: {mass: m, inertia: [0, m*l^2/12, 0], position: [r*cos(a) + l/2*cos(b), 0, r*sin(a) - l/2*sin(b)], orientation: {axis: y, angle: b}}
particles: {slider: {mass: M, position: [x, 0, z]}}
points: {end: {on: rod, at: [l/2, 0, 0]}}
constraints: {gudgeon: {coincide: [end, slider]}}
forces: {weight: {uniform: [0, 0, -g]}, rubs: {friction: dot(x), limit: F}}
"""

TRAMMEL = """gauss: 1
name: trammel
parameters: {m: 1, L: 0.5, F: 0.5, om: 2}
coordinates: {x: {initial: L*cos(0.4), initial_rate: -om*L*sin(0.4)}, z: {initial: L*sin(0.4), initial_rate: om*L*cos(0.4)}}
particles: {sx: {mass: m, position: [x, 0, 0]}, sz: {mass: m, position: [0, 0, z]}}
constraints: {bar: {distance: [sx, sz], is: L}}
forces: {rubs: {friction: dot(x), limit: F}}
"""

# A block that rocks from one lower corner to the other.
TOWER = """gauss: 1
name: tower
parameters: {m: 100, b: 0.2, h: 0.8, p0: 0.12, mu: 0.8, g: 9.81}
coordinates:
  x: {initial: -b + b*cos(p0) + h*sin(p0)}
  z: {initial: b*sin(p0) + h*cos(p0)}
  p: {initial: p0}
bodies: {tower: {mass: m, inertia: [0, m*(b^2 + h^2)/3, 0], position: [x, 0, z], orientation: {axis: y, angle: p}}}
points: {left: {on: tower, at: [-b, 0, -h]}, right: {on: tower, at: [b, 0, -h]}}
contacts: {l: {gap: left.z}, r: {gap: right.z}}
forces:
  weight: {uniform: [0, 0, -g]}
  rl: {slides: tower, at: left, directions: x, limit: mu*l.reaction}
  rr: {slides: tower, at: right, directions: x, limit: mu*r.reaction}
"""


def crate(order=(1, 2, 3, 4), cx=CX, cy=CY, v=0, w=4):
    return CRATE.format(cx=cx, cy=cy, v=v, w=w, contacts="".join(f"  c{i}: {{gap: p{i}.z}}\n" for i in order),
                        frictions="".join(f"  f{i}: {{slides: box, at: p{i}, directions: [x, y], limit: mu*c{i}.reaction}}\n"
                                          for i in order))


def solved(matrix, right):
    """By Cramer's rule, for three unknowns."""
    def determinant(m):
        return sum(m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3]) for i in range(3))
    return [determinant([[right[i] if j == k else matrix[i][j] for j in range(3)] for i in range(3)]) / determinant(matrix)
            for k in range(3)]


def accelerations_on_flat_ground(x, y, turn, vx, vy, w):
    """By Newton and Euler, of a body that stays flat. Each foot bears (dz + tx y - ty x)/L^2 of a small motion dz, tx, ty, where
    L^2 = 1/m + y^2/J_x + x^2/J_y: the least loads that bear it, in the metric of masses. The motion is that which makes the
    forces balance: heights, and moments about both axes, friction at the height of the ground among them."""
    c, s = math.cos(turn), math.sin(turn)
    feet = [(i * A - CX, j * B - CY) for i in (1, -1) for j in (1, -1)]
    shares, arms, slips = [], [], []
    for fx, fy in feet:
        square = 1 / M + fy ** 2 / (M * B ** 2 / 3) + fx ** 2 / (M * A ** 2 / 3)
        shares.append([1 / square, fy / square, -fx / square])
        ax, ay = c * fx - s * fy, s * fx + c * fy
        arms.append((ax, ay))
        sx, sy = vx - w * ay, vy + w * ax
        slips.append((sx / math.hypot(sx, sy), sy / math.hypot(sx, sy)))
    rows = [[0] * 3 for _ in range(3)]
    for share, (ax, ay), (sx, sy) in zip(shares, arms, slips):
        # moments of (-mu N s_x, -mu N s_y, N) at (a_x, a_y, -h)
        for row, part in zip(rows, (1, ay - MU * H * sy, -ax + MU * H * sx)):
            for k in range(3):
                row[k] += part * share[k]
    motion = solved(rows, [M * G, 0, 0])
    fx = fy = moment = 0
    for share, (ax, ay), (sx, sy) in zip(shares, arms, slips):
        load = sum(p * q for p, q in zip(share, motion))
        fx -= MU * load * sx
        fy -= MU * load * sy
        moment += MU * load * (ay * sx - ax * sy)
    return [fx / M, fy / M, moment / (M * (A ** 2 + B ** 2) / 3)]


def slide(state, duration, steps):
    """By the classical method of Runge and Kutta."""
    def rates(s):
        return s[3:] + accelerations_on_flat_ground(*s)
    h = duration / steps
    for _ in range(steps):
        k1 = rates(state)
        k2 = rates([a + h / 2 * b for a, b in zip(state, k1)])
        k3 = rates([a + h / 2 * b for a, b in zip(state, k2)])
        k4 = rates([a + h * b for a, b in zip(state, k3)])
        state = [a + h / 6 * (b + 2 * c + 2 * d + e) for a, b, c, d, e in zip(state, k1, k2, k3, k4)]
    return state


class Sliding(Regimes):
    def test_a_crate_that_turns_on_four_feet_rubs_by_the_least_loads(self):
        table, events = self.go(crate(v=2, w=4), "--duration", "0.25", "--samples", "2", "--tolerance", "1e-12")
        self.assertEqual({words.split()[1] for _, words, _ in events}, {"closed", "slides"})
        x, y, turn, vx, vy, w = slide([0, 0, 0, 2, 0, 4], 0.25, 2000)
        for name, value in (("x", x), ("y", y), ("x_dot", vx), ("y_dot", vy), ("wz", w), ("e3", math.sin(turn / 2))):
            self.assertAlmostEqual(table[name][-1], value, delta=1e-9, msg=name)

    def test_in_any_order_of_the_file(self):
        rows = []
        for order in ((1, 2, 3, 4), (4, 3, 2, 1), (2, 4, 1, 3)):
            table, _ = self.go(crate(order, v=2, w=4), "--duration", "0.25", "--samples", "3", "--tolerance", "1e-12")
            rows.append([table[name] for name in ("x", "y", "e0", "e3", "x_dot", "y_dot", "wz")])
        for other in rows[1:]:
            for column, same in zip(rows[0], other):
                for a, b in zip(column, same):
                    self.assertAlmostEqual(a, b, delta=1e-13)

    def test_what_is_reported_is_what_rubs(self):
        table, _ = self.go(crate(v=2, w=0), "--duration", "0.1", "--samples", "3", "--outputs", "state,reactions")
        total = sum(table[f"reactions.c{i}.multiplier"][1] for i in (1, 2, 3, 4))
        self.assertAlmostEqual(total, M * G, delta=1e-12)
        # At the start all feet slip along x: moments about y, and about z, where the loads that are reported rub.
        loads = [table[f"reactions.c{i}.multiplier"][0] for i in (1, 2, 3, 4)]
        ways = [CX - A, CX - A, CX + A, CX + A]
        self.assertAlmostEqual(sum(n * (d + MU * H) for n, d in zip(loads, ways)), 0, delta=1e-12)

    def test_a_crate_that_only_turns_comes_to_rest_at_once(self):
        """All slips end together: w' = -mu m g r/J, with r the way from the middle to each foot."""
        table, events = self.go(crate(cx=0, cy=0, v=0, w=4), "--duration", "0.5", "--samples", "6")
        stops = 4 / (MU * G * math.hypot(A, B) / ((A ** 2 + B ** 2) / 3))
        ends = [t for t, words, _ in events if words.endswith("sticks")]
        self.assertEqual(len(ends), 4)
        for t in ends:
            self.assertAlmostEqual(t, stops, delta=1e-8)
        self.assertAlmostEqual(2 * math.asin(table["e3"][-1]), 4 * stops / 2, delta=1e-8)
        self.assertEqual(self.summary("x.json").get("warnings", []), [])

    def test_two_boxes_slide_on_the_ground_and_then_on_each_other(self):
        table, events = self.go(STACK, "--duration", "5.5", "--samples", "2", timeout=30)
        together, apart = 0.25 * 8 * G / 10, (8 * 0.35 + 8 * 0.25) * G / 10
        self.assertAlmostEqual(self.instants(events, "fl1 forwards")[0], together, delta=1e-12)
        self.assertAlmostEqual(self.instants(events, "ft2 backwards")[0], apart, delta=1e-12)
        # 8 x'' = k t - nu 8 g from `together` on, then x'' = mu g, and 6 X'' = k t - nu 8 g - mu 2 g
        first, last = apart - together, 5.5 - apart
        x, v = 10 / 8 * first ** 3 / 6, 10 / 8 * first ** 2 / 2
        self.assertAlmostEqual(table["x"][-1], x + v * last + 0.35 * G * last ** 2 / 2, delta=1e-9)
        self.assertAlmostEqual(table["X"][-1], x + v * last + 0.35 * G * last ** 2 / 2 + 10 / 6 * last ** 3 / 6, delta=1e-9)

    def test_a_slide_turns_back_at_its_dead_centre(self):
        """There its slip is 0 whatever friction does: it takes F times the way, and no more."""
        x_least = math.sqrt(0.25 ** 2 - 0.04 ** 2)
        for tolerance in ("1e-9", "1e-11"):
            table, events = self.go(CRANK, "--duration", "0.3", "--samples", "2", "--tolerance", tolerance)
            self.assertEqual([words for _, words, _ in events], ["rubs backwards", "rubs forwards"])
            (x, x_end), (energy, energy_end) = table["x"], table["energy.total"]
            self.assertAlmostEqual(energy_end, energy - 2.5 * (x + x_end - 2 * x_least), delta=1e-8)
            self.assertGreater(table["a_dot"][-1], 13)

    def test_a_trammel_slides_until_its_energy_is_used_up(self):
        for om in (2, 3, 4):
            table, _ = self.go(TRAMMEL, "--duration", "12", "--samples", "2", "--set", f"om={om}")
            way, x, turns = om ** 2 / 4, 0.5 * math.cos(0.4), [-0.5, 0.5]
            for turn in turns * 10:
                if way < abs(turn - x):
                    break
                way, x = way - abs(turn - x), turn
            self.assertAlmostEqual(table["x"][-1], x + math.copysign(way, turn - x), delta=1e-8)

    def test_a_block_that_rocks_comes_to_rest(self):
        for height in ("0.6", "0.8"):
            table, events = self.go(TOWER, "--duration", "12", "--samples", "121", "--set", f"h={height}")
            self.assertGreater(len([1 for _, words, _ in events if words.endswith("hits")]), 20)
            for name in ("p", "x_dot", "z_dot", "p_dot"):
                self.assertAlmostEqual(table[name][-1], 0, delta=1e-12, msg=name)
            energy = table["energy.total"]
            self.assertTrue(all(later <= before + 1e-9 for before, later in zip(energy, energy[1:])))

    def test_what_has_come_to_rest_stays_so(self):
        """Until squares of its speeds are no numbers any more."""
        for samples in ("11", "25"):
            light = crate(v=2e-4, w=4, cx=2e-5, cy=1e-5).replace("m: 3, a: 0.4, b: 0.3, h: 0.1, g: 9.81", "m: 3e-6, a: 4e-5, b: 3e-5, h: 1e-5, g: 9.81e-4")
            table, events = self.go(light, "--duration", "1.5", "--samples", samples)
            self.assertEqual(len([1 for _, words, _ in events if words.endswith("sticks")]), 4)
            for name in ("x_dot", "y_dot", "wz"):
                self.assertEqual(table[name][-1], 0)
            self.assertNotIn("tighter run stops", " ".join(map(str, self.summary("x.json").get("warnings", []))))

    def test_a_foot_that_shares_could_only_pull_bears_nothing_in_any_order(self):
        """Least loads would pull at the first foot; without the middle one there are none but one share."""
        # N_1 + N_3 = m g, and no moment about the middle: x_1 N_1 + x_3 N_3 = h (mu_1 N_1 + mu_3 N_3)
        one, three = -1.9 - 0.05 * 0.15, 0.1 - 0.05 * 0.05
        rubs = (0.15 * three - 0.05 * one) / (three - one)
        places = set()
        for order in itertools.permutations(("c1: {gap: p1.z}", "c2: {gap: p2.z}", "c3: {gap: p3.z}")):
            text = SLEDGE.replace("c1: {gap: p1.z}, c2: {gap: p2.z}, c3: {gap: p3.z}", ", ".join(order))
            table, events = self.go(text, "--duration", "1", "--samples", "2")
            self.assertEqual({words for _, words, _ in events if words.endswith("closed")}, {"c1 closed", "c3 closed"})
            places.add(round(table["x"][-1], 12))
        self.assertEqual(len(places), 1)
        self.assertAlmostEqual(2 * (2 - places.pop()), rubs * G, delta=1e-9)


if __name__ == "__main__":
    unittest.main()
