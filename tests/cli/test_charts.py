"""W070: places at which the coordinates of a model no longer describe every motion, as geometry has them, and silence elsewhere."""

import json
import re
import unittest

from gauss_gen import MODELS, SOURCE, Program

HEAD = "gauss: 1\nname: chart\n"
GLOBE = HEAD + """coordinates: {lat: {initial: 0.3}, lon: {}}
particles: {p: {mass: 1, position: [cos(lat)*cos(lon), cos(lat)*sin(lon), sin(lat)]}}
"""
POLAR = HEAD + """coordinates: {r: {initial: 1}, phi: {}}
particles: {p: {mass: 1, position: [r*cos(phi), r*sin(phi), 0]}}
"""
BODY = HEAD + """coordinates: {a: {initial: 0.2}, b: {initial: 0.5}, c: {initial: 0.1}}
bodies: {top: {mass: 1, inertia: [1, 2, 2.5], position: [0, 0, 0], orientation: {euler: %s, angles: [a, b, c]}}}
"""
RING = "%s: {mass: 1, inertia: 0.1, position: [0, 0, 0], orientation: {euler: zxz, angles: [%s]}}, "
CARDAN = HEAD + """joints: {hook: {type: universal, axes: [x, y], child: b, coordinates: [a, c]}}
bodies: {b: {mass: 1, inertia: %s, centre: [0, 0, 1]}}
"""
SPEEDS = """speeds:
  wx: {is: dot(b)*cos(c) + dot(a)*sin(b)*sin(c)}
  wy: {is: -dot(b)*sin(c) + dot(a)*sin(b)*cos(c)}
  wz: {is: dot(c) + dot(a)*cos(b)}
"""
SINGULAR = {
    "latitude": (GLOBE, "lat = pi/2 and -pi/2", "'lon' moves nothing", "Cartesian"),
    "polar": (POLAR, "r = 0", "'phi' moves nothing", "Cartesian"),
    "z-x-z": (BODY % "zxz", "b = 0 and pi", "'a' and 'c' do not move apart", "quaternion"),
    "x-y-z": (BODY % "xyz", "b = pi/2 and -pi/2", "'a' and 'c' do not move apart", "quaternion"),
    "a latitude that is counted from 0.4": (GLOBE.replace("(lat)", "(lat - 0.4)"), "lat = -1.171 and 1.971",
                                            "'lon' moves nothing", "Cartesian"),
    # x = (u² - v²)/2, y = u v: det g = (u² + v²)².
    "parabolic": (HEAD + "coordinates: {u: {initial: 1}, v: {initial: 0.5}}\n"
                  "particles: {p: {mass: 1, position: [(u^2 - v^2)/2, u*v, 0]}}\n", "u = 0 and v = 0", "", "Cartesian"),
    # A point on two massless bars: det g = sin²(a - b).
    "elbow": (HEAD + "coordinates: {a: {initial: 1}, b: {initial: 0.5}}\n"
              "particles: {p: {mass: 1, position: [cos(a) + cos(b), sin(a) + sin(b), 0]}}\n", "for instance",
              "'a' and 'b' do not move apart", "Cartesian"),
    "crank without inertia": (HEAD + "coordinates: {a: {initial: 1}}\n"
                              "particles: {p: {mass: 1, position: [cos(a), 0, 0]}}\n", "a = 0 and pi",
                              "'a' moves nothing", "Cartesian"),
    "joint of Cardan with a point on it": (CARDAN % "0", "c = pi/2 and -pi/2", "'a' moves nothing", "quaternion"),
    "speeds that are angular velocities": (BODY % "zxz" + SPEEDS, "b = 0 and pi", "the speeds do not determine the rates",
                                           "speeds"),
}
REGULAR = {
    "a second angle that is constant": HEAD + """coordinates: {x: {}, psi: {}}
bodies: {p: {mass: 1, inertia: 1, position: [x, 0, 0], orientation: {euler: zxz, angles: [psi, 0.3, 0]}}}
""",
    "rings that resist": (BODY % "zxz").replace(
        "bodies: {", "bodies: {" + RING % ("outer", "a, 0, 0") + RING % ("inner", "a, b, 0")),
    "a body on the joint of Cardan": CARDAN % "[1, 1, 1]",
    "a motor holds the azimuth": POLAR + "constraints: {motor: {velocity: dot(phi) - 1}}\n",
    "a constraint keeps away": GLOBE + "constraints: {parallel: {equation: sin(lat) - sin(0.3)}}\n",
    "a free joint": HEAD + "joints: {j: {type: free, child: b}}\nbodies: {b: {mass: 1, inertia: [1, 2, 2.5]}}\n",
    "a spherical joint": HEAD + "joints: {j: {type: spherical, child: b}}\nbodies: {b: {mass: 1, inertia: [1, 2, 2.5]}}\n",
    "a held azimuth": POLAR.replace("phi: {}", "phi: {held_at: 2*t}"),
}
WARNED = {"lagrange_top_euler", "rattleback", "rolling_disc", "sphere_in_cylinder", "spherical_pendulum_angles",
          "balls_in_cylinder_euler", "spring_pendulum"}


class Charts(Program):
    def warnings(self, *arguments, stdin=None):
        result = self.run_it("--check", *arguments, stdin=stdin)
        self.assertEqual(result.returncode, 0, result.stderr)
        return [line for line in result.stderr.splitlines() if "warning[W070]" in line], result.stderr

    def test_singular_charts_are_found_where_geometry_has_them(self):
        for what, (text, place, cause, other) in SINGULAR.items():
            with self.subTest(what):
                found, all_of_it = self.warnings("-", stdin=text)
                self.assertEqual(len(found), 1, all_of_it)
                self.assertIn(place, found[0])
                self.assertIn(cause, found[0])
                self.assertIn(other, all_of_it)

    def test_an_instance_lies_on_the_relation(self):
        found, _ = self.warnings("-", stdin=SINGULAR["elbow"][0])
        a, b = (float(x) for x in re.search(r"a = (\S+) and b = ([-\d.]+)", found[0]).groups())
        turns = (a - b) / 3.14159265
        self.assertAlmostEqual(turns, round(turns), 3)

    def test_regular_charts_are_left_alone(self):
        for what, text in REGULAR.items():
            with self.subTest(what):
                found, all_of_it = self.warnings("-", stdin=text)
                self.assertEqual(found, [], all_of_it)

    def test_models_are_warned_of_where_they_have_a_pole_and_nowhere_else(self):
        files = [*MODELS.glob("*.yaml"), *(MODELS / "families").glob("*.yaml"),
                 *(SOURCE / "hard_cases/models").glob("*.yaml")]
        for file in sorted(files):
            with self.subTest(file.stem):
                found, all_of_it = self.warnings(file)
                has_pole = file.stem in WARNED or file.stem == "ball_on_plane_euler"
                self.assertEqual(len(found), 1 if has_pole else 0, all_of_it)

    def test_free_and_spherical_joints_have_a_quaternion_unless_asked_otherwise(self):
        for joint in ("a free joint", "a spherical joint"):
            state = json.loads(self.ok("evaluate", "-", "--format=json", stdin=REGULAR[joint]))["state"]
            self.assertEqual(sum(name.endswith(("_e0", "_e1", "_e2", "_e3")) for name in state), 4, state)

    def test_a_start_at_the_pole_is_said_once(self):
        result = self.run_it("--check", "-", stdin=GLOBE.replace("initial: 0.3", "initial: pi/2"))
        self.assertEqual(re.findall(r"\[(\w+)\]", result.stderr), ["W053"])


if __name__ == "__main__":
    unittest.main()
