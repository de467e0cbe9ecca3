"""Impacts, rest after them, and contacts that open: each motion against its closed form."""

import math
import unittest

from gauss_sim import Regimes

G = 9.81

BOUNCE = """gauss: 1
name: bounce
parameters: {m: 1, g: 9.81, e: 0.9}
coordinates: {z: {initial: 1}}
particles: {ball: {mass: m, position: [0, 0, z]}}
contacts: {floor: {gap: z, restitution: e}}
forces: {gravity: {uniform: [0, 0, -g]}}
"""

PAIR = """gauss: 1
name: pair
parameters: {m: 2, M: 6}
coordinates: {x: {initial: -0.5, initial_rate: 1}, y: {initial: 0.11}}
particles: {a: {mass: m, position: [x, 0, 0]}, b: {mass: M, position: [y, 0, 0]}}
contacts: {touch: {gap: y - x - 0.1, restitution: 1}}
"""

CRADLE = """gauss: 1
name: cradle
parameters: {{m: 1, d: 0.1, e: 1, s: {spaces}}}
coordinates:
{coordinates}particles:
{particles}contacts:
{contacts}"""

STOP = """gauss: 1
name: stop
parameters: {m: 1, l: 0.5, g: 9.81, e: 0.5, lo: 0.2}
coordinates: {theta: {initial: 1.2}}
particles: {bob: {mass: m, position: [l*sin(theta), 0, -l*cos(theta)]}}
contacts: {stop: {gap: theta + lo, restitution: e}}
forces: {gravity: {uniform: [0, 0, -g]}}
"""

ROPE = """gauss: 1
name: rope
parameters: {m: 1, l: 1, g: 9.81, v: 4.5}
coordinates: {x: {initial: 0, initial_rate: v}, z: {initial: -1}}
particles: {bob: {mass: m, position: [x, 0, z]}}
contacts: {rope: {gap: "l - sqrt(x^2 + z^2)"}}
forces: {gravity: {uniform: [0, 0, -g]}}
"""

TABLE = """gauss: 1
name: shaken
parameters: {m: 2, g: 9.81, A: 0.05, w: 20}
coordinates: {z: {initial: 0, initial_rate: A*w}}
particles: {block: {mass: m, position: [0, 0, z]}}
contacts: {table: {gap: z - A*sin(w*t)}}
forces: {gravity: {uniform: [0, 0, -g]}}
"""

WEDGED = """gauss: 1
name: corner
parameters: {m: 2, e: 1}
coordinates: {x: {initial: 1, initial_rate: -2}, y: {initial: 1.5, initial_rate: -3}}
particles: {ball: {mass: m, position: [x, y, 0]}}
contacts: {left: {gap: x, restitution: e}, low: {gap: y, restitution: e}}
"""

GAUSS_8 = [(0.1834346424956498, 0.3626837833783620), (0.5255324099163290, 0.3137066458778873),
           (0.7966664774136267, 0.2223810344533745), (0.9602898564975363, 0.1012285362903763)]


def integral(f, a, b, parts=64):
    """Gauss's rule of eight places in each part."""
    h = (b - a) / (2 * parts)
    return h * sum(w * (f(a + (2 * i + 1 - x) * h) + f(a + (2 * i + 1 + x) * h)) for i in range(parts) for x, w in GAUSS_8)


def root(f, a, b):
    """Between a and b, at which f has different signs."""
    rises = f(b) > 0
    for _ in range(200):
        middle = (a + b) / 2
        if (f(middle) > 0) == rises:
            b = middle
        else:
            a = middle
    return (a + b) / 2


def swing(amplitude, angle, w):
    """How long a pendulum takes from the bottom to this angle: an elliptic integral of the first kind."""
    k = math.sin(amplitude / 2)
    end = math.asin(max(-1, min(1, math.sin(angle / 2) / k)))
    return integral(lambda p: 1 / math.sqrt(1 - (k * math.sin(p)) ** 2), 0, end) / w


def cradle(balls=range(1, 6), contacts=range(1, 5), spaces="0"):
    """Five balls in a row, of which the first moves; entries in the order given."""
    x = {1: "{initial: -0.5, initial_rate: 1}", **{i: f"{{initial: {i - 1}*(d + s)}}" for i in range(2, 6)}}
    return CRADLE.format(
        spaces=spaces,
        coordinates="".join(f"  x{i}: {x[i]}\n" for i in balls),
        particles="".join(f"  b{i}: {{mass: m, position: [x{i}, 0, 0]}}\n" for i in reversed(list(balls))),
        contacts="".join(f"  c{i}: {{gap: x{i + 1} - x{i} - d, restitution: e}}\n" for i in contacts))


BOX_IN_AIR = """gauss: 1
name: tumbling_box
parameters: {m: 1, a: 0.5, h: 0.3, mu: 0.4, g: 9.81, e: 0.4}
coordinates: {x: {initial_rate: 1}, z: {initial: 1.2}, phi: {initial: 0.4, initial_rate: 1}}
frames: {f: {position: [x, 0, z], orientation: {axis: y, angle: phi}}}
bodies: {box: {frame: f, mass: m, inertia: [1, "m*(a^2 + h^2)/3", 1]}}
points: {p1: {on: box, at: [-a, 0, -h]}, p2: {on: box, at: [a, 0, -h]}, p3: {on: box, at: [-a, 0, h]}, p4: {on: box, at: [a, 0, h]}}
contacts:
  c1: {gap: p1.z, restitution: e}
  c2: {gap: p2.z, restitution: e}
  c3: {gap: p3.z, restitution: e}
  c4: {gap: p4.z, restitution: e}
forces:
  gravity: {uniform: [0, 0, -g]}
  f1: {slides: box, at: p1, directions: [x], limit: mu*c1.reaction}
  f2: {slides: box, at: p2, directions: [x], limit: mu*c2.reaction}
  f3: {slides: box, at: p3, directions: [x], limit: mu*c3.reaction}
  f4: {slides: box, at: p4, directions: [x], limit: mu*c4.reaction}
"""

# Three boxes, each of a height of 0.5, above each other.
TOWER = """gauss: 1
name: tower
parameters: {m: 1, h: 0.5, g: 9.81, e: 0.3}
coordinates: {a: {initial: 0.5}, b: {initial: 1.2}, c: {initial: 2.1}}
particles: {A: {mass: m, position: [0, 0, a]}, B: {mass: m, position: [0, 0, b]}, C: {mass: m, position: [0, 0, c]}}
contacts: {c0: {gap: a, restitution: e}, c1: {gap: b - a - h, restitution: e}, c2: {gap: c - b - h, restitution: e}}
forces: {gravity: {uniform: [0, 0, -g]}}
"""

SPINNING = """gauss: 1
name: ball
parameters: {m: 0.17, L: 1, r: 0.03*L, g: 9.81*L, mu: 0.2, f: 0.0005*L}
coordinates: {x: {initial_rate: 2*L}, y: {initial_rate: 0.3*L}, z: {initial: r + 0.1*L}}
orientations: {q: {quaternion: [e0, e1, e2, e3], angular_velocity: [wx, wy, wz], frame: space, initial_angular_velocity: [0, -40, 5]}}
bodies: {ball: {mass: m, inertia: 2/5*m*r^2, position: [x, y, z], orientation: q}}
contacts: {c: {gap: z - r, restitution: 0.6}}
forces:
  gravity: {uniform: [0, 0, -g]}
  f: {slides: ball, at: [x, y, 0], directions: [x, y], limit: mu*c.reaction}
  roll: {friction: [ball.wx, ball.wy], limit: f*c.reaction}
  spin: {friction: ball.wz, limit: f/2*c.reaction}
"""

# On three posts, of which two would do, and turned off them.
PLANK = """gauss: 1
name: plank
parameters: {m: 4, g: 9.81, d: 0.25, T: 2}
coordinates: {z: {}, phi: {}}
bodies: {plank: {mass: m, inertia: [0, m*d^2, 0], position: [0, 0, z], orientation: {axis: y, angle: phi}}}
points: {a: {on: plank, at: [-d, 0, 0]}, b: {on: plank, at: [0, 0, 0]}, c: {on: plank, at: [d, 0, 0]}}
contacts: {A: {gap: a.z}, B: {gap: b.z}, C: {gap: c.z}}
forces: {weight: {uniform: [0, 0, -g]}, turn: {generalized: {phi: T*t}}}
"""

WALK = """gauss: 1
name: walk
counts: {n: 7}
parameters: {m: 4, g: 9.81, d: 0.2, M: 3, v: 0.5}
coordinates: {z: {}, phi: {}, s: {held_at: v*t}}
bodies: {plank: {mass: m, inertia: [0, "m*(10*d)^2/12", 0], position: [0, 0, z], orientation: {axis: y, angle: phi}}}
particles: {load: {mass: M, position: [s*cos(phi), 0, z - s*sin(phi)]}}
points:
  p_$i: {count: n, on: plank, at: [($i - 4)*d, 0, 0]}
contacts:
  post_$i: {count: n, gap: p_$i.z}
forces: {weight: {uniform: [0, 0, -g]}}
"""

# Into the corner, so that two walls are hit at once.
ROOM = """gauss: 1
name: room
parameters: {m: 1, e: 0.8}
coordinates: {x: {initial: 0.5, initial_rate: 1}, y: {initial: 0.5, initial_rate: 1}}
particles: {p: {mass: m, position: [x, y, 0]}}
contacts: {l: {gap: x, restitution: e}, r: {gap: 1 - x, restitution: e}, b: {gap: y, restitution: e}, t: {gap: 1 - y, restitution: e}}
"""


class Impacts(Regimes):
    def rows(self, table):
        return [dict(zip(table, values)) for values in zip(*table.values())]

    def test_a_bouncing_ball_comes_to_rest_in_time(self):
        table, events = self.go(BOUNCE, "--duration", "12", "--samples", "1201")
        hits = [(t, impulse) for t, words, impulse in events if words == "floor hits"]
        first, v = math.sqrt(2 / G), math.sqrt(2 * G)
        rest = first * (1 + 2 * 0.9 / (1 - 0.9))
        self.assertAlmostEqual(rest, 8.578949179, delta=1e-9)
        (closed,) = self.instants(events, "floor closed")
        self.assertAlmostEqual(closed, rest, delta=1e-6)
        self.assertLess(len(hits), 300)
        self.assertGreater(len(hits), 100)
        for n, (t, impulse) in enumerate(hits[:-1]):
            self.assertAlmostEqual(t, first * (1 + 2 * 0.9 * (1 - 0.9**n) / (1 - 0.9)), delta=1e-10)
            self.assertAlmostEqual(impulse / (v * 1.9 * 0.9**n), 1, delta=1e-9 if n < 60 else 1e-3)
        for (t, _), (later, _), (third, _) in list(zip(hits, hits[1:], hits[2:]))[:80]:
            self.assertAlmostEqual((third - later) / (later - t), 0.9, delta=1e-8)
        for row in self.rows(table):
            self.assertGreaterEqual(row["z"], -1e-9)
            if row["t"] > closed:
                self.assertEqual((row["z"], row["z_dot"]), (0, 0))

    def test_each_impact_leaves_its_part_of_the_speed_to_twelve_digits(self):
        _, events = self.go(BOUNCE, "--duration", "8")
        impulses = [impulse for _, words, impulse in events if words == "floor hits"]
        self.assertGreater(len(impulses), 15)
        for one, other in zip(impulses, impulses[1:16]):
            self.assertAlmostEqual(other / one, 0.9, delta=1e-12)

    def test_a_ball_without_restitution_stays_at_once_and_one_with_all_of_it_never(self):
        table, events = self.go(BOUNCE, "--duration", "2", "--set", "e=0")
        self.assertEqual([words for _, words, _ in events], ["floor hits", "floor closed"])
        for row in self.rows(table):
            if row["t"] > math.sqrt(2 / G):
                self.assertEqual((row["z"], row["z_dot"]), (0, 0))
        table, events = self.go(BOUNCE, "--duration", "20", "--set", "e=1")
        first = math.sqrt(2 / G)
        self.assertEqual({words for _, words, _ in events}, {"floor hits"})
        self.assertEqual(len(events), int((20 / first + 1) / 2))
        for n, (t, _, _) in enumerate(events):
            self.assertAlmostEqual(t, (2 * n + 1) * first, delta=1e-9)
        for energy in table["energy.total"]:
            self.assertAlmostEqual(energy, G, delta=1e-9)

    def test_a_ball_bounces_in_long_double(self):
        rest = math.sqrt(2 / G) * 19
        _, events = self.go(BOUNCE, "--duration", "12", "--number", "long-double")
        self.assertAlmostEqual(self.instants(events, "floor closed")[0], rest, delta=1e-7)

    def test_a_ball_bounces_in_float(self):
        _, events = self.go(BOUNCE, "--duration", "12", "--number", "float", "--tolerance", "1e-6")
        self.assertAlmostEqual(self.instants(events, "floor closed")[0], math.sqrt(2 / G) * 19, delta=1e-3)

    def test_a_ball_hands_its_speed_on_to_another_one(self):
        table, events = self.go(PAIR, "--duration", "1")
        ((t, words, impulse),) = events
        self.assertEqual(words, "touch hits")
        self.assertAlmostEqual(t, 0.51, delta=1e-14)
        self.assertAlmostEqual(impulse, 2 * 1.5, delta=1e-13)  # m1 m2/(m1 + m2) (1 + e) v
        self.assertAlmostEqual(table["x_dot"][-1], -0.5, delta=1e-13)
        self.assertAlmostEqual(table["y_dot"][-1], 0.5, delta=1e-13)
        self.assertAlmostEqual(table["y"][-1], 0.11 + 0.5 * 0.49, delta=1e-13)

    def end_of_cradle(self, text):
        table, events = self.go(text, "--duration", "3", "--samples", "301")
        for row in self.rows(table):
            speeds = [row[f"x{i}_dot"] for i in range(1, 6)]
            self.assertAlmostEqual(sum(speeds), 1, delta=1e-13)
            self.assertAlmostEqual(sum(v * v for v in speeds), 1, delta=1e-12)
        last = self.rows(table)[-1]
        return [last[f"x{i}{dot}"] for dot in ("", "_dot") for i in range(1, 6)], events

    def test_balls_with_spaces_between_hand_on_all_of_the_speed(self):
        end, events = self.end_of_cradle(cradle(spaces="0.01"))
        hits = [(t, words, impulse) for t, words, impulse in events]
        self.assertEqual([words for _, words, _ in hits], [f"c{i} hits" for i in range(1, 5)])
        for i, (t, _, impulse) in enumerate(hits):  # 0.5 + 0.11 - 0.1 to the first, 0.01 to each of the others
            self.assertAlmostEqual(t, 0.51 + 0.01 * i, delta=1e-13)
            self.assertAlmostEqual(impulse, 1, delta=1e-13)
        expected = [0.01, 0.12, 0.23, 0.34, 0.44 + (3 - 0.54), 0, 0, 0, 0, 1]
        for one, other in zip(end, expected):
            self.assertAlmostEqual(one, other, delta=1e-12)

    def test_balls_that_touch_take_the_impact_together(self):
        # All gaps at once: the first gets -3/5 and the others 2/5, which keeps momentum and energy.
        end, events = self.end_of_cradle(cradle())
        self.assertEqual(self.instants(events, "c12 hits"), [])
        self.assertEqual(len(self.instants(events, "c1 hits")), 1)
        expected = [-0.6 * 2.5] + [0.1 * i + 0.4 * 2.5 for i in range(1, 5)] + [-0.6] + [0.4] * 4
        for one, other in zip(end, expected):
            self.assertAlmostEqual(one, other, delta=1e-12)

    def test_the_order_of_entries_says_nothing(self):
        orders = [((3, 5, 1, 2, 4), (4, 2, 1, 3)), ((5, 4, 3, 2, 1), (4, 3, 2, 1))]
        first, _ = self.end_of_cradle(cradle(spaces="0.01"))
        for balls, contacts in orders:
            other, _ = self.end_of_cradle(cradle(balls, contacts, spaces="0.01"))
            for a, b in zip(first, other):
                self.assertAlmostEqual(a, b, delta=1e-13)

    def test_the_order_of_entries_says_nothing_where_all_touch(self):
        first, _ = self.end_of_cradle(cradle())
        for balls, contacts in [((3, 5, 1, 2, 4), (4, 2, 1, 3)), ((5, 4, 3, 2, 1), (4, 3, 2, 1))]:
            other, _ = self.end_of_cradle(cradle(balls, contacts))
            for a, b in zip(first, other):
                self.assertAlmostEqual(a, b, delta=1e-13)

    def test_a_corner_sends_a_ball_back_whichever_wall_is_named_first(self):
        left, low = "left: {gap: x, restitution: e}", "low: {gap: y, restitution: e}"
        for text in (WEDGED, WEDGED.replace(f"{left}, {low}", f"{low}, {left}")):
            table, events = self.go(text, "--duration", "1")
            self.assertEqual(sorted(words for _, words, _ in events), ["left hits", "low hits"])
            for t, words, impulse in events:
                self.assertAlmostEqual(t, 0.5, delta=1e-14)
                self.assertAlmostEqual(impulse, 8 if words == "left hits" else 12, delta=1e-12)
            for name, value in (("x", 1), ("y", 1.5), ("x_dot", 2), ("y_dot", 3)):
                self.assertAlmostEqual(table[name][-1], value, delta=1e-13)

    def test_a_pendulum_meets_its_stop_when_elliptic_integrals_say(self):
        table, events = self.go(STOP, "--duration", "5", "--tolerance", "1e-12", "--samples", "1001")
        hits = [(t, impulse) for t, words, impulse in events if words == "stop hits"]
        self.assertEqual(len(hits), 5)
        w, lo, amplitude = math.sqrt(G / 0.5), 0.2, 1.2
        t = swing(amplitude, amplitude, w) + swing(amplitude, lo, w)
        instants = []
        for found, impulse in hits:
            self.assertAlmostEqual(found, t, delta=1e-9)
            v = w * math.sqrt(2 * (math.cos(lo) - math.cos(amplitude)))
            self.assertAlmostEqual(impulse, 1.5 * v * 0.25, delta=1e-9)  # along an angle: m l^2 (1 + e) v
            instants.append((t, amplitude))
            amplitude = math.acos(math.cos(lo) - 0.25 * v * v / (2 * w * w))
            t += 2 * (swing(amplitude, amplitude, w) + swing(amplitude, lo, w))
        for row in self.rows(table):
            self.assertGreaterEqual(row["theta"], -lo - 1e-12)
            done = sum(t < row["t"] for t, _ in instants)
            # Of the energy over the stop each takes all but e^2.
            kinetic = G * 0.5 * (math.cos(lo) - math.cos(1.2)) * 0.25**done
            self.assertAlmostEqual(row["energy.total"], kinetic - G * 0.5 * math.cos(lo), delta=1e-10)

    def test_impulses_along_angles_have_another_unit_than_those_along_lengths(self):
        def head(text):
            self.go(text, "--duration", "1")
            return (self.folder / "x.events.csv").read_text(encoding="utf-8").splitlines()

        ball = ("gauss: 1\nname: ball\nparameters: {m: {value: 2, unit: kg}, l: {value: 0.5, unit: m}, g: {value: 9.81, unit: m/s^2}, lo: {value: 0.2, unit: rad}}\n"
                "coordinates: {z: {unit: m, initial: 0.1}, theta: {unit: rad, initial: 1.2}}\n"
                "particles: {ball: {mass: m, position: [0, 0, z]}, bob: {mass: m, position: [l*sin(theta), 0, -l*cos(theta)]}}\n"
                "contacts: {floor: {gap: z}, stop: {gap: theta + lo}}\nforces: {gravity: {uniform: [0, 0, -g]}}\n")
        self.assertEqual(head(ball.replace(", stop: {gap: theta + lo}", ""))[0], "t [s],event,impulse [N*s]")
        self.assertEqual(head(ball.replace("floor: {gap: z}, ", ""))[0], "t [s],event,impulse [N*m*s]")
        self.write("model.yaml", ball)
        self.ok("run", "model.yaml", "-q", "--duration", "1", "-o", "x.csv")
        rows = [line.split(",") for line in (self.folder / "x.events.csv").read_text(encoding="utf-8").splitlines()]
        self.assertEqual(rows[0], ["t [s]", "event", "impulse", "unit"])
        units = {row[1]: row[3] for row in rows[1:]}
        self.assertEqual((units["floor hits"], units["stop hits"], units["floor closed"]), ("N*s", "N*m*s", ""))
        self.assertEqual(head(STOP)[0], "t [s],event,impulse")  # it states no units

    def test_a_rope_goes_slack_where_its_tension_ends_and_the_bob_flies(self):
        table, events = self.go(ROPE, "--duration", "0.9", "--tolerance", "1e-12", "--outputs", "state,reactions", "--samples", "901")
        # m v^2/l + m g cos(phi) = 0 with v^2 = v0^2 - 2 g l (1 - cos(phi))
        phi = math.acos((2 * G - 4.5**2) / (3 * G))
        slack = integral(lambda a: 1 / math.sqrt(4.5**2 - 2 * G * (1 - math.cos(a))), 0, phi)
        self.assertAlmostEqual(self.instants(events, "rope open")[0], slack, delta=1e-9)
        v = math.sqrt(-G * math.cos(phi))
        x0, z0, vx, vz = math.sin(phi), -math.cos(phi), v * math.cos(phi), v * math.sin(phi)

        def flight(s):
            return x0 + vx * s, z0 + vz * s - G * s * s / 2

        # The distance is l again: |r|^2 - l^2 = s^3 (g^2 s/4 - g vz), for the curve touches the circle with its curvature.
        flies = 4 * vz / G
        again = slack + flies
        (taut,) = self.instants(events, "rope hits")
        self.assertAlmostEqual(taut, again, delta=1e-8)
        (x, z), (u, w) = flight(flies), (vx, vz - G * flies)
        impulse = [i for _, words, i in events if words == "rope hits"][0]
        self.assertAlmostEqual(impulse, u * x + w * z, delta=1e-7)
        along = -u * z + w * x  # what is left of the speed
        for row in self.rows(table):
            t, distance = row["t"], math.hypot(row["x"], row["z"])
            self.assertLess(distance, 1 + 1e-9)
            if t < slack:
                tension = (row["x_dot"] ** 2 + row["z_dot"] ** 2) - G * row["z"]
                self.assertAlmostEqual(row["reactions.rope.multiplier"], tension, delta=1e-8)
                self.assertAlmostEqual(distance, 1, delta=1e-12)
            elif t < again:
                self.assertAlmostEqual(row["x"], flight(t - slack)[0], delta=1e-8)
                self.assertAlmostEqual(row["z"], flight(t - slack)[1], delta=1e-8)
                self.assertEqual(row["reactions.rope.multiplier"], 0)
            else:
                energy = (row["x_dot"] ** 2 + row["z_dot"] ** 2) / 2 + G * row["z"]
                self.assertAlmostEqual(energy, along * along / 2 + G * z, delta=1e-6)
                self.assertAlmostEqual(distance, 1, delta=1e-12)

    def test_a_block_leaves_a_shaken_table_that_falls_faster_than_it(self):
        table, events = self.go(TABLE, "--duration", "0.3", "--tolerance", "1e-12", "--outputs", "state,reactions")
        a, w = 0.05, 20
        leaves = math.asin(G / (a * w * w)) / w
        self.assertAlmostEqual(self.instants(events, "table open")[0], leaves, delta=1e-10)
        z0, v0 = a * math.sin(w * leaves), a * w * math.cos(w * leaves)

        def height(t):
            return z0 + v0 * (t - leaves) - G * (t - leaves) ** 2 / 2

        lands = root(lambda t: height(t) - a * math.sin(w * t), 0.1, 0.3)
        (hit,) = self.instants(events, "table hits")
        self.assertAlmostEqual(hit, lands, delta=1e-9)
        impulse = [i for _, words, i in events if words == "table hits"][0]
        self.assertAlmostEqual(impulse, 2 * (a * w * math.cos(w * lands) - v0 + G * (lands - leaves)), delta=1e-8)
        for row in self.rows(table):
            t = row["t"]
            if t < leaves:
                self.assertAlmostEqual(row["z"], a * math.sin(w * t), delta=1e-12)
                self.assertAlmostEqual(row["reactions.table.multiplier"], 2 * (G - a * w * w * math.sin(w * t)), delta=1e-9)
            elif t < lands:
                self.assertAlmostEqual(row["z"], height(t), delta=1e-10)
                self.assertEqual(row["reactions.table.multiplier"], 0)

    def test_a_contact_that_opens_is_not_hit_at_once(self):
        for samples in (301, 501, 601, 701):
            _, events = self.go(TABLE, "--duration", "0.3", "--tolerance", "1e-12", "--samples", samples)
            self.assertEqual([words for _, words, _ in events], ["table closed", "table open", "table hits", "table closed"], samples)

    def test_more_and_more_impacts_end_with_an_error(self):
        # Two walls come together: before they do the ball meets them without end, faster each time.
        self.write("walls.yaml", PAIR.replace("pair", "walls").replace(", y: {initial: 0.11}", "").replace(
            ", b: {mass: M, position: [y, 0, 0]}", "").replace(
            "touch: {gap: y - x - 0.1, restitution: 1}", "left: {gap: x + 1, restitution: 1}, right: {gap: 1 - t - x, restitution: 1}"))
        result = self.run_it("run", "walls.yaml", "--duration", "3", "-q", "-o", "x.csv", timeout=8)
        self.assertEqual(result.returncode, 5, result.stderr)
        self.assertEqual(self.summary("x.json")["outcome"], "too many events")

    def test_tolerances_and_methods_find_the_same_instants(self):
        _, exact = self.go(STOP, "--duration", "5", "--tolerance", "1e-13")
        for how in (["--tolerance", "1e-10"], ["--method", "dopri5", "--tolerance", "1e-11"], ["--method", "fehlberg78"],
                    ["--longest-step", "0.002"], ["--samples", "2"], ["--engine", "interpreted"]):
            _, events = self.go(STOP, "--duration", "5", *how)
            self.assertEqual([words for _, words, _ in events], [words for _, words, _ in exact], how)
            for (t, _, _), (other, _, _) in zip(events, exact):
                self.assertAlmostEqual(t, other, delta=1e-9, msg=how)

    def test_a_box_that_tumbles_and_comes_to_rest_moves_alike_however_it_is_integrated(self):
        """Four corners with restitution and friction, bounces without end on one corner while the other one slides."""
        rows = []
        for options in (("--tolerance", "1e-9"), ("--tolerance", "1e-11"), ("--tolerance", "1e-13"),
                        ("--tolerance", "1e-12", "--longest-step", "1e-3"), ("--tolerance", "1e-12", "--longest-step", "3e-4")):
            table, events = self.go(BOX_IN_AIR, "--duration", "2", "--samples", "201", *options, timeout=20)
            rows.append([column[60:] for name, column in table.items() if not name.startswith("energy")])
            energy = table["energy.total"]
            self.assertTrue(all(later <= before + 1e-9 for before, later in zip(energy, energy[1:])))
            for z, phi in zip(table["z"], table["phi"]):
                for x, height in ((-0.5, -0.3), (0.5, -0.3), (-0.5, 0.3), (0.5, 0.3)):
                    self.assertGreater(z - x * math.sin(phi) + height * math.cos(phi), -1e-8)
            for name in ("x_dot", "z_dot", "phi_dot"):
                self.assertAlmostEqual(table[name][-1], 0, delta=1e-300)
            self.assertGreater(len(events), 40)
        for other in rows[1:]:
            for one, column in zip(rows[0], other, strict=True):
                self.assertLess(max(abs(a - b) for a, b in zip(one, column)), 1e-7)

    def test_a_tower_that_is_dropped_stands_in_the_end(self):
        """Bounces without end on what itself has come to rest, after it, and on what still bounces."""
        for e in (0.1, 0.3, 0.6):
            table, events = self.go(TOWER, "--duration", "5", "--set", f"e={e}", "--outputs", "state,reactions,modes", timeout=20)
            for name, value in (("a", 0), ("b", 0.5), ("c", 1), ("a_dot", 0), ("b_dot", 0), ("c_dot", 0)):
                self.assertAlmostEqual(table[name][-1], value, delta=1e-9)
            for name, value in (("c0", 3 * G), ("c1", 2 * G), ("c2", G)):
                self.assertAlmostEqual(table[f"reactions.{name}.multiplier"][-1], value, delta=1e-12)
                self.assertEqual(table[f"modes.{name}"][-1], 1)
            self.assertTrue(all(impulse > 0 for _, words, impulse in events if words.endswith("hits")))
            for i in range(len(table["t"])):
                a, b, c = (table[name][i] for name in "abc")
                self.assertTrue(a > -1e-9 and b > a + 0.5 - 1e-9 and c > b + 0.5 - 1e-9)

    def test_a_plank_on_more_posts_than_it_needs_tips_where_statics_says(self):
        table, events = self.go(PLANK, "--duration", "6", "--samples", "121", "--outputs", "z,phi,modes,reactions", timeout=20)
        tips = 4 * G * 0.25 / 2  # T t = m g d
        (opens,) = [t for t, words, _ in events if words == "B open"]
        self.assertAlmostEqual(opens, tips, delta=1e-9)
        for i, t in enumerate(table["t"]):
            reactions = [table[f"reactions.{name}.multiplier"][i] for name in "ABC"]
            if 1e-3 < t < tips:
                self.assertAlmostEqual(sum(reactions), 4 * G, delta=1e-9)
                self.assertAlmostEqual(0.25 * (reactions[2] - reactions[0]), 2 * t, delta=1e-9)
                self.assertTrue(all(reaction >= 0 for reaction in reactions))
            if t < tips:
                self.assertAlmostEqual(table["phi"][i], 0, delta=1e-11)
        self.assertGreater(table["phi"][-1], 0.1)
        # A load that walks off at 0.5 m/s, on seven posts 0.2 m apart: beyond the last but one by (m/M) times its distance.
        table, events = self.go(WALK, "--duration", "3", "--samples", "7", "--outputs", "z,phi,modes", timeout=60)
        self.assertAlmostEqual(events[-1][0], (0.6 + 0.6 * 4 / 3) / 0.5, delta=1e-9)
        self.assertAlmostEqual(table["phi"][5], 0, delta=1e-15)

    def test_the_unit_of_length_is_of_no_matter_to_an_impact(self):
        """Friction along the ground, and against rolling and spinning, of a ball of 3 cm and of one of 30 nm."""
        spins = []
        for length in (1, 1e-6):
            table, _ = self.go(SPINNING, "--duration", "0.15", "--samples", "2", "--set", f"L={length}")
            spins.append([table[name][-1] for name in ("wx", "wy", "wz")] + [table["x_dot"][-1] / length])
        for one, other in zip(*spins):
            self.assertAlmostEqual(one, other, delta=1e-11)
        self.assertLess(spins[0][0], -1)

    def test_what_lands_elsewhere_changes_nothing(self):
        changed = SPINNING.replace("contacts: {", "contacts: {heavy: {gap: Z}, ").replace("coordinates: {", "coordinates: {Z: {initial: L*0.1}, ")
        for mass in (1e-6, 1, 1e12):
            table, _ = self.go(SPINNING, "--duration", "0.15", "--samples", "2")
            with_other, _ = self.go(changed + f"particles: {{other: {{mass: {mass}, position: [5, 0, Z]}}}}\n", "--duration", "0.15", "--samples", "2")
            for name in ("wx", "wy", "wz", "x_dot", "z_dot"):
                self.assertAlmostEqual(with_other[name][-1], table[name][-1], delta=1e-12, msg=(name, mass))

    def test_a_gap_is_none_by_its_own_size(self):
        """Not by that of coordinates that it has nothing to do with, nor by its factor."""
        ball = """gauss: 1
name: ball
parameters: {m: 1, g: 9.81, k: 1}
coordinates: {z: {initial: 0.001}, th: {initial: 1e6}}
bodies: {wheel: {mass: 1, inertia: [1, 1, 1], position: [0, 0, 0], orientation: {axis: z, angle: th}}}
particles: {p: {mass: m, position: [0, 0, z]}}
contacts: {floor: {gap: k*z}}
forces: {weight: {generalized: {z: -m*g}}}
"""
        for k in ("1", "1e-9", "1e9"):
            table, events = self.go(ball, "--duration", "0.1", "--samples", "3", "--set", f"k={k}")
            self.assertEqual(table["z"][0], 0.001)
            self.assertAlmostEqual(self.instants(events, "floor hits")[0], math.sqrt(0.002 / G), delta=1e-9)
        dock = """gauss: 1
name: dock
parameters: {m: 1}
coordinates: {x: {initial: 7e6, initial_rate: 0.001}, y: {initial: 7e6 + 0.005}}
particles: {p: {mass: m, position: [x, 0, 0]}, q: {mass: m, position: [y, 0, 0]}}
contacts: {dock: {gap: y - x}}
"""
        _, events = self.go(dock, "--duration", "10", "--samples", "3")
        self.assertAlmostEqual(self.instants(events, "dock hits")[0], 5, delta=1e-5)

    def test_two_frictions_on_one_block_hold_together(self):
        """Up to the sum of their limits, in either order, and then both act."""
        for first, second in (("a", "b"), ("b", "a")):
            limits = {"a": 1, "b": 3}
            text = f"""gauss: 1
name: brakes
parameters: {{m: 1, c: 1}}
coordinates: {{x: {{}}}}
particles: {{p: {{mass: m, position: [x, 0, 0]}}}}
forces:
  pull: {{generalized: {{x: c*t}}}}
  {first}: {{friction: dot(x), limit: {limits[first]}}}
  {second}: {{friction: dot(x), limit: {limits[second]}}}
"""
            table, _ = self.go(text, "--duration", "6", "--samples", "13")
            for t, x in zip(table["t"], table["x"]):
                self.assertAlmostEqual(x, max(t - 4, 0) ** 3 / 6, delta=1e-9)

    def test_samples_at_the_instant_of_an_impact_are_no_error(self):
        self.write("model.yaml", ROOM)  # speeds 1: hits walls at 0.5, which is a sample
        said = self.ok("run", "model.yaml", "--duration", "2", "--samples", "101", "-o", "x.csv")
        self.assertIn("hits", said)
        self.assertLess(self.summary("x.json")["error_estimate"]["relative"], 1e-10)



if __name__ == "__main__":
    unittest.main()
