"""What acts on parts without mass: who feels it, by hand."""

import json
import math
import re
import unittest

from gauss_gen import SOURCE, Program

HEAD = "gauss: 1\nname: plate\n"
PLATE = HEAD + """coordinates: {h: {held_at: 0}, x: {initial: 0.4}, y: {}}
joints:
  lift: {type: prismatic, axis: z, child: plate, coordinates: h}
  sx: {type: prismatic, axis: x, parent: plate, child: slide, coordinates: x}
  sy: {type: prismatic, axis: y, parent: slide, child: puck, coordinates: y}
points: {mast: {on: plate, at: [0, 0, 0.3]}}
particles: {puck: {mass: 1, frame: puck}}
"""
TABLE = HEAD + """coordinates: {turn: {held_at: 0}}
joints:
  motor: {type: revolute, axis: z, child: table, coordinates: turn}
  sx: {type: prismatic, axis: x, parent: table, child: slide, coordinates: x, initial: 1}
  sy: {type: prismatic, axis: y, parent: slide, child: puck, coordinates: y, initial: 0.2}
points: {o: {on: table, at: [0.1, 0, 0]}}
"""


class Massless(Program):
    def found(self, text, warnings=""):
        result = self.run_it("evaluate", "-", "--format=json", stdin=text)
        self.assertEqual(re.findall(r"\[(\w+)\]", result.stderr), warnings.split())
        found = json.loads(result.stdout)
        self.assertEqual(found["status"], "ok")
        return found

    def check(self, text, reaction, forces, compulsion):
        """The reaction of the drive, forces on the puck along z, and Gauss's function."""
        found = self.found(text)
        self.assertAlmostEqual(float(found["reactions"]["h"]["value"]), reaction, 13)
        of = found["reaction_forces"]
        for name, value in forces.items():
            self.assertAlmostEqual(float(of[f"{name}.force_on_puck.z"]["value"]), value, 13)
        self.assertAlmostEqual(float(of["on_puck.force.z"]["value"]), sum(forces.values()), 13)
        self.assertAlmostEqual(float(found["joint_reactions"]["sy.force.z"]["value"]), forces["h"], 13)
        self.assertAlmostEqual(float(found["compulsion"]["Z"]["value"]), compulsion, 12)

    def test_rods_that_nothing_keys_have_no_accelerations_in_line_and_evaluate_says_so(self):
        text = (SOURCE / "tests" / "diagnostics" / "w052_undetermined_rates.yaml").read_text(encoding="utf-8")
        for rates in ("", ", initial_rate: 0"):
            done = self.run_it("evaluate", "-", stdin=text.replace("initial: 0}", "initial: 0" + rates + "}"))
            self.assertIn("not to be trusted: singular_mass_matrix", done.stdout)
            self.assertIn("neither inertia nor the constraints that say something here determine all accelerations", done.stderr)
        # Keyed, they are one rod of three lengths.
        keyed = json.loads(self.run_it("evaluate", "-", "--format=json", "--set", "k=1", "--set", "a=0.1", "--set", "b=0.1", "--set",
                                       f"x={3 * math.sin(0.1)!r}", "--set", f"z={-3 * math.cos(0.1)!r}", stdin=text).stdout)
        self.assertAlmostEqual(float(keyed["accelerations"]["a_ddot"]["value"]), -9.81 / 3 * math.sin(0.1), 12)

    def test_a_load_on_the_plate_is_held_by_its_drive_and_not_felt_by_the_puck(self):
        self.check(PLATE + "forces: {load: {force: [0, 0, -7], on: plate}}\n", 7, {"h": 0}, 0)

    def test_what_pulls_at_the_plate_is_taken_off_what_the_drive_passes_on(self):
        # The weight is 10. A rope up to the mast of the plate, at 3/5, takes 6 of it, for its pull along x is the 8 of the push.
        rope = "constraints: {rope: {distance: [puck, mast], is: 0.5}}\n"
        forces = "forces: {g: {uniform: [0, 0, -10]}, push: {force: [8, 0, 0], on: puck}}\n"
        self.check(PLATE + rope + forces, 10, {"h": 4, "rope": 6}, (10**2 + 8**2) / 2)
        # A jack between both presses the puck up by 8, and the plate down: Z has what is left of the weight, 2.
        jack = "forces: {g: {uniform: [0, 0, -10]}, jack: {force: [0, 0, 8], on: puck, from: plate}}\n"
        self.check(PLATE + jack, 10, {"h": 2}, 2)

    def test_a_torque_on_the_table_turns_nothing_that_it_carries(self):
        for load, warning in (("{torque: [0, 0, 1], on: table}", ""),
                              ("{spring: [table, o], stiffness: 3, length: 0.2}", "W067")):
            found = self.found(TABLE + "bodies: {puck: {mass: 1, inertia: 0.1}}\nforces: {f: " + load + "}\n", warning)
            self.assertEqual(float(found["reaction_forces"]["on_puck.moment.z"]["value"]), 0)
            self.assertEqual(float(found["compulsion"]["Z"]["value"]), 0)

    def test_gausss_function_has_a_value_where_bodies_share_a_place(self):
        # 2 Z is Σ (F - m a)²/m, with F of the spring on the place that both share, which names neither.
        two = TABLE.replace("held_at: 0", "held_at: 3*t") + """particles: {puck: {mass: 1, frame: puck}, load: {mass: 2, frame: puck}}
forces: {s: {spring: [puck, o], stiffness: 40}}
"""
        found = self.found(two)
        self.assertAlmostEqual(float(found["accelerations"]["x_ddot"]["value"]), 9 - 40 * 0.9 / 3, 12)
        self.assertNotIn("undefined", found["compulsion"]["Z"]["value"])

    def test_a_spring_at_a_place_that_wanders_over_a_body_is_no_constraint_on_it(self):
        wander = HEAD + """coordinates: {x: {initial: 1}, y: {initial: 0.2}, h: {held_at: 0}}
joints:
  c: {type: prismatic, axis: z, child: C, coordinates: h}
  a: {type: prismatic, axis: x, child: A, coordinates: x}
  b: {type: prismatic, axis: z, child: B, coordinates: y}
bodies: {A: {mass: 1, inertia: 1}, B: {mass: 1, inertia: 1}, C: {mass: 1, inertia: 1}}
points: {p: {on: A, at: [0, Y, 1]}, o: {on: space, at: [0, 3, 0]}}
forces: {s: {spring: [p, o], stiffness: 10, length: 1}}
"""
        moving, still = self.found(wander.replace("Y", "y")), self.found(wander.replace("Y", "0.2"))
        for name in ("force.x", "force.y", "force.z", "moment.x", "moment.y", "moment.z"):
            on_body = float(moving["reaction_forces"][f"on_A.{name}"]["value"])
            self.assertAlmostEqual(on_body, float(still["reaction_forces"][f"on_A.{name}"]["value"]), 12)
            self.assertAlmostEqual(on_body, float(moving["joint_reactions"][f"a.{name}"]["value"]), 12)

    def test_a_constraint_at_a_place_that_wanders_pushes_along_its_way_too(self):
        # By hand: m x'' = 1 + k, m s'' = k, x'' + s'' = 0. The coordinate s moves B, and the place p on A by as much.
        wander = HEAD + """coordinates: {x: {initial: 0}, s: {initial: 1}}
frames: {F: {position: [x, 0, 0]}}
particles: {A: {mass: 1, frame: F}, B: {mass: 1, position: [0, s, 0]}}
points: {p: {on: F, at: [s, 0, 0]}, o: {on: space, at: [-1, 0, 0]}}
constraints: {k: {LAW}}
forces: {push: {force: [1, 0, 0], on: A}}
"""
        for law in ("velocity: dot(p.x)", "velocity: dot(x) + dot(s)", "equation: p.x - 1", "distance: [p, o], is: 2"):
            found = self.found(wander.replace("LAW", law))
            self.assertAlmostEqual(float(found["accelerations"]["s_ddot"]["value"]), -0.5, 13, law)
            forces = {name: float(force["value"]) for name, force in found["reaction_forces"].items()}
            self.assertAlmostEqual(forces["k.force_on_B.y"], -0.5, 13, law)
            for name in ("A", "B"):
                for axis in "xyz":
                    single = sum(value for key, value in forces.items()
                                 if key in (f"k.force_on_{name}.{axis}", f"k.force_on_p.{axis}" if name == "A" else ""))
                    self.assertAlmostEqual(single, forces[f"on_{name}.force.{axis}"], 13, law)

    def test_a_load_beside_a_particle_presses_on_the_joints_of_its_light_arm(self):
        # A particle at 1 on an arm with a hinge about y, pushed by [0, 3, 5] at 2 and turned by [7, 2, 3]; a body without inertia is
        # the same. Free, about the hinge: 5*2 - 2 = -theta''. Held, the hinge carries this, too, and the particle rests.
        arm = HEAD + "coordinates: {a: {HOW}}\njoints: {hip: {type: revolute, child: arm, axis: y, coordinates: a}}\n" + (
            "points: {tip: {on: arm, at: [2, 0, 0]}}\n"
            "forces: {push: {force: [0, 3, 5], on: tip}, screw: {torque: [7, 2, 3], on: arm}}\n")
        for how, acceleration, about_y in (("initial: 0", -8, 0), ("held_at: 0", None, 8)):
            for mass in ("particles: {p: {mass: 1, frame: arm, centre: [1, 0, 0]}}\n",
                         "bodies: {p: {mass: 1, inertia: 0, frame: arm, centre: [1, 0, 0]}}\n"):
                found = self.found(arm.replace("HOW", how) + mass)
                if acceleration:
                    self.assertAlmostEqual(float(found["accelerations"]["a_ddot"]["value"]), acceleration, 13)
                else:
                    self.assertAlmostEqual(float(found["reactions"]["a"]["value"]), about_y, 13)
                for axis, value in zip("xyz", (-7, about_y, -2 * 3 - 3)):
                    self.assertAlmostEqual(float(found["joint_reactions"][f"hip.moment.{axis}"]["value"]), value, 13)
                if "particles" in mass and acceleration:
                    # What drives the particle along its way, less the ideal part: nothing but the force across it is left.
                    self.assertAlmostEqual(float(found["compulsion"]["Z"]["value"]), 3**2 / 2, 13)

    def test_a_massless_part_that_is_not_needed_is_named_or_has_no_effect(self):
        arm = HEAD + """parameters: {m: 0}
joints:
  a: {type: revolute, axis: y, child: one, initial: 0.3}
  b: {TYPE, parent: one, child: two, at: [0, 0, -1]}
bodies: {one: {mass: 1, inertia: 0.1, centre: [0, 0, -1]}BODY}
forces: {gravity: {uniform: [0, 0, -9.81]}}
"""
        alone, turning = "type: fixed", "type: revolute, axis: y, initial: 0.2"
        # What nothing moves by itself: the motion is that of the rest, and the body is named, whether its mass is a number or a parameter.
        for body, codes in (("", []), (", two: {mass: 0, inertia: 0}", ["W056"]), (", two: {mass: m, inertia: m}", ["W056"])):
            done = self.run_it("evaluate", "-", "--format=json", stdin=arm.replace("TYPE", alone).replace("BODY", body))
            self.assertEqual(re.findall(r"warning\[(W05\d)\]", done.stderr), codes)
            self.assertAlmostEqual(float(json.loads(done.stdout)["accelerations"]["a_ddot"]["value"]), -9.81 * math.sin(0.3) / 1.1, 13)
        # What moves by itself: refused, or said of this state where a value of a parameter is the reason.
        for body, codes, code in ((", two: {mass: 0, inertia: 0}", ["E052", "W056"], 1), (", two: {mass: m, inertia: 0}", ["E052", "W056"], 1),
                                  (", two: {mass: m, inertia: m}", ["W053", "W056"], 0)):
            done = self.run_it("--check", "-", stdin=arm.replace("TYPE", turning).replace("BODY", body))
            self.assertEqual((done.returncode, sorted(re.findall(r"\[([EW]05\d)\]", done.stderr))), (code, codes), done.stderr)
            self.assertIn("'b'", done.stderr)
        # Within a chain: nothing is lost, for what it carries has mass.
        chain = arm.replace("TYPE", turning).replace("bodies:", "  c: {type: revolute, axis: y, parent: two, child: three, at: [0, 0, -1]}\nbodies:")
        light, none = (chain.replace("BODY", body + ", three: {mass: 2, inertia: 0.1}") for body in (", two: {mass: 0, inertia: 0}", ""))
        with_it, without = (json.loads(self.run_it("evaluate", "-", "--format=json", stdin=text).stdout) for text in (light, none))
        self.assertEqual(with_it["status"], "ok")
        for name, value in without["accelerations"].items():
            self.assertAlmostEqual(float(with_it["accelerations"][name]["value"]), float(value["value"]), 12)


if __name__ == "__main__":
    unittest.main()
