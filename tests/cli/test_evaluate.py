"""gauss-gen evaluate: numbers at one state."""

import json
import math
import re
import unittest
from fractions import Fraction

from gauss_gen import MODELS, PARTICLE, SKATER, SKEW, SPHERE, Evaluate

GROUPS = ["state", "accelerations", "multipliers", "reactions", "reaction_forces", "joint_reactions", "energy", "residuals", "compulsion", "quantities"]
# Those of a model without joints.
OF_SPHERE = [group for group in GROUPS if group not in ("joint_reactions", "quantities")]

POLE = "constraints:\n  c: {velocity: dot(x)/y - dot(y)/y}\n"
SUM = """gauss: 1
name: sum
parameters: {m: 1, k: 2}
coordinates: {x: {}, y: {}}
particles: {p: {mass: m, position: [x + y, 0, 0]}}
forces: {f: {generalized: {x: 1}}}
constraints: {c: {velocity: dot(x) - k*dot(y)}}
"""
DOUBLED = """gauss: 1
name: doubled
parameters: {m: 1}
coordinates: {x: {}, y: {}, a: {initial: 0.3}}
particles: {p: {mass: m, position: [x, y, 0]}, q: {mass: m, position: [x + cos(a), y + sin(a), 0]}}
constraints:
  blade: {velocity: dot(x)*sin(a) - dot(y)*cos(a)}
  again: {velocity: dot(x)*sin(2*a)/2 - dot(y)*cos(a)^2}
"""
HOISTED = """gauss: 1
name: hoisted
parameters: {m: {value: 1, unit: kg}, a: {value: 1, unit: m/s^2}}
coordinates: {h: {unit: m, held_at: a*t^2/2}, x: {unit: m}}
particles: {p: {mass: m, position: [x, 0, h]}}
"""
EXTREMES = ["0", "1e-300", "1e300", "-1e300", "1e308", "1e-308", "(10^300)^64*0+1"]


class Table(Evaluate):
    def test_it_shows_every_group_with_units(self):
        text = self.ok("evaluate", SPHERE)
        self.assertEqual([line for line in text.splitlines() if re.match(r"\w", line)], ["status", *OF_SPHERE, "notes"])
        self.assertRegex(text, r"(?m)^  rho +-4\.0000000000000000 +N +held coordinate rho; ")
        self.assertRegex(text, r"(?m)^  Z +21\.798578571428571 +N\^2/kg$")
        self.assertRegex(text, r"(?m)^  velocity\.rolling_along +0$")
        self.assertEqual(self.files(), [])

    def test_decimal_points_stand_under_each_other(self):
        for model in (SPHERE, SKEW, SKATER):
            lines = self.ok("evaluate", model).splitlines()
            self.assertEqual(len({match.start(1) for line in lines if (match := re.match(r"  \S+ +-?\d+(\.)\d+", line))}), 1)

    def test_no_line_ends_with_a_blank(self):
        self.assertNotRegex(self.ok("evaluate", SPHERE), r"(?m) $")

    def test_zeros_up_to_rounding_are_zeros(self):
        for model in sorted(MODELS.rglob("*.yaml")):
            for digits in (1, 17, 50):
                self.assertNotRegex(self.ok("evaluate", model, "--digits", digits), r"e-\d\d", (model, digits))

    def status_of(self, text):
        return json.loads(self.run_it("evaluate", "--format=json", "-", stdin=text).stdout)["status"]

    def test_a_pole_at_an_angle_that_is_rounded_is_a_pole(self):
        one = "gauss: 1\nname: pole\ncoordinates: {a: {initial: pi/2}}\nparticles: {p: {mass: 1, position: [a, 0, 0]}}\n"
        sleigh = """gauss: 1
name: sleigh
coordinates: {x: {initial_rate: 1}, y: {}, a: {initial: pi/2}}
bodies: {b: {mass: 1, inertia: 1, position: [x, y, 0], orientation: {axis: z, angle: a}}}
constraints: {blade: {velocity: dot(y) - dot(x)*tan(a)}}
"""
        speed = """gauss: 1
name: speed
coordinates: {x: {}, a: {initial: pi/2}}
speeds: {u: {is: dot(x)*cos(a), initial: 1}}
bodies: {b: {mass: 1, inertia: 1, position: [x, 0, 0], orientation: {axis: z, angle: a}}}
"""
        forces = ["tan(a)", "1/cos(a)", "log(cos(a)^2)", "cos(a)^(-1/2)", "atan2(cos(a), 0)", "sin(1e200*a/7)"]
        for text in [sleigh, speed, *(f"{one}forces: {{f: {{generalized: {{a: '{force}'}}}}}}\n" for force in forces)]:
            self.assertEqual(self.status_of(text), "not_finite", text)
        parameter = one + "parameters: {c: pi/2, k: 1/cos(c)}\nforces: {f: {generalized: {a: k}}}\n"
        self.assertEqual(self.status_of(parameter), "not_finite")

    def test_jumps_at_an_angle_that_is_rounded_are_where_they_are(self):
        text = """gauss: 1
name: jumps
coordinates: {a: {initial: pi}}
particles: {p: {mass: 1, position: [a, 0, 0]}}
quantities: {direction: "atan2(sin(a), cos(a))", sense: sign(sin(a)), case: "piecewise(sin(a) >= 0, 1, 2)", root: sqrt(-sin(a))}
"""
        found = {name: float(entry["value"]) for name, entry in self.document("-", stdin=text)["quantities"].items()}
        self.assertEqual(found, {"direction": 3.141592653589793, "sense": 0, "case": 1, "root": 0})

    def test_a_value_that_is_small_but_not_rounding_is_shown(self):
        self.assertRegex(self.ok("evaluate", SPHERE, "--set", "zeta=1e-250"), r"(?m)^  zeta +1\.0000000000000000e-250")
        self.close(self.value("energy", "potential", SPHERE, "--set", "zeta=1e-250"), Fraction(4905, 10**253))


class Forces(Evaluate):
    TROLLEY = """gauss: 1
name: trolley
parameters: {F: 3, m: 2}
joints: {rail: {type: prismatic, axis: x, child: slide, coordinates: x}, swing: {type: revolute, parent: slide, child: arm, axis: y}}
coordinates: {x: {held_at: 0}}
bodies: {block: {mass: m, inertia: 1, frame: slide, centre: [0, 0, -1]}, rod: {mass: 1, inertia: 1, frame: arm, centre: [0, 0, -1]}}
points: {hook: {on: slide, at: [0, 0, 1]}}
forces: {push: {force: [F, 0, 0], on: %s}}
"""

    def test_a_force_on_a_frame_is_felt_by_the_only_body_on_it(self):
        # The rail alone keeps the block from moving along it: it feels -F, whatever name its frame, the block or the hook has.
        for place in ("slide", "hook", "block"):
            found = self.document("-", stdin=self.TROLLEY % place)
            self.assertEqual(float(found["reaction_forces"]["on_block.force.x"]["value"]), -3, place)
            self.assertEqual(float(found["joint_reactions"]["rail.force.x"]["value"]), -3, place)
        found = self.document("-", stdin=self.TROLLEY % "hook")
        # About the mass centre, 2 below the hook, the push turns the block by 2 F, which the rail takes.
        self.assertEqual(float(found["reaction_forces"]["on_block.moment.y"]["value"]), -6)

    def test_of_two_bodies_on_a_frame_nobody_said_which_feels_a_force_on_it(self):
        two = self.TROLLEY.replace("bodies: {", "bodies: {crate: {mass: 1, inertia: 1, frame: slide, centre: [1, 0, 0]}, ")
        found = self.document("-", stdin=two % "hook")
        for body in ("block", "crate"):
            self.assertEqual(float(found["reaction_forces"][f"on_{body}.force.x"]["value"]), 0, body)
        self.assertEqual(float(found["joint_reactions"]["rail.force.x"]["value"]), -3)
        found = self.document("-", stdin=two % "crate")
        self.assertEqual(float(found["reaction_forces"]["on_crate.force.x"]["value"]), -3)

    def test_an_axis_may_point_backwards(self):
        arm = """gauss: 1
name: arm
joints: {a: {type: revolute, child: arm, axis: %s, initial: 0.4, initial_rate: 1}}
bodies: {arm: {mass: 2, inertia: [1, 2, 2.5], centre: [0.5, 0, 0]}}
forces: {gravity: {uniform: [0, 0, -9.81]}}
"""
        found = {axis: self.document("-", stdin=arm % axis) for axis in ("y", "-y", "[0, -1, 0]")}
        self.assertEqual(found["-y"], found["[0, -1, 0]"])
        # With the y axis a positive angle lowers the arm; with the opposite one it raises it: m g l cos(a) / (J + m l^2).
        for axis, sign in (("y", 1), ("-y", -1)):
            self.close(Fraction(found[axis]["accelerations"]["a_ddot"]["value"]), sign * Fraction(2 * 9.81 * 0.5 * math.cos(0.4) / 2.5), 14)

    def test_multipliers_have_units(self):
        text = """gauss: 1
name: units
parameters: {m: {value: 1, unit: kg}, r: {value: 2, unit: m}, J: {value: 1, unit: kg*m^2}}
coordinates: {x: {unit: m, initial: 2}, y: {unit: m}, phi: {unit: rad}, psi: {unit: rad}}
particles: {p: {mass: m, position: [x, y, 0]}}
bodies: {w: {mass: m, inertia: J, position: [0, 0, r*phi], orientation: {axis: z, angle: phi}}, v: {mass: m, inertia: J, position: [0, 0, 0], orientation: {axis: z, angle: psi}}}
constraints:
  force: {velocity: dot(y) - r*dot(phi)}
  moment: {velocity: dot(psi) - dot(phi)}
  tension: {equation: x^2 + y^2 - r^2}
"""
        found = self.document("-", stdin=text)["multipliers"]
        self.assertEqual({name: entry["unit"] for name, entry in found.items()}, {"force": "N", "moment": "N*m", "tension": "N/m"})
        self.assertEqual(self.document(MODELS / "rolling_disc.yaml")["multipliers"]["rim_x"]["unit"], "N")
        self.assertEqual(self.document(MODELS / "four_bar.yaml")["multipliers"].popitem()[1]["unit"], "N")


class Cases(Evaluate):
    # What is the same almost everywhere is not the same: seen from the cart, the wall would be wherever the cart is.
    def test_a_wall_stands_in_space_and_not_on_the_cart(self):
        wall = {"soft(tip.x)": 20, "(sqrt(tip.x^2) + tip.x)": 2, "max(0, tip.x)": 1, "sqrt((tip.x - 1)^2)": -1, "log(tip.x)": 25}
        for value, slope in wall.items():
            with self.subTest(value):
                model = ("gauss: 1\nname: wall\nparameters: {m: 2}\n"
                         + "tables: {soft: {of: [0, 0.05, 0.1], values: [0, 1, 5], outside: hold}}\n" * ("soft" in value) +
                         "joints: {slide: {type: prismatic, child: cart, axis: x, coordinates: x, initial: 0.03}}\n"
                         "bodies: {cart: {mass: m, inertia: 0}}\npoints: {tip: {on: cart, at: [0.01, 0, 0]}}\n"
                         f"forces: {{push: {{potential: {value}}}}}\n")
                self.assertAlmostEqual(float(self.document("-", stdin=model)["accelerations"]["x_ddot"]["value"]), -slope / 2, 12)


class Quantities(Evaluate):
    def test_their_names_are_the_users(self):
        text = "gauss: 1\nname: m\ncoordinates: {x: {initial: 2}}\nparticles: {p: {mass: 1, position: [x, 0, 0]}}\n" \
               "quantities: {position: [x, 1, 0], velocity: [dot(x), 0, 0], quaternion: [1, 2, x], missing: [x, x, x]}\n"
        found = self.document("-", stdin=text)["quantities"]
        self.assertEqual(float(found["position.x"]["value"]), 2)
        self.assertEqual(float(found["quaternion.y"]["value"]), 2)
        self.assertEqual(len(found), 12)


    def test_a_number_in_a_list_has_the_unit_of_the_others(self):
        text = "gauss: 1\nname: m\nparameters: {m: {value: 1, unit: kg}}\ncoordinates: {x: {unit: m, initial: 2}}\nparticles: {p: {mass: m, position: [x, 0, 0]}}\n" \
               "quantities: {place: [x, 0, 0], nothing: [0, 0, 0], mixed: [x, dot(x), 0]}\n"
        units = {name: entry.get("unit", "") for name, entry in self.document("-", stdin=text)["quantities"].items()}
        self.assertEqual({name[:-2] for name, unit in units.items() if unit == "m"}, {"place"})
        self.assertEqual({unit for name, unit in units.items() if not name.startswith("place")}, {""})


class Json(Evaluate):
    def test_the_keys_are_the_groups_and_values_are_text(self):
        for model in sorted(MODELS.rglob("*.yaml")):
            document = self.document(model)
            self.assertEqual([key for key in document if key in GROUPS], [key for key in GROUPS if key in document])
            self.assertEqual(set(document) - set(GROUPS), {"model", "digits", "time", "status", "not_finite", "not_unique", "warnings", "notes"})
            # Without inertia about an axis, as thin bars are, there is no compulsion.
            expected = {"state", "accelerations", "energy"} | ({"compulsion"} if document["model"] not in ("chain", "bar") else set())
            self.assertGreaterEqual(set(document), expected)
            for group in set(document) & set(GROUPS):
                for name, entry in document[group].items():
                    self.assertRegex(entry["value"], r"^(0|-?\d+(\.\d+)?(e[-+]\d+)?)$", name)
        self.assertEqual(self.document(SPHERE)["model"], "sphere_in_cylinder")
        self.assertEqual(self.document(SPHERE)["energy"]["kinetic"], {"value": "1.5755000000000000", "unit": "J"})

    def test_it_states_the_same_as_the_table(self):
        table = self.ok("evaluate", SPHERE)
        for group in OF_SPHERE:
            for name, entry in self.document(SPHERE)[group].items():
                self.assertRegex(table, rf"(?m)^  {re.escape(name)} +{re.escape(entry['value'])}\b")

    def test_what_has_no_value_says_why(self):
        self.write("m.yaml", PARTICLE.replace("x: {unit: m, initial_rate: 1}", "x: {unit: m}") + POLE)
        document = json.loads(self.run_it("evaluate", "m.yaml", "--format=json").stdout)
        self.assertEqual(set(document["state"]["x_dot"]), {"undefined", "unit"})
        self.assertIn("division by zero", document["state"]["x_dot"]["undefined"])
        self.assertEqual(document["warnings"], ["the initial state is undefined"])


class Meaning(Evaluate):
    def test_a_force_says_on_what_and_a_moment_about_which_point(self):
        forces = self.document(SKATER)["reaction_forces"]
        self.assertEqual(forces["blade.moment_on_skater.x"]["about"],
                         "reaction of blade; space axes, on skater about the stated point of blade")
        self.assertEqual(forces["z.moment_on_skater.z"]["about"], "reaction of z; space axes, on skater about the mass centre")
        self.assertEqual(forces["z.moment_on_skater.z"]["unit"], "N*m")

    def test_a_sum_says_which_forces_are_in_it(self):
        about = self.document(SKATER)["reaction_forces"]["on_skater.moment.x"]["about"]
        self.assertEqual(about, "all constraints on skater, and the forces that name no body: upright, push; space axes, about the mass centre")

    def test_the_table_says_it_once_per_vector(self):
        text = self.ok("evaluate", SKATER)
        self.assertRegex(text, r"(?m)^  on_skater\.force\.x .* N  +all constraints on skater, and the forces .* space axes$")
        self.assertRegex(text, r"(?m)^  on_skater\.force\.y .* N$")

    def test_a_multiplier_says_what_it_multiplies_and_its_unit(self):
        document = self.document(SKATER)
        self.assertEqual(document["multipliers"]["blade"]["unit"], "N")
        self.assertIn("N where phi is in m/s", self.document("-", stdin=SUM)["multipliers"]["c"]["about"])
        self.assertIn("a constraint phi = 0 adds lambda * dphi/du", "".join(document["notes"]))
        self.assertNotIn("lambda", "".join(self.document("-", stdin=PARTICLE)["notes"]))

    def test_parameters_of_any_size_stand_beside_each_other(self):
        """The row of th alone, which has no mass, gives its multiplier: -0.3/1.04 for every m."""
        model = """gauss: 1
name: massless
parameters: {m: 1}
coordinates: {x: {initial: 0.2, initial_rate: 0.4}, y: {}, th: {initial: 0.6}}
particles: {p: {mass: m, position: [x, y, 0]}}
constraints:
  skate: {velocity: -dot(x)*sin(th) + dot(y)*cos(th)}
  steer: {velocity: (1 + x^2)*dot(th) - 0.5*dot(x)}
forces: {f: {generalized: {x: 2, th: 0.3}}}
"""
        for mass in ("1", "1e-80", "1e80", "1e300"):
            with self.subTest(mass=mass):
                found = self.document("-", "--set", "m=" + mass, stdin=model)
                self.close(found["multipliers"]["steer"]["value"], "-0.28846153846153846")

    def test_coordinates_that_do_the_same_release_nothing(self):
        model = """gauss: 1
name: twins
parameters: {m: 1}
coordinates: {x: {}, y: {held_at: 0}, z: {held_at: 0.5*t}}
particles: {p: {mass: m, position: [x + y, 2*(x + y), z]}}
forces: {f: {generalized: {x: 2, y: 0.3}}}
"""
        notes = "".join(self.document("-", stdin=model)["notes"])
        self.assertIn("as the coordinates do not describe every motion of the bodies: y, z.", notes)

    def test_notes_are_on_lines_of_their_own(self):
        notes = self.ok("evaluate", SKATER).split("\nnotes\n")[1].splitlines()
        self.assertEqual([note.split(":")[0].strip() for note in notes],
                         ["multipliers", "reaction_forces", "energy", "residuals", "compulsion"])
        self.assertIn("on_<body> is the sum over all constraints, by Newton and Euler.", notes[1])


class Digits(Evaluate):
    def test_there_are_as_many_as_asked_for_and_all_are_right(self):
        for digits in (1, 2, 16, 17, 50, 200):
            entry = self.document(SPHERE, "--digits", digits)["multipliers"]["rolling_along"]["value"]
            self.assertEqual(len(entry.replace(".", "").lstrip("0-")), digits)
            self.close(entry, Fraction("9.01") / 7, digits - 1)
        self.assertEqual(self.document(SPHERE, "--digits", 200)["digits"], 200)

    def test_more_digits_never_change_the_first_ones(self):
        few, many = self.document(SKATER, "--digits", 20), self.document(SKATER, "--digits", 120)
        for group in set(few) & set(GROUPS):
            for name, entry in few[group].items():
                self.close(entry["value"], many[group][name]["value"], 19)


    def test_what_is_found_has_them_all(self):
        circle = ("{gauss: 1, name: circle, coordinates: {x: {initial_guess: 1}, y: {initial: 0.3, initial_rate: 1}}, "
                  "particles: {p: {mass: 1, position: [x, y, 0]}}, constraints: {c: {equation: x^2 + y^2 - 1}}}")
        found = self.document("-", "--digits", 300, stdin=circle)
        self.assertEqual((found["status"], found["residuals"]["position.c"]["value"]), ("ok", "0"))
        x, rate = (Fraction(found["state"][name]["value"]) for name in ("x", "x_dot"))
        self.assertLess(abs(x * x - Fraction("0.91")), Fraction(10) ** -298)
        self.assertLess(abs(x * rate + Fraction("0.3")), Fraction(10) ** -298)


class Set(Evaluate):
    def test_a_parameter(self):
        self.close(self.value("reactions", "rho", SPHERE, "--set", "m=1"), -8)
        self.close(self.value("reactions", "rho", SPHERE, "--set", " m = 2/4 * 3 "), -12)

    def test_a_coordinate(self):
        self.close(self.value("energy", "potential", SPHERE, "--set", "zeta=2"), Fraction("9.81"))

    def test_a_rate_in_both_spellings(self):
        for name in ("dot(chi)", "chi_dot", "dot( chi )"):
            self.close(self.value("reactions", "rho", SPHERE, "--set", f"{name}=2"), -1)

    def test_a_quaternion_component_and_an_angular_velocity(self):
        document = self.document(SKATER, "--set", "e0=3", "--set", "e1=0", "--set", "e2=0", "--set", "e3=4", "--set", "q=7")
        self.assertEqual([Fraction(document["state"][e]["value"]) for e in ("e0", "e3", "q")], [Fraction(3, 5), Fraction(4, 5), 7])

    def test_an_input(self):
        self.assertNotEqual(self.value("accelerations", "x_ddot", SKATER, "--set", "thrust=3"),
                            self.value("accelerations", "x_ddot", SKATER))

    def test_a_state_may_be_given_by_parameters(self):
        self.close(self.value("state", "zeta", SPHERE, "--set", "zeta=2*R"), Fraction("1.2"))
        self.close(self.value("state", "chi", SPHERE, "--set", "chi=pi/4"), "0.78539816339744831")

    def test_a_loop_moves_in_a_tilted_plane_as_in_a_level_one(self):
        bars = """gauss: 1
name: bars
frames: {base: {orientation: TURN}}
joints:
  a: {type: revolute, parent: base, child: one, initial_guess: 1.2, initial_rate: 2}
  b: {type: revolute, parent: one, child: two, at: [1, 0, 0], initial_guess: -1}
  c: {type: revolute, parent: base, child: three, at: [2.2, 0, 0], initial_guess: 1.5}
bodies:
  one: {mass: 1, inertia: 0.1, centre: [0.5, 0, 0]}
  two: {mass: 2, inertia: 0.3, centre: [1, 0, 0]}
  three: {mass: 3, inertia: 0.2, centre: [0.6, 0, 0]}
points: {p: {on: two, at: [2, 0, 0]}, q: {on: three, at: [1.2, 0, 0]}}
constraints: {close: {coincide: [p, q], in: base}}
forces: {weight: {force: [0, -9.81, 0], on: two, in: base}}
"""
        level, tilted = (self.document("-", stdin=bars.replace("TURN", turn)) for turn in ("{axis: z, angle: 0}", "{euler: xyz, angles: [0.7, 0.4, -0.3]}"))
        for found in (level, tilted):
            self.assertEqual(found["status"], "ok")
            self.assertEqual(list(found["multipliers"]), ["close_x", "close_y"])
        for group in ("accelerations", "multipliers"):
            for name, entry in level[group].items():
                self.close(tilted[group][name]["value"], entry["value"])

    def test_a_constraint_of_a_place_and_a_coordinate_acts_at_the_place(self):
        # A Scotch yoke: the slot presses the pin, said once by its place and once by the coordinate of the yoke.
        yoke = """gauss: 1
name: yoke
joints:
  a: {type: revolute, child: crank, coordinates: th, initial: 0.7, initial_rate: 2}
  s: {type: prismatic, child: yoke, axis: y, coordinates: y}
bodies: {crank: {mass: 1, inertia: 0.02, centre: [0.1, 0.02, 0]}, yoke: {mass: 2, inertia: 0.1}}
points: {pin: {on: crank, at: [0.3, 0, 0]}}
constraints: {slot: {equation: EQUATION}}
forces: {gravity: {uniform: [0, -9.81, 0]}}
"""
        by_place, by_coordinate = (self.document("-", stdin=yoke.replace("EQUATION", way)) for way in ("pin.y - yoke.y", "pin.y - y"))
        for group in ("multipliers", "reaction_forces", "joint_reactions"):
            for name, entry in by_place[group].items():
                if "position" in name or name.startswith("s."):
                    continue
                self.close(by_coordinate[group][name]["value"], entry["value"])
        self.close(by_coordinate["reaction_forces"]["slot.force_on_pin.y"]["value"], by_coordinate["multipliers"]["slot"]["value"])
        self.assertNotEqual(Fraction(by_coordinate["multipliers"]["slot"]["value"]), 0)

    def test_a_place_on_a_body_and_its_coordinates_act_together(self):
        # Of one constraint alone, force and moment on a free plate are those of all constraints, which Newton and Euler give.
        plate = """gauss: 1
name: plate
joints: {free: {type: planar, axis: z, child: plate, coordinates: [x, y, th], initial: [0.1, 0.2, 0.4], initial_rate: [1, -0.7, 2]}}
bodies: {plate: {mass: 2, inertia: 0.3, centre: [0.2, 0.1, 0]}}
constraints: {c: {velocity: dot(plate.y) + 0.5*dot(th) - 0.3*dot(x)}}
forces: {push: {force: [1, 2, 0], on: plate}}
"""
        found = self.document("-", stdin=plate)["reaction_forces"]
        for part in ("force", "moment"):
            for axis in "xyz":
                value, total = (Fraction(found[name]["value"]) for name in (f"c.{part}_on_plate.{axis}", f"on_plate.{part}.{axis}"))
                self.assertLess(abs(value - total), Fraction(1, 10**15))
        self.assertNotEqual(Fraction(found["on_plate.moment.z"]["value"]), 0)

    def test_a_second_value_for_one_name_is_refused(self):
        for first, second in (("zeta=2", "zeta = 3"), ("dot(chi)=1", "chi_dot=1"), ("dot(chi)=1", "dot( chi )=1")):
            error = self.refused(2, "evaluate", SPHERE, "--set", first, "--set", second)
            self.assertIn(f"--set: '{second.split('=')[0].strip()}' is given twice", error)
        error = self.refused(2, "evaluate", SPHERE, "--accelerate", "chi=1", "--accelerate", "chi=2")
        self.assertIn("--accelerate: 'chi' is given twice", error)

    def test_a_formula_parameter_may_be_replaced_by_a_number(self):
        self.assertNotEqual(self.value("energy", "kinetic", SPHERE, "--set", "J=1"), self.value("energy", "kinetic", SPHERE))

    def test_what_cannot_be_set_is_refused(self):
        for assignment, answer in {
                "mm=1": "did you mean 'm'?", "dot(chii)=1": "did you mean 'dot(chi)'?", "chi_dott=1": "did you mean 'chi_dot'?",
                "rho=1": "'rho' is held by the model", "dot(rho)=1": "is held by the model", "m=2*R": "give parameter 'm' a number",
                "J=m": "give parameter 'J' a number", "t=1": "use --time", "pi=3": "cannot be set", "chi=zeta": "not a parameter",
                "chi=t": "not a parameter", "chi=dot(zeta)": "dot(...) has no meaning", "m": "expected name=value", "=1": "a name is missing",
                "m=": "error[E039]", "m=1+": "error[E033]", "m=1 2": "error[E035]", "m=1e999": "error[E054]",
                "m=0/0": "error[E053]: division by zero", "m=sqrt(-1)": "error[E053]", "m=log(0)": "error[E053]",
                "m=(-8)^(1/3)": "error[E053]", "m=tan(pi/2)": "error[E053]", "m=1e308*1e308": "error[E054]",
                "m=exp(1e6)": "error[E054]", "chi=1/0": "error[E053]",
                "chi=1/(m-m)": "--set chi: with the values of the parameters this is infinite",
                "chi=sqrt(r-R)": "--set chi: with the values of the parameters this is not a real number"}.items():
            self.assertIn(answer, self.refused(2, "evaluate", SPHERE, "--set", assignment), assignment)

    def test_what_is_wrong_on_the_command_line_is_said_before_warnings_of_the_model(self):
        warned_of = PARTICLE.replace("unit: kg", "unit: g")
        self.assertIn("W055", self.run_it("evaluate", "-", stdin=warned_of).stderr)
        for option in ("--set=nowhere=1", "--time=now", "--accelerate=nowhere=1"):
            error = self.refused(2, "evaluate", "-", option, stdin=warned_of)
            self.assertRegex(error, "^gauss-gen: " + option.split("=", maxsplit=1)[0])

    def test_a_value_that_a_model_may_not_have_is_warned_of(self):
        for assignment, answer in {"m1=-1": "the mass of 'first' is negative: -1",
                                   "m1=0": "'first' has no mass: it resists no motion and weighs nothing"}.items():
            result = self.run_it("evaluate", SKEW, "--set", assignment)
            self.assertEqual(result.returncode, 0)
            self.assertIn(f"warning: {answer}", result.stderr)


class Extremes(Evaluate):
    def test_no_value_is_an_internal_error(self):
        for model, names in {SPHERE: ("m", "r", "R", "g", "chi", "dot(chi)", "zeta"), SKATER: ("e0", "p", "q", "thrust"),
                             SKEW: ("m1", "k", "frequency", "a", "dot(b)")}.items():
            for name in names:
                for value in EXTREMES:
                    result = self.run_it("evaluate", model, "--set", f"{name}={value}", "--digits", "3")
                    self.assertIn(result.returncode, (0, 1, 2), (model, name, value, result.stderr))
                    self.assertNotIn("internal", result.stderr)

    def test_a_zero_mass_is_no_acceleration_of_zero(self):
        result = self.run_it("evaluate", "-", "--set", "m=0", stdin=PARTICLE)
        self.assertIn("warning: 'p' has no mass: it resists no motion and weighs nothing", result.stderr)
        self.assertIn("warning: the mass matrix is not positive definite here", result.stderr)


class Degenerate(Evaluate):
    def test_a_constraint_may_tell_coordinates_apart_that_move_the_same(self):
        # x = k y: (k + 1)^2 m y_ddot = k
        document = self.document("-", stdin=SUM)
        self.close(document["accelerations"]["y_ddot"]["value"], Fraction(2, 9), 14)
        self.close(document["accelerations"]["x_ddot"]["value"], Fraction(4, 9), 14)
        self.close(document["multipliers"]["c"]["value"], Fraction(-1, 3), 14)

    def test_where_it_does_not_this_is_said(self):
        result = self.run_it("evaluate", "-", "--set", "k=-1", stdin=SUM)
        self.assertIn("warning: the mass matrix is not positive definite here", result.stderr)


class Time(Evaluate):
    def test_it_moves_what_is_held_in_time(self):
        later = self.value("reactions", "s", SKEW, "--time", "1/3")
        self.assertNotEqual(later, self.value("reactions", "s", SKEW))
        self.close(later, self.value("reactions", "s", SKEW, "--time=2/6"))
        self.assertEqual(self.document(SKEW, "--time", "1/3")["time"], "1/3")

    def test_the_state_shows_it_with_what_it_holds(self):
        state = self.document("-", "--time", "3", stdin=HOISTED)["state"]
        self.assertEqual(list(state), ["t", "h", "x", "x_dot"])
        self.assertEqual(state["t"], {"value": "3.0000000000000000", "unit": "s", "about": "time"})
        self.assertEqual(state["h"], {"value": "4.5000000000000000", "unit": "m", "about": "held at this time"})

    def test_a_held_value_that_is_undefined_is_no_state(self):
        result = self.run_it("evaluate", "-", "--time=-1", stdin=HOISTED.replace("t^2/2", "sqrt(t)").replace("m/s^2", "m/s^(1/2)"))
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stdout, r"(?m)^  h +undefined: fractional power of a negative number")
        self.assertIn("not to be trusted: not_finite", result.stdout)

    def test_it_is_a_number(self):
        for text in ("1/0", "k", "t", "sin(1)", "", "1 2", "now"):
            self.assertIn("--time", self.refused(2, "evaluate", SKEW, "--time", text))


class Warnings(Evaluate):
    def test_a_violated_constraint_is_named_with_its_residual(self):
        result = self.run_it("evaluate", SPHERE, "--set", "dot(psi)=1", "--set", "dot(theta)=0", "--format=json")
        self.assertEqual(result.returncode, 0)
        self.assertIn("warning: the initial state violates constraint 'rolling_around' by ", result.stderr)
        self.assertEqual(len(json.loads(result.stdout)["warnings"]), 2)

    def test_a_singular_chart_is_named(self):
        result = self.run_it("evaluate", SPHERE, "--set", "theta=0", "--set", "dot(phi)=0")
        self.assertIn("warning: accelerations are undefined here", result.stderr)

    def test_what_is_not_to_be_trusted_says_so_itself(self):
        negative = self.run_it("evaluate", SKEW, "--set", "m1=-1", "--format=json")
        self.assertEqual(json.loads(negative.stdout)["status"], "impossible_bodies, singular_mass_matrix")
        pole = [SPHERE, "--set", "theta=0", "--set", "dot(phi)=0"]
        self.assertIn("status\n  not to be trusted: not_finite, singular_mass_matrix\n", self.run_it("evaluate", *pole).stdout)
        self.assertIn("status\n  ok, but for multipliers: dependent_constraints, they are not unique and the least are shown\n",
                      self.run_it("evaluate", "-", stdin=DOUBLED).stdout)
        late = self.run_it("evaluate", SPHERE, "--set", "dot(psi)=1", "--set", "dot(theta)=0")
        self.assertIn("status\n  not to be trusted: violated_constraints\n", late.stdout)
        self.assertIn("status\n  ok\n", self.ok("evaluate", SPHERE))

    CRANE = """gauss: 1
name: crane
parameters: {m: 1, M: 2, J: 0.05}
joints: {slew: {type: revolute, axis: y, child: arm, initial: 0.4, initial_rate: 2}}
bodies:
  load: {mass: M, inertia: J, frame: arm, centre: [0, 0, -1]}
  hook: {mass: m, inertia: J, frame: arm, centre: [0.1, 0, 0]}
forces: {g: {uniform: [0, 0, -9.81]}, wind: {force: [3, 0, 0], on: hook}}
"""

    def test_undefined_values_of_one_group_leave_the_others_to_be_trusted(self):
        text = self.run_it("evaluate", "-", "--set", "m=0", stdin=self.CRANE).stdout
        self.assertIn("status\n  not to be trusted: not_finite\n  not_finite in compulsion alone: the other groups are to be trusted\n", text)
        massless = self.document("-", "--set", "m=0", stdin=self.CRANE)
        self.assertEqual((massless["status"], massless["not_finite"]), ("not_finite", ["compulsion"]))
        self.assertIn("undefined", massless["compulsion"]["Z"])
        # What a mass of 1e-40 changes is beyond all digits.
        light = self.document("-", "--set", "m=1e-40", stdin=self.CRANE)
        self.assertEqual((light["status"], light["not_finite"]), ("ok", []))
        for group in ("state", "accelerations", "joint_reactions", "energy"):
            self.assertGreater(len(light[group]), 0)
            for name, entry in light[group].items():
                self.close(massless[group][name]["value"], entry["value"])
        # By hand: (M l^2 + 2 J) theta_ddot = -M g l sin(theta) + moment of the wind at the hook.
        moment = -2 * 9.81 * math.sin(0.4) - 3 * 0.1 * math.sin(0.4)
        self.assertAlmostEqual(float(massless["accelerations"]["slew_ddot"]["value"]), moment / 2.1, places=13)

    def test_where_the_motion_is_undefined_no_group_is_to_be_trusted(self):
        pole = [SPHERE, "--set", "theta=0", "--set", "dot(phi)=0"]
        text = self.run_it("evaluate", *pole).stdout
        self.assertRegex(text, r"(?m)^  not_finite in accelerations, .*compulsion$")
        self.assertNotIn("are to be trusted", text)
        groups = json.loads(self.run_it("evaluate", "--format=json", *pole).stdout)["not_finite"]
        self.assertEqual(groups[0], "accelerations")
        self.assertNotIn("state", groups)
        force = "gauss: 1\nname: pole\ncoordinates: {a: {initial: pi/2}}\nparticles: {p: {mass: 1, position: [a, 0, 0]}}\nforces: {f: {generalized: {a: tan(a)}}}\n"
        text = self.run_it("evaluate", "-", stdin=force).stdout
        self.assertRegex(text, r"(?m)^  not to be trusted: not_finite$")
        self.assertNotIn("are to be trusted", text)

    def test_forces_that_are_left_out_are_named(self):
        left_out = "Not stated one by one, as the coordinates do not describe every motion of the bodies: platform."
        self.assertIn(left_out, "".join(self.document(MODELS / "rotor_on_platform.yaml")["notes"]))
        self.assertIn(left_out, self.ok("evaluate", MODELS / "rotor_on_platform.yaml"))
        self.assertNotIn("Not stated", self.ok("evaluate", SPHERE))

    def test_constraints_that_depend_on_each_other_are_named(self):
        result = self.run_it("evaluate", "-", stdin=DOUBLED)
        self.assertIn("warning: constraint 'again' follows from constraint 'blade' here: multipliers are not unique", result.stderr)

    def test_rows_that_take_turns_to_vanish_are_as_usual(self):
        # 'rolls' asks along two axes of the pinion for what is one condition: whichever of them says nothing here, as many do elsewhere.
        gears = """gauss: 1
name: gears
joints:
  ja: {type: revolute, child: pinion, axis: z, coordinates: a, initial: ANGLE}
  jb: {type: revolute, child: wheel, at: [0.17, 0, 0], axis: z, coordinates: b}
bodies: {pinion: {mass: 1, inertia: 0.00125}, wheel: {mass: 1, inertia: 0.0072}}
points: {mesh: {at: [0.05, 0, 0]}}
constraints: {mesh: {rolls: wheel, on: pinion, at: mesh}}
forces: {drive: {torque: [0, 0, 1], on: pinion}}
"""
        for angle in ("0", "0.3", "pi/2", "2"):
            done = self.run_it("evaluate", "-", "--format=json", stdin=gears.replace("ANGLE", angle))
            found = json.loads(done.stdout)
            self.assertEqual((found["status"], found["not_unique"][0]), ("dependent_constraints", "multipliers"), done.stderr)
            self.assertAlmostEqual(float(found["accelerations"]["a_ddot"]["value"]), 1 / (0.00125 + 0.0072 * (0.05 / 0.12) ** 2), 9)
            # The force on the wheel is across the line of centres: J b'' over its radius.
            force = [float(found["multipliers"][f"mesh_{axis}"]["value"]) for axis in "xy"]
            self.assertAlmostEqual(math.hypot(*force), 10, 12)

    def test_a_part_without_mass_between_others_is_carried_by_constraints(self):
        # A four-bar moves as with a coupler of next to no mass.
        light = json.loads(self.run_it("evaluate", MODELS / "four_bar.yaml", "--set", "m2=1e-14", "--format=json").stdout)
        none = json.loads(self.run_it("evaluate", MODELS / "four_bar.yaml", "--set", "m2=0", "--format=json").stdout)
        self.assertEqual((none["status"], none["not_finite"]), ("not_finite", ["compulsion"]))
        for group in ("accelerations", "multipliers"):
            for name, entry in none[group].items():
                self.assertAlmostEqual(float(entry["value"]) / float(light[group][name]["value"]), 1, 11, name)

    def test_constraints_that_ask_for_different_accelerations_are_violated(self):
        belt = PARTICLE.replace("initial_rate: 1", "initial_rate: 0") + \
            "constraints: {wall: {equation: x}, belt: {velocity: dot(x) - a*t}}\n"
        belt = belt.replace("parameters:\n", "parameters:\n  a: {value: 0, unit: m/s^2}\n")
        done = self.run_it("evaluate", "-", "--set", "a=1", "--format=json", stdin=belt)
        self.assertIn("violated_constraints", json.loads(done.stdout)["status"])
        self.assertIn("no accelerations satisfy constraints 'wall' and 'belt' together", done.stderr)

    def test_motors_that_share_a_load_are_not_unique(self):
        # Two gears that are held by the same law drive a third: any preload between them is possible.
        gears = """gauss: 1
name: gears
coordinates: {qa: {held_at: sin(t)}, qc: {held_at: sin(t)}}
joints:
  a: {type: revolute, child: A, axis: z, coordinates: qa}
  b: {type: revolute, child: B, at: [0.2, 0, 0], axis: z, coordinates: qb}
  c: {type: revolute, child: C, at: [0.4, 0, 0], axis: z, coordinates: qc}
bodies: {A: {mass: 1, inertia: 1}, B: {mass: 1, inertia: 1}, C: {mass: 1, inertia: 1}}
constraints: {ab: {rolls: B, on: A, at: [0.1, 0, 0]}, cb: {rolls: B, on: C, at: [0.3, 0, 0]}}
"""
        found = json.loads(self.run_it("evaluate", "-", "--format=json", stdin=gears).stdout)
        self.assertIn("reactions", found["not_unique"])

    def test_a_model_from_standard_input_works(self):
        self.assertIn("x_ddot", self.ok("evaluate", "-", stdin=PARTICLE))


if __name__ == "__main__":
    unittest.main()
