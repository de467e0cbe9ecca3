"""Loads that more contacts, friction and links share than a body needs: against statics."""

import math
import unittest

from gauss_sim import Regimes

G = 9.81

FEET = """gauss: 1
name: feet
parameters: {{m: 1, J: 0.05, l: 0.5, h: 0.1, g: 9.81, c: 1, mu_l: 0.2, mu_r: 0.6}}
coordinates: {{x: {{}}, z: {{initial: 0.1}}, th: {{}}}}
bodies:
  box: {{mass: m, inertia: [J, J, J], position: [x, 0, z], orientation: {{axis: y, angle: th}}}}
points:
  L: {{on: box, at: [-l, 0, -h]}}
  R: {{on: box, at: [l, 0, -h]}}
contacts:
  left: {{gap: L.z}}
  right: {{gap: R.z}}
forces:
  gravity: {{uniform: [0, 0, -g]}}
  pull: {{generalized: {{x: c*t, th: -h*c*t}}}}
{frictions}"""

FRICTIONS_OF_FEET = ["  at_left: {friction: dot(L.x), limit: mu_l*left.reaction}\n",
                     "  at_right: {friction: dot(R.x), limit: mu_r*right.reaction}\n"]

LADDER = """gauss: 1
name: ladder
parameters: {m: 1, J: 0.02083333333333333, l: 0.5, g: 9.81, c: 1, mu: 0.5}
coordinates: {x: {initial: 0.15}, z: {initial: 0.2}, th: {initial: "atan2(0.8, 0.6)"}}
bodies:
  rod: {mass: m, inertia: [J, J, J], position: [x, 0, z], orientation: {axis: y, angle: th}}
points:
  foot: {on: rod, at: [l/2, 0, 0]}
  top: {on: rod, at: [-l/2, 0, 0]}
contacts:
  floor: {gap: foot.z}
  wall: {gap: top.x}
forces:
  gravity: {uniform: [0, 0, -g]}
  pull: {on: foot, force: [c*t, 0, 0]}
  at_floor: {friction: dot(foot.x), limit: mu*floor.reaction}
  at_wall: {friction: dot(top.z), limit: mu*wall.reaction}
"""

TABLE = """gauss: 1
name: table
parameters: {m: 10, g: 9.81, a: 0.5, b: 0.3, h: 0.4, p: 10, mu: 0.5, mu_0: 0.6, arm: 0}
coordinates:
  x: {}
  y: {}
  z: {initial: h}
orientations: {q: {quaternion: [e0, e1, e2, e3], angular_velocity: [wx, wy, wz]}}
bodies:
  top: {mass: m, inertia: [m*b^2/3, m*a^2/3, m*(a^2 + b^2)/3], position: [x, y, z], orientation: q}
points:
  l1: {on: top, at: [a, b, -h]}
  l2: {on: top, at: [-a, b, -h]}
  l3: {on: top, at: [-a, -b, -h]}
  l4: {on: top, at: [a, -b, -h]}
  hand: {on: top, at: [0, arm, -h]}
contacts:
  leg1: {gap: l1.z}
  leg2: {gap: l2.z}
  leg3: {gap: l3.z}
  leg4: {gap: l4.z}
forces:
  weight: {uniform: [0, 0, -g]}
  push: {on: hand, force: [p*t, 0, 0]}
  f1: {friction: [dot(l1.x), dot(l1.y)], limit: mu*leg1.reaction, static_limit: mu_0*leg1.reaction}
  f2: {friction: [dot(l2.x), dot(l2.y)], limit: mu*leg2.reaction, static_limit: mu_0*leg2.reaction}
  f3: {friction: [dot(l3.x), dot(l3.y)], limit: mu*leg3.reaction, static_limit: mu_0*leg3.reaction}
  f4: {friction: [dot(l4.x), dot(l4.y)], limit: mu*leg4.reaction, static_limit: mu_0*leg4.reaction}
"""

SHAFT = """gauss: 1
name: shaft
parameters: {m: 1, g: 9.81, mu: 0.5, side: 0}
coordinates: {x: {}, z: {}}
particles: {p: {mass: m, position: [x, 0, z]}}
contacts:
  left: {gap: x}
  right: {gap: -x}
forces:
  gravity: {uniform: [0, 0, -g]}
  pressed: {uniform: [side/m, 0, 0]}
  at_left: {friction: dot(z), limit: mu*left.reaction}
  at_right: {friction: dot(z), limit: mu*right.reaction}
"""

WEDGE = """gauss: 1
name: wedge
parameters: {{be: 0.1, mu: 0.5}}
coordinates: {{x: {{}}, z: {{}}}}
particles: {{p: {{mass: 1, position: [x, 0, z]}}}}
contacts:
{faces}forces:
  load: {{generalized: {{z: t - 10}}}}
  fl: {{friction: -dot(x)*sin(be) + dot(z)*cos(be), limit: mu*l.reaction}}
  fr: {{friction: dot(x)*sin(be) + dot(z)*cos(be), limit: mu*r.reaction}}
"""

TIPPING = """gauss: 1
name: tipping
parameters: {m: 1, J: 0.1, w: 0.2, g: 9.81, mu: 0.5, side: 30}
coordinates: {x: {}, z: {}, th: {}}
bodies:
  box: {mass: m, inertia: [J, J, J], position: [x, 0, z], orientation: {axis: y, angle: th}}
points:
  L: {on: box, at: [-w, 0, 0]}
  R: {on: box, at: [w, 0, 0]}
contacts:
  left: {gap: L.x + w}
  right: {gap: w - R.x}
forces:
  gravity: {uniform: [0, 0, -g]}
  pressed: {uniform: [side/m, 0, 0]}
  at_left: {friction: dot(L.z), limit: mu*left.reaction}
  at_right: {friction: dot(R.z), limit: mu*right.reaction}
"""

LINKS = """gauss: 1
name: links
parameters: {{m: 1, g: 9.81}}
coordinates: {{x: {{}}, z: {{initial: -1}}}}
particles: {{p: {{mass: m, position: [x, 0, z]}}}}
points: {{o: {{at: [0, 0, 0]}}}}
constraints:
{bars}forces:
  gravity: {{uniform: [0, 0, -g]}}
  load: {{on: p, force: [0, 0, -t]}}
"""


PUCKS = """gauss: 1
name: pucks
parameters: {m: 1, g: 9.81, mu: 0.2, alpha: 0.5}
coordinates: {x1: {}, y1: {}, z1: {}, x2: {}, y2: {initial: 1}, z2: {}}
particles:
  a: {mass: m, position: [x1, y1, z1]}
  b: {mass: m, position: [x2, y2, z2]}
contacts: {under_a: {gap: z1}, under_b: {gap: z2}}
forces:
  gravity: {uniform: [g*sin(alpha), 0, -g*cos(alpha)]}
  at_a: {friction: [dot(x1), dot(y1)], limit: mu*under_a.reaction}
  at_b: {friction: [dot(x2), dot(y2)], limit: mu*under_b.reaction}
"""

BEAM = """gauss: 1
name: beam
parameters: {m: 40, g: 9.81, J: 10, k: 40}
coordinates: {z: {}, th: {}}
bodies: {beam: {mass: m, inertia: [J, J, J], position: [0, 0, z], orientation: {axis: y, angle: th}}}
constraints:
  h1: {equation: z + 1.5*sin(th), breaks_at: 150}
  h2: {equation: z + 0.5*sin(th), breaks_at: 150}
  h3: {equation: z - 0.5*sin(th), breaks_at: 150}
  h4: {equation: z - 1.5*sin(th), breaks_at: 150}
forces:
  gravity: {uniform: [0, 0, -g]}
  load: {generalized: {z: -k*t}}
"""

DROP = """gauss: 1
name: drop
parameters: {m: 3, a: 0.4, b: 0.3, h: 0.2, g: 9.81, e: 0.5}
coordinates: {x: {initial_rate: 1}, y: {}, z: {initial: h + 0.3}}
orientations: {q: {quaternion: [e0, e1, e2, e3], angular_velocity: [wx, wy, wz]}}
bodies: {box: {mass: m, inertia: [m*(b^2+h^2)/3, m*(a^2+h^2)/3, m*(a^2+b^2)/3], position: [x, y, z], orientation: q}}
points:
  p1: {on: box, at: [a, b, -h]}
  p2: {on: box, at: [a, -b, -h]}
  p3: {on: box, at: [-a, b, -h]}
  p4: {on: box, at: [-a, -b, -h]}
contacts:
  c1: {gap: p1.z, restitution: e}
  c2: {gap: p2.z, restitution: e}
  c3: {gap: p3.z, restitution: e}
  c4: {gap: p4.z, restitution: e}
forces: {gravity: {uniform: [0, 0, -g]}}
"""

BLOCK_ON_BOX = """gauss: 1
name: block_on_box
parameters: {m: 2, M: 6, A: 0.4, H: 0.1, g: 9.81, mu: 0.35, nu: 0.25, k: 10}
coordinates: {x: {}, z: {initial: 2*H}, X: {}, Z: {initial: H}, P: {}}
bodies: {low: {mass: M, inertia: [0, M*(A^2+H^2)/3, 0], position: [X, 0, Z], orientation: {axis: y, angle: P}}}
particles: {top: {mass: m, position: [x, 0, z]}}
points: {l1: {on: low, at: [A, 0, -H]}, l2: {on: low, at: [-A, 0, -H]}}
contacts:
  ct: {gap: (x - X)*sin(P) + (z - Z)*cos(P) - H}
  cl1: {gap: l1.z}
  cl2: {gap: l2.z}
forces:
  gravity: {uniform: [0, 0, -g]}
  pull: {force: [k*t, 0, 0], on: low}
  ft: {friction: (dot(x) - dot(X))*cos(P) - (dot(z) - dot(Z))*sin(P), limit: mu*ct.reaction}
  fl1: {slides: low, at: l1, directions: [x], limit: nu*cl1.reaction}
  fl2: {slides: low, at: l2, directions: [x], limit: nu*cl2.reaction}
"""

DOOR = """gauss: 1
name: door
parameters: {m: 1, g: 9.81, mu: 0.4}
coordinates: {x: {}, z: {}}
particles: {p: {mass: m, position: [x, 0, z]}}
constraints:
  rail: {equation: z}
  doubled: {equation: 2*z}
forces:
  gravity: {uniform: [0, 0, -g]}
  pull: {generalized: {x: t}}
  rubs: {friction: dot(x), limit: mu*rail.reaction}
"""


GROOVE = """gauss: 1
name: groove
parameters: {m: 1, r: 0.1, g: 9.81, beta: 0.3, mu: 0.5, e: 0.5}
coordinates: {x: {}, z: {initial: 0.5}, th: {}}
bodies: {disc: {mass: m, inertia: [m*r^2/2, m*r^2/2, m*r^2/2], position: [x, 0, z], orientation: {axis: y, angle: th}}}
contacts:
  left: {gap: x*cos(beta) + z*sin(beta), restitution: e}
  right: {gap: -x*cos(beta) + z*sin(beta), restitution: e}
forces:
  gravity: {uniform: [0, 0, -g]}
  at_left: {friction: -dot(x)*sin(beta) + dot(z)*cos(beta) - r*dot(th), limit: mu*left.reaction}
  at_right: {friction: dot(x)*sin(beta) + dot(z)*cos(beta) + r*dot(th), limit: mu*right.reaction}
"""


def least(function, low, high):
    """Of a convex function."""
    for _ in range(100):
        a, b = low + (high - low) / 3, high - (high - low) / 3
        low, high = (low, b) if function(a) < function(b) else (a, high)
    return function((low + high) / 2)


def push_that_turns_a_table(arm, limit, legs):
    """That whose power is what friction takes, of the motion of the table for which this is least (the upper bound theorem):
    turning with w, and with vy sideways, while the hand goes with 1."""
    def taken(w, vy):
        vx = 1 + w * arm
        return sum(limit * math.hypot(vx - w * y, vy + w * x) for x, y in legs)
    return least(lambda w: least(lambda vy: taken(w, vy), -5, 5), -20, 20)


class Loads(Regimes):
    def instants(self, events, mode):
        return [t for t, words, _ in events if words.endswith(mode)]

    def test_a_box_on_two_feet_holds_as_much_as_both_bear_together(self):
        slips = (0.2 + 0.6) * G / 2
        for frictions, engine in ((FRICTIONS_OF_FEET, "interpreted"), (FRICTIONS_OF_FEET[::-1], "compiled")):
            table, events = self.go(FEET.format(frictions="".join(frictions)), "--duration", "6", "--samples", "13", "--engine", engine)
            self.assertEqual(self.instants(events, "sticks"), [0, 0])
            for t in self.instants(events, "forwards"):
                self.assertAlmostEqual(t, slips, delta=1e-13)
            for t, x in zip(table["t"], table["x"]):
                if t < slips:
                    self.assertEqual(x, 0)
                else:
                    # m a (1 - (mu_r - mu_l) h/(2 l)) = F - (mu_l + mu_r) m g/2: what accelerates the box leans it on its left foot
                    self.assertAlmostEqual(x, (t - slips) ** 3 / 6 / (1 - 0.4 * 0.1 / 2 / 0.5), delta=1e-9)

    def test_a_ladder_in_a_corner_holds_as_long_as_any_share_of_its_load_does(self):
        """Where it slips, both frictions are at their limits: N_f + mu N_w = m g, N_w + F = mu N_f, and no moment about the foot."""
        mu, weight, base, height = 0.5, G, 0.3, 0.4
        # m g base/2 = N_w height + mu N_w base
        wall = weight * base / 2 / (height + mu * base)
        slips = mu * (weight - mu * wall) - wall
        table, events = self.go(LADDER, "--duration", "2", "--samples", "21")
        self.assertAlmostEqual(self.instants(events, "at_floor forwards")[0], slips, delta=1e-12)
        self.assertAlmostEqual(self.instants(events, "at_wall backwards")[0], slips, delta=1e-12)
        for t, x in zip(table["t"], table["x"]):
            if t < slips:
                self.assertAlmostEqual(x, 0.15, delta=1e-15)
        self.assertGreater(table["x"][-1], 0.151)

    def test_a_table_on_four_legs_slides_where_it_is_pushed(self):
        """Eight slips of one body, of which three are independent."""
        table, events = self.go(TABLE, "--duration", "8", "--samples", "17", timeout=60)
        slips = 0.6 * G
        for t in self.instants(events, "slides"):
            self.assertAlmostEqual(t, slips, delta=1e-12)
        self.assertEqual([words for _, words, _ in events if words.endswith("open")], [])
        for t, x, y in zip(table["t"], table["x"], table["y"]):
            s = max(t - slips, 0)
            self.assertAlmostEqual(x, 0.1 * G * s ** 2 / 2 + s ** 3 / 6, delta=1e-8)
            self.assertAlmostEqual(y, 0, delta=1e-8)

    def test_a_table_that_is_pushed_beside_its_middle_turns_where_limit_analysis_says(self):
        legs = [(0.5, 0.3), (-0.5, 0.3), (-0.5, -0.3), (0.5, -0.3)]
        slips = push_that_turns_a_table(0.2, 0.6 * 10 * G / 4, legs) / 10
        table, events = self.go(TABLE.replace("arm: 0}", "arm: 0.2}"), "--duration", "6", "--samples", "13", timeout=60)
        for t in self.instants(events, "slides"):
            self.assertAlmostEqual(t, slips, delta=1e-9)
        self.assertLess(table["e3"][-1], -1e-3)

    def test_walls_hold_a_body_only_where_something_presses_it_against_them(self):
        table, _ = self.go(SHAFT, "--duration", "1", "--samples", "11")
        for t, z in zip(table["t"], table["z"]):
            self.assertAlmostEqual(z, -G * t ** 2 / 2, delta=1e-12)
        # Against one wall, with 30 N: 15 N of friction, more than the weight.
        table, events = self.go(SHAFT.replace("side: 0", "side: 30"), "--duration", "1", "--samples", "11")
        self.assertEqual(set(table["z"]), {0})
        # With 10 N: 5 N.
        table, events = self.go(SHAFT.replace("side: 0", "side: 10"), "--duration", "1", "--samples", "11")
        self.assertAlmostEqual(table["z"][-1], -(G - 5) / 2, delta=1e-12)

    def test_nor_do_walls_that_go_apart(self):
        """A particle between faces that are 0.1 rad off the vertical: friction of which one would 'slide' without a slip could hold it."""
        shaft = SHAFT.replace("gap: x}", "gap: x*cos(0.1) - z*sin(0.1)}").replace("gap: -x}", "gap: -x*cos(0.1) - z*sin(0.1)}")
        shaft = shaft.replace("at_left: {friction: dot(z),", "at_left: {friction: dot(x)*sin(0.1) + dot(z)*cos(0.1),")
        shaft = shaft.replace("at_right: {friction: dot(z),", "at_right: {friction: -dot(x)*sin(0.1) + dot(z)*cos(0.1),")
        table, _ = self.go(shaft, "--duration", "1", "--samples", "11")
        for t, z in zip(table["t"], table["z"]):
            self.assertAlmostEqual(z, -G * t ** 2 / 2, delta=1e-12)

    def test_a_wedge_holds_as_long_as_something_presses_it_in(self):
        """Steep walls with friction could hold it for ever by pressing each other: it leaves when it is pulled, after 10 s."""
        for order in (1, -1):
            faces = ["  l: {gap: x*cos(be) + z*sin(be)}\n", "  r: {gap: -x*cos(be) + z*sin(be)}\n"][::order]
            table, events = self.go(WEDGE.format(faces="".join(faces)), "--duration", "12", "--samples", "7")
            for mode in ("l open", "r open"):
                self.assertAlmostEqual(self.instants(events, mode)[0], 10, delta=1e-12)
            self.assertEqual(set(table["z"][:6]), {0})
            self.assertAlmostEqual(table["z"][-1], 2 ** 3 / 6, delta=1e-12)

    def test_constraints_that_depend_on_each_other_give_friction_no_more_than_their_share(self):
        _, events = self.go(DOOR, "--duration", "6", "--samples", "3")
        [slides] = self.instants(events, "forwards")
        self.assertLess(slides, 0.4 * G + 1e-9)

    def test_pucks_that_begin_to_slide_together_go_their_ways(self):
        table, _ = self.go(PUCKS, "--duration", "1", "--samples", "11")
        a = G * (math.sin(0.5) - 0.2 * math.cos(0.5))
        for name in ("x1", "x2"):
            for t, x in zip(table["t"], table[name]):
                self.assertAlmostEqual(x, a * t ** 2 / 2, delta=1e-10)

    def test_a_ladder_on_two_feet_slips_as_on_one(self):
        """Pushed along an axis, so that a slip begins exactly in the direction in which nobody may look first."""
        wide = LADDER.replace('z: {initial: 0.2}', 'y: {}, z: {initial: 0.2}').replace("position: [x, 0, z]", "position: [x, y, z]")
        for name, place in (("foot", "l/2"), ("top", "-l/2")):
            wide = wide.replace(f"  {name}: {{on: rod, at: [{place}, 0, 0]}}\n",
                                "".join(f"  {name}{i}: {{on: rod, at: [{place}, {w}, 0]}}\n" for i, w in ((1, 0.1), (2, -0.1))))
        wide = wide.replace("  floor: {gap: foot.z}\n  wall: {gap: top.x}\n",
                            "".join(f"  floor{i}: {{gap: foot{i}.z}}\n  wall{i}: {{gap: top{i}.x}}\n" for i in (1, 2)))
        wide = wide.replace("  pull: {on: foot, force: [c*t, 0, 0]}", "  pull: {on: foot, force: [c*t, 0, 0]}".replace("foot", "middle"))
        wide = wide.replace("points:\n", "points:\n  middle: {on: rod, at: [l/2, 0, 0]}\n")
        a, b = wide.index("  at_floor:"), len(wide)
        wide = wide[:a] + "".join(f"  at_floor{i}: {{friction: [dot(foot{i}.x), dot(foot{i}.y)], limit: mu*floor{i}.reaction}}\n"
                                  f"  at_wall{i}: {{friction: [dot(top{i}.y), dot(top{i}.z)], limit: mu*wall{i}.reaction}}\n" for i in (1, 2))
        one, _ = self.go(LADDER, "--duration", "2", "--samples", "11")
        two, _ = self.go(wide, "--duration", "2", "--samples", "11", timeout=60)
        for x, other in zip(one["x"], two["x"]):
            self.assertAlmostEqual(x, other, delta=1e-9)

    def test_four_hangers_of_a_beam_have_a_quarter_each(self):
        _, events = self.go(BEAM, "--duration", "8", "--samples", "3")
        self.assertEqual(len(events), 4)
        for t, words, _ in events:
            self.assertAlmostEqual(t, (4 * 150 - 40 * G) / 40, delta=1e-12, msg=words)

    def test_a_crate_on_smooth_feet_stands_on_all_of_them(self):
        """Three would do, and two that it balances on without a disturbance."""
        standing = DROP.replace("h + 0.3", "h").replace("initial_rate: 1", "initial_rate: 0")
        table, events = self.go(standing, "--duration", "3", "--samples", "7", "--outputs", "state,reactions")
        self.assertEqual([words for _, words, _ in events], [f"c{i} closed" for i in (1, 2, 3, 4)])
        for i in (1, 2, 3, 4):
            self.assertAlmostEqual(table[f"reactions.c{i}.multiplier"][-1], 3 * G / 4, delta=1e-12)
        for name in ("z_dot", "wx", "wy", "wz", "e1", "e2", "e3"):
            self.assertEqual(set(table[name]), {0})

    def test_a_block_on_a_box_that_is_pulled(self):
        """Its height is multiplied by the sine of an angle that is 0."""
        table, events = self.go(BLOCK_ON_BOX, "--duration", "5.5", "--samples", "2")
        together, apart = 0.25 * 8 * G / 10, (8 * 0.35 + 8 * 0.25) * G / 10
        self.assertAlmostEqual(self.instants(events, "fl1 forwards")[0], together, delta=1e-12)
        self.assertAlmostEqual(self.instants(events, "ft backwards")[0], apart, delta=1e-12)

    def test_feet_that_fall_flat_touch_at_once(self):
        """Bounces of all four together: rest after 3 sqrt(2 H/g), for e = 0.5."""
        table, events = self.go(DROP, "--duration", "1", "--samples", "11")
        hits = [t for t, words, _ in events if words.endswith("hits")]
        self.assertEqual(len(hits) % 4, 0)
        for k in range(0, len(hits), 4):
            self.assertEqual(set(hits[k:k + 4]), {hits[k]})
        self.assertAlmostEqual(hits[-1], 3 * math.sqrt(0.6 / G), delta=1e-7)
        for name in ("wx", "wy", "wz"):
            self.assertAlmostEqual(table[name][-1], 0, delta=1e-9)

    def test_a_disc_that_falls_into_a_rough_groove_is_caught(self):
        """Newton's law of restitution has no impulses for it. By Poisson's, friction holds what would throw it back: mu > tan(beta)."""
        table, events = self.go(GROOVE, "--duration", "2", "--samples", "201")
        hits = [t for t, words, _ in events if words.endswith("hits")]
        self.assertAlmostEqual(hits[0], math.sqrt(1 / G), delta=1e-12)
        energy = table["energy.total"]
        self.assertTrue(all(later <= before + 1e-12 for before, later in zip(energy, energy[1:])))
        for name in ("x", "z", "th", "z_dot"):
            self.assertAlmostEqual(table[name][-1], 0, delta=1e-9)

    def test_a_body_that_turns_away_from_a_wall_leaves_it(self):
        """Both contacts hold it at the start, and together they would hold it for ever: it turns about the right one."""
        table, events = self.go(TIPPING, "--duration", "0.25", "--samples", "6")
        self.assertIn("left open", [words for _, words, _ in events])
        for x, z, th in zip(table["x"], table["z"], table["th"]):
            self.assertAlmostEqual(x + 0.2 * math.cos(th), 0.2, delta=1e-12)
            self.assertAlmostEqual(z - 0.2 * math.sin(th), 0, delta=1e-12)
        self.assertLess(table["th"][-1], -0.1)

    def test_links_side_by_side_have_equal_parts_in_any_order(self):
        bars = ["  weak: {distance: [p, o], is: 1, breaks_at: 6}\n", "  strong: {distance: [p, o], is: 1, breaks_at: 20}\n"]
        for order in (bars, bars[::-1]):
            table, events = self.go(LINKS.format(bars="".join(order)), "--duration", "12", "--samples", "13")
            self.assertEqual([words for _, words, _ in events], ["weak broken", "strong broken"])
            self.assertAlmostEqual(events[0][0], 2 * 6 - G, delta=1e-11)
            self.assertAlmostEqual(events[1][0], 20 - G, delta=1e-11)


if __name__ == "__main__":
    unittest.main()
