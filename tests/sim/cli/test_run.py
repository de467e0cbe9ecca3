"""gauss-sim run: motions against closed forms, and what is written."""

import csv
import math
import os
import re
import subprocess
import unittest

from gauss_sim import MODELS, PROGRAM, PUSHED, SLIDE, SPRING, Program

# A pendulum of two rods in coordinates of its masses, and a body that hangs from a spring by a point beside its centre: from rest.
SWING = """gauss: 1
name: swing
parameters: {m_1: {value: 1, unit: kg}, m_2: {value: 0.5, unit: kg}, L_1: {value: 1, unit: m}, L_2: {value: 0.8, unit: m}, k: {value: 30, unit: N/m}, g: {value: 9.81, unit: m/s^2}}
coordinates: {x_1: {unit: m, initial: 0.8}, y_1: {unit: m, initial: -0.6}, x_2: {unit: m, initial: 0.8}, y_2: {unit: m, initial: -1.4}}
particles: {a: {mass: m_1, position: [x_1, y_1, 0]}, b: {mass: m_2, position: [x_2, y_2, 0]}}
constraints: {upper: {equation: x_1^2 + y_1^2 - L_1^2}, lower: {equation: (x_2-x_1)^2 + (y_2-y_1)^2 - L_2^2}}
forces: {gravity: {uniform: [0, -g, 0]}, spring: {potential: k*x_2^2/2}}
"""
HUNG = """gauss: 1
name: hung
parameters: {m: {value: 2, unit: kg}, A: {value: 0.02, unit: kg*m^2}, B: {value: 0.05, unit: kg*m^2}, C: {value: 0.06, unit: kg*m^2}, k: {value: 60, unit: N/m}, l: {value: 0.3, unit: m}, g: {value: 9.81, unit: m/s^2}}
coordinates: {x: {unit: m, initial: 0.1}, y: {unit: m}, z: {unit: m, initial: -0.8}}
orientations: {attitude: {quaternion: [e_0, e_1, e_2, e_3], angular_velocity: [p, q, s], frame: body}}
bodies: {body: {mass: m, inertia: [A, B, C], position: [x, y, z], orientation: attitude}}
points: {top: {at: [0, 0, 0]}, hook: {on: body, at: [0.1, 0.05, 0.02]}}
forces: {gravity: {uniform: [0, 0, -g]}, spring: {spring: [top, hook], stiffness: k, length: l}}
"""
# From aphelion, in metres.
COMET = """gauss: 1
name: comet
parameters: {GM: {value: 1.327e20, unit: m^3/s^2}, m: {value: 1e13, unit: kg}}
coordinates: {x: {unit: m, initial: 5e12}, y: {unit: m, initial: 0, initial_rate: 1000}}
particles: {p: {mass: m, position: [x, y, 0]}}
forces: {sun: {potential: -GM*m/sqrt(x^2+y^2)}}
"""
# 1 ms of force.
PULSE = """gauss: 1
name: pulse
parameters: {m: {value: 1, unit: kg}, F: {value: 5, unit: N}, a: {value: 3.3, unit: s}, d: {value: 0.001, unit: s}}
coordinates: {x: {unit: m}}
particles: {p: {mass: m, position: [x, 0, 0]}}
forces: {f: {generalized: {x: "piecewise(t < a, 0, t < a + d, F, 0)"}}}
"""
# Both rest until something begins to push the first.
KICK = """gauss: 1
name: kick
parameters: {k: {value: 7, unit: N/m}, m: {value: 2, unit: kg}}
tables: {push: {of: [0, 3.5, 5], values: [0, 0, 225], of_unit: s, unit: N}}
coordinates: {x: {unit: m}, y: {unit: m}}
particles: {p: {mass: m, position: [x, y, 0]}}
forces: {f: {generalized: {x: push(t), y: k*x}}}
"""

# From times that have few digits left.
LATE = """gauss: 1
name: late
coordinates: {y: {initial: 1, initial_rate: 0}}
particles: {p: {mass: 1, position: [0, y, 0]}}
forces: {f: {generalized: {y: "-cos(t)"}}}
"""
# A spring and a field that takes nearly all of it away.
CANCEL = """gauss: 1
name: cancel
parameters: {k: STIFF, h: 200000000}
coordinates: {x: {unit: m, initial: 1}}
particles: {bob: {mass: 2, position: [x, 0, 0]}}
forces: {pull: {generalized: {x: h*x - k*x}}}
"""

FORMULA = """gauss: 1
name: formula
parameters: {c: 600000000, d: 1399999999}
coordinates: {x: {unit: m, initial: 1}}
particles: {bob: {mass: 1, position: [x, 0, 0]}}
forces: {pull: {generalized: {x: "-(c/3 - d/7)*x"}}}
"""
TIDE = """gauss: 1
name: tide
parameters: {GM: {value: 3.986e14, unit: m^3/s^2}, R: {value: 42164000, unit: m}, m: {value: 100, unit: kg}}
coordinates: {x: {unit: m, initial: 1e-3}}
particles: {p: {mass: m, position: [x, 0, 0]}}
forces: {tide: {generalized: {x: m*GM/R^2 - m*GM/(R+x)^2}}}
"""
NOISE = """gauss: 1
name: noise
parameters: {A: {value: 1e9, unit: N}, L: {value: 1, unit: m}, k: {value: 1, unit: N/m}}
coordinates: {x: {unit: m, initial: 1e-10}}
particles: {p: {mass: 1, position: [x, 0, 0]}}
forces: {pull: {generalized: {x: A*(cos(x/L) - cos(2*x/L)) - k*x}}}
"""
# On the way that decays.
DECAYS = """gauss: 1
name: decays
parameters: {k: {value: 0.01, unit: N/m}}
coordinates: {x: {unit: m, initial: 1, initial_rate: -0.1}}
particles: {p: {mass: 1, position: [x, 0, 0]}}
forces: {push: {generalized: {x: k*x}}}
"""

# Its carriage glides with 2 m/s, exactly; steps follow the wheel, which turns fifty times a second.
FLYWHEEL = """gauss: 1
name: flywheel
coordinates: {x: {initial_rate: 2}}
orientations:
  att: {quaternion: [e0, e1, e2, e3], angular_velocity: [wx, wy, wz], initial_angular_velocity: [1, 0, 314]}
bodies: {wheel: {mass: 1, inertia: [0.02, 0.02, 0.03], position: [x, 0, 0], orientation: att}}
"""

# Nothing moves, and nothing acts at first.
DRIVEN = """gauss: 1
name: driven
parameters: {{m: {{value: 1, unit: kg}}, F: {{value: 2, unit: N}}, w: {{value: 3, unit: rad/s}}}}
coordinates: {{x: {{unit: m, initial: 0}}}}
particles: {{bob: {{mass: m, position: [x, 0, 0]}}}}
forces: {{push: {{generalized: {{x: F*sin(w*t)^{power}}}}}}}
"""

UPRIGHT = """gauss: 1
name: upright
parameters: {g: {value: 9.81, unit: m/s^2}, l: {value: 1, unit: m}, m: {value: 1, unit: kg}}
coordinates: {theta: {unit: rad, initial: pi, initial_rate: 0}}
particles: {bob: {mass: m, position: [l*sin(theta), -l*cos(theta), 0]}}
forces: {weight: {uniform: [0, -g, 0]}}
"""


class Motions(Program):
    def test_a_spring_swings_as_its_closed_form(self):
        self.write("spring.yaml", SPRING)
        for method in ("auto", "taylor", "prince87", "fehlberg78", "dopri5", "cash_karp54"):
            self.ok("run", "spring.yaml", "--method", method, "--tolerance", "1e-11", "-q")
            table = self.table("spring.csv")
            for t, x in zip(table["t [s]"], table["x [m]"]):
                self.assertAlmostEqual(x, math.cos(2 * t), delta=2e-8, msg=method)

    def test_steps_of_one_length_have_their_order(self):
        self.write("spring.yaml", SPRING)
        errors = []
        for step in ("0.04", "0.02"):
            self.ok("run", "spring.yaml", "--method", "rk4", "--step", step, "--samples", "2", "--duration", "8", "-q")
            errors.append(abs(self.table("spring.csv")["x [m]"][-1] - math.cos(16)))
        self.assertGreater(errors[0] / errors[1], 13)
        self.assertLess(errors[0] / errors[1], 19)

    def test_samples_that_are_found_several_at_once_are_those_that_are_found_one_by_one(self):
        """To the bit: with the functions of one way, of two ways, and with angles of which project and what follows it share the sine."""
        for model, outputs in (("sphere_in_cylinder_quaternion", "reactions,state"), ("sphere_in_cylinder", "energy,reactions"),
                               ("double_pendulum", "joint_reactions,energy")):
            rows = {}
            for duration, samples in (("0.8", 8001), ("1.2", 12001)):
                self.ok("run", MODELS / f"{model}.yaml", "--method", "taylor", "--every", "1e-4", "--duration", duration, "--outputs", outputs,
                        "-o", "table.csv", "-q", env=dict(os.environ, XDG_CACHE_HOME=str(self.folder / f"{model}_{duration}")))
                rows[samples] = (self.folder / "table.csv").read_text().splitlines()
                together = any("GaussSimSampled" in text.read_text() for text in self.folder.glob(f"{model}_{duration}/gauss/*/model.cpp"))
                self.assertEqual(together, samples > 10000)
            self.assertEqual(rows[8001][:8000], rows[12001][:8000], model)

    def test_the_ball_climbs_as_its_closed_form_and_the_wall_pushes_so(self):
        """Neimark and Fufaev: the height of a ball that rolls in a cylinder is harmonic, with nu = chi' sqrt(2/7)."""
        start = {"m": 0.5, "R": 0.6, "r": 0.1, "g": 9.81, "zeta_dot_0": 0.7, "omega_r_0": 2}
        sets = [word for name, value in start.items() for word in ("--set", f"{name}={value}")]
        self.ok("run", MODELS / "sphere_in_cylinder.yaml", "--outputs", "chi,zeta,reactions.rho", *sets, "--set", "chi_dot=4",
                "--tolerance", "1e-12", "-q")
        table = self.table("sphere_in_cylinder.csv")
        nu = 4 * math.sqrt(2 / 7)
        push = -(2 / 5 * 0.1 * 4 * 2 + 9.81) / (7 / 5)
        for t, chi, zeta, force in zip(table["t [s]"], table["chi [rad]"], table["zeta [m]"], table["reactions.rho.generalized [N]"]):
            self.assertAlmostEqual(chi, 4 * t, delta=1e-8)
            self.assertAlmostEqual(zeta, 0.7 / nu * math.sin(nu * t) + push / nu**2 * (1 - math.cos(nu * t)), delta=1e-8)
            self.assertAlmostEqual(force, -0.5 * 0.5 * 16, delta=1e-7)

    def test_long_double_has_more_digits(self):
        self.write("spring.yaml", SPRING)
        self.ok("run", "spring.yaml", "--number", "long-double", "--tolerance", "1e-17", "--duration", "10", "-q")
        last = self.summary("spring.json")["last_state"][0]
        self.assertGreaterEqual(len(last.lstrip("-0.")), 18, last)

    def test_constraints_are_kept(self):
        self.ok("run", MODELS / "four_bar.yaml", "-q")
        drift = self.summary("four_bar.json")["drift"]["constraints"]
        self.assertLess(drift["positions"], 1e-11)
        self.ok("run", MODELS / "four_bar.yaml", "--projection", "off", "--tolerance", "1e-6", "-q")
        self.assertGreater(self.summary("four_bar.json")["drift"]["constraints"]["positions"], 1e-9)


class Writing(Program):
    def setUp(self):
        super().setUp()
        self.write("spring.yaml", SPRING)

    def test_the_table_has_units_and_the_samples_asked_for(self):
        self.ok("run", "spring.yaml", "--samples", "11", "--duration", "2", "--outputs", "x,x_dot,x_ddot,energy.total")
        table = self.table("spring.csv")
        self.assertEqual(list(table), ["t [s]", "x [m]", "x_dot [m/s]", "x_ddot [m/s^2]", "energy.total [J]"])
        self.assertEqual(table["t [s]"], [2 * k / 10 for k in range(11)])
        self.assertAlmostEqual(table["x_ddot [m/s^2]"][0], -4)

    def test_every_is_the_time_between_rows(self):
        self.ok("run", "spring.yaml", "--every", "0.25", "--duration", "1", "-q")
        self.assertEqual(self.table("spring.csv")["t [s]"], [0, 0.25, 0.5, 0.75, 1])
        self.ok("run", "spring.yaml", "--every", "0.25", "--duration", "0.9", "-q")
        self.assertEqual(self.table("spring.csv")["t [s]"], [0, 0.25, 0.5, 0.75])

    def test_times_may_be_formulas(self):
        self.ok("run", "spring.yaml", "--duration", "pi/2", "--samples", "3", "--outputs", "x", "-q")
        self.assertAlmostEqual(self.table("spring.csv")["x [m]"][-1], -1, delta=1e-8)

    def test_an_estimate_that_nothing_supports_is_left_out(self):
        self.ok("run", "spring.yaml", "--method", "rk4", "--step", "100", "--samples", "11", "-q")
        error = self.summary("spring.json").get("error_estimate")
        self.assertTrue(error is None or error["relative"] > 0.01, error)

    def test_steps_of_one_length_are_as_many_as_fit_however_times_are_rounded(self):
        self.write("spring.yaml", SPRING)
        for step, duration, steps in ((0.05, 2000, 40000), (0.1, 10000, 100000)):
            self.ok("run", "spring.yaml", "--method", "verlet", "--step", step, "--every", step, "--duration", duration, "--outputs", "energy.total", "-q")
            self.assertEqual(self.summary("spring.json")["steps"], steps)

    def test_steps_that_no_shorter_one_follows_end(self):
        """A refused step was made as long as before where it nearly led to the next row, for ever."""
        self.write("late.yaml", LATE)
        self.write("jump.yaml", LATE.replace('"-cos(t)"', '"piecewise(t < 3.3, 1, t < 3.32, 100, -1)"'))
        for tolerance in ("1e-5", "1e-7", "1e-9"):
            for method in ("prince87", "bulirsch_stoer"):
                result = self.run_it("run", "late.yaml", "--start", "2e9*pi", "--method", method, "--tolerance", tolerance, "-q", timeout=60)
                self.assertIn(result.returncode, (0, 5))
        self.ok("run", "jump.yaml", "--method", "dopri5", "-q", timeout=60)
        self.ok("run", "jump.yaml", "--method", "prince87", "--number", "float", "--tolerance", "1e-5", "-q", timeout=60)

    def test_a_first_guess_that_breaks_constraints_is_no_trouble_of_the_motion(self):
        said = self.run_it("run", MODELS / "lagrange_top.yaml", "--method", "gauss_legendre4", "--step", "0.003", "--duration", "3", "--samples", "31", "-q").stderr
        self.assertIn("the equations of the implicit method were not solved: the step is too long", said)

    def test_what_is_a_function_of_time_may_act_for_a_short_one(self):
        self.write("late.yaml", LATE)
        self.assertRegex(self.ok("run", "late.yaml"), r"(?m)^  error   .*; of what acts for 0\.00991 s or longer$")
        self.write("spring.yaml", SPRING)
        self.assertNotIn("of what acts for", self.ok("run", "spring.yaml"))

    def test_where_times_are_too_far_apart_for_steps_the_program_says_so(self):
        self.write("kink.yaml", LATE.replace('"-cos(t)"', '"abs(sin(t))"'))
        result = self.run_it("run", "kink.yaml", "--start", "1.7e9", "--tolerance", "1e-13", "-q")
        self.assertEqual(result.returncode, 5)
        said = result.stderr
        self.assertIn("in double, times near 1.7e+09 s are 4e-07 s apart", said)
        self.assertNotIn("abs(...)", said)

    def test_why_there_is_no_estimate_is_said(self):
        for options, why in ((["--method", "rk4", "--step", "100", "--samples", "11"], None), (["--method", "rk4", "--step", "1e-7", "--duration", "9", "--engine", "interpreted"], "runs of more than 5 s are not made again")):
            with self.subTest(options):
                said = self.ok("run", "spring.yaml", *options)
                self.assertRegex(said, rf"\n  error   (not estimated: {why}|.* of the range.*)\n")
                self.assertEqual("error_estimate" in self.summary("spring.json"), "not estimated" not in said)
                self.assertEqual("not estimated: " + self.summary("spring.json").get("not_estimated", "") in said, "not estimated" in said)
                if why:
                    self.assertIn(why, said)

    def test_motions_that_end_where_steps_of_one_length_go_on_have_a_warning(self):
        """A fall into the centre ends after pi / (2 sqrt(2)) s."""
        self.write("fall.yaml", "gauss: 1\nname: fall\nparameters: {m: 1, k: 1}\ncoordinates: {x: {initial: 1}}\n"
                   "particles: {p: {mass: m, position: [x, 0, 0]}}\nforces: {pull: {generalized: {x: -k*x/abs(x)^3}}}\n")
        result = self.run_it("run", "fall.yaml", "--method", "rk4", "--duration", "4", "-q")
        self.assertEqual(result.returncode, 0)
        end = re.search(r"warning: a tighter run stops at t = (\S+): .*, so that the table may be no motion of this model", result.stderr)
        self.assertAlmostEqual(float(end[1]), math.pi / math.sqrt(8), delta=1e-3)
        self.assertNotIn("tighter run", self.run_it("run", "fall.yaml", "--method", "rk4", "--duration", "1", "-q").stderr)

    def test_components_of_reactions_have_the_units_of_their_speeds(self):
        self.ok("run", MODELS / "rolling_disc.yaml", "--outputs", "reactions,poses", "--duration", "0.01", "--samples", "2", "-q", "-o", "disc.csv")
        heads = list(self.table("disc.csv"))
        units = {head[:head.index(" ")]: head[head.index("[") if " [" not in head else head.index(" [") + 1:] for head in heads}
        along = {name: unit for name, unit in units.items() if ".generalized[" in name}
        self.assertGreater(len(along), 4)
        self.assertEqual(set(along.values()), {"[N]", "[N*m]"})
        self.assertEqual({unit for name, unit in units.items() if ".rotation[" in name}, {"[1]"})

    def test_a_quaternion_of_another_length_is_divided_by_it_with_a_word(self):
        said = self.run_it("run", MODELS / "free_top.yaml", "--set", "float_e0=0.5", "--set", "float_e1=0.2", "--duration", "0.01", "-q").stderr
        self.assertIn("warning: the initial quaternion of 'float' has length 0.5385, and is divided by it", said)
        said = self.run_it("run", MODELS / "free_top.yaml", "--set", "float_e0=0.8", "--set", "float_e1=0.6", "--duration", "0.01", "-q").stderr
        self.assertNotIn("quaternion", said)
        said = self.refused(2, "run", MODELS / "free_top.yaml", "--set", "float_e0=0")
        self.assertIn("has length 0: [1, 0, 0, 0] is no rotation", said)

    def test_series_that_compilers_take_long_for_are_no_default(self):
        for model, words, method in (("robot_arm", [], "prince87"), ("robot_arm", ["--method", "taylor"], "taylor"), ("double_pendulum", [], "taylor")):
            self.ok("run", MODELS / f"{model}.yaml", *words, "--duration", "0.01", "--samples", "2", "-q")
            self.assertEqual(self.summary(f"{model}.json")["method"], method, (model, words))

    def test_where_a_force_jumps_steps_are_said_to_become_short(self):
        """A bob that friction has stopped, and that the spring would pull back and forth over the jump."""
        rubbed = SPRING.replace("name: spring", "name: rubbed").replace("  k: {", "  F: {value: 3, unit: N}\n  eps: {value: 1e-3, unit: m/s}\n  k: {").replace("forces:\n", "forces:\n  friction: {generalized: {x: -F*LAW}}\n")
        self.write("rubbed.yaml", rubbed.replace("LAW", "sign(dot(x))"))
        result = self.run_it("run", "rubbed.yaml", "--max-steps", "20000")
        self.assertEqual(result.returncode, 5, result.stderr)
        self.assertIn("too many steps", result.stderr)
        self.assertIn("steps become short where a force has a jump or a kink, as by sign(...)", result.stderr)
        self.assertEqual(self.summary("rubbed.json")["steps"], 20000)
        with self.subTest("a run that hardly goes on says so while it can be stopped"):
            said = self.run_it("run", "rubbed.yaml", "--max-steps", "250000").stderr
            self.assertRegex(said, r"warning: the run hardly goes on: 200000 steps lead on from t = 1\.5\d*, and it is not at 1\.5\d* yet; steps become short")
            self.assertEqual(said.count("hardly goes on"), 1)
        with self.subTest("the hint helps"):
            self.write("rubbed.yaml", rubbed.replace("LAW", "tanh(dot(x)/eps)"))
            self.ok("run", "rubbed.yaml", "--max-steps", "20000", "-q")
        with self.subTest("nothing jumps"):
            said = self.run_it("run", "rubbed.yaml", "--max-steps", "20", "-q").stderr
            self.assertIn("too many steps", said)
            self.assertNotIn("jump", said)

    def test_progress_on_a_terminal_names_the_scene(self):
        self.write("scene.yaml", "gauss: 1\nscene: long_swing\nmodel: spring.yaml\nmethod: rk4\nstep: 1e-7\nduration: 1\n")
        terminal, stderr = os.openpty()
        self.addCleanup(os.close, terminal)
        subprocess.run([PROGRAM, "run", "scene.yaml"], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=stderr, timeout=120, check=True)
        os.close(stderr)
        self.assertIn(" %  long_swing  ", os.read(terminal, 4096).decode())

    def test_what_is_not_used_is_said(self):
        for options, said in ((["--method", "rk4", "--tolerance", "1e-3"], "the tolerance is not used"), (["--step", "1e-3"], "the step is not used"),
                              (["--tolerance", "1e-20"], "brings nothing")):
            self.assertIn(said, self.run_it("run", "spring.yaml", "-q", *options).stderr)

    def test_methods_that_do_not_take_a_model_leave_nothing(self):
        """Its rods are in line at the start, where nothing depends on speeds yet."""
        for method in ("verlet", "mclachlan4", "kahan_li8"):
            said = self.refused(2, "run", MODELS / "double_pendulum.yaml", "--method", method)
            self.assertIn(f"method '{method}': only models whose accelerations depend on coordinates alone suit it; gauss_legendre4", said)

    def test_automatic_methods_suit_the_projection(self):
        self.ok("run", "spring.yaml", "--projection", "energy", "-q")
        self.assertEqual(self.summary("spring.json")["method"], "prince87")

    def test_the_summary_says_how_it_went(self):
        self.ok("run", "spring.yaml", "--tolerance", "1e-10")
        summary = self.summary("spring.json")
        self.assertEqual((summary["outcome"], summary["status"], summary["reached"]), ("finished", "ok", 10))
        self.assertGreater(summary["steps"], 0)
        self.assertGreaterEqual(summary["calls"], summary["steps"])
        self.assertLess(summary["drift"]["energy"]["largest_change"], 1e-7)
        self.assertLess(summary["error_estimate"]["relative"], 1e-7)

    def test_the_estimate_of_the_error_is_that_of_the_closed_form(self):
        for method in ("dopri5", "fehlberg78"):
            self.ok("run", "spring.yaml", "--method", method, "--tolerance", "1e-6", "--samples", "6", "--outputs", "x", "-q")
            table = self.table("spring.csv")
            error = max(abs(x - math.cos(2 * t)) for t, x in zip(table["t [s]"], table["x [m]"])) / 2
            estimate = self.summary("spring.json")["error_estimate"]["relative"]
            self.assertLess(abs(estimate - error), 0.1 * error, method)

    def test_the_estimate_holds_where_samples_are_what_steps_are_short_by(self):
        """A tolerance says nothing of errors there: these are what steps of that length leave."""
        for model, method, tolerance, least, most in (("kepler", "prince87", "1e-4", 0.9, 1.1), ("double_pendulum", "prince87", "1e-6", 0.9, 1.1), ("kepler", "bulirsch_stoer", "1e-6", 0.9, 1.1),
                                                      ("rattleback", "prince87", "1e-8", 0.9, 1.1), ("double_pendulum_points", "prince87", "1e-11", 0.9, 1.1),
                                                      ("spherical_pendulum", "prince87", "1e-3", 0.9, 20), ("gyroscope_in_gimbals", "prince87", "1e-12", 0.9, 20)):
            with self.subTest((model, method)):
                path = MODELS / f"{model}.yaml"
                self.ok("run", path, "--number", "long-double", "--method", "prince87", "--tolerance", "1e-16", "-q", "-o", "tight.csv")
                self.ok("run", path, "--method", method, "--tolerance", tolerance, "-q", "-o", "loose.csv")
                said = self.summary("loose.json")["error_estimate"]
                error = self.off(self.table("loose.csv"), self.table("tight.csv"), said["constant"])
                self.assertLess(said["relative"], most * error)
                self.assertLess(least * error, said["relative"])
                # Of rounding alone, tighter runs have as much.
                self.assertLessEqual(said["agreement"], (0.25 if most < 2 else 1) * said["relative"])

    @staticmethod
    def off(table, exact, constants):
        """The largest difference beside ranges, of what has one."""
        moving = [head for head in exact if head.split(" [")[0] not in ("t", *constants)]
        return max(max(abs(a - b) for a, b in zip(table[head], exact[head])) / (max(exact[head]) - min(exact[head])) for head in moving)

    def test_estimates_see_rounding_that_all_runs_share(self):
        """Of two springs that nearly cancel each other, one is rounded to 1.5e-8: x = cos(sqrt(0.1) t)."""
        self.write("cancel.yaml", CANCEL.replace("STIFF", "200000000.2"))
        for method in ("taylor", "prince87", "bulirsch_stoer", "gauss_legendre6", "kahan_li8"):
            with self.subTest(method):
                accuracy = ("--step", "0.01") if method in ("gauss_legendre6", "kahan_li8") else ("--tolerance", "1e-13")
                said = self.ok("run", "cancel.yaml", "--duration", "100", "--outputs", "x", "--method", method, *accuracy)
                table, said_json = self.table("cancel.csv"), self.summary("cancel.json")["error_estimate"]
                true = max(abs(x - math.cos(math.sqrt(0.1) * t)) for t, x in zip(table["t [s]"], table["x [m]"])) / 2
                self.assertGreater(true, 1e-8)
                self.assertAlmostEqual(said_json["relative"], true, delta=0.1 * true)
                self.assertEqual(said_json["relative"], said_json["digits_lost"]["makes"])
                self.assertIn("; told by a run in long-double, since tighter runs lose the same digits", said)

    def test_estimates_see_what_formulas_and_equations_round(self):
        """A formula of parameters that nearly cancels; and the tide of the Earth, a difference of two pulls: x = x_0 cosh(sqrt(2 GM/R^3) t), to x_0/R."""
        self.write("formula.yaml", FORMULA)
        self.write("tide.yaml", TIDE)
        root = math.sqrt(2 * 3.986e14 / 42164000**3)
        for name, duration, exact in (("formula", 100, lambda t: math.cos(math.sqrt(1 / 7) * t)), ("tide", 43000, lambda t: 1e-3 * math.cosh(root * t))):
            for how in ((), ("--engine", "interpreted"), ("--method", "rk4", "--step", str(duration / 10000)), ("--tolerance", "1e-13"), ("--number", "long-double", "--tolerance", "1e-13")):
                with self.subTest((name, how)):
                    self.ok("run", f"{name}.yaml", "--duration", duration, "--outputs", "x", *how)
                    table, estimate = self.table(f"{name}.csv"), self.summary(f"{name}.json")["error_estimate"]
                    right = [exact(t) for t in table["t [s]"]]
                    true = max(abs(x - y) for x, y in zip(table["x [m]"], right)) / (max(right) - min(right))
                    if "long-double" not in how:
                        self.assertGreater(true, 1e-9)
                        self.assertIn("digits_lost", estimate)
                    # What the formulas above round, and neglect, is 1e-10.
                    self.assertGreater(estimate["relative"], 0.9 * true - 1e-10)
                    self.assertLess(estimate["relative"], 5 * true + 1e-10)

    def test_losses_are_seen_wherever_they_are(self):
        """K - A is b/(2A), of which double keeps little: between two samples only, of runs in float, of what moves little beside others, and over thousands of periods. b = 1 but for the last."""
        bump = ("bump", "{A: {value: 1e10}, b: {value: 1}, K: {value: sqrt(A^2+b)}}", "{x: {initial: 0, initial_rate: 0.1}}", "{p: {mass: 1, position: [x, 0, 0]}}", '{x: "-x + exp(-4*(t-5)^2)*A*(K-A)"}')
        push = ("push", "{A: {value: 1e8}, b: {value: 1}, K: {value: sqrt(A^2+b)}}", "{x: {initial: 0}}", "{p: {mass: 1, position: [x, 0, 0]}}", '{x: "A*(K-A)"}')
        beside = ("beside", "{A: {value: 5e7}, b: {value: 1}, K: {value: sqrt(A^2+b)}}", "{x: {initial: 1e7}, y: {initial: 0}}", "{p: {mass: 1, position: [x, 0, 0]}, q: {mass: 1, position: [0, y, 0]}}",
                  '{x: "-9*x*(1+x^2/1e14)", y: "0.02*A*(K-A)"}')
        swing = ("swing", "{A: {value: 1e5}, b: {value: 170000}, K: {value: sqrt(A^2+b)}}", "{x: {initial: 1}}", "{p: {mass: 1, position: [x, 0, 0]}}", '{x: "-(K-A)*x"}')
        # From the stiffness: (sqrt(1e10 + 170000) - 1e5), as b/(K + A).
        stiff = 170000 / (math.sqrt(1e10 + 170000) + 1e5)
        for (name, parameters, coordinates, particles, forces), how, last in (
                (bump, ("--duration", "10", "--samples", "2"), None),
                (push, ("--duration", "10", "--number", "float"), 25),
                (beside, ("--duration", "100", "--samples", "101", "--tolerance", "1e-6", "--outputs", "y"), 50),
                (swing, ("--duration", "20000", "--tolerance", "1e-10", "--outputs", "x"), math.cos(math.sqrt(stiff) * 20000))):
            with self.subTest(name):
                self.write(f"{name}.yaml", f"gauss: 1\nname: {name}\nparameters: {parameters}\ncoordinates: {coordinates}\nparticles: {particles}\nforces: {{f: {{generalized: {forces}}}}}\n")
                self.ok("run", f"{name}.yaml", "-q", *how)
                estimate = self.summary(f"{name}.json")["error_estimate"]
                self.assertIn("makes", estimate["digits_lost"])
                column = "y" if name == "beside" else "x"
                table = next(values for head, values in self.table(f"{name}.csv").items() if head.split(" ")[0] == column)
                if last is None:
                    self.ok("run", f"{name}.yaml", "-q", *how, "--number", "float128", "--tolerance", "1e-20", "-o", "exact.csv")
                    last = next(values for head, values in self.table("exact.csv").items() if head.split(" ")[0] == column)[-1]
                self.assertGreater(estimate["relative"], 0.3 * abs(table[-1] - last) / (2 if name == "swing" else max(abs(last), abs(table[-1]))))

    def test_where_nothing_but_rounding_moves_a_model_a_warning_says_so(self):
        """In double and long double, cos(x) - cos(2x) of 1e-10 is noise."""
        self.write("noise.yaml", NOISE)
        for how in ((), ("--engine", "interpreted"), ("--tolerance", "1e-6", "--method", "dopri5")):
            with self.subTest(how):
                ended = self.run_it("run", "noise.yaml", "--duration", "30", *how)
                self.assertEqual(ended.returncode, 0, ended.stderr)
                self.assertRegex(ended.stderr, "warning: a run in float128 differs by 0.* in double, formulas and equations lose too many digits")
                self.assertIn("; told by a run in float128", ended.stdout)
                self.assertGreater(self.summary("noise.json")["error_estimate"]["relative"], 0.1)

    def test_where_double_and_long_double_lose_the_same_float128_is_found(self):
        """x = y 1e-10: y'' = 0.15 y^2 - y."""
        self.write("noise.yaml", NOISE)
        self.ok("run", "noise.yaml", "--duration", "30", "--error", "1e-6", "--budget", "60", "--outputs", "x", "-q")
        self.assertEqual(self.summary("noise.json")["number"], "float128")
        table = self.table("noise.csv")
        exact, (y, v), parts = [], (1.0, 0.0), 20
        step = 30 / 500 / parts
        rates = lambda y, v: (v, 0.15 * y * y - y)  # noqa: E731
        for k in range(501):
            exact.append(1e-10 * y)
            for _ in range(parts):
                a = rates(y, v)
                b = rates(y + step / 2 * a[0], v + step / 2 * a[1])
                c = rates(y + step / 2 * b[0], v + step / 2 * b[1])
                d = rates(y + step * c[0], v + step * c[1])
                y += step / 6 * (a[0] + 2 * b[0] + 2 * c[0] + d[0])
                v += step / 6 * (a[1] + 2 * b[1] + 2 * c[1] + d[1])
        off = max(abs(x - right) for x, right in zip(table["x [m]"], exact)) / (max(exact) - min(exact))
        self.assertLess(off, 1.1e-6)

    def test_what_values_alone_make_of_an_unstable_motion_is_a_bound(self):
        """x = e^(-t/10), which ends in what the start of its speed is rounded by."""
        self.write("decays.yaml", DECAYS)
        said = self.ok("run", "decays.yaml", "--duration", "250", "--tolerance", "1e-12", "--outputs", "x")
        estimate = self.summary("decays.json")["error_estimate"]
        table = self.table("decays.csv")
        true = max(abs(x - math.exp(-t / 10)) for t, x in zip(table["t [s]"], table["x [m]"]))
        self.assertGreater(estimate["relative"], 0.5 * true)
        self.assertEqual(estimate["relative"], estimate["rounding"])
        self.assertIn(" at most; from values that are rounded otherwise, runs differ by as much", said)

    def test_estimates_near_rounding_see_what_a_method_makes_of_it(self):
        """Tighter runs by the same method are no tighter there, and agree with each other in the wrong place."""
        self.write("comet.yaml", COMET)
        often = ("--duration", "4.6e9", "--samples", "201", "--outputs", "state", "-q")
        self.ok("run", "comet.yaml", "--method", "taylor", "--number", "float128", "--tolerance", "1e-24", "-o", "exact.csv", *often)
        exact = self.table("exact.csv")
        for method in ("arkode_verner", "arkode_bogacki_shampine", "dopri5", "cash_karp54"):
            with self.subTest(method):
                self.ok("run", "comet.yaml", "--method", method, "--tolerance", "1e-14", *often)
                true = self.off(self.table("comet.csv"), exact, [])
                self.assertGreater(self.summary("comet.json")["error_estimate"]["relative"], 0.5 * true)

    def test_a_table_is_not_called_wrong_for_what_another_run_misses(self):
        """A push of 1 ms: v = F d/m."""
        self.write("pulse.yaml", PULSE)
        said = self.run_it("run", "pulse.yaml", "--duration", "10", "-q").stderr
        self.assertAlmostEqual(self.table("pulse.csv")["x_dot [m/s]"][-1], 0.005, delta=1e-6)
        self.assertNotIn("the table is off", said)
        if self.summary("pulse.json")["error_estimate"]["relative"] >= 0.1:
            self.assertIn("one of the two is not this motion", said)

    def test_values_that_are_as_they_were_written_are_not_rounded(self):
        self.write("cancel.yaml", CANCEL.replace("STIFF", "200000000.25"))
        self.ok("run", "cancel.yaml", "--duration", "100", "--outputs", "x", "--tolerance", "1e-13", "-q")
        self.assertLess(self.summary("cancel.json")["error_estimate"]["relative"], 1e-11)

    def test_what_rounding_makes_of_a_constant_is_no_range(self):
        self.write("wheel.yaml", FLYWHEEL)
        for duration in ("10", "30"):
            said = self.run_it("run", "wheel.yaml", "--method", "prince87", "--duration", duration, "-q")
            self.assertEqual((said.returncode, said.stderr), (0, ""))
            summary = self.summary("flywheel.json")["error_estimate"]
            self.assertLess(summary["relative"], 1e-5)
            self.assertIn("x_dot", summary["constant"])

    def test_errors_that_no_second_run_confirms_are_said_to_be_such(self):
        self.assertRegex(self.ok("run", MODELS / "kepler.yaml", "--tolerance", "1e-14"), "of the range, largest in [a-z_]+ at most; two tighter runs agree to [0-9.e-]+ only")
        summary = self.summary("kepler.json")["error_estimate"]
        self.assertGreaterEqual(summary["relative"], summary["agreement"])

    def test_the_energy_of_what_begins_at_rest_is_kept(self):
        """Rounding of its potential is more than all that moves at first; speeds do not make up for it."""
        for name, kinetic in (("double_pendulum", 18), ("chain", 40)):
            for method in ("prince87", "dopri5", "bulirsch_stoer"):
                for tolerance in ("1e-12", "1e-13", "1e-14"):
                    with self.subTest(name, method=method, tolerance=tolerance):
                        self.ok("run", MODELS / f"{name}.yaml", "--projection", "energy", "--method", method, "--tolerance", tolerance, "--duration", "2", "--max-steps", "20000", "-q")
                        found = self.summary(f"{name}.json")
                        self.assertLess(found["drift"]["energy"]["largest_change"], 3e-14 * kinetic)
                        self.assertLess(found["error_estimate"]["relative"], 1e-8)

    def test_so_it_is_by_methods_of_sundials(self):
        """Speeds that rounding of places would be, in the time of a short step, are not given to what rests; nor do they keep steps short for good."""
        self.write("swing.yaml", SWING)
        for method in ("arkode_verner", "arkode_fehlberg78", "arkode_esdirk4", "cvode_bdf"):
            with self.subTest(method):
                rows = {}
                for projection in ("energy", "full"):
                    self.ok("run", "swing.yaml", "--projection", projection, "--method", method, "--tolerance", "1e-12", "--duration", "0.05", "--samples", "2", "-q")
                    rows[projection] = {name: values[-1] for name, values in self.table("swing.csv").items()}
                for name, value in rows["full"].items():
                    self.assertAlmostEqual(rows["energy"][name], value, delta=1e-9, msg=name)
        self.write("hung.yaml", HUNG)
        for tolerance in ("1e-6", "1e-9", "1e-12"):
            self.ok("run", "hung.yaml", "--projection", "energy", "--method", "cvode_bdf", "--tolerance", tolerance, "--duration", "3", "--max-steps", "20000", "-q")
            self.assertLess(self.summary("hung.json")["drift"]["energy"]["largest_change"], 1e-10)

    def test_a_force_that_begins_to_act_on_what_rests_is_passed(self):
        """At a row, 3.5; what it pushes pulls something else along: x = 150 t^3/12, y = 7 * 150 t^5/(2 * 240), of the time since then."""
        self.write("kick.yaml", KICK)
        for method in ("dopri5", "prince87", "cash_karp54"):
            for tolerance in ("1e-9", "1e-12", "1e-13", "1e-15"):
                with self.subTest(method, tolerance=tolerance):
                    self.ok("run", "kick.yaml", "--method", method, "--tolerance", tolerance, "--duration", "4", "--samples", "201", "-q")
                    table = self.table("kick.csv")
                    for t, x, y in zip(table["t [s]"], table["x [m]"], table["y [m]"]):
                        since = max(t - 3.5, 0)
                        self.assertAlmostEqual(x, 12.5 * since**3, delta=1e-6)
                        self.assertAlmostEqual(y, 7 * 150 / 480 * since**5, delta=1e-6)
                    found = self.summary("kick.json")
                    if float(tolerance) >= 1e-12:
                        self.assertIn("agreement", found["error_estimate"])
                    else:  # Tighter runs follow rounding of the time for seconds behind the kick: whether they arrive is up to the machine.
                        self.assertTrue("error_estimate" in found or "20 times as long" in found["not_estimated"])

    def test_steps_as_long_as_the_time_between_rows_leave_nothing_over(self):
        """0.02 and its multiples are rounded: what is left of the way is no step."""
        for method in ("prince87", "bulirsch_stoer", "dopri5"):
            self.ok("run", MODELS / "kepler.yaml", "--method", method, "--tolerance", "1e-4", "-q", "-o", "without.csv")
            self.ok("run", MODELS / "kepler.yaml", "--method", method, "--tolerance", "1e-4", "--longest-step", "0.02", "-q", "-o", "with.csv")
            self.assertEqual(self.summary("with.json")["steps"], self.summary("without.json")["steps"], method)

    def test_steps_that_nobody_can_count_are_too_many(self):
        for number, method, step in (("double", "rk4", "1e-21"), ("double", "verlet", "1e-300"), ("long-double", "gauss_legendre4", "1e-20")):
            result = self.run_it("run", "spring.yaml", "--number", number, "--method", method, "--step", step, "-q")
            self.assertEqual(result.returncode, 5, result.stderr)
            self.assertIn("stops at t = 0: too many steps", result.stderr)

    def test_the_estimate_of_float_sees_what_all_its_runs_round(self):
        """Times and values: two runs in float have these errors in common."""
        for start in (0, 1000, 10000):
            self.write("driven.yaml", DRIVEN.format(power=1))
            self.ok("run", "driven.yaml", "--method", "rk4", "--number", "float", "--start", start, "--duration", "8", "--samples", "51", "--outputs", "x", "-q")
            off, estimate = self.off_in_driven(start), self.summary("driven.json")["error_estimate"]["relative"]
            self.assertLess(off, 2 * estimate, start)
            self.assertLess(estimate, 4 * off, start)
        with self.subTest("times in double, too"):
            self.ok("run", "driven.yaml", "--start", "1e9", "--outputs", "x", "-q")
            self.assertLess(1e-8, self.summary("driven.json")["error_estimate"]["relative"])

    def off_in_driven(self, start):
        """x'' = 2 sin(3 t) from rest: of the largest x, at the times that were asked for."""
        table = self.table("driven.csv")
        exact = []
        for k in range(len(table["x [m]"])):
            t = 8 * k / (len(table["x [m]"]) - 1)
            exact.append(2/3*math.cos(3*start)*t - 2/9*(math.sin(3*(start + t)) - math.sin(3*start)))
        return max(abs(a - b) for a, b in zip(table["x [m]"], exact)) / (max(exact) - min(exact))

    def test_rest_is_left_at_any_time(self):
        """What begins as t^2 is all error in a first step of order 1."""
        for method in ("cvode_bdf", "cvode_adams", "ida", "arkode_esdirk4"):
            for start in (0, 1, 100, 1e4):
                with self.subTest((method, start)):
                    self.write("driven.yaml", DRIVEN.format(power=1).replace("sin", "cos"))
                    self.ok("run", "driven.yaml", "--method", method, "--projection", "off", "--start", start, "--outputs", "x", "--samples", "51", "-q")
                    table = self.table("driven.csv")
                    exact = [2/9*(math.cos(3*start) - math.cos(3*(start + t/5)) - 3*t/5*math.sin(3*start)) for t in range(51)]
                    self.assertLess(max(abs(a - b) for a, b in zip(table["x [m]"], exact)), 1e-6 * (max(exact) - min(exact)))

    def test_where_forces_cancel_series_take_rounding_for_what_it_is(self):
        """A pendulum that stands upright: nothing but rounding moves it."""
        self.write("upright.yaml", UPRIGHT)
        for number in ("double", "float", "long-double", "float128"):
            self.ok("run", "upright.yaml", "--method", "taylor", "--number", number, "--tolerance", "1e-15", "--duration", "5", "-q")
            summary = self.summary("upright.json")
            self.assertLess(summary["steps"] + summary["rejected"], 100, number)
            self.assertLess(max(abs(x - math.pi) for x in self.table("upright.csv")["theta [rad]"]), 10 if number == "float" else 1e-8, number)
        with self.subTest("an error is delivered"):
            self.ok("run", "upright.yaml", "--error", "1e-3", "--budget", "60", "-q")

    def test_where_a_force_jumps_the_estimate_is_by_a_method_that_sees_it(self):
        self.write("slide.yaml", SLIDE)
        for method, speed in (("prince87", 0.7), ("dopri5", 3.3), ("bulirsch_stoer", 0.5), ("fehlberg78", 0.7), ("cvode_adams", 10), ("arkode_fehlberg78", 0.7),
                              ("arkode_bogacki_shampine", 3.3), ("arkode_kvaerno5", 5), ("cvode_bdf", 2), ("rk4", 2)):
            with self.subTest(method):
                off = ["--projection", "off"] if method == "cvode_adams" else []
                said = self.run_it("run", "slide.yaml", "--method", method, "--set", f"v0={speed}", "--outputs", "x", "--samples", "11", "-q", *off).stderr
                end = speed**2 / (2 * 0.3 * 9.81)
                error = max(abs(x - (end if t >= speed / 2.943 else speed*t - 2.943*t*t/2)) for t, x in zip(*self.table("slide.csv").values())) / end
                self.assertLess(error, 3 * self.summary("slide.json")["error_estimate"]["relative"])
                self.assertEqual("may step over a place where a force jumps, as by piecewise" in said, "fehlberg78" in method or method == "bulirsch_stoer")

    def test_an_energy_that_is_conserved_has_no_range(self):
        """What a method of few digits makes of it is no motion."""
        for model, options in (("double_pendulum", ["--method", "cvode_bdf", "--tolerance", "1e-10"]), ("chaplygin_sleigh", ["--method", "arkode_trbdf2", "--tolerance", "1e-10"])):
            said = self.run_it("run", MODELS / f"{model}.yaml", "-q", *options).stderr
            self.assertNotIn("it is not this motion", said)
            self.assertIn("energy.total", self.summary(f"{model}.json")["error_estimate"]["constant"])
            self.assertLess(self.summary(f"{model}.json")["error_estimate"]["relative"], 1e-3)

    def test_nor_has_one_that_rounding_alone_changes(self):
        """Of a damper of 0 nobody knows before the run."""
        self.write("swing.yaml", SWING.replace("k: {", "c: {value: 0, unit: N*s/m}, k: {").replace("spring:", "damper: {generalized: {x_2: -c*dot(x_2)}}, spring:"))
        for tolerance in ("1e-12", "1e-13"):
            said = self.run_it("run", "swing.yaml", "--method", "prince87", "--tolerance", tolerance, "-q").stderr
            self.assertNotIn("it is not this motion", said)
            self.assertIn("energy.total", self.summary("swing.json")["error_estimate"]["constant"])

    def test_what_grows_out_of_the_smallest_numbers_stops_no_method(self):
        self.write("pushed.yaml", PUSHED)
        for method in ("cvode_adams", "cvode_bdf", "arkode_kvaerno5", "arkode_fehlberg78", "arkode_zonneveld"):
            self.ok("run", "pushed.yaml", "--method", method, "--projection", "off", "--longest-step", "0.01", "--outputs", "x", "-q")
            self.assertAlmostEqual(self.table("pushed.csv")["x"][-1], 6.7 * 0.02 * math.sqrt(math.pi), delta=1e-5, msg=method)

    def test_times_between_rows_are_those_that_were_asked_for(self):
        self.ok("run", "spring.yaml", "--every", "0.1", "--duration", "0.3", "-q")
        self.assertEqual(self.table("spring.csv")["t [s]"], [0, 0.1, 0.2, 0.3])

    def test_closed_forms_may_have_corners(self):
        for law in ("v*min(t, T)", "v*max(t, 0)", "v*t*sign(t + 1)", "piecewise(t < 0, 0, t < T, v*t, 0)", "v*abs(t)"):
            self.write("straight.yaml", "gauss: 1\nname: straight\nparameters: {m: 1, v: 2, T: 100}\ncoordinates: {x: {initial: 0, initial_rate: v}}\nparticles: {p: {mass: m, position: [x, 0, 0]}}\n" + f'exact: {{x: "{law}"}}\n')
            self.assertNotIn("another motion", self.run_it("run", "straight.yaml", "-q").stderr, law)
            self.assertLess(self.summary("straight.json")["from_closed_forms"]["relative"], 1e-14, law)

    def test_lists_on_a_full_disk_are_an_error_like_others(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            self.assertEqual(subprocess.run([PROGRAM, "methods"], stdout=full, stderr=subprocess.DEVNULL, check=False).returncode, 3)

    def test_all_that_is_wrong_with_an_option_is_said(self):
        said = self.refused(2, "run", "spring.yaml", "--set", "y=3", "--set", "z=4", "--set", "m=abc")
        for words in ("no 'y'", "no 'z'", "'abc' is not a parameter"):
            self.assertIn(words, said)
        said = self.refused(2, "run", "spring.yaml", "--outputs", "qq,rr")
        self.assertIn("'qq'", said)
        self.assertIn("'rr'", said)

    def test_a_table_of_another_motion_is_not_left_without_a_word(self):
        """After a minute the tolerance of a double pendulum is all that its angles depend on."""
        chaos = self.run_it("run", MODELS / "double_pendulum.yaml", "--method", "dopri5", "--tolerance", "1e-3", "--duration", "60", "-q")
        self.assertEqual(chaos.returncode, 0)
        self.assertIn("warning: the table is off by", chaos.stderr)
        self.assertEqual(self.run_it("run", "spring.yaml", "-q").stderr, "")

    def test_what_rests_is_moved_by_a_force_that_begins_with_0(self):
        """All is 0 at the start, and so are the rates of it: for sin^4, up to its sixth derivative."""
        integral = {1: lambda u: u - math.sin(u),
                    4: lambda u: 3*u*u/16 + math.cos(2*u)/8 - math.cos(4*u)/128 - 15/128}
        for power, x in integral.items():
            self.write("driven.yaml", DRIVEN.format(power=power))
            for method in ("taylor", "prince87", "dopri5", "bulirsch_stoer"):
                for start in (0, math.pi / 3):
                    # There sin^4 begins with (1e-16)^4, and rounding of time changes that by all of it.
                    if power == 4 and start > 0 and method != "taylor":
                        continue
                    with self.subTest((power, method, start)):
                        self.ok("run", "driven.yaml", "--method", method, "--start", start, "--outputs", "x", "-q")
                        table, sign = self.table("driven.csv"), 1 if start == 0 or power == 4 else -1
                        for t, value in zip(table["t [s]"], table["x [m]"]):
                            self.assertAlmostEqual(value, sign * 2 / 9 * x(3 * (t - start)), delta=1e-7)
        self.write("driven.yaml", DRIVEN.format(power=4))
        self.write("many.yaml", "gauss: 1\nmodel: driven.yaml\noutputs: [x]\nensemble: {parameters: {F: {sweep: {from: 1, to: 20, count: 20}}}}\n")
        self.ok("ensemble", "many.yaml", "-q")
        summary = self.summary("driven.ensemble.json")
        self.assertEqual(summary["by_status"], {"finished": 20})
        self.assertEqual(summary.get("left_lanes", 0), 0)
        with open(self.folder / "driven.ensemble.csv", encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file):
                self.assertAlmostEqual(float(row["x [m]"]) / float(row["parameters.F [N]"]), integral[4](30) / 9, delta=1e-7)

    def test_a_model_is_compiled_once_whatever_its_values_are(self):
        self.ok("run", "spring.yaml", "-q")
        self.ok("run", "spring.yaml", "--set", "m=3", "--set", "x=2", "--duration", "5", "-q")
        self.assertTrue(self.summary("spring.json")["seconds"]["cached"])
        self.assertEqual(self.table("spring.csv")["x [m]"][0], 2)

    def test_decimals_in_formulas_are_not_compiled_either(self):
        model = SPRING.replace("k: {value: 8, unit: N/m}", "soft: {value: 0.7, unit: N/m}\n  k: {value: 3*soft, unit: N/m}")
        for value in ("0.7", "0.71", "1/3", "1", "1e-9"):
            self.write("spring.yaml", model.replace("0.7", value))
            self.ok("run", "spring.yaml", "--duration", "1", "-q")
        self.assertTrue(self.summary("spring.json")["seconds"]["cached"])
        self.ok("run", "spring.yaml", "--set", "soft=0.123", "--set", "x=0.456", "-q")
        self.assertTrue(self.summary("spring.json")["seconds"]["cached"])

    def test_both_engines_have_the_same_bits(self):
        for model in (self.folder / "spring.yaml", MODELS / "four_bar.yaml", MODELS / "iftomm_a02_parallel.yaml"):
            tables = []
            for engine in ("compiled", "interpreted"):
                self.ok("run", model, "--engine", engine, "--method", "prince87", "--duration", "1", "-o", "table.csv", "-q")
                self.assertEqual(self.summary("table.json")["engine"], engine)
                tables.append((self.folder / "table.csv").read_bytes())
            self.assertEqual(tables[0], tables[1], model)

    def test_without_a_compiler_models_are_interpreted(self):
        without = {**os.environ, "CXX": "", "PATH": str(self.folder)}
        self.ok("run", "spring.yaml", "-q", env=without)
        summary = self.summary("spring.json")
        self.assertEqual((summary["engine"], summary["method"]), ("interpreted", "prince87"))
        self.assertIn("no C++ compiler", self.refused(3, "run", "spring.yaml", "--engine", "compiled", "-o", "other.csv", env=without))

    def test_where_a_compiler_fails_models_are_interpreted_and_it_is_said(self):
        compiler = self.write("broken-cxx", '#!/bin/sh\n[ "$1" = --version ] && echo "broken 1.0" && exit 0\necho no space left >&2\nexit 1\n')
        compiler.chmod(0o755)
        broken = {**os.environ, "CXX": str(compiler)}
        result = self.run_it("run", "spring.yaml", env=broken)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("warning: the model cannot be compiled", result.stderr)
        self.assertIn("it is interpreted", result.stderr)
        self.assertEqual(self.summary("spring.json")["engine"], "interpreted")
        self.assertIn("no space left", self.refused(3, "run", "spring.yaml", "--engine", "compiled", "-o", "other.csv", env=broken))

    def test_a_broken_cache_is_mended(self):
        cache = self.folder / "cache"
        own = {**os.environ, "XDG_CACHE_HOME": str(cache)}
        self.ok("run", "spring.yaml", "-q", env=own)
        for plugin in cache.rglob("model.so"):
            plugin.write_bytes(b"no library")
        self.ok("run", "spring.yaml", "-q", env=own)
        self.assertFalse(self.summary("spring.json")["seconds"]["cached"])
        self.ok("run", "spring.yaml", "-q", env=own)
        self.assertTrue(self.summary("spring.json")["seconds"]["cached"])

    def test_standard_output_takes_the_table(self):
        lines = self.ok("run", "spring.yaml", "-o", "-", "--samples", "3").splitlines()
        self.assertEqual(len(lines), 4)
        self.assertEqual(self.files(), ["spring.yaml"])

    def test_tables_are_no_files_of_other_formats(self):
        self.write("spring.yaml", SPRING)
        for ending in ("h5", "hdf5", "svg"):
            said = self.refused(2, "run", "spring.yaml", "-o", f"table.{ending}")
            self.assertIn(f"'table.{ending}' would be no .{ending} file: tables are CSV, such as table.csv", said)

    def test_outputs_take_the_place_of_tables_alone(self):
        before = (self.folder / "spring.yaml").read_bytes()
        self.assertIn("where the summary goes", self.refused(2, "run", "spring.yaml", "-o", "x.json"))
        self.assertIn("what the run reads", self.refused(2, "run", "spring.yaml", "-o", "spring.yaml"))
        os.mkfifo(self.folder / "pipe")
        self.assertIn("no file that a table", self.refused(2, "run", "spring.yaml", "-o", "pipe"))
        self.assertEqual((self.folder / "spring.yaml").read_bytes(), before)

    def test_what_has_no_motion_is_said(self):
        self.write("held.yaml", "gauss: 1\nname: held\nparameters: {m: 1}\ncoordinates: {x: {held_at: sin(t)}}\n"
                   "particles: {bob: {mass: m, position: [x, 0, 0]}}\n")
        self.assertIn("nothing moves", self.refused(5, "run", "held.yaml"))

    def test_masses_that_no_body_has_are_refused_wherever_they_come_from(self):
        self.assertIn("negative", self.refused(2, "run", "spring.yaml", "--set", "m=-1"))
        with self.subTest("a scene is not to blame for it"):
            self.write("s.yaml", "gauss: 1\nmodel: spring.yaml\nparameters: {m: 3}\n")
            self.assertIn("--set: the mass of 'bob' is negative: -1", self.refused(2, "run", "s.yaml", "--set", "m=-1"))
            self.write("s.yaml", "gauss: 1\nmodel: spring.yaml\nparameters: {m: -3}\n")
            self.assertIn("s.yaml:3:14: error[E055]: the mass of 'bob' is negative: -3", self.refused(1, "run", "s.yaml", "--set", "k=2"))
        self.write("s.yaml", "gauss: 1\nmodel: spring.yaml\nparameters: {m: -1}\n")
        self.assertIn("s.yaml:3:", self.refused(1, "run", "s.yaml"))

    def test_ctrl_c_leaves_a_whole_table(self):
        code, said = self.stopped_while_writing("spring.csv*", "run", "spring.yaml", "--method", "rk4", "--step", "1e-7", "--duration", "1000",
                                                "--samples", "1000001", "-q")
        self.assertEqual(code, 130, said)
        table = self.table("spring.csv")
        summary = self.summary("spring.json")
        self.assertEqual(summary["outcome"], "interrupted")
        self.assertEqual(len(table["t [s]"]), summary["samples"])
        self.assertEqual(self.files(), ["spring.csv", "spring.json", "spring.yaml"])


if __name__ == "__main__":
    unittest.main()
