"""Scenes choose which effects of a model act; forces may contain reactions."""

import json
import math
import unittest

from gauss_sim import Program

BALL = """gauss: 1
name: ball
parameters: {m: {value: 0.5, unit: kg}, h: {value: 1, unit: m}, u: {value: 3, unit: m/s}, v: {value: 2, unit: m/s}}
coordinates:
  x: {unit: m, initial_rate: u}
  z: {unit: m, initial: h, initial_rate: v}
particles: {ball: {mass: m, position: [x, 0, z]}}
exact: {x: u*t, z: h + v*t - g/2*t^2}
effects:
  gravity:
    about: weight
    default: on
    parameters: {g: {value: 9.81, unit: m/s^2}}
    forces: {weight: {uniform: [0, 0, -g]}}
  oil:
    about: drag of a thick medium
    parameters: {c: {value: 0.2, unit: kg/s}}
    forces: {oil: {generalized: {x: -c*dot(x), z: -c*dot(z)}}}
  wind:
    requires: [oil]
    inputs: {w: {value: 1, unit: N}}
    forces: {gust: {generalized: {x: w}}}
"""
SCENE = """gauss: 1
scene: throw
model: ball.yaml
effects: [gravity, oil]
parameters: {c: 0.4}
inputs: {w: 2}
duration: 1
samples: 3
outputs: [x, z]
"""

LADDER = """gauss: 1
name: ladder
parameters: {m: 3, l: 1.2, J: 1.1, mu_floor: 0.3, mu_wall: 0.2, g: 9.81}
coordinates: {x: {initial_guess: 0.7}, z: {initial_guess: 0.95}, theta: {initial: 0.64, initial_rate: 0.3}}
frames: {ladder: {position: [x, 0, z], orientation: {axis: y, angle: -theta}}}
bodies: {beam: {frame: ladder, mass: m, inertia: [J, J, J]}}
points: {foot: {on: ladder, at: [0, 0, -l]}, head: {on: ladder, at: [0, 0, l]}}
constraints: {floor: {equation: foot.z}, wall: {equation: head.x}}
forces:
  gravity: {uniform: [0, 0, -g]}
  friction_of_floor: {force: [-mu_floor*floor.reaction, 0, 0], on: foot}
  friction_of_wall: {force: [0, 0, mu_wall*wall.reaction], on: head}
"""


class Effects(Program):
    def setUp(self):
        super().setUp()
        self.write("ball.yaml", BALL)

    def last(self, name="throw"):
        table = self.table(f"{name}.csv")
        return table["x [m]"][-1], table["z [m]"][-1]

    def summary(self, name="throw"):
        return json.loads((self.folder / f"{name}.json").read_text())

    def test_a_scene_chooses_effects(self):
        self.write("scene.yaml", SCENE)
        said = self.run_it("run", "scene.yaml")
        self.assertEqual(said.returncode, 0)
        self.assertIn("effects gravity, oil\n", said.stdout)
        self.assertEqual(self.summary()["effects"], ["gravity", "oil"])
        r = 0.4 / 0.5
        x, z = self.last()
        self.assertAlmostEqual(x, 3 / r * (1 - math.exp(-r)), delta=1e-8)
        self.assertAlmostEqual(z, 1 + (2 + 9.81 / r) / r * (1 - math.exp(-r)) - 9.81 / r, delta=1e-8)

    def test_options_have_precedence_and_values_of_absent_effects_may_stay(self):
        self.write("scene.yaml", SCENE)
        result = self.run_it("run", "scene.yaml", "--effects", "none")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("scene.yaml:5:14: warning[W064]: 'c' is of the effect 'oil', which does not act here", result.stderr)
        self.assertIn("'w' is of the effect 'wind'", result.stderr)
        self.assertIn("effects none\n", result.stdout)
        for one, expected in zip(self.last(), (3, 3)):
            self.assertAlmostEqual(one, expected, delta=1e-12)
        self.run_it("run", "scene.yaml", "--effects=+oil,+wind", "-q")
        self.assertEqual(self.summary()["effects"], ["gravity", "oil", "wind"])
        self.assertGreater(self.last()[0], 3)

    def test_the_closed_form_of_a_model_is_that_of_its_default(self):
        self.ok("run", "ball.yaml", "--duration", "1", "-q")
        self.assertIn("from_closed_forms", self.summary("ball"))
        self.ok("run", "ball.yaml", "--effects=+oil", "--duration", "1", "-q")
        self.assertNotIn("from_closed_forms", self.summary("ball"))

    def test_a_wrong_choice_is_said_at_its_place_beside_other_mistakes(self):
        self.write("scene.yaml", SCENE.replace("[gravity, oil]", "[gravity, wind, olil]").replace("duration: 1", "duration: 0"))
        said = self.refused(1, "run", "scene.yaml")
        self.assertIn("scene.yaml:4:20: error[E093]: 'wind' requires 'oil', which does not act", said)
        self.assertIn("scene.yaml:4:26: error[E093]: there is no effect 'olil'", said)
        self.assertIn("did you mean 'oil'?", said)
        self.write("scene.yaml", SCENE)
        self.assertIn("--effects wind: 'wind' requires 'oil'", self.refused(2, "run", "scene.yaml", "--effects", "wind"))
        self.assertEqual(list(self.folder.glob("*.csv")), [])

    def test_a_run_does_not_go_on_with_other_effects(self):
        self.write("scene.yaml", SCENE)
        self.run_it("run", "scene.yaml", "--max-steps", "1", "--method", "rk4", "--step", "0.1", "-q")
        result = self.run_it("run", "scene.yaml", "--max-steps", "1", "--method", "rk4", "--step", "0.1", "--resume",
                             "--effects", "gravity")
        self.assertEqual(result.returncode, 2, result.stderr)

    def test_friction_by_reactions_moves_the_same_whatever_minimises_z_and_integrates(self):
        self.write("ladder.yaml", LADDER)
        common = ("run", "ladder.yaml", "--duration", "0.4", "--samples", "9", "--outputs", "theta,reactions", "-q",
                  "--tolerance", "1e-11")
        tables = []
        for options in (("--method", "prince87", "--engine", "interpreted"), ("--method", "taylor"),
                        ("--method", "prince87", "--strategy", "multipliers", "--engine", "interpreted"),
                        ("--method", "prince87", "--strategy", "metric", "--engine", "interpreted"),
                        ("--method", "prince87", "--strategy", "tree", "--number", "long-double")):
            self.ok(*common, *options)
            tables.append(self.table("ladder.csv"))
        for table in tables[1:]:
            for column, values in tables[0].items():
                for one, other in zip(values, table[column]):
                    self.assertAlmostEqual(one, other, delta=1e-8 * max(1, abs(one)), msg=column)

    def test_the_work_of_friction_is_what_energy_loses(self):
        """Of a block on an incline, by the closed form of both."""
        self.write("block.yaml", "gauss: 1\nname: block\nparameters: {m: 2, mu: 0.3, alpha: 0.4, g: 9.81}\n"
                                 "coordinates: {x: {initial_rate: 1}, z: {held_at: 0}}\n"
                                 "particles: {block: {mass: m, position: [x, 0, z]}}\n"
                                 "forces: {gravity: {uniform: [g*sin(alpha), 0, -g*cos(alpha)]},\n"
                                 "         friction: {generalized: {x: -mu*z.reaction}}}\n")
        self.ok("run", "block.yaml", "--duration", "2", "--samples", "5", "-q")
        table = self.table("block.csv")
        a = 9.81 * (math.sin(0.4) - 0.3 * math.cos(0.4))
        for t, x, energy in zip(table["t [s]"], table["x"], table["energy.total [J]"] if "energy.total [J]" in table else table["energy.total"]):
            self.assertAlmostEqual(x, t + a * t * t / 2, delta=1e-12)
            self.assertAlmostEqual(energy, 1 - 0.3 * 2 * 9.81 * math.cos(0.4) * x, delta=1e-11)


if __name__ == "__main__":
    unittest.main()
