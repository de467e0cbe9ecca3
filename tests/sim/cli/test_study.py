"""gauss-sim study: figures that hold together."""

import csv
import json
import math
import os
import signal
import subprocess
import time
import unittest
from pathlib import Path

import jsonschema

from gauss_sim import HAMMER, MODELS, PROGRAM, PUSHED, Program, SLIDE, SPRING, hammered

SCHEMA = jsonschema.Draft7Validator(json.loads((Path(os.environ["GAUSS_SOURCE_DIR"]) / "apps/sim/report/study.schema.json").read_text(encoding="utf-8")))


class Study(Program):
    def setUp(self):
        super().setUp()
        self.write("spring.yaml", SPRING)
        self.ok("study", "spring.yaml", "--budget", "8", "--tightest", "1e-11", "-q")
        self.study = json.loads((self.folder / "study.json").read_text(encoding="utf-8"))
        self.problem = self.study["problems"][0]

    def test_what_is_measured_holds_together(self):
        points = [point for point in self.problem["points"] if point["status"] == "ok"]
        self.assertGreater(len(points), 20)
        self.assertIs(self.study["interrupted"], False)
        with self.subTest("nobody on the front is beaten"):
            for point in points:
                beaten = [other for other in points if other["time_s"] <= point["time_s"] and other["error"] <= point["error"]
                          and (other["time_s"] < point["time_s"] or other["error"] < point["error"])]
                self.assertEqual(point["pareto"], not beaten, point)
        with self.subTest("tighter tolerances deliver less error, up to rounding"):
            for method in {point["method"] for point in points if point["tolerance"]}:
                errors = [(p["tolerance"], p["error"]) for p in points if p["method"] == method]
                # Where few had time, all of them may take the same steps, from sample to sample.
                self.assertLess(min(errors)[1], max(1.01 * max(errors)[1], 1e-11), method)
        with self.subTest("errors are those of the closed form"):
            self.assertLess(self.problem["reference"]["agreement"], 1e-13)
        with self.subTest("failures have their reasons"):
            for point in self.problem["points"]:
                self.assertEqual(point["status"] == "ok", point["why"] == "")
        with self.subTest("all three files say the same"):
            with open(self.folder / "study.csv", encoding="utf-8", newline="") as file:
                rows = list(csv.DictReader(file))
            self.assertEqual(len(rows), len(self.problem["points"]))
            for row, point in zip(rows, self.problem["points"]):
                self.assertEqual((row["method"], row["status"]), (point["method"], point["status"]))
            page = (self.folder / "study.html").read_text(encoding="utf-8")
            self.assertTrue('"name":"spring"' in page and "@STUDY@" not in page)
        with self.subTest("a model alone has no scene"):
            self.assertEqual((self.problem["file"], "scene" in self.problem), ("spring.yaml", False))
        with self.subTest("drift of the best is there over time"):
            for trace in self.problem["drifts"]:
                self.assertEqual(len(trace["t"]), self.problem["samples"])
                self.assertTrue(all(math.isfinite(value) for value in trace["energy"]))


EFFECTS = SPRING.replace("forces:", "effects:\n  push: {about: a constant force, parameters: {F: {value: 0.004, unit: N}}, "
                         "forces: {push: {generalized: {x: F}}}}\nforces:")


class Effects(Program):
    def effects_of(self, scene, *options):
        self.write("model.yaml", EFFECTS)
        self.write("scene.yaml", f"gauss: 1\nscene: s\nmodel: model.yaml\nduration: pi\noutputs: [x]\n{scene}")
        said = self.ok("study", "scene.yaml", "--budget", "2", "--tightest", "1e-6", *options)
        study = json.loads((self.folder / "study.json").read_text(encoding="utf-8"))
        self.assertEqual([error.message for error in SCHEMA.iter_errors(study)], [])
        self.assertIn("runs, reference good to", said)
        return study["problems"][0].get("effects")

    def test_what_effects_cost_and_change_is_a_part_of_the_study(self):
        found = self.effects_of("effects: all\n")
        # x = F/k + (1 - F/k) cos(2 t), so without the push it is off by F/k (1 - cos), of a range of 2.
        [without] = found["each"]
        self.assertEqual((without["what"], without["effects"], without["output"]), ("without push", [], "x"))
        self.assertAlmostEqual(without["change"], 0.0005, delta=1e-3 * 0.0005)
        self.assertLess(without["operations"], found["all"]["operations"])
        self.assertEqual(found["about"], {"push": "a constant force"})
        self.assertIn('"what":"without push"', (self.folder / "study.html").read_text(encoding="utf-8"))

    def test_where_no_effect_is_chosen_they_are_no_part_of_it(self):
        self.assertIsNone(self.effects_of("effects: none\n"))
        self.assertIsNone(self.effects_of("effects: all\n", "--methods", "prince87"))


class Files(Program):
    def test_a_mistake_in_a_later_file_is_told_before_anything_is_measured(self):
        self.write("spring.yaml", SPRING)
        self.write("wrong.yaml", SPRING.replace("mass: m", "mass: mq"))
        begin = time.monotonic()
        said = self.refused(3, "study", "spring.yaml", "wrong.yaml", "nowhere.yaml", "--budget", "600")
        self.assertLess(time.monotonic() - begin, 60)
        self.assertIn("wrong.yaml", said)
        self.assertIn("'mq'", said)
        self.assertIn("nowhere.yaml: No such file", said)

    def study_of(self, text, *options):
        """Points by method and tolerance."""
        self.write("model.yaml", text)
        self.write("scene.yaml", "gauss: 1\nscene: s\nmodel: model.yaml\noutputs: [x]\n" + "".join(options))
        self.ok("study", "scene.yaml", "--methods", "taylor,prince87,dopri5,bulirsch_stoer", "--budget", "4", "-q")
        [problem] = json.loads((self.folder / "study.json").read_text(encoding="utf-8"))["problems"]
        return problem, {(p["method"], p["tolerance"]): p for p in problem["points"] if p["status"] == "ok"}

    def test_a_reference_sees_what_acts_for_a_short_time(self):
        problem, points = self.study_of(PUSHED)
        self.assertLess(problem["reference"]["agreement"], 1e-12)
        self.assertAlmostEqual(problem["outputs"][0]["range"], 6.7 * 0.02 * math.sqrt(math.pi), delta=1e-6)
        self.assertAlmostEqual(points["taylor", 1e-3]["error"], 1, delta=1e-3)  # it steps over the push
        self.assertLess(points["prince87", 1e-9]["error"], 1e-6)
        with self.subTest("the longest step of the scene is that of all runs"):
            _, points = self.study_of(PUSHED, "longest_step: 0.01\n")
            self.assertLess(points["taylor", 1e-3]["error"], 1e-2)
            self.assertGreaterEqual(min(p["steps"] for p in points.values()), 1000)

    def test_a_reference_sees_what_jumps_for_a_ten_thousandth_of_the_time(self):
        problem, points = self.study_of(HAMMER, "samples: 1001\n")
        self.assertLess(problem["reference"]["agreement"], 1e-8)
        motion = [hammered(10 * i / 1000) for i in range(1001)]
        self.assertAlmostEqual(problem["outputs"][0]["range"], max(motion) - min(motion), delta=1e-6)
        self.assertGreater(points["prince87", 1e-3]["error"], 0.01)  # it steps over some of the blows

    def test_a_reference_sees_where_a_force_jumps(self):
        """Extrapolation steps over the stop, in any number of digits."""
        problem, points = self.study_of(SLIDE.replace("v0: 2", "v0: 0.5"))
        self.assertLess(problem["reference"]["agreement"], 1e-8)
        self.assertAlmostEqual(problem["outputs"][0]["range"], 0.25 / (2 * 0.3 * 9.81), delta=1e-6)
        for method in ("prince87", "dopri5"):
            self.assertLess(points[method, 1e-9]["error"], 1e-5)
        self.assertGreater(max(p["error"] for (method, _), p in points.items() if method == "bulirsch_stoer"), 1)

    def test_errors_are_no_less_than_what_the_reference_may_be_off_by(self):
        problem, points = self.study_of(SLIDE.replace("v0: 2", "v0: 0.5"))
        self.assertLessEqual(problem["reference"]["agreement"], min(p["error"] for p in points.values()))
        ask = ("advise", "scene.yaml", "--error", "1e-4", "--study", "study.json")
        self.ok(*ask)
        study = json.loads((self.folder / "study.json").read_text(encoding="utf-8"))
        for reference, why in ((None, "the study has no reference: as nobody knows"), ({**problem["reference"], "agreement": 1e-5}, "the reference of the study is good to")):
            study["problems"][0].update(reference=reference, why="as nobody knows")
            self.write("study.json", json.dumps(study))
            self.assertIn(why, self.refused(6, *ask))

    def test_what_nobody_can_mean_is_refused(self):
        self.write("spring.yaml", SPRING)
        self.assertIn("is tighter than", self.refused(2, "study", "spring.yaml", "--loosest", "1e-9", "--tightest", "1e-3"))
        self.assertIn("a name is missing", self.refused(2, "study", "spring.yaml", "-o", "./"))

    def test_where_nothing_can_be_written_nothing_is_measured(self):
        self.write("spring.yaml", SPRING)
        (self.folder / "study.html").mkdir()
        begin = time.monotonic()
        for name in ((), ("-o", "study"), ("-o", "study.html")):
            said = self.refused(3, "study", "spring.yaml", "--budget", "600", *name)
            self.assertIn("study.html: is a directory", said)
        self.assertLess(time.monotonic() - begin, 60)

    def test_where_the_energy_changes_there_is_no_drift_of_it(self):
        self.write("damped.yaml", SPRING.replace("forces:\n", "forces:\n  damper: {generalized: {x: -dot(x)*sqrt(k*m)/9}}\n"))
        self.ok("study", "damped.yaml", "--methods", "prince87", "--budget", "2", "-q")
        [problem] = json.loads((self.folder / "study.json").read_text(encoding="utf-8"))["problems"]
        self.assertGreater(len(problem["drifts"]), 0)
        for trace in problem["drifts"]:
            self.assertEqual(sorted(trace), ["point", "t"])


class Interruption(Program):
    def test_ctrl_c_leaves_what_was_measured_and_says_so(self):
        self.write("spring.yaml", SPRING)
        self.write("other.yaml", SPRING.replace("name: spring", "name: other"))
        process = subprocess.Popen([PROGRAM, "study", "spring.yaml", "other.yaml"], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True)
        self.wait_for_processor(process, 8)
        process.send_signal(signal.SIGINT)
        table, said = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, said)
        study = json.loads((self.folder / "study.json").read_text(encoding="utf-8"))
        points = study["problems"][0]["points"]
        self.assertIs(study["interrupted"], True)
        self.assertEqual([problem["name"] for problem in study["problems"]], ["spring"])
        self.assertTrue(any(point["status"] == "ok" for point in points))
        runs = sum(point["status"] != "refused" for point in points)
        self.assertIn(f"interrupted: the study has {runs} runs, of 1 of 2 problems", said)
        self.assertIn(f"spring: {runs} runs until it was interrupted", table)
        self.assertIn('"interrupted":true', (self.folder / "study.html").read_text(encoding="utf-8"))
        with open(self.folder / "study.csv", encoding="utf-8", newline="") as file:
            self.assertEqual(len(list(csv.DictReader(file))), len(points))


# The same swing by its angle, and by its place, which a constraint holds on the circle.
BY_ANGLE = """gauss: 1
name: by_angle
parameters:
  m: {value: 1, unit: kg}
  l: {value: 2, unit: m}
  g: {value: 10, unit: m/s^2}
coordinates:
  phi: {unit: rad, initial: 0.5}
particles:
  bob: {mass: m, position: [l*sin(phi), -l*cos(phi), 0]}
forces:
  gravity: {uniform: [0, -g, 0]}
"""
BY_PLACE = """gauss: 1
name: by_place
parameters:
  m: {value: 1, unit: kg}
  l: {value: 2, unit: m}
  g: {value: 10, unit: m/s^2}
coordinates:
  x: {unit: m, initial: l*sin(1/2)}
  y: {unit: m, initial: -l*cos(1/2)}
particles:
  bob: {mass: m, position: [x, y, 0]}
constraints:
  bar: {equation: x^2 + y^2 - l^2}
forces:
  gravity: {uniform: [0, -g, 0]}
"""
SCENE = """gauss: 1
scene: swing
model: by_place.yaml
formulation: place
formulations:
  angle: {model: by_angle.yaml}
  lower: {model: by_angle.yaml, initial: {phi: 0.4}}
duration: 10
samples: 3
outputs: [poses.bob, energy.kinetic]
"""


class Formulations(Program):
    def setUp(self):
        super().setUp()
        self.write("by_angle.yaml", BY_ANGLE)
        self.write("by_place.yaml", BY_PLACE)

    def study(self, scene, *options):
        self.write("swing.yaml", scene)
        self.ok("study", "swing.yaml", "--tightest", "1e-9", "-q", *options)
        return self.written()

    def written(self):
        study = json.loads((self.folder / "study.json").read_text(encoding="utf-8"))
        SCHEMA.validate(study)
        return study["problems"][0]

    def test_strategies_that_make_the_same_code_are_one_formulation(self):
        """Z of the double pendulum is minimised along the tree where nobody says anything: its code has other names then, nothing else."""
        self.ok("study", MODELS / "double_pendulum.yaml", "--tightest", "1e-3", "--budget", "1", "-q")
        forms = {point["formulation"] for point in self.written()["points"]}
        self.assertEqual(forms, {"as given", "as given, metric"})

    def test_ways_to_describe_one_motion(self):
        def those(**keys):
            return [p for p in points if all(p[key] == value for key, value in keys.items())]

        for budget in ("20", "80"):  # the second where the machine is slow or busy
            problem = self.study(SCENE, "--budget", budget)
            points = problem["points"]
            if those(number="float128", status="ok") and those(projection="off", tolerance=1e-6, status="ok"):
                break
        with self.subTest("another formulation is compared with the same reference"):
            self.assertLess(min(p["error"] for p in those(formulation="angle", status="ok")), 1e-8)
        with self.subTest("one that tells another motion is refused"):
            self.assertEqual({p["status"] for p in those(formulation="lower")}, {"refused"})
            self.assertIn("another motion", those(formulation="lower")[0]["why"])
        with self.subTest("codes and number types"):
            self.assertTrue({"optimised", "folded"} <= {p["code"] for p in points})
            self.assertEqual({p["number"] for p in those(status="ok")}, {"float", "double", "long-double", "float128"})
            self.assertGreater(min(p["error"] for p in those(number="float", status="ok")), 1e-8)
        with self.subTest("projection keeps the bar, gains pull it back, nothing lets it drift"):
            drift = {p["projection"]: p["drift"]["constraints"] for p in those(method="prince87", number="double", tolerance=1e-6, status="ok",
                                                                             code="optimised", formulation="place")}
            self.assertTrue({"full", "off", "gains", "positions", "velocities", "energy"} <= set(drift), drift)
            self.assertLess(drift["full"], 1e-12)
            self.assertLess(drift["full"], drift["gains"])
            self.assertLess(drift["gains"], drift["off"])
        with self.subTest("scene and model have their names"):
            self.assertEqual((problem["scene"], problem["file"]), ("swing.yaml", "by_place.yaml"))
        with self.subTest("one point is the default"):
            self.assertEqual([(p["tolerance"], p["method"]) for p in points if p["is_default"]], [(1e-9, "taylor")])
        with self.subTest("the motion is there: a bob at the end of its bar, and the force that holds it"):
            motion = problem["motion"]
            self.assertEqual(len(motion["t"]), len(motion["bodies"][0]["position"]))
            for (x, y, _), (fx, fy, _) in zip(motion["bodies"][0]["position"], motion["reactions"][0]["force"]):
                self.assertAlmostEqual(math.hypot(x, y), 2, places=5)  # six digits are written
                self.assertAlmostEqual(x * fy - y * fx, 0, places=3)
        with self.subTest("operations of each build"):
            self.assertTrue(all(build["operations"] > 0 for build in problem["builds"]))
        with self.subTest("builds call number types as points do"):
            named = {number for build in problem["builds"] for number in build["number"].split(", ")}
            self.assertEqual(named, {"float", "double", "long-double", "float128"})

    def test_however_little_time_is_left_runs_are_measured_whole(self):
        """So that steps of one length take about the same time, in points of many and of few."""
        self.write("spring.yaml", SPRING)
        most = 0
        for budget in (2, 3, 4, 8, 16):  # the last two where the machine is slow or busy
            if budget > 4 and most > 3:
                break
            problem = self.study("gauss: 1\nscene: swing\nmodel: spring.yaml\noutputs: [x]\nduration: 3\n", "--budget", budget)
            of_method = {}
            for point in problem["points"]:
                if point["status"] == "ok" and point["step"]:
                    of_method.setdefault((point["method"], point["number"], point["projection"]), []).append(point["time_s"] / point["steps"])
            most = max([most, *map(len, of_method.values())])
            for way, times in of_method.items():
                self.assertGreater(min(times), max(times) / 20, (budget, way))
            with self.subTest("what is left out says why", budget=budget):
                self.assertIn("beyond the time that the study was given", {p["why"] for p in problem["points"] if p["status"] == "refused"})
        self.assertGreater(most, 3)

    def test_no_method_goes_without_for_what_tight_settings_of_others_take(self):
        self.write("spring.yaml", SPRING)
        problem = self.study("gauss: 1\nscene: swing\nmodel: spring.yaml\noutputs: [x]\nduration: 10\n", "--budget", 12)
        without = {}
        for point in problem["points"]:
            is_late = point["why"] == "beyond the time that the study was given"
            without.setdefault(point["method"], []).append(is_late)
        self.assertGreater(len(without), 20)
        self.assertEqual([method for method, are_late in without.items() if all(are_late)], [])
        with self.subTest("rows stand together, from loose to tight"):
            rows = [tuple(p[key] for key in ("formulation", "code", "method", "number", "projection")) for p in problem["points"]]
            self.assertEqual(len(set(rows)), 1 + sum(a != b for a, b in zip(rows, rows[1:])))
            self.assertEqual([p["id"] for p in problem["points"]], list(range(1, len(rows) + 1)))

    def test_closed_forms(self):
        self.write("spring.yaml", SPRING)
        scene = "gauss: 1\nscene: swing\nmodel: spring.yaml\noutputs: [x, x_dot]\nduration: 3\nexact: {x: cos(sqrt(k/m)*t)"
        with self.subTest("of some columns: they check the reference"):
            problem = self.study(scene + "}\n", "--budget", "3")
            self.assertEqual(problem["reference"]["kind"], "float128")
            self.assertLess(problem["reference"]["agreement"], 1e-17)
        with self.subTest("of all: they are the reference"):
            problem = self.study(scene + ", x_dot: -sqrt(k/m)*sin(sqrt(k/m)*t)}\n", "--budget", "3")
            self.assertEqual(problem["reference"]["kind"], "closed form")
            self.assertLess(min(p["error"] for p in problem["points"] if p["status"] == "ok"), 1e-14)
        with self.subTest("the model names them, of its own initial state"):
            own = (SPRING.replace("coordinates:", "  x0: {value: 1, unit: m}\ncoordinates:")
                   + "exact: {x: x0*cos(sqrt(k/m)*t), x_dot: -x0*sqrt(k/m)*sin(sqrt(k/m)*t)}\n")
            self.write("spring.yaml", own)
            plain = scene[: scene.index("exact")]
            self.assertEqual(self.study(plain, "--budget", "3")["reference"]["kind"], "closed form")
            self.assertEqual(self.study(plain + "initial: {x: 0.5}\n", "--budget", "3")["reference"]["kind"], "float128")
            self.assertEqual(self.study(plain + "parameters: {k: 2}\n", "--budget", "3")["reference"]["kind"], "closed form")
        with self.subTest("a wrong one of the model is found"):
            self.write("spring.yaml", own.replace("cos(sqrt(k/m)*t)", "cos(1.9*sqrt(k/m)*t)"))
            self.write("swing.yaml", plain)
            said = self.run_it("study", "swing.yaml", "--budget", "3", "-q").stderr
            self.assertIn("closed form of 'x' differs", said)
            problem = self.written()
            self.assertIn(problem["why"], " ".join(said.split()))
            self.assertEqual((problem["reference"], problem["points"]), (None, []))
            self.assertIn("closed form of 'x' differs", (self.folder / "study.html").read_text(encoding="utf-8"))
        self.write("spring.yaml", SPRING)
        with self.subTest("a wrong one is found"):
            self.write("swing.yaml", scene.replace("sqrt(k/m)", "1.9") + "}\n")
            said = self.run_it("study", "swing.yaml", "--budget", "3", "-q").stderr
            self.assertIn("closed form of 'x' differs", said)


# A crank, a coupler and a rocker, closed where coupler and rocker meet; and a disc that rolls along a line.
FOUR_BAR = """gauss: 1
name: bars
parameters:
  m: {value: 1, unit: kg}
  g: {value: 10, unit: m/s^2}
joints:
  O: {type: revolute, child: crank, coordinates: alpha, initial: 0.6, initial_rate: 2}
  A: {type: revolute, parent: crank, child: coupler, at: [0.2, 0, 0], coordinates: beta, initial_guess: 0.3}
  C: {type: revolute, child: rocker, at: [0.55, 0, 0], coordinates: gamma, initial_guess: 1.4}
points:
  B: {on: coupler, at: [0.6, 0, 0]}
  D: {on: rocker, at: [0.5, 0, 0]}
bodies:
  crank: {mass: m, inertia: 0.01, centre: [0.1, 0, 0]}
  coupler: {mass: m, inertia: 0.01, centre: [0.3, 0, 0]}
  rocker: {mass: m, inertia: 0.01, centre: [0.25, 0, 0]}
constraints:
  loop: {coincide: [B, D]}
forces:
  gravity: {uniform: [0, -g, 0]}
"""
WHEEL = """gauss: 1
name: wheel
parameters:
  R: {value: 0.5, unit: m}
coordinates:
  x: {unit: m, initial: 0, initial_rate: 3}
  y: {unit: m, held_at: R}
  phi: {unit: rad, initial: 0}
frames:
  carried: {position: [x, y, 0]}
  rim: {parent: carried, orientation: {axis: z, angle: phi}}
points:
  ground: {on: carried, at: [0, -R, 0]}
bodies:
  rim: {mass: 2, inertia: [0.1, 0.1, 0.2]}
constraints:
  rolling: {no_slip: rim, at: ground, direction: x}
forces:
  gravity: {uniform: [0, -10, 0]}
"""


BEADS = """gauss: 1
name: beads
coordinates:
  a: {initial: 0.6}
  b: {initial_guess: -0.8}
  c: {initial: 0.9}
  d: {initial_guess: -1.2}
  e: {initial: 1}
  f: {initial_guess: 1}
particles:
  one: {mass: 1, position: [a, b, 0]}
  two: {mass: 2, position: [c, d, 0]}
  three: {mass: 1, position: [e, f, 0]}
constraints:
  upper: {equation: a^2 + b^2 - 1}
  lower: {equation: (a-c)^2 + (b-d)^2 - 0.25}
  track: {equation: f - e^2}
forces:
  gravity: {uniform: [0, -10, 0]}
"""

HELD_BEADS = """gauss: 1
name: held_beads
coordinates:
  a: {initial: 0.6}
  b: {initial: 1.1}
  upper: {held_at: 1}
  lower: {held_at: 0.5}
particles:
  one: {mass: 1, position: [upper*sin(a), -upper*cos(a), 0]}
  two: {mass: 2, position: [upper*sin(a) + lower*sin(b), -upper*cos(a) - lower*cos(b), 0]}
forces:
  gravity: {uniform: [0, -10, 0]}
"""

NO_RODS = """gauss: 1
name: no_rods
coordinates: {z1: {initial: 0.5}, z2: {initial: 1}, x1: {initial: 1}, x2: {initial: 2}, s: {initial: 1}, h: {initial: -1}, w: {initial_rate: 0.1}}
particles:
  one: {mass: 1, position: [0, 0, z1]}
  two: {mass: 2, position: [0, 0, z2]}
  left: {mass: 1, position: [x1, 0, 0]}
  right: {mass: 1, position: [x2, 0, 0]}
  cart: {mass: 1, position: [s, 0, 0]}
  book: {mass: 1, position: [0, 0, h]}
  puck: {mass: 1, position: [w, 0, 1e7*(h + 2)]}
constraints:
  tackle: {velocity: dot(z1) + 2*dot(z2)}
  gear: {equation: x1 + x2 - 3}
  motor: {velocity: dot(s) - 0.3}
  floor: {equation: h + 1}
forces:
  gravity: {uniform: [0, 0, -10]}
  push: {on: left, force: [1, 0, 0]}
  drag: {on: cart, force: ["-2*dot(s)", 0, 0]}
"""


class Motions(Program):
    def motion(self, text, duration=1):
        self.write("model.yaml", text)
        self.write("scene.yaml", f"gauss: 1\nscene: short\nmodel: model.yaml\nduration: {duration}\nsamples: 201\ncode: optimised\nstrategy: metric\n")
        self.ok("study", "scene.yaml", "--budget", "1", "--tightest", "1e-4", "-q")
        return json.loads((self.folder / "study.json").read_text(encoding="utf-8"))["problems"][0]["motion"]

    def test_a_closed_loop_is_drawn_closed(self):
        motion = self.motion(FOUR_BAR)
        lines = {line["name"]: line["points"] for line in motion["lines"]}
        with self.subTest("up is against gravity"):
            self.assertEqual(motion["up"], [0, 1, 0])
        with self.subTest("a bar goes from joint to joint, through its mass centre"):
            for name, length in (("crank", 0.2), ("coupler", 0.6), ("rocker", 0.5)):
                for first, centre, last in lines[name]:
                    self.assertAlmostEqual(math.dist(first, last), length, places=4)
                    self.assertAlmostEqual(math.dist(first, centre), length / 2, places=4)
        with self.subTest("coupler and rocker meet where the loop is closed"):
            for coupler, rocker in zip(lines["coupler"], lines["rocker"]):
                self.assertLess(math.dist(coupler[-1], rocker[-1]), 1e-4)
        forces = {force["name"]: force for force in motion["reactions"]}
        with self.subTest("one arrow for each joint, the closing one among them"):
            self.assertEqual(sorted(forces), ["A", "C", "O", "loop"])
            self.assertEqual(len(motion["reactions"]), 4)
            for at, coupler in zip(forces["loop"]["at"], lines["coupler"]):
                self.assertLess(math.dist(at, coupler[-1]), 1e-4)
        with self.subTest("what both joints do to the coupler, and its weight, move it: m a by differences of places"):
            step = motion["t"][1] - motion["t"][0]
            places = [body["position"] for body in motion["bodies"] if body["name"] == "coupler"][0]
            for k in range(1, len(places) - 1):
                for axis, weight in ((0, 0), (1, -10)):
                    acceleration = (places[k + 1][axis] - 2 * places[k][axis] + places[k - 1][axis]) / step**2
                    force = forces["A"]["force"][k][axis] + forces["loop"]["force"][k][axis] + weight
                    self.assertAlmostEqual(force, acceleration, delta=0.2)

    def test_what_holds_particles_is_drawn(self):
        """Two of them in a row on rods, beside one on a track that bends about no point."""
        for text in (BEADS, BEADS.replace("{equation: (a-c)^2 + (b-d)^2 - 0.25}", "{distance: [one, two], is: 0.5}"), HELD_BEADS):
            motion = self.motion(text)
            places = {body["name"]: body["position"] for body in motion["bodies"]}
            lines = {line["name"]: line["points"] for line in motion["lines"]}
            with self.subTest(text):
                self.assertEqual(sorted(lines), ["lower", "upper"])
                for k, (upper, lower) in enumerate(zip(lines["upper"], lines["lower"])):
                    self.assertEqual(upper, [[0, 0, 0], places["one"][k]])
                    self.assertEqual(sorted(lower), sorted([places["one"][k], places["two"][k]]))
                    self.assertAlmostEqual(math.dist(*lower), 0.5, places=4)

    def test_what_is_no_rod_is_not_drawn(self):
        """A tackle whose ends go up and down, a gear, a drive, and a floor below the origin."""
        self.assertEqual(self.motion(NO_RODS)["lines"], [])

    def test_a_contact_has_its_force_where_it_is(self):
        motion = self.motion(WHEEL)
        rolling = [force for force in motion["reactions"] if force["name"] == "rolling"][0]
        for (x, y, z), centre in zip(rolling["at"], motion["bodies"][0]["position"]):
            self.assertAlmostEqual(x, centre[0], places=4)
            self.assertAlmostEqual(y, centre[1] - 0.5, places=4)
        disc = motion["bodies"][0]
        with self.subTest("a circle of contacts around the mass centre is the rim of a disc, whose axis lies across the way"):
            self.assertEqual(disc["shape"]["kind"], "cylinder")
            self.assertAlmostEqual(disc["shape"]["radius"], 0.5, places=5)
            for w, x, y, z in disc["orientation"]:
                self.assertAlmostEqual(abs(1 - 2 * (x * x + y * y)), 1, places=5)

    def test_what_rolls_over_all_of_its_surface_is_a_ball(self):
        motion = self.motion((MODELS / "chaplygin_sphere.yaml").read_text(encoding="utf-8"), duration=5)
        [ball], [along] = motion["bodies"], [force for force in motion["reactions"] if force["name"] == "plane"]
        self.assertEqual(ball["shape"]["kind"], "sphere")
        for at, centre in zip(along["at"], ball["position"]):
            self.assertAlmostEqual(math.dist(at, centre), ball["shape"]["radius"], places=4)


if __name__ == "__main__":
    unittest.main()
