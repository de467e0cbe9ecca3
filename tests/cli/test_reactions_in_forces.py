"""Friction that is proportional to reactions of the same instant: beside Newton and Euler, written by hand and solved in floating point."""

import json
import unittest
from math import atan, cos, sin

from gauss_gen import Program

G = 9.81
LADDER = """gauss: 1
name: ladder
about: A ladder slides down a wall, with friction at both ends
parameters: {m: 3, l: 1.2, J: 1.1, mu_floor: 0.3, mu_wall: 0.2, g: 9.81}
coordinates: {x: {initial_guess: 0.7}, z: {initial_guess: 0.95}, theta: {initial: 0.64, initial_rate: 0.3}}
frames: {ladder: {position: [x, 0, z], orientation: {axis: y, angle: -theta}}}
bodies: {beam: {frame: ladder, mass: m, inertia: [J, J, J]}}
points: {foot: {on: ladder, at: [0, 0, -l]}, head: {on: ladder, at: [0, 0, l]}}
constraints: {floor: {equation: foot.z}, wall: {equation: head.x}}
forces:
  gravity: {uniform: [0, 0, -g]}
  friction_of_floor: {force: [FLOOR, 0, 0], on: foot}
  friction_of_wall: {force: [0, 0, WALL], on: head}
quantities: {carried: floor.reaction, squared: floor.reaction*wall.reaction}
"""
BLOCK = """gauss: 1
name: block
parameters: {m: 2, mu: 0.3, alpha: 0.4, g: 9.81}
coordinates: {x: {initial_rate: 1}, z: {held_at: 0}}
particles: {block: {mass: m, position: [x, 0, z]}}
forces:
  gravity: {uniform: [g*sin(alpha), 0, -g*cos(alpha)]}
  friction: {generalized: {x: -mu*z.reaction}}
"""
ROD = """gauss: 1
name: rod
about: Painleve's rod, whose lower end slides to the right
parameters: {m: 1, l: 1, mu: 0.5, g: 9.81}
coordinates: {x: {initial_rate: 1}, z: {}, theta: {initial: 0.6, initial_rate: 0.1}}
frames: {body: {position: [x, 0, z], orientation: {axis: y, angle: -theta}}}
bodies: {rod: {frame: body, mass: m, inertia: [m*l^2/3, m*l^2/3, m*l^2/3]}}
points: {tip: {on: body, at: [0, 0, -l]}}
constraints: {floor: {equation: tip.z}}
forces: {gravity: {uniform: [0, 0, -g]}, friction: {force: [-mu*floor.reaction, 0, 0], on: tip}}
"""


def solved(rows):
    """Gaussian elimination with pivots: rows are coefficients and the right-hand side."""
    rows = [list(map(float, row)) for row in rows]
    n = len(rows)
    for i in range(n):
        best = max(range(i, n), key=lambda k: abs(rows[k][i]))
        rows[i], rows[best] = rows[best], rows[i]
        for k in range(n):
            if k != i:
                factor = rows[k][i] / rows[i][i]
                rows[k] = [a - factor * b for a, b in zip(rows[k], rows[i])]
    return [rows[i][n] / rows[i][i] for i in range(n)]


def ladder_by_hand(theta, rate, floor_force, wall_force, m=3.0, l=1.2, J=1.1):
    """Unknown: accelerations of x, z, theta, then the forces of floor (up) and wall (along x).

    The foot is at (x + l sin theta, z - l cos theta), the head at (x - l sin theta, z + l cos theta), theta counts from the upright against the y axis.
    """
    s, c = sin(theta), cos(theta)
    # Forces at the foot (f N, N), at the head (W, w W); theta_ddot is about -y: moments of (Fx, Fz) at (rx, rz) about -y are rx Fz - rz Fx.
    foot, head = (l * s, -l * c), (-l * s, l * c)
    return solved([
        [m, 0, 0, -floor_force, -1, 0],
        [0, m, 0, -1, -wall_force, -m * G],
        [0, 0, J, -(foot[0] - foot[1] * floor_force), -(head[0] * wall_force - head[1]), 0],
        [0, 1, l * s, 0, 0, -l * c * rate**2],
        [1, 0, -l * c, 0, 0, -l * s * rate**2],
    ])


class ReactionsInForces(Program):
    def values(self, text, *options):
        result = self.run_it("evaluate", "-", "--format", "json", *options, stdin=text)
        self.assertEqual(result.returncode, 0, result.stderr)
        document = json.loads(result.stdout)
        return document["status"], {group: {name: float(entry["value"]) for name, entry in values.items()}
                                    for group, values in document.items() if isinstance(values, dict)}

    def test_a_block_slides_down_an_incline(self):
        status, found = self.values(BLOCK)
        self.assertEqual(status, "ok")
        self.assertAlmostEqual(found["accelerations"]["x_ddot"], G * (sin(0.4) - 0.3 * cos(0.4)), delta=1e-14)
        self.assertAlmostEqual(found["reactions"]["z"], 2 * G * cos(0.4), delta=1e-14)

    def test_two_contacts_carry_each_other(self):
        """Whichever of the two forces depends on which of the two reactions."""
        for of_floor, of_wall, floor_force, wall_force in (
                ("-mu_floor*floor.reaction", "mu_wall*wall.reaction", -0.3, 0.2),
                ("mu_floor*floor.reaction", "0", 0.3, 0.0),
                ("0", "-mu_wall*wall.reaction*2", 0.0, -0.4),
                ("0", "0", 0.0, 0.0)):
            with self.subTest(floor=of_floor, wall=of_wall):
                status, found = self.values(LADDER.replace("FLOOR", of_floor).replace("WALL", of_wall))
                self.assertEqual(status, "ok")
                expected = ladder_by_hand(0.64, 0.3, floor_force, wall_force)
                names = [("accelerations", "x_ddot"), ("accelerations", "z_ddot"), ("accelerations", "theta_ddot"),
                         ("multipliers", "floor"), ("multipliers", "wall")]
                scale = max(map(abs, expected))
                for (group, name), value in zip(names, expected):
                    self.assertAlmostEqual(found[group][name], value, delta=1e-13 * scale, msg=name)
                self.assertAlmostEqual(found["quantities"]["carried"], expected[3], delta=1e-13 * scale)
                self.assertAlmostEqual(found["quantities"]["squared"], expected[3] * expected[4], delta=1e-12 * scale**2)

    def test_as_many_reactions_as_there_are_depend_on_each_other(self):
        """r_i = -load_i - sum of c_ij r_j, of coordinates that are held."""
        names = "abcdef"
        weights = [[sin(7 * i + 3 * j + 1) / 3 for j in range(6)] for i in range(6)]
        forces = "".join(f"  of_{name}: {{generalized: {{{name}: {i + 1}" + "".join(f" + ({w!r})*{other}.reaction" for w, other in zip(row, names))
                         + "}}\n" for i, (name, row) in enumerate(zip(names, weights)))
        held = ", ".join(f"{name}: {{held_at: 0}}" for name in names)
        text = ("gauss: 1\nname: circle\ncoordinates: {x: {initial_rate: 1}, " + held + "}\nparticles: {p: {mass: 1, position: [x, a, b]}, "
                "q: {mass: 1, position: [c, d, e]}, r: {mass: 1, position: [f, 0, 0]}}\nforces:\n" + forces)
        status, found = self.values(text)
        self.assertEqual(status, "ok")
        expected = solved([[(i == j) + weights[i][j] for j in range(6)] + [-(i + 1)] for i in range(6)])
        for name, value in zip(names, expected):
            self.assertAlmostEqual(found["reactions"][name], value, delta=1e-12 * max(map(abs, expected)))

    def test_painleves_rod_has_its_critical_friction(self):
        """1 - (its part of friction) vanishes first at mu = 4/3 for a uniform rod: there the floor would have to push without bound."""
        critical = 4 / 3
        theta = atan(0.5)  # where 1 + 3 sin^2 - 3 mu sin cos is least
        forces = []
        for mu in (0.0, 0.5, 1.0, 1.3, critical * (1 - 1e-6)):
            status, found = self.values(ROD, f"--set=mu={mu!r}", f"--set=theta={theta!r}")
            self.assertEqual(status, "ok")
            forces.append(found["multipliers"]["floor"])
        self.assertEqual(forces, sorted(forces))
        self.assertGreater(forces[-1], 1e5 * forces[0])
        status, beyond = self.values(ROD, "--set=mu=1.4", f"--set=theta={theta!r}")
        self.assertLess(beyond["multipliers"]["floor"], 0)

    def test_what_cannot_be_said_is_not(self):
        self.assertEqual(self.run_it("evaluate", "-", "--accelerate", "x=1", stdin=BLOCK).returncode, 2)
        self.assertEqual(self.run_it("evaluate", "-", "--accelerate", "x=1", stdin=BLOCK).stdout, "")
        self.assertIn("reactions", self.run_it("-", "--route", "paper", stdin=BLOCK).stderr)


if __name__ == "__main__":
    unittest.main()
