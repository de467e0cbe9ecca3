"""`gauss-gen evaluate --equilibrium` and `--accelerate`, against statics by hand."""

import json
import math
import re
import unittest
from fractions import Fraction

from gauss_gen import MODELS, SOURCE, Program

HEAD = "gauss: 1\nname: statics\n"
SPRING = HEAD + """parameters: {m: 2, k: 30, g: 10}
coordinates: {z: {initial: 0.5, initial_rate: 3}}
particles: {p: {mass: m, position: [0, 0, z]}}
forces: {gravity: {uniform: [0, 0, -g]}, spring: {spring: z, stiffness: k}}
"""
# A lamp of mass m on two ropes of length L, whose ends are 2*a apart.
LAMP = HEAD + """parameters: {m: 3, L: 1.3, a: 0.5, g: 10}
coordinates: {x: {initial_guess: 0.1}, y: {initial_guess: -1}}
particles: {lamp: {mass: m, position: [x, y, 0]}}
points: {left: {at: [-a, 0, 0]}, right: {at: [a, 0, 0]}}
constraints: {left_rope: {distance: [lamp, left], is: L}, right_rope: {distance: [lamp, right], is: L}}
forces: {gravity: {uniform: [0, -g, 0]}}
"""
PLATE = HEAD + """joints: {ball: {type: spherical, child: plate}}
points:
  left: {on: plate, at: [1, 0.3, 0]}
  right: {on: plate, at: [-1, 0.4, 0.2]}
  nail: {at: [2, 1, 3]}
  hook: {at: [-1.5, 0.5, 2]}
bodies: {plate: {mass: 2, inertia: [1, 2, 2.5], centre: [0.1, 0.5, -0.3]}}
forces:
  gravity: {uniform: [0, 0, -9.81]}
  one: {spring: [left, nail], stiffness: 30, length: 0.7}
  two: {spring: [right, hook], stiffness: 20, length: 0.5}
"""
FALLING = HEAD + """coordinates: {z: {}}
particles: {p: {mass: 1, position: [0, 0, z]}}
forces: {gravity: {uniform: [0, 0, -9.81]}}
"""


class Statics(Program):
    def at_equilibrium(self, text_or_path, *more):
        is_text = isinstance(text_or_path, str)
        out = self.ok("evaluate", "-" if is_text else text_or_path, "--equilibrium", "--format=json", *more,
                      stdin=text_or_path if is_text else None)
        return json.loads(out)

    def test_a_weight_on_a_spring(self):
        found = self.at_equilibrium(SPRING, "--digits=40")
        self.assertLess(abs(Fraction(found["state"]["z"]["value"]) + Fraction(2, 3)), Fraction(1, 10**39))
        self.assertEqual(float(found["state"]["z_dot"]["value"]), 0)
        self.assertEqual(found["status"], "ok")

    def test_the_ropes_of_a_lamp_carry_it(self):
        found = self.at_equilibrium(LAMP)
        self.assertAlmostEqual(float(found["state"]["y"]["value"]), -1.2, 15)
        self.assertAlmostEqual(float(found["state"]["x"]["value"]), 0, 15)
        for rope in ("left_rope", "right_rope"):
            # Positive where it pushes: a rope pulls with m g/2 over the cosine of its slope, 1.2/1.3.
            self.assertAlmostEqual(float(found["multipliers"][rope]["value"]), -15 * 1.3 / 1.2, 12)

    def test_a_bead_on_a_turning_hoop_is_in_relative_equilibrium(self):
        found = self.at_equilibrium(MODELS / "bead_on_hoop.yaml", "--set", "theta=1")
        self.assertAlmostEqual(float(found["state"]["theta"]["value"]), math.acos(9.81 / (36 * 0.5)), 14)

    def test_pendulums_sink_from_where_their_moment_is_greatest(self):
        found = self.at_equilibrium(MODELS / "double_pendulum.yaml")
        self.assertEqual([float(found["state"][name]["value"]) for name in ("pivot", "elbow")], [0, 0])
        self.assertAlmostEqual(float(found["joint_reactions"]["pivot.force.y"]["value"]), 2.1 * 9.81, 13)

    def test_a_plate_turns_until_its_weight_and_two_springs_balance(self):
        found = self.at_equilibrium(PLATE)
        w, *v = (float(found["state"][f"ball_e{i}"]["value"]) for i in range(4))

        def cross(a, b):
            return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

        def turned(r):  # r + 2 w v x r + 2 v x (v x r)
            once = cross(v, r)
            return [x + 2 * w * y + 2 * z for x, y, z in zip(r, once, cross(v, once))]

        moment = cross(turned([0.1, 0.5, -0.3]), [0, 0, -2 * 9.81])
        for at, end, stiffness, length in (([1, 0.3, 0], [2, 1, 3], 30, 0.7), ([-1, 0.4, 0.2], [-1.5, 0.5, 2], 20, 0.5)):
            place = turned(at)
            gap = [b - a for a, b in zip(place, end)]
            pull = stiffness * (1 - length / math.hypot(*gap))
            moment = [m + c for m, c in zip(moment, cross(place, [pull * x for x in gap]))]
        self.assertAlmostEqual(math.hypot(w, *v), 1, 15)
        for component in moment:
            self.assertAlmostEqual(component, 0, 12)

    def test_a_loop_stays_closed(self):
        found = self.at_equilibrium(MODELS / "four_bar.yaml")
        self.assertEqual(found["status"], "ok")
        for name in ("alpha_ddot", "beta_ddot", "gamma_ddot"):
            self.assertLess(abs(float(found["accelerations"][name]["value"])), 1e-15)

    def test_at_rest_a_speed_against_a_belt_is_that_of_the_belt(self):
        # The belt drags the block to c v/k, where u = dot(x) - v is -v, not 0.
        belt = HEAD + """parameters: {k: 10, v: 0.5, c: 2}
coordinates: {x: {initial: 0.3}, s: {held_at: v*t}}
speeds: {u: {is: dot(x) - dot(s), initial: 0}}
particles: {p: {mass: 1, position: [x, 0, 0]}, q: {mass: 1, position: [s, 0, 0]}}
forces: {spring: {spring: x, stiffness: k}, friction: {generalized: {u: -c*u}}}
"""
        found = self.at_equilibrium(belt)
        self.assertEqual(found["status"], "ok")
        self.assertAlmostEqual(float(found["state"]["x"]["value"]), 0.1, 15)
        self.assertEqual(float(found["state"]["u"]["value"]), -0.5)
        self.assertAlmostEqual(float(found["accelerations"]["u_dot"]["value"]), 0, 15)

    def test_an_equilibrium_of_an_instant_says_so(self):
        # What acts on y through the bar changes with time, and moves nothing; what acts on x does.
        pulled = HEAD + """coordinates: {x: {initial: 0.6}, y: {initial: 0.8}}
particles: {p: {mass: 1, position: [x, 0, 0]}, q: {mass: 1, position: [0, y, 0]}}
forces: {spring: {generalized: {x: -3*(x - 0.5)}}, pull: {generalized: {x: LAW, y: 2}}}
constraints: {stop: {equation: y - 0.8}}
"""
        for law, lasts in (("1", True), ("1 + t", False)):
            for of_y, text in (("2", pulled), ("2 + t^2", pulled.replace("y: 2}", "y: 2 + t^2}"))):
                with self.subTest(law=law, of_y=of_y):
                    done = self.run_it("evaluate", "-", "--equilibrium", stdin=text.replace("LAW", law))
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertEqual("this equilibrium is one of this instant" in done.stderr, not lasts)
                    done = self.run_it("evaluate", "-", "--equilibrium", "--format=json", stdin=text.replace("LAW", law))
                    self.assertEqual(len(json.loads(done.stdout)["warnings"]), 0 if lasts else 1)

    def test_what_a_constraint_drives_has_none(self):
        # Velocities that grow from 0, a belt that starts to move under a wheel, a position that is a law in time.
        driven = HEAD + "coordinates: {x: {initial: 1}}\nparticles: {p: {mass: 1, position: [x, 0, 0]}}\nconstraints: {c: {LAW}}\n"
        for law in ("velocity: dot(x) - t", "velocity: dot(x) - 2", "velocity: dot(x) - sin(t)", "equation: x - 1 - t^2"):
            self.assertIn("at which constraint 'c' lets the model rest",
                          self.refused(1, "evaluate", "-", "--equilibrium", stdin=driven.replace("LAW", law)))
        done = self.run_it("evaluate", "-", "--equilibrium", stdin=driven.replace("LAW", "velocity: dot(x) - t^2"))
        self.assertIn("this equilibrium is one of this instant", done.stderr)
        belt = HEAD + """parameters: {r: 0.1}
coordinates: {b: {held_at: "LAW"}, x: {}, phi: {}}
joints: {drive: {type: prismatic, axis: x, child: belt, coordinates: b}}
frames: {axle: {position: [x, 0, r]}, wheel: {parent: axle, orientation: {axis: y, angle: phi}}}
points: {contact: {on: axle, at: [0, 0, -r]}}
bodies: {wheel: {mass: 2, inertia: 0.01}}
constraints: {road: {rolls: wheel, on: belt, at: contact}}
"""
        self.assertIn("at which constraint 'road_x' lets the model rest",
                      self.refused(1, "evaluate", "-", "--equilibrium", stdin=belt.replace("LAW", "3*t^2/2")))
        self.ok("evaluate", "-", "--equilibrium", stdin=belt.replace("LAW", "3"))

    def test_a_constraint_that_drives_only_elsewhere_says_where_to_rest(self):
        field = HEAD + "coordinates: {x: {initial: 1}}\nparticles: {p: {mass: 1, position: [x, 0, 0]}}\n" \
                       "constraints: {c: {velocity: dot(x) - x + 0.3}}\n"
        found = json.loads(self.ok("evaluate", "-", "--equilibrium", "--format=json", stdin=field))
        self.assertAlmostEqual(float(found["state"]["x"]["value"]), 0.3, 15)

    def test_where_all_rests_it_stays_where_it_starts(self):
        # No force: the assembled start is an equilibrium itself.
        rods = HEAD + """coordinates: {x: {initial: 1}, y: {}, z: {}}
particles: {p: {mass: 1, position: [x, 0, 0]}, q: {mass: 1, position: [y, 0, z]}}
constraints: {rod: {equation: (x - y)^2 + z^2 - 4}, rail: {equation: z - 1}}
"""
        start = json.loads(self.ok("evaluate", "-", "--format=json", stdin=rods))
        rest = json.loads(self.ok("evaluate", "-", "--equilibrium", "--format=json", stdin=rods))
        for name in ("x", "y", "z"):
            self.assertAlmostEqual(float(rest["state"][name]["value"]), float(start["state"][name]["value"]), 15)

    def test_statics_need_no_mass(self):
        # A load on a slider without mass: where it hangs across the slider, nothing is accelerated along it.
        for axis, pull, angle in (("x", (0, -9.81), 0), ("[4, 0, 3]", (0.6 * 9.81, -0.8 * 9.81), -math.atan(0.75))):
            slider = HEAD + f"""joints:
  slide: {{type: prismatic, child: slider, axis: {axis}, initial: 0.1}}
  hinge: {{type: revolute, parent: slider, child: rod, axis: y, initial: 0.4}}
particles: {{b: {{mass: 2, frame: rod, centre: [0, 0, -1]}}}}
forces:
  gravity: {{uniform: [{pull[0]}, 0, {pull[1]}]}}
  centring: {{spring: slide, stiffness: 30}}
"""
            found = json.loads(self.run_it("evaluate", "-", "--equilibrium", "--format=json", stdin=slider).stdout)
            self.assertEqual(found["status"], "ok")
            self.assertEqual(found["warnings"], ["the mass matrix is singular here: in motion, accelerations cannot be trusted"])
            self.assertAlmostEqual(float(found["state"]["hinge"]["value"]), angle, 14)
            for joint in ("slide", "hinge"):
                for name, force in zip("xyz", (-2 * pull[0], 0, -2 * pull[1])):
                    self.assertAlmostEqual(float(found["joint_reactions"][f"{joint}.force.{name}"]["value"]), force, 13)
                    self.assertEqual(float(found["joint_reactions"][f"{joint}.moment.{name}"]["value"]), 0)
            self.assertEqual({float(a["value"]) for a in found["accelerations"].values()}, {0})

    def test_where_coordinates_do_not_describe_all_motion_nothing_is_known_to_rest(self):
        # At the pole no angle moves the bob along y, and so nothing there tells that the wind does.
        bob = HEAD + """coordinates: {theta: {initial: 0.2}, phi: {}}
particles: {bob: {mass: 2, position: [sin(theta)*cos(phi), sin(theta)*sin(phi), -cos(theta)]}}
forces: {gravity: {uniform: [0, 0, -9.81]}, wind: {uniform: [0, WIND, 0]}}
"""
        for wind in ("0", "1"):
            found = json.loads(self.run_it("evaluate", "-", "--equilibrium", "--format=json", stdin=bob.replace("WIND", wind)).stdout or "{}")
            if found and abs(float(found["state"]["theta"]["value"])) < 1e-9:
                self.assertIn("singular_mass_matrix", found["status"])
                self.assertIn("the coordinates do not describe every motion here", found["warnings"][0])
        # A ball that rolls in an upright cylinder falls, whatever Euler angles say of it.
        found = self.run_it("evaluate", MODELS / "sphere_in_cylinder.yaml", "--equilibrium")
        self.assertTrue(found.returncode == 1 or "not to be trusted" in found.stdout)

    def test_of_equilibria_side_by_side_it_finds_one_nearby(self):
        # A load on a rope that a constant force holds, whatever the length of the rope.
        rope = HEAD + """parameters: {m: 3, g: 9.81}
coordinates: {l: {initial: 4}, a: {initial: 0.1}, b: {initial: 0.2}}
particles: {load: {mass: m, position: [l*sin(a), l*cos(a)*sin(b), -l*cos(a)*cos(b)]}}
forces:
  gravity: {uniform: [0, 0, -g]}
  winch: {generalized: {l: -m*g}}
"""
        found = self.at_equilibrium(rope)
        self.assertEqual(found["status"], "ok")
        self.assertAlmostEqual(float(found["state"]["l"]["value"]), 4, delta=1)
        for angle in "ab":
            self.assertAlmostEqual(float(found["state"][angle]["value"]), 0, 12)

    def test_a_governor_swings_out_in_a_plane_that_turns(self):
        governor = HEAD + """parameters: {m: 1, M: 2, l: 0.2, e: 0.03, g: 9.81}
coordinates: {psi: {held_at: 1 + 12*t}}
joints:
  spindle: {type: revolute, child: shaft, axis: z, coordinates: psi}
  pin_$i: {count: 2, type: revolute, parent: shaft, child: arm_$i, at: [e*(3 - 2*$i), 0, 0], axis: y, initial_guess: -0.6*(3 - 2*$i)}
  knee_$i: {count: 2, type: revolute, parent: arm_$i, child: link_$i, at: [0, 0, -l], axis: y, initial_guess: 1.2*(3 - 2*$i)}
  slide: {type: prismatic, parent: shaft, child: sleeve, axis: z, initial: -1.6*l}
particles:
  ball_$i: {count: 2, mass: m, frame: arm_$i, centre: [0, 0, -l]}
  weight: {mass: M, frame: sleeve, centre: [0, 0, 0]}
points:
  foot_$i: {count: 2, on: link_$i, at: [0, 0, -l]}
  ear_$i: {count: 2, on: sleeve, at: [e*(3 - 2*$i), 0, 0]}
constraints: {close_$i: {count: 2, coincide: [foot_$i, ear_$i], in: shaft}}
forces: {gravity: {uniform: [0, 0, -g]}}
"""
        found = self.at_equilibrium(governor)
        self.assertEqual(found["status"], "ok")
        angle = float(found["state"]["pin_2"]["value"])
        self.assertAlmostEqual(144 * (0.03 + 0.2 * math.sin(angle)), 3 * 9.81 * math.tan(angle), 12)
        # Each link carries half of the sleeve, along itself.
        self.assertAlmostEqual(float(found["multipliers"]["close_2_z"]["value"]), -9.81, 12)
        self.assertAlmostEqual(float(found["multipliers"]["close_2_x"]["value"]), 9.81 * math.tan(angle), 12)
        # Along the axes of the shaft; in space it has turned by 1.
        for axis, part in (("x", math.cos(1)), ("y", math.sin(1))):
            force = float(found["reaction_forces"][f"close_2_x.force_on_foot_2.{axis}"]["value"])
            self.assertAlmostEqual(force, 9.81 * math.tan(angle) * part, 12)

    def test_what_rolls_moves_as_it_turns(self):
        # A cart on two wheels, each with a spring: x = r a = r b all the way, (k + K)/r^2 x = m g sin.
        cart = HEAD + """coordinates: {x: {}, a: {}, b: {}}
bodies:
  cart: {mass: 5, inertia: 0, position: [x, 0, 0], orientation: {axis: y, angle: 0}}
  front: {mass: 1, inertia: 0.01, position: [x + 1, 0, 0], orientation: {axis: y, angle: a}}
  rear: {mass: 1, inertia: 0.01, position: [x - 1, 0, 0], orientation: {axis: y, angle: b}}
constraints: {front_rolls: {velocity: dot(x) - 0.2*dot(a)}, rear_rolls: {velocity: dot(x) - 0.2*dot(b)}}
forces: {slope: {uniform: [2, 0, -9.81]}, one: {spring: a, stiffness: 4}, other: {spring: b, stiffness: 1}}
"""
        found = self.at_equilibrium(cart)
        for group, name, value in (("state", "x", 0.112), ("state", "a", 0.56), ("state", "b", 0.56),
                                   ("multipliers", "front_rolls", -11.2), ("multipliers", "rear_rolls", -2.8)):
            self.assertAlmostEqual(float(found[group][name]["value"]), value, 12)

    def test_the_way_to_rest_is_one_that_constraints_on_velocities_allow(self):
        # Each of these constraints can be integrated from where the model starts, so that there is one place of rest: on the curve.
        bead = HEAD + """coordinates: {x: {initial: 1}, y: {initial: 1}}
particles: {p: {mass: 1, position: [x, y, 0]}}
constraints: {c: {LAW}}
forces: {a: {spring: x, stiffness: 3, rest: 4}, b: {spring: y, stiffness: 10}}
"""
        by_rates, by_place = (self.at_equilibrium(bead.replace("LAW", law)) for law in ("velocity: x*dot(y) + y*dot(x)", "equation: x*y - 1"))
        for name in ("x", "y"):
            self.assertAlmostEqual(float(by_rates["state"][name]["value"]), float(by_place["state"][name]["value"]), 9)
        # 3 (x - 4) dx + 10 y dy = 0 along x y = 1
        x = float(by_rates["state"]["x"]["value"])
        self.assertAlmostEqual(3 * (x - 4) - 10 / x**3, 0, 8)
        # A ball that a spring pulls 0.5 m along turns 0.5/0.2 rad.
        ball = HEAD + """coordinates: {x: {initial: 0}, y: {initial: 0}, z: {held_at: 0.2}}
orientations: {o: {quaternion: [e0, e1, e2, e3], angular_velocity: [wx, wy, wz], frame: body}}
bodies: {ball: {mass: 1, inertia: 0.016, position: [x, y, z], orientation: o}}
points: {foot: {at: [x, y, 0]}}
constraints: {rim: {rolls: ball, at: foot}}
forces: {pull: {spring: x, stiffness: 7, rest: 0.5}}
"""
        state = self.at_equilibrium(ball)["state"]
        self.assertAlmostEqual(float(state["x"]["value"]), 0.5, 15)
        self.assertAlmostEqual(float(state["e0"]["value"]), math.cos(1.25), 9)
        self.assertAlmostEqual(float(state["e2"]["value"]), math.sin(1.25), 9)

    def test_a_spring_is_as_linear_far_away(self):
        far = HEAD + "coordinates: {x: {initial: START}}\nparticles: {p: {mass: 1e4, position: [x, 0, 0]}}\nforces: {s: {spring: x, stiffness: 3, rest: -2}}\n"
        for start in ("300", "-1e5"):
            self.assertAlmostEqual(float(self.at_equilibrium(far.replace("START", start))["state"]["x"]["value"]), -2, 14)

    def test_what_is_at_rest_stays(self):
        brake = HEAD + """coordinates: {x: {initial: 0.2}}
particles: {p: {mass: 1, position: [x, 0, 0]}}
constraints: {brake: {velocity: dot(x)}}
forces: {pull: {spring: x, stiffness: 500}}
"""
        found = self.at_equilibrium(brake)
        self.assertAlmostEqual(float(found["state"]["x"]["value"]), 0.2, 15)
        self.assertAlmostEqual(float(found["multipliers"]["brake"]["value"]), 100, 12)

    def test_heavy_and_light_find_their_places(self):
        pair = HEAD + """coordinates: {x: {initial: 3}, y: {initial: 5}}
particles: {heavy: {mass: 10^12, position: [x, 0, 0]}, light: {mass: 1, position: [0, y, 0]}}
forces: {one: {spring: x, stiffness: 1, rest: -2}, two: {spring: y, stiffness: 1, rest: 7}}
"""
        found = self.at_equilibrium(pair)
        self.assertEqual([float(found["state"][name]["value"]) for name in "xy"], [-2, 7])

    def test_three_legs_under_a_plank_carry_the_least_together(self):
        # Of leg forces with the sum m g and no moment those with the least sum of (c f)^2: c^2 = 1/m + arm^2/J are 4/m, 1.75/m, 4/m.
        plank = HEAD + """
coordinates: {x: {initial: 0.2}, y: {}, phi: {}}
frames: {f: {position: [x, y, 0], orientation: {axis: z, angle: phi}}}
bodies: {plank: {mass: 3, inertia: 1, frame: f}}
points: {a: {on: f, at: [-1, 0, 0]}, b: {on: f, at: [0.5, 0, 0]}, c: {on: f, at: [1, 0, 0]}}
constraints: {la: {equation: a.y}, lb: {equation: b.y}, lc: {equation: c.y}}
forces: {gravity: {uniform: [0, -10, 0]}, spring: {generalized: {x: -50*x}}}
"""
        p = 30 / (13 / 72 + 7 / 31.5 + 5 / 72)
        legs = {"la": 13 / 72 * p, "lb": 7 / 31.5 * p, "lc": 5 / 72 * p}
        for start in ("x=0.2", "x=-7"):
            found = json.loads(self.run_it("evaluate", "-", "--equilibrium", "--format=json", "--set", start, stdin=plank).stdout)
            self.assertEqual(found["not_unique"], ["multipliers", "reaction_forces"])
            for leg, force in legs.items():
                self.assertAlmostEqual(float(found["multipliers"][leg]["value"]), force, 11)

    def test_nearly_parallel_rows_carry_at_rest_what_their_difference_can(self):
        # The difference of both rows holds z, with multipliers of weight / d.
        skate = HEAD + """parameters: {d: DIFFERENCE}
coordinates: {x: {initial: 0.931}, y: {initial: 0.470}, z: {initial: -0.361}}
particles: {p: {mass: 1, position: [x, y, z]}}
constraints:
  a: {velocity: dot(x) + dot(y) + x*dot(z)}
  b: {velocity: dot(x) + dot(y) + (x + d)*dot(z)}
forces: {gravity: {uniform: [0, 0, -9.81]}}
"""
        for digits in (3, 5, 6, 8):
            found = self.at_equilibrium(skate.replace("DIFFERENCE", f"1e-{digits}"))
            self.assertEqual([float(found["state"][name]["value"]) for name in "xyz"], [0.931, 0.47, -0.361])
            for name, sign in (("a", -1), ("b", 1)):
                self.assertAlmostEqual(float(found["multipliers"][name]["value"]) / (sign * 9.81 * 10**digits), 1, 12)
        # On positions, with a spring: both rows hold it where they meet.
        rails = HEAD + """coordinates: {x: {initial: -0.05}, y: {initial: 0.05}, z: {initial: 0.3}}
particles: {p: {mass: 1, position: [x, y, z]}}
constraints: {a: {equation: x - y + 0.1}, b: {equation: x - y + 0.1 + DIFFERENCE*(z - 0.3)}}
forces: {spring: {potential: 5*(x^2 + y^2 + z^2)}, gravity: {uniform: [0, 0, -9.81]}}
"""
        for digits in (2, 4, 6, 8):
            found = self.at_equilibrium(rails.replace("DIFFERENCE", f"1e-{digits}"))
            self.assertAlmostEqual(float(found["multipliers"]["b"]["value"]) / (12.81 * 10**digits), 1, 12)

    def test_a_search_that_goes_on_and_on_along_constraints_ends_soon(self):
        text = (SOURCE / "hard_cases" / "models" / "near_parallel.yaml").read_text(encoding="utf-8")
        text = text.replace("value: 2/$i, unit: 1", "value: $i/3 + 0.001*$i*$i, unit: 1")
        text = re.sub(r"(drift_\w: {value: )1", r"\g<1>0", text)
        error = self.refused(1, "evaluate", "-", "--equilibrium", stdin=text, timeout=30)
        self.assertIn("no equilibrium was found", error)

    def test_forces_that_only_fade_have_none(self):
        bead = HEAD + """coordinates: {x: {initial: 0.1}}
particles: {p: {mass: 1, position: [x, 0, 0]}}
forces: {push: {force: [5, 0, 0], on: p}, rope: {force: ["PULL", 0, 0], on: p}}
"""
        for pull in ("-5*x/sqrt(x^2 + 1)", "-5*tanh(x)", "-5 - 5*exp(-x)"):
            error = self.refused(1, "evaluate", "-", "--equilibrium", stdin=bead.replace("PULL", pull))
            self.assertRegex(error, "along 'x' (forces fade, and do not vanish|are not in balance)")
        found = self.at_equilibrium(bead.replace("PULL", "-6*tanh(x)"))
        self.assertAlmostEqual(float(found["state"]["x"]["value"]), math.atanh(5 / 6), 15)

    def test_a_held_coordinate_that_moves_is_named_where_there_is_no_rest(self):
        # A rope drum that holds the load at rest does not while the wind of the drive pulls it aside.
        crane = HEAD + """parameters: {A: 0.1, Omega: 2, c: 20}
coordinates: {y: {held_at: A*sin(Omega*t)}, phi: {}, beta: {initial: 0.1}}
particles: {load: {mass: 3, position: [0, y + (5 + phi)*sin(beta), -(5 + phi)*cos(beta)]}}
forces: {gravity: {uniform: [0, 0, -10]}, drum: {generalized: {phi: -30}}, air: {on: load, force: [0, -c*dot(load.y), 0]}}
"""
        error = self.refused(1, "evaluate", "-", "--equilibrium", stdin=crane)
        self.assertIn("the held coordinate 'y' moves at this time, at 0.2 and 0, and drives the model", error)
        self.assertIn("--set A, Omega", error.replace(" and ", ", "))
        self.assertIn("'y' moves", self.refused(1, "linearize", "-", "--at", "equilibrium", stdin=crane))
        self.at_equilibrium(crane, "--set", "A=0")

    def test_where_nothing_is_stiff_the_place_is_known_to_fewer_digits(self):
        # An inverted pendulum whose spring is just as stiff as its weight turns it: sin(a) - a, flat at 0.
        pendulum = HEAD + """coordinates: {a: {initial: 0.4}}
particles: {p: {mass: 1, position: [2*sin(a), 0, 2*cos(a)]}}
forces: {gravity: {uniform: [0, 0, -10]}, s: {spring: a, stiffness: STIFFNESS}}
"""
        done = self.run_it("evaluate", "-", "--equilibrium", "--format=json", stdin=pendulum.replace("STIFFNESS", "20"))
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"nothing is stiff along 'a' at this equilibrium: where it is, is known to about \de-\d+ only")
        claim = float(re.search(r"about (\S+) only", done.stderr)[1])
        self.assertLess(abs(float(json.loads(done.stdout)["state"]["a"]["value"])), 5 * claim)
        self.assertLess(claim, 1e-7)
        self.at_equilibrium(pendulum.replace("STIFFNESS", "21"))

    def test_few_digits_are_rounded_and_not_wrong(self):
        for digits in (1, 2, 5):
            self.assertEqual(self.at_equilibrium(MODELS / "four_bar.yaml", f"--digits={digits}")["status"], "ok")

    def test_what_no_force_turns_keeps_its_heading(self):
        # A coin falls on its edge; which way it looks then, nothing says.
        found = self.at_equilibrium(MODELS / "rolling_disc.yaml")
        self.assertAlmostEqual(float(found["state"]["psi"]["value"]), 0, 5)

    def test_a_place_that_is_found_is_as_singular_as_one_that_is_given(self):
        # A particle on an arm on a slider along z, both light: pulled along the arm, their motions are one, at 0 as at pi.
        aligned = HEAD + """joints:
  slider: {type: prismatic, child: A, axis: z, coordinates: z}
  hinge: {type: revolute, parent: A, child: B, axis: y, coordinates: a, initial: 0.3}
particles: {p: {mass: 1, frame: B, centre: [1, 0, 0]}}
forces: {pull: {uniform: [9.81, 0, 0]}}
"""
        for start, end in (("0.3", 0), ("2.5", math.pi)):
            done = self.run_it("evaluate", "-", "--equilibrium", "--set", f"a={start}", "--format=json", stdin=aligned)
            self.assertAlmostEqual(float(json.loads(done.stdout)["state"]["a"]["value"]), end, 15)
            self.assertIn("the mass matrix is singular here", done.stderr)

    def test_a_long_chain_uncoils(self):
        # Let go in a coil of more than half a turn, 40 rods hang straight down: nothing but springs that are at rest there and weights.
        chain = HEAD + """counts: {n: 40}
joints:
  hinge_1: {type: revolute, child: link_1, axis: y, coordinates: q_1, initial: 0.1}
  hinge_$(i+1): {count: n-1, type: revolute, parent: link_$i, child: link_$(i+1), at: [0, 0, -0.7], axis: y, coordinates: q_$(i+1), initial: 0.1}
bodies: {link_$i: {count: n, mass: 1.3, inertia: [0.053, 0.053, 0.001], centre: [0, 0, -0.35]}}
forces: {spring_$i: {count: n, spring: q_$i, stiffness: 3}, gravity: {uniform: [0, 0, -9.81]}}
"""
        done = self.run_it("evaluate", "-", "--equilibrium", "--format=json", "--digits", "9", stdin=chain)
        state = json.loads(done.stdout)["state"]
        self.assertEqual(len([name for name in state if name.startswith("q_")]), 2 * 40)
        for name, entry in state.items():
            self.assertAlmostEqual(float(entry["value"]), 0, 9, msg=name)

    def test_what_falls_has_none(self):
        self.assertIn("no equilibrium was found near the initial position: where the search ends, after 1200 steps, -9.81 along 'z' are not in balance",
                      self.refused(1, "evaluate", "-", "--equilibrium", stdin=FALLING))


class InverseDynamics(Program):
    def test_the_force_that_holds_a_weight_and_the_one_that_lifts_it(self):
        for wanted, force in (("z=0", 9.81), ("z=2", 11.81), ("z=-9.81", 0)):
            found = json.loads(self.ok("evaluate", "-", "--accelerate", wanted, "--format=json", stdin=FALLING))
            self.assertAlmostEqual(float(found["inverse_dynamics"]["missing.z"]["value"]), force, 14)

    def test_reactions_are_those_of_the_motion_that_is_wanted(self):
        # A bob on a rod that is held at 30 degrees on a cart: its moment is m l (g sin + a cos), with the force that makes a = 3 and without a word.
        crane = HEAD + """parameters: {M: 3, m: 2, l: 1, g: 10}
inputs: {F: 0}
coordinates: {x: {}, phi: {held_at: pi/6}}
particles: {cart: {mass: M, position: [x, 0, 0]}, bob: {mass: m, position: [x + l*sin(phi), 0, -l*cos(phi)]}}
forces: {gravity: {uniform: [0, 0, -g]}, push: {generalized: {x: F}}}
"""
        for load in ("F=0", "F=15"):
            found = json.loads(self.ok("evaluate", "-", "--accelerate", "x=3", "--set", load, "--format=json", stdin=crane))
            self.assertAlmostEqual(float(found["reactions"]["phi"]["value"]), 10 + 3 * math.sqrt(3), 13)
            self.assertAlmostEqual(float(found["reaction_forces"]["on_bob.force.z"]["value"]), 20, 13)

    def test_inputs_that_do_the_same_are_not_unique(self):
        twins = HEAD + """inputs: {F: 0, G: 0}
coordinates: {x: {}}
particles: {p: {mass: 2, position: [x, 0, 0]}}
forces: {push: {generalized: {x: F + 3*G}}}
"""
        done = self.run_it("evaluate", "-", "--accelerate", "x=6", stdin=twins)
        self.assertIn("those that are needed are not unique", done.stderr)
        self.assertIn("not to be trusted: dependent_constraints", done.stdout)

    def test_an_input_that_acts_nowhere_here_is_named(self):
        arm = HEAD + """inputs: {u: 0, w: 1}
coordinates: {x: {initial: 0}, y: {initial: 2}}
particles: {p: {mass: 0.5, position: [x, y, 0]}}
forces: {f: {force: [u*x, w*y, 0], on: p}}
"""
        done = self.run_it("evaluate", "-", "--accelerate", "y=8", stdin=arm)
        self.assertIn("warning: input 'u' acts along no free speed here: what it has to be is not determined", done.stderr)
        self.assertNotIn("do the same", done.stderr)
        self.assertRegex(done.stdout, r"needed.w +2.0")

    def test_what_is_missing_has_the_unit_of_its_speed(self):
        units = HEAD + """parameters: {m: {value: 1, unit: kg}, J: {value: 1, unit: kg*m^2}}
coordinates: {x: {unit: m}, phi: {unit: rad}}
frames: {arm: {orientation: {axis: z, angle: phi}}}
bodies: {arm: {mass: m, inertia: J}}
particles: {p: {mass: m, position: [x, 0, 0]}}
"""
        found = json.loads(self.ok("evaluate", "-", "--accelerate", "x=1", "--format=json", stdin=units))
        self.assertEqual(found["inverse_dynamics"]["missing.x"]["unit"], "N")
        self.assertEqual(found["inverse_dynamics"]["missing.phi"]["unit"], "N*m")

    def test_inputs_that_cannot_be_found_get_a_word(self):
        squared = HEAD + """inputs: {F: 1}
coordinates: {x: {}}
particles: {p: {mass: 2, position: [x, 0, 0]}}
forces: {push: {generalized: {x: F^2}}}
"""
        for model, word in ((squared, True), (squared.replace("F^2", "F"), False), (FALLING, False)):
            shown = self.ok("evaluate", "-", "--accelerate", "x=1" if model != FALLING else "z=1", stdin=model)
            self.assertEqual("needed inputs are not found: none acts along a speed, or forces are not linear in them" in shown, word)

    def test_fewer_inputs_than_motions_reach_what_they_can_and_say_so(self):
        # A mass of 1 pulled by F along [3, 4]: of the wanted [1, 0], the part 3/5 along it, [9/25, 12/25].
        skew = HEAD + """inputs: {F: 0}
coordinates: {x: {}, y: {}}
particles: {p: {mass: 1, position: [x, y, 0]}}
forces: {pull: {force: [3*F, 4*F, 0], on: p}}
"""
        done = self.run_it("evaluate", "-", "--accelerate", "x=1", "--format=json", stdin=skew)
        found = json.loads(done.stdout)["inverse_dynamics"]
        self.assertEqual((done.returncode, float(found["needed.F"]["value"])), (0, 0.12))
        self.assertEqual(done.stderr, "warning: the inputs that are needed make x_ddot 0.360: they cannot make all that is wanted\n")
        self.assertEqual(self.run_it("evaluate", "-", "--accelerate", "x=3", "--accelerate", "y=4", stdin=skew).stderr, "")

    def test_accelerations_that_constraints_forbid_are_named(self):
        done = self.run_it("evaluate", "-", "--accelerate", "x=1", stdin=LAMP)
        self.assertIn("the wanted accelerations violate constraint ", done.stderr)
        self.assertIn("not to be trusted: violated_constraints", done.stdout)

    def test_accelerations_that_are_not_named_follow_from_the_constraints(self):
        # A bar of length 1 between x and y, at 3/5 and 4/5: x x'' + y y'' = -(x'^2 + y'^2).
        bar = HEAD + """parameters: {m: 2}
inputs: {F: 0, G: 0}
coordinates: {x: {initial: 0.6, initial_rate: 4}, y: {initial: 0.8, initial_rate: -3}}
particles: {p: {mass: m, position: [x, 0, 0]}, q: {mass: m, position: [0, y, 0]}}
constraints: {bar: {distance: [p, q], is: 1}}
forces: {push: {generalized: {x: F, y: G}}}
"""
        found = json.loads(self.ok("evaluate", "-", "--accelerate", "x=1", "--set", "G=5", "--format=json", stdin=bar))
        self.assertEqual(found["status"], "ok")
        y = (-25 - 0.6) / 0.8
        self.assertAlmostEqual(float(found["wanted"]["y_ddot"]["value"]), y, 12)
        # The bar takes what G and the inertia of q leave along y, and hands it to x: F = m x'' - (m y'' - G) x/y.
        self.assertNotIn("needed.G", found["inverse_dynamics"])
        self.assertAlmostEqual(float(found["inverse_dynamics"]["needed.F"]["value"]), 2 - (2 * y - 5) * 0.6 / 0.8, 12)
        for name, value in (("x", 1), ("y", y)):
            self.assertAlmostEqual(float(found["inverse_dynamics"][f"reached.{name}"]["value"]), value, 12)
        # m x'' = N x and m y'' = N y + G with N = -m (x'^2 + y'^2) - G y: the push of the bar as it is.
        push = -50 - 5 * 0.8
        self.assertAlmostEqual(float(found["inverse_dynamics"]["missing.x"]["value"]), 2 - push * 0.6, 12)
        self.assertAlmostEqual(float(found["inverse_dynamics"]["missing.y"]["value"]), 2 * y - 5 - push * 0.8, 12)

    def test_forces_without_a_value_at_rest_are_named(self):
        drag = HEAD + "coordinates: {z: {}}\nparticles: {p: {mass: 1, position: [0, 0, z]}}\n" \
                      "forces: {drag: {generalized: {z: -dot(z)/sqrt(dot(z)^2)}}}\n"
        self.assertIn("at rest at the initial position there is no force: division by zero", self.refused(1, "evaluate", "-", "--equilibrium", stdin=drag))

    def test_a_pole_of_a_force_is_no_equilibrium(self):
        for start in ("pi/2", "1.5"):
            pole = HEAD + f"coordinates: {{q: {{initial: {start}}}}}\nparticles: {{p: {{mass: 1, position: [q, 0, 0]}}}}\n" \
                          "forces: {f: {generalized: {q: 1/cos(q)}}}\n"
            self.refused(1, "evaluate", "-", "--equilibrium", stdin=pole)

    def test_a_search_does_not_cross_a_pole(self):
        funnel = """
gauss: 1
name: funnel
coordinates: {x: {initial: 1}}
particles: {p: {mass: 1, position: [x, 0, 0]}}
forces: {pull: {potential: -1/x}}
"""
        self.assertIn("along 'x' are not in balance", self.refused(1, "evaluate", "-", "--equilibrium", stdin=funnel))

    def test_names_and_numbers_are_checked(self):
        for wrong, message in (("q=1", "'q' is no free coordinate"), ("z", "expected name=value"), ("z=z", "a number is needed"),
                               ("m=1", "'m' is no free coordinate"), ("z_ddot=1", "write 'z' for its acceleration, as in --accelerate z=1"),
                               ("z_dot=1", "not 'z_dot'")):
            self.assertIn(message, self.refused(2, "evaluate", "-", "--accelerate", wrong, stdin=SPRING))


if __name__ == "__main__":
    unittest.main()
