"""Degenerate input (hard case H29): lengths, masses, motions and constraints of nothing. Each has a named finding, or the right answer by hand."""

import io
import json
import re
import sys
import unittest

from gauss_gen import Program

HEAD = "gauss: 1\nname: degenerate\n"
LINE = HEAD + "coordinates: {x: {initial: %s}}\nparticles: {p: {mass: %s, position: [x, 0, 0]}}\n"
ONE = LINE % (1, 2)
PLANE = HEAD + "coordinates: {x: {initial: 0.6}, z: {initial: -0.8}}\nparticles: {p: {mass: 2, position: [x, 0, z]}}\n"
ORIGIN = "points: {o: {at: [0, 0, 0]}}\n"
HELD = HEAD + "coordinates: {z: {held_at: %s}}\nparticles: {p: {mass: 2, position: [0, 0, z]}}\n"
BODY = HEAD + "joints: {j: {%s, child: b}}\nbodies: {b: {mass: 1, inertia: [1, 2, 2.5]}}\n"
TURNED = HEAD + """orientations: {a: {quaternion: [e0, e1, e2, e3], angular_velocity: [wx, wy, wz], frame: body%s}}
bodies: {b: {mass: %s, inertia: %s, position: [0, 0, 0], orientation: a}}
"""
GRAVITY = "forces: {g: {uniform: [0, 0, -10]}}\n"
CAR = HEAD + """joints: {j: {type: prismatic, axis: x, child: car, coordinates: x}}
bodies: {car: {mass: 1}}
points: {a: {on: car, at: [0, 1, 0]}, b: {on: car, at: [0, 2, 0]}}
"""

# What is refused, and with which findings.
REFUSED = {
    "a distance of zero": (PLANE + ORIGIN + "constraints: {rod: {distance: [p, o], is: 0}}\n", "E053"),
    "a negative distance": (PLANE + ORIGIN + "constraints: {rod: {distance: [p, o], is: -1}}\n", "E053"),
    "the distance of a place to itself": (PLANE + "constraints: {rod: {distance: [p, p], is: 1}}\n", "E058"),
    "a distance within one body": (CAR + "constraints: {rod: {distance: [a, b], is: 1}}\n", "E058"),
    "a place that coincides with itself": (PLANE + "constraints: {c: {coincide: [p, p]}}\n", "E058"),
    "0 = 0": (ONE + "constraints: {c: {equation: 0}}\n", "E058"),
    "1 = 0": (ONE + "constraints: {c: {equation: 1}}\n", "E058"),
    "x - x = 0": (ONE + "constraints: {c: {equation: x - x}}\n", "E058"),
    "1 = 0 in disguise": (ONE + "constraints: {c: {equation: sin(x)^2 + cos(x)^2}}\n", "E058"),
    "0 = 0 of rates": (ONE + "constraints: {c: {velocity: 0*dot(x)}}\n", "E058"),
    "1 = 0 of rates": (ONE + "constraints: {c: {velocity: 1}}\n", "E058"),
    "a particle without mass": (LINE % (1, 0), "E052 W056"),
    "a body without mass and inertia": (TURNED % ("", 0, 0), "E052 E052 E052 W056"),
    "a negative mass": (LINE % (1, -1), "E055"),
    "two coordinates for one motion": (HEAD + "coordinates: {x: {}, y: {}}\n"
                                       "particles: {p: {mass: 1, position: [x + y, 0, 0]}}\n", "E052"),
    "parallel axes where crossing ones are needed": (BODY % "type: universal, axes: [x, x], coordinates: [a, c]", "E052"),
    "an axis of length zero": (BODY % "type: revolute, axis: [0, 0, 0], coordinates: a", "E053"),
    "an axis that is zero by a parameter": (BODY.replace("joints", "parameters: {k: 0}\njoints") %
                                            "type: revolute, axis: [k, 0, 0], coordinates: a", "E053"),
    "a direction of length zero": (PLANE + "constraints: {c: {no_slip: p, at: p, direction: [0, 0, 0]}}\n", "E053"),
    "a quaternion of length zero": (TURNED % (", initial: [0, 0, 0, 0]", 1, 1), "E053"),
    "a spring between a place and itself": (ONE + "forces: {s: {spring: [p, p], stiffness: 1, length: 1}}\n", "E053"),
    "no bodies": (HEAD + "coordinates: {x: {}}\n", "E050"),
    "empty bodies": (HEAD + "coordinates: {x: {}}\nbodies: {}\n", "E050"),
    "no coordinates": (HEAD + "particles: {p: {mass: 2, position: [0, 0, 1]}}\n" + GRAVITY, "E051"),
    "a value without a value": (HELD % "0/0", "E053"),
}

# What has an answer at its start: findings of --check, status, and numbers by hand.
ANSWERED = {
    "one coordinate": (LINE % (0.1, 2) + "forces: {s: {spring: x, stiffness: 8}}\n", "", "ok",
                       {"accelerations": {"x_ddot": -8 * 0.1 / 2}}),
    "gravity of 0": (HEAD + "coordinates: {z: {initial: 1}}\nparticles: {p: {mass: 1, position: [0, 0, z]}}\n"
                     + GRAVITY.replace("-10", "0"), "W067", "ok", {"accelerations": {"z_ddot": 0}}),
    "gravity of 0 by a parameter": (HEAD + "parameters: {g: 0}\ncoordinates: {z: {initial: 1}}\n"
                                    "particles: {p: {mass: 1, position: [0, 0, z]}}\n" + GRAVITY.replace("-10", "-g"), "",
                                    "ok", {"accelerations": {"z_ddot": 0}, "energy": {"total": 0}}),
    "no degree of freedom, by a held coordinate": (HELD % 1 + GRAVITY, "", "ok",
                                                   {"reactions": {"z": 20}, "reaction_forces": {"z.force_on_p.z": 20}}),
    # Two bars of length 1 carry 20 N at slopes of 0.8: 20/2/0.8 = 12.5 N in each.
    "no degree of freedom, by two bars": (
        PLANE + "points: {a: {at: [0, 0, 0]}, b: {at: [1.2, 0, 0]}}\nconstraints: {l: {distance: [p, a], is: 1}, "
        "r: {distance: [p, b], is: 1}}\n" + GRAVITY, "", "ok",
        {"accelerations": {"x_ddot": 0, "z_ddot": 0},
         "reaction_forces": {"l.force_on_p.x": -7.5, "l.force_on_p.z": 10, "r.force_on_p.x": 7.5, "r.force_on_p.z": 10}}),
    # The pivot bears the weight, and the moment of it at 0.4 m.
    "no degree of freedom, by a joint": (
        HEAD + "joints: {j: {type: fixed, child: b}}\ncoordinates: {z: {held_at: 0}}\n"
        "bodies: {b: {mass: 2, frame: b, centre: [0.4, 0, 0], inertia: 1}, c: {mass: 1, position: [0, 0, z]}}\n" + GRAVITY,
        "", "ok", {"joint_reactions": {"j.force.z": 20, "j.moment.y": -8}, "reactions": {"z": 10}}),
    "a rod of length zero by a parameter": (
        HEAD + "parameters: {l: 0}\ncoordinates: {theta: {initial: 1}}\n"
        "particles: {p: {mass: 1, position: [l*sin(theta), 0, -l*cos(theta)]}}\n" + GRAVITY, "W053",
        "not_finite", {}),
    "k*x = 0 with k = 0": (HEAD + "parameters: {k: 0}\n" + (LINE % (0, 1)).replace(HEAD, "")
                           + "constraints: {c: {equation: k*x}}\n", "W054", "dependent_constraints",
                           {"accelerations": {"x_ddot": 0}}),
    "a spring that begins without a gap": (LINE % (0, 1) + ORIGIN + "forces: {s: {spring: [p, o], stiffness: 1, length: 1}}\n",
                                           "W053", "not_finite", {}),
    "a spring of no length that begins without a gap": (LINE % (0, 1) + ORIGIN + "forces: {s: {spring: [p, o], stiffness: 1}}\n",
                                                        "", "ok", {"accelerations": {"x_ddot": 0}}),
    "a spring without stiffness": (ONE + ORIGIN + "forces: {s: {spring: [p, o], stiffness: 0}}\n", "W067", "ok",
                                   {"accelerations": {"x_ddot": 0}}),
    "places at one point whose distance is to be 1": (
        PLANE.replace("initial: 0.6", "initial_guess: 0").replace("initial: -0.8", "initial_guess: 0") + ORIGIN
        + "constraints: {rod: {distance: [p, o], is: 1}}\n", "W068", "ok", {"residuals": {"position.rod": 0}}),
    # Without a radius, rolling is a point that stays.
    "a ball of radius zero that rolls": (
        HEAD + "parameters: {r: 0}\ncoordinates: {x: {}, y: {}, z: {held_at: r}}\n"
        "orientations: {a: {quaternion: [e0, e1, e2, e3], angular_velocity: [wx, wy, wz], frame: space, "
        "initial_angular_velocity: [1, 0, 0]}}\nbodies: {b: {mass: 2, inertia: 1, position: [x, y, z], orientation: a}}\n"
        "constraints: {c: {rolls: b, at: [x, y, 0]}}\nforces: {f: {uniform: [3, 0, -10]}}\n", "", "ok",
        {"accelerations": {"x_ddot": 0, "wx_dot": 0}, "multipliers": {"c_x": -6}, "reactions": {"z": 20}}),
    "a torque on a particle": (ONE + "forces: {t: {torque: [1, 0, 0], on: p}}\n", "W067", "ok",
                               {"accelerations": {"x_ddot": 0}}),
}


class Degenerate(Program):
    def findings(self, result):
        return sorted(re.findall(r"(?:error|warning)\[(\w+)\]: ", result.stderr))

    def test_what_makes_no_sense_is_refused_by_name(self):
        for what, (text, codes) in REFUSED.items():
            for command in (("--check", "-"), ("-", "-o", "-"), ("evaluate", "-")):
                with self.subTest(what, command=command):
                    result = self.run_it(*command, stdin=text)
                    self.assertEqual((result.returncode, self.findings(result)), (1, codes.split()), result.stderr)
                    self.assertIn("hint:", result.stderr)

    def test_what_makes_sense_has_the_answer_by_hand(self):
        for what, (text, codes, status, groups) in ANSWERED.items():
            with self.subTest(what):
                checked = self.run_it("--check", "-", stdin=text)
                self.assertEqual((checked.returncode, self.findings(checked)), (0, codes.split()), checked.stderr)
                result = self.run_it("evaluate", "-", "--format=json", stdin=text)
                self.assertEqual(result.returncode, 0, result.stderr)
                found = json.loads(result.stdout)
                self.assertIn(status, str(found["status"]))
                for group, values in groups.items():
                    for name, value in values.items():
                        self.assertAlmostEqual(float(found[group][name]["value"]), value, 12, (group, name))

    def test_what_holds_nothing_is_not_counted_as_if_it_did(self):
        for power, mobility in (("(x - 0.3)", "mobility 1 (2 speeds, 1 constraint)"),
                                ("(x - 0.3)^2", "mobility 2 (2 speeds, 1 constraint of rank 0)")):
            text = HEAD + ("coordinates: {x: {initial_guess: 0.4}, y: {initial_rate: 2}}\n"
                           f"particles: {{p: {{mass: 1, position: [x, y, 0]}}}}\nconstraints: {{wall: {{equation: {power}}}}}\n")
            with self.subTest(power):
                checked = self.run_it("--check", "-", stdin=text)
                self.assertEqual("W071" in checked.stderr, "^2" in power)
                self.assertIn("ok, " + mobility, checked.stdout)

    def test_what_fits_at_one_place_alone_does_not_move(self):
        bars = HEAD + """joints:
  a: {type: revolute, child: one, KEY: A}
  b: {type: revolute, parent: one, child: two, at: [1.1, 0, 0], KEY: 0}
  c: {type: revolute, child: three, at: [SPAN*cos(A), SPAN*sin(A), 0], KEY: A + 3.141592653589793}
bodies: {one: {mass: 1, inertia: 0.1}, two: {mass: 1, inertia: 0.1}, three: {mass: 1, inertia: 0.1}}
points: {p: {on: two, at: [0.7, 0, 0]}, q: {on: three, at: [0.45, 0, 0]}}
constraints: {close: {coincide: [p, q]}}
"""
        for key, angle in (("initial", "0"), ("initial_guess", "0"), ("initial_guess", "0.4")):
            for span, locked in (("2.25", 2), ("2.2", None)):
                text = bars.replace("A + 3", f"{angle} + 3")
                text = text.replace("KEY: A", "KEY: " + angle).replace("KEY", key if locked else "initial_guess").replace("(A)", f"({angle})").replace(": A}", f": {angle}}}").replace("SPAN", span)
                self.alone(text, locked, 3)
        # In space two bars in line leave two directions to first order, in a plane one.
        for more, n in ((", z: {initial: 0}", 3), ("", 2)):
            text = HEAD + ("coordinates: {x: {initial: 1}, y: {initial: 0}" + more + "}\n"
                           "particles: {p: {mass: 1, position: [x, y, " + ("z" if more else "0") + "]}}\n"
                           "points: {A: {at: [0, 0, 0]}, B: {at: [2, 0, 0]}}\n"
                           "constraints: {c: {distance: [p, A], is: 1}, d: {distance: [p, B], is: 1}}\n")
            self.alone(text, n - 1, n)

    def alone(self, text, locked, n):
        done = self.run_it("--check", "-", stdin=text)
        self.assertEqual("at no other place near" in done.stderr, locked is not None, text + done.stderr)
        words = f"mobility 0 ({n} speeds, 2 constraints of rank {n - locked}: {locked} motion" if locked else "mobility 1 (3 speeds, 2 constraints)"
        self.assertIn(words, done.stdout)

    # Agreed at the start with first and second derivatives, and a part of 1e-8 apart later.
    def test_what_differs_by_little_does_not_agree(self):
        for part, agrees in (("0", True), ("1e-8", False)):
            text = HEAD + (f"parameters: {{d: {part}}}\ncoordinates: {{x: {{initial_rate: 1}}, y: {{}}}}\n"
                           "particles: {p: {mass: 1, position: [x, y, 0]}}\n"
                           "constraints: {a: {velocity: dot(x) - 1}, b: {velocity: 2*dot(x) - 2 - d*t^3}}\n")
            with self.subTest(part):
                said = self.run_it("--check", "-", stdin=text).stderr
                self.assertIn("W054", said)
                self.assertEqual("but not in other states or at other times" not in said, agrees)

    def test_the_code_of_what_has_an_answer_is_emitted(self):
        for what, (text, *_) in ANSWERED.items():
            with self.subTest(what):
                result = self.run_it("-", "-o", "-", stdin=text)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertIn("namespace gauss", result.stdout)


def report():
    """How many models there are, and how many checks of them ended otherwise, for hard_cases/."""
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(Degenerate)
    result = unittest.TextTestRunner(stream=io.StringIO()).run(suite)
    json.dump({"refused": len(REFUSED), "answered": len(ANSWERED), "otherwise": len(result.failures) + len(result.errors)}, sys.stdout)


if __name__ == "__main__":
    if sys.argv[1:] == ["--json"]:
        report()
    else:
        unittest.main()
