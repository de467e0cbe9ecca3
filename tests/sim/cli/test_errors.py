"""An error instead of a tolerance: gauss-sim run --error, and gauss-sim advise."""

import json
import math
import os
import signal
import subprocess
import time
import unittest

from gauss_sim import HAMMER, MODELS, PROGRAM, SPRING, Program, hammered

# Unstable, and started on the way that decays: x = e^(-t/10), where rounding the start of -1/10 alone is 4e-5 in the end.
UNSTABLE = """gauss: 1
name: unstable
parameters: {m: {value: 1, unit: kg}, k: {value: 0.01, unit: N/m}}
coordinates: {x: {unit: m, initial: 1, initial_rate: -0.1}}
particles: {bob: {mass: m, position: [x, 0, 0]}}
forces: {push: {generalized: {x: k*x}}}
"""

# A blow of a hundredth of a second, whose impulse is the integral of a Gauss curve.
BLOW = """gauss: 1
name: blow
parameters: {m: {value: 1, unit: kg}, F: {value: 1, unit: N}, w: {value: 200, unit: 1/s}, at: {value: 5.3, unit: s}}
coordinates: {x: {unit: m, initial: 0}}
particles: {bob: {mass: m, position: [x, 0, 0]}}
forces: {push: {generalized: {x: F*exp(-((t - at)*w)^2)}}}
"""

# A push that nobody feels who looks every ten seconds: 0.2 s of 2 N.
PULSE = """gauss: 1
name: pulse
parameters: {m: {value: 1, unit: kg}, F: {value: 2, unit: N}, w: {value: 0.1, unit: s}, at: {value: 6.3, unit: s}}
coordinates: {x: {unit: m, initial: 0}}
particles: {bob: {mass: m, position: [x, 0, 0]}}
forces: {push: {generalized: {x: "piecewise(abs(t - at) < w, F, 0*F)"}}}
"""

# A ball on a spring that swings by a centimetre beside one that flies 600 km: of one unit, one range 3e7 times the other.
BESIDE = """gauss: 1
name: beside
parameters: {m: {value: 1, unit: kg}, k: {value: 4, unit: N/m}}
coordinates:
  x: {unit: m, initial: 0.01}
  far: {unit: m, initial: 0, initial_rate: 6e4}
particles: {bob: {mass: m, position: [x, 0, 0]}, stone: {mass: m, position: [far, 0, 0]}}
forces: {pull: {potential: k*x^2/2}}
"""


# Of its own each, with the same unit.
TWO = """gauss: 1
name: {name}
parameters: {{m: {{value: 1, unit: kg}}, k: {{value: 1, unit: N/m}}}}
coordinates: {{y: {{unit: m, initial: {y}}}, z: {{unit: m, initial: {z}}}}}
particles: {{p: {{mass: m, position: [0, y, z]}}}}
forces: {{f: {{generalized: {{y: "-5^2*k*y", z: "-k*z"}}}}}}
"""


class Errors(Program):
    def off(self, name):
        """The error of x against the closed form, relative to its range."""
        table = self.table(f"{name}.csv")
        return max(abs(x - math.cos(2 * t)) for t, x in zip(table["t [s]"], table["x [m]"])) / 2

    def test_what_is_asked_for_is_delivered(self):
        self.write("spring.yaml", SPRING)
        for exponent in (3, 6, 9):
            error = 10.0 ** -exponent
            self.ok("run", "spring.yaml", "--error", error, "--outputs", "x", "-q")
            said = self.summary("spring.json")
            with self.subTest(error):
                self.assertLessEqual(self.off("spring"), error)
                self.assertLessEqual(said["error_estimate"]["relative"], error)
                self.assertLessEqual(said["asked_for"]["agreement"], error / 20)
                # Not by running as tight as possible.
                self.assertGreater(said["error_estimate"]["relative"], error / 1e3)

    def test_errors_of_two_runs_that_round_the_same_start_are_seen(self):
        self.write("unstable.yaml", UNSTABLE)
        self.ok("run", "unstable.yaml", "--error", "1e-6", "--outputs", "x", "--duration", "300", "-q")
        table = self.table("unstable.csv")
        off = max(abs(x - math.exp(-t / 10)) for t, x in zip(table["t [s]"], table["x [m]"]))
        self.assertLessEqual(off, 1e-6)

    def test_what_overflows_is_not_delivered(self):
        self.write("unstable.yaml", UNSTABLE.replace("0.01", "1e4").replace("-0.1", "-100"))
        self.refused(6, "run", "unstable.yaml", "--error", "1e-6", "--outputs", "state", "-q")

    def test_what_acts_for_a_short_time_is_seen(self):
        self.write("blow.yaml", BLOW)
        self.ok("run", "blow.yaml", "--error", "1e-6", "--outputs", "x", "-q")
        self.assertAlmostEqual(self.table("blow.csv")["x [m]"][-1], math.sqrt(math.pi) / 200 * 4.7, delta=1e-7)
        self.ok("run", "blow.yaml", "--outputs", "x", "-q", "-o", "plain.csv")
        self.assertGreater(self.summary("plain.json")["error_estimate"]["relative"], 0.1)

    def test_what_acts_for_a_short_time_is_seen_by_those_who_look_twice_in_all(self):
        self.write("pulse.yaml", PULSE)
        self.ok("run", "pulse.yaml", "--error", "1e-6", "--outputs", "x", "--samples", "2", "-q")
        self.assertAlmostEqual(self.table("pulse.csv")["x [m]"][-1], 2 * 0.2 * 3.7, delta=1.5e-6)

    def test_a_push_that_steps_of_one_length_see_is_seen_by_what_tells_their_error(self):
        self.write("pulse.yaml", PULSE)
        said = self.run_it("run", "pulse.yaml", "--set", "w=0.05", "--method", "rk4", "--outputs", "x", "--samples", "2", "-q").stderr
        self.assertNotIn("is not this motion", said)
        off = abs(self.table("pulse.csv")["x [m]"][-1] / (2 * 0.1 * 3.7) - 1)
        self.assertLess(off / 2, self.summary("pulse.json")["error_estimate"]["relative"])
        self.assertLess(self.summary("pulse.json")["error_estimate"]["relative"], 0.01)

    def test_what_acts_for_a_ten_thousandth_of_the_time_is_seen_where_forces_jump(self):
        self.write("hammer.yaml", HAMMER)

        def off(name):
            table = self.table(f"{name}.csv")
            times, places = table.values()
            exact = [hammered(t) for t in times]
            return max(abs(x - y) for x, y in zip(places, exact)) / (max(exact) - min(exact))

        for asked in (1e-3, 1e-6):
            self.ok("run", "hammer.yaml", "--error", asked, "--outputs", "x", "--samples", "11", "-q")
            self.assertLess(off("hammer"), asked)
        said = self.ok("run", "hammer.yaml", "--outputs", "x", "--samples", "11", "-o", "plain.csv")
        self.assertGreater(off("plain"), 0.5)
        self.assertGreater(self.summary("plain.json")["error_estimate"]["relative"], 0.99 * off("plain"))
        self.assertRegex(said, r"(?m)^  error   .*; of what acts for 0\.000\d+ s or longer$")

    def test_what_rests_is_set_moving_wherever_samples_and_steps_fall(self):
        self.write("pulse.yaml", PULSE)
        for method in ("prince87", "dopri5", "cash_karp54", "bulirsch_stoer"):
            for at in (6.3, 6.31, 1.1, 5.0, 7.77777):
                for more in ((), ("--longest-step", 10 / 1009), ("--samples", 1001)):
                    with self.subTest((method, at, more)):
                        self.ok("run", "pulse.yaml", "--set", f"at={at}", "--method", method, "--outputs", "x", "-q", *more)
                        last = self.table("pulse.csv")["x [m]"][-1]
                        self.assertAlmostEqual(last, 2 * 0.2 * (10 - at), delta=1e-5)

    def test_a_small_motion_beside_a_large_one_of_its_unit_is_delivered_in_parts_of_its_own_range(self):
        self.write("beside.yaml", BESIDE)
        self.ok("run", "beside.yaml", "--error", "1e-6", "-q")
        table = self.table("beside.csv")
        off = max(abs(x / 0.01 - math.cos(2 * t)) for t, x in zip(table["t [s]"], table["x [m]"])) / 2
        self.assertLessEqual(off, 1e-6)
        self.ok("run", "beside.yaml", "--method", "rk4", "--step", "0.2", "-q")
        table = self.table("beside.csv")
        off = max(abs(x / 0.01 - math.cos(2 * t)) for t, x in zip(table["t [s]"], table["x [m]"])) / 2
        said = self.summary("beside.json")["error_estimate"]
        self.assertGreater(said["relative"], off / 2)
        self.assertEqual(said["constant"], ["far_dot", "energy.total"])

    def test_a_run_that_loses_what_is_small_says_so(self):
        """1 mm beside 1.5e11 m, and 1e-13 m alone: sizes in a unit excuse nothing."""
        self.write("far.yaml", TWO.format(name="far", y="1e-3", z="1.5e11"))
        self.write("tiny.yaml", TWO.format(name="tiny", y="1e-13", z="0"))
        for model, y, options in (("far", 1e-3, ["--outputs", "y,z"]), ("tiny", 1e-13, ["--method", "dopri5", "--tolerance", "1e-2", "--duration", "100"]),
                                  ("tiny", 1e-13, ["--method", "verlet", "--step", "0.1", "--samples", "101"])):
            with self.subTest((model, options)):
                self.ok("run", f"{model}.yaml", *options, "-q")
                table = self.table(f"{model}.csv")
                off = max(abs(x / y - math.cos(5 * t)) for t, x in zip(table["t [s]"], table["y [m]"])) / 2
                self.assertGreater(off, 1e-2)
                self.assertGreater(self.summary(f"{model}.json")["error_estimate"]["relative"], off / 3)

    def test_a_closed_form_that_is_wrong_in_what_is_small_is_refused(self):
        self.write(
            "beside.yaml",
            BESIDE.replace("k: {", "a: {value: 0.011, unit: m}, w: {value: 2, unit: rad/s}, k: {") + "exact: {x: a*cos(w*t)}\n",
        )
        self.write("scene.yaml", "gauss: 1\nmodel: beside.yaml\nduration: 5\n")
        said = self.run_it("study", "scene.yaml", "-q", "--budget", "1", "-o", "s").stderr
        self.assertIn("the closed form of 'x' differs from the motion by 0.05 of its range", said)

    def test_more_digits_than_double_has(self):
        self.write("spring.yaml", SPRING)
        self.ok("run", "spring.yaml", "--error", "1e-17", "--outputs", "x", "-q")
        said = self.summary("spring.json")
        self.assertIn(said["number"], ("long-double", "float128"))
        self.assertLessEqual(said["error_estimate"]["relative"], 1e-17)

    def test_closed_forms_of_a_model_are_compared_with_where_they_are_its_motion(self):
        model = SPRING.replace("parameters:\n", "parameters:\n  a: {value: 1, unit: m}\n  w: {value: 2, unit: rad/s}\n")
        self.write("spring.yaml", model + "exact: {x: a*cos(w*t)}\n")
        said = self.ok("run", "spring.yaml", "--tolerance", "1e-6")
        self.assertIn("exact   off by ", said)
        found = self.summary("spring.json")["from_closed_forms"]
        self.assertEqual(found["output"], "x")
        self.assertAlmostEqual(found["relative"], self.off("spring"), delta=1e-3 * found["relative"])
        wrong = self.run_it("run", "spring.yaml", "--set", "w=2.1", "-q").stderr
        self.assertIn("the closed form of 'x' is another motion", wrong)
        nearly = ("run", "spring.yaml", "--set", "w=2.00001", "-q")
        self.assertEqual(self.run_it(*nearly).stderr, "")
        self.assertIn("the closed form of 'x' is another motion", self.run_it(*nearly, "--error", "1e-8").stderr)
        self.assertEqual(self.run_it("run", "spring.yaml", "--set", "x=2", "-q").stderr, "")
        self.assertNotIn("from_closed_forms", self.summary("spring.json"))

    def test_what_cannot_be_delivered_is_refused(self):
        self.write("spring.yaml", SPRING)
        with self.subTest("no number type has the digits"):
            said = self.refused(6, "run", "spring.yaml", "--error", "1e-36", "-q")
            self.assertIn("1.0e-36", said)
        with self.subTest("the scene insists on double"):
            self.write("s.yaml", "gauss: 1\nmodel: spring.yaml\nnumber: double\nerror: 1e-17\n")
            self.assertIn("no setting delivers", self.refused(6, "run", "s.yaml", "-q"))
            self.write("s.yaml", "gauss: 1\nmodel: spring.yaml\nnumber: double\nerror: 1e-18\n")
            self.assertIn("cannot be shown", self.refused(6, "run", "s.yaml", "-q"))
        with self.subTest("not beside a tolerance"):
            self.refused(2, "run", "spring.yaml", "--error", "1e-6", "--tolerance", "1e-6")

    def test_a_method_that_does_not_take_the_model_is_not_tried_on(self):
        """A damper that acts for a time: it shows on the way, and no step is short enough for it."""
        self.write("spring.yaml", SPRING.replace("parameters:", "parameters:\n  c: {value: 3, unit: kg/s}\n  one: {value: 1, unit: s}").replace("{potential: k*x^2/2}", "{potential: k*x^2/2}\n  hit: {generalized: {x: 'piecewise(t < 3.3*one, 0, t < 3.45*one, -c*dot(x), 0)'}}"))
        begin = time.monotonic()
        said = self.refused(6, "run", "spring.yaml", "--method", "kahan_li8", "--error", "1e-8", "-q")
        self.assertIn("the method takes only models whose accelerations depend on coordinates alone", said)
        self.assertIn("'kahan_li8' may step over a place where a force jumps", said)
        self.assertLess(time.monotonic() - begin, 60)

    @unittest.skipUnless(os.environ.get("GAUSS_ALL_MODELS") == "1", "half a minute")
    def test_all_digits_of_float128_are_tried(self):
        """A motion without order for a minute: what is off by all tells nothing of how far."""
        for error in ("1e-2", "1e-3"):
            self.ok("run", MODELS / "double_pendulum.yaml", "--duration", "60", "--samples", "61", "--outputs", "state", "--error", error, "-q")
            found = self.summary("double_pendulum.json")
            self.assertEqual(found["number"], "float128")
            self.assertLess(found["error_estimate"]["relative"], float(error))

    def test_a_search_ends_with_its_budget(self):
        """Coulomb's friction holds the bob after a second: each step after that is a short one."""
        begin = time.monotonic()
        said = self.refused(6, "run", MODELS / "functions.yaml", "--duration", "10", "--error", "1e-3", "--budget", "5")
        self.assertIn("steps become short where a force has a jump or a kink, as by sign(...)", said)
        self.assertNotIn("--budget gives it more", said)
        self.assertLess(time.monotonic() - begin, 60)
        self.refused(6, "advise", MODELS / "functions.yaml", "--duration", "10", "--error", "1e-3", "--budget", "5")

    def test_ctrl_c_ends_a_search(self):
        for command, said in (("run", "interrupted while a setting was looked for; nothing is written"), ("advise", "interrupted; nothing is written")):
            with self.subTest(command):
                process = subprocess.Popen([PROGRAM, command, MODELS / "functions.yaml", "--error", "1e-3", "--budget", "600"], cwd=self.folder,
                                           stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
                self.wait_for_processor(process, 2)
                process.send_signal(signal.SIGINT)
                begin = time.monotonic()
                self.assertIn(said, process.communicate(timeout=60)[1])
                self.assertLess(time.monotonic() - begin, 5)
                self.assertEqual(process.returncode, 130)
                self.assertEqual(self.files(), [])

    def test_a_smooth_motion_takes_more_time_where_it_gets_more(self):
        self.write("spring.yaml", SPRING)
        said = self.refused(6, "run", "spring.yaml", "--duration", "1e6", "--error", "1e-6", "--budget", "0.3")
        self.assertIn("--budget gives it more", said)

    def test_what_was_tried_has_heads_and_the_digits_that_were_meant(self):
        self.write("spring.yaml", SPRING)
        advice = self.ok("advise", "spring.yaml", "--error", "1e-5")
        self.assertRegex(advice.splitlines()[0], "^#  method +number +projection +accuracy +error +time$")
        self.assertEqual(len(advice.splitlines()[0]), len(advice.splitlines()[1]))
        for exponent in range(3, 9):
            found = json.loads(self.ok("advise", "spring.yaml", "--error", f"1e-{exponent}", "--method", "dopri5", "--format", "json"))
            self.assertEqual(found["found"]["tolerance"], float(f"{found['found']['tolerance']:.1e}"))

    def test_methods_of_the_scene_are_kept(self):
        self.write("spring.yaml", SPRING)
        for method in ("rk4", "dopri5"):
            self.write("s.yaml", f"gauss: 1\nscene: s\nmodel: spring.yaml\nmethod: {method}\nerror: 1e-7\noutputs: [x]\n")
            self.ok("run", "s.yaml", "-q")
            self.assertEqual(self.summary("s.json")["method"], method)
            self.assertLessEqual(self.off("s"), 1e-7)

    def test_advice_can_be_pasted(self):
        self.write("spring.yaml", SPRING)
        advice = self.ok("advise", "spring.yaml", "--error", "1e-7")
        self.write("s.yaml", "gauss: 1\nscene: s\nmodel: spring.yaml\noutputs: [x]\n" + advice)
        self.ok("run", "s.yaml", "-q")
        self.assertLessEqual(self.off("s"), 1e-7)
        found = json.loads(self.ok("advise", "spring.yaml", "--error", "1e-7", "--format", "json"))
        self.assertLessEqual(found["found"]["error"], 1e-7)
        self.assertLessEqual(found["found"]["time_s"], 1.1 * min(one["time_s"] for one in found["tried"]))

    def test_projection_is_left_out_in_double_too_where_float_is_cheaper_with_it(self):
        """Of the bicycle, projection takes two thirds of a run: double without it takes half of the time of float with it."""
        found = json.loads(self.ok("advise", MODELS / "bicycle.yaml", "--error", "1e-3", "--format", "json"))
        self.assertIn(("double", "off"), [(one["number"], one["projection"]) for one in found["tried"]])

    def test_advice_does_not_rest_on_samples(self):
        """Steps end at each of them: with fewer, they would be longer, and the error another one."""
        advice = self.ok("advise", MODELS / "spherical_pendulum.yaml", "--error", "1e-8", "--method", "prince87")
        self.assertIn("\nlongest_step: 0.02\n", advice)
        self.write("s.yaml", f"gauss: 1\nscene: s\nmodel: {MODELS / 'spherical_pendulum.yaml'}\nsamples: 11\n" + advice)
        self.ok("run", "s.yaml", "-q")
        self.assertGreaterEqual(self.summary("s.json")["steps"], 500)
        self.assertLessEqual(self.summary("s.json")["error_estimate"]["relative"], 1e-8)
        with self.subTest("series pass by samples"):
            self.assertNotIn("longest_step", self.ok("advise", MODELS / "spherical_pendulum.yaml", "--error", "1e-8", "--method", "taylor"))

    def test_stiff_models_get_stiff_methods(self):
        found = json.loads(self.ok("advise", MODELS / "spring_pendulum.yaml", "--error", "1e-4", "--format", "json"))
        tried = {one["method"] for one in found["tried"]}
        self.assertTrue(tried & {"radau", "cvode_bdf", "arkode_esdirk4", "arkode_kvaerno5", "ida"}, tried)

    def test_advice_from_a_study(self):
        point = {"id": 1, "method": "dopri5", "formulation": "as given", "code": "optimised", "number": "double", "projection": "full",
                 "tolerance": 1e-5, "step": None, "status": "ok", "why": "", "error": 1e-5, "time_s": 1e-3}
        points = [point, {**point, "id": 2, "tolerance": 1e-8, "error": 1e-8, "time_s": 2e-3},
                  {**point, "id": 3, "status": "failed", "why": "it stopped", "error": None, "time_s": None}]
        self.write("spring.yaml", SPRING)
        self.ok("study", "spring.yaml", "-q", "--budget", "1", "--methods", "rk4", "-o", "study")
        study = self.summary("study.json")
        study["problems"][0]["points"] = points
        self.write("study.json", json.dumps(study))
        self.assertIn("tolerance: 1e-05\n", self.ok("advise", "spring.yaml", "--error", "1e-4", "--study", "study.json"))
        with self.subTest("a strategy is a line of a scene"):
            study["problems"][0]["points"] = [{**point, "formulation": "as given, metric"}]
            self.write("metric.json", json.dumps(study))
            said = self.ok("advise", "spring.yaml", "--error", "1e-4", "--study", "metric.json")
            self.assertIn("\nstrategy: metric\n", said)
            self.assertNotIn("formulation", said)
        with self.subTest("a margin of two"):
            self.assertIn("tolerance: 1e-08\n", self.ok("advise", "spring.yaml", "--error", "1.5e-5", "--study", "study.json"))
        with self.subTest("nothing delivers it"):
            self.assertIn("1.0e-08", self.refused(6, "advise", "spring.yaml", "--error", "1e-9", "--study", "study.json"))
        with self.subTest("another problem"):
            self.write("other.yaml", SPRING.replace("name: spring", "name: other"))
            self.assertIn("other", self.refused(3, "advise", "other.yaml", "--error", "1e-4", "--study", "study.json"))
        with self.subTest("another time, and other outputs"):
            of_study = ("advise", "spring.yaml", "--error", "1e-4", "--study", "study.json")
            self.assertIn("lasts 10 s, and here 5 s", self.refused(3, *of_study, "--duration", "5"))
            self.assertIn("other outputs", self.refused(3, *of_study, "--outputs", "x"))
        with self.subTest("another motion"):
            for more in (("--start", "1"), ("--samples", "11")):
                self.assertIn("is not the same", self.refused(3, *of_study, *more), more)
            for change in ("m=3", "x=2", "x_dot=1"):
                self.assertIn("is not the same", self.refused(3, *of_study, "--set", change), change)
            self.write("spring.yaml", SPRING.replace("k*x^2/2", "3*k*x^2/2"))
            self.assertIn("is not the same", self.refused(3, *of_study))
            self.write("spring.yaml", SPRING)
        with self.subTest("what is asked for is kept"):
            self.ok(*of_study, "--method", "dopri5", "--number", "double", "--projection", "full")
            for more in (("--method", "prince87"), ("--number", "float"), ("--projection", "off"), ("--code", "expanded")):
                self.assertIn("no run that arrives", self.refused(6, *of_study, *more), more)
        with self.subTest("what has neither a tolerance nor a step is no setting"):
            study["problems"][0]["points"] = [{**point, "tolerance": None}]
            self.write("other.json", json.dumps(study))
            self.assertIn("no run that arrives", self.refused(6, *of_study[:-1], "other.json"))
        with self.subTest("no study"):
            self.write("list.json", "[]")
            self.refused(3, "advise", "spring.yaml", "--error", "1e-4", "--study", "list.json")

    def test_advice_from_a_study_is_of_all_files_that_it_saw(self):
        part = "gauss: 1\nname: part\ncoordinates: {x: {unit: m, initial: 1}}\nparameters: {m: {value: 2, unit: kg}, k: {value: 8, unit: N/m}}\nparticles: {bob: {mass: m, position: [x, 0, 0]}}\nforces: {pull: {potential: k*x^2/2}}\n"
        other = SPRING.replace("x:", "y:").replace("[x,", "[y,").replace("k*x", "k*y")
        self.write("part.yaml", part)
        self.write("whole.yaml", "gauss: 1\nname: whole\nsubmodels: {a: {file: part.yaml}}\n")
        self.write("other.yaml", other)
        self.write("scene.yaml", "gauss: 1\nmodel: whole.yaml\noutputs: [energy.kinetic]\nformulations: {other: {model: other.yaml}}\n")
        self.ok("study", "scene.yaml", "-q", "--budget", "2", "-o", "study")
        ask = ("advise", "scene.yaml", "--error", "1e-3", "--study", "study.json")
        self.ok(*ask)
        with self.subTest("of a submodel"):
            self.write("part.yaml", part.replace("x^2/2", "x^2"))
            self.assertIn("is not the same", self.refused(3, *ask))
            self.write("part.yaml", part)
        with self.subTest("of another formulation"):
            self.write("other.yaml", other.replace("y^2/2", "y^2"))
            self.assertIn("its formulation 'other' is not the same", self.refused(3, *ask))
            self.write("other.yaml", other)
        with self.subTest("which are others"):
            self.write("scene.yaml", "gauss: 1\nmodel: whole.yaml\noutputs: [energy.kinetic]\nformulations: {another: {model: other.yaml}}\n")
            self.assertIn("it has other formulations", self.refused(3, *ask))


if __name__ == "__main__":
    unittest.main()
