"""Scenes: what they say, and what is wrong with them."""

import json
import math
import unittest

from gauss_sim import MODELS, SPRING, Program

SCENE = """gauss: 1
scene: slow_swing
model: spring.yaml
parameters: {k: 2}
initial: {x: 0.5}
duration: 2*pi*sqrt(m/k)
samples: 5
outputs: [x]
tolerance: 1e-11
"""


class Scenes(Program):
    def setUp(self):
        super().setUp()
        self.write("spring.yaml", SPRING)

    def mistake(self, text, code=1):
        self.write("scene.yaml", text)
        return self.refused(code, "run", "scene.yaml")

    def test_a_scene_says_values_duration_and_outputs(self):
        self.write("scene.yaml", SCENE)
        self.ok("run", "scene.yaml", "-q")
        table = self.table("slow_swing.csv")
        self.assertEqual(list(table), ["t [s]", "x [m]"])
        self.assertAlmostEqual(table["t [s]"][-1], 2 * math.pi, delta=1e-14)
        for x, expected in zip(table["x [m]"], (0.5, 0, -0.5, 0, 0.5)):
            self.assertAlmostEqual(x, expected, delta=1e-9)

    def test_options_have_precedence(self):
        self.write("scene.yaml", SCENE)
        self.ok("run", "scene.yaml", "--duration", "1", "--samples", "3", "-o", "other.csv", "-q")
        self.assertEqual(self.table("other.csv")["t [s]"], [0, 0.5, 1])

    def test_all_mistakes_are_said_at_once_with_their_places(self):
        text = SCENE.replace("samples: 5", "sampels: 5").replace("tolerance: 1e-11", "tolerance: -1\nmethod: dopri6")
        said = self.mistake(text)
        self.assertIn("scene.yaml:7:1: error[E010]", said)
        self.assertIn("did you mean 'samples'?", said)
        self.assertIn("scene.yaml:9:12: error[E017]", said)
        self.assertIn("scene.yaml:10:9: error[E015]", said)
        self.assertIn("did you mean 'dopri5'?", said)

    def test_no_mistake_hides_another(self):
        said = self.mistake("""gauss: 1
scene: ../bad
model: spring.yaml
counts: {n: 4}
parameters: {kk: 1, m: 1/0}
initial: {x: 2*, v: 1, k: 3}
start: 1*
duration: -1
every: 100
samples: 0
outputs: [x, y]
method: dopri6
exact: {z: 1}
""")
        for line, column, what in ((2, 8, "cannot name files"), (4, 10, "no 'counts'"), (5, 14, "no 'kk'"), (5, 24, "this is infinite"), (6, 16, "stops where an operand"),
                                   (6, 18, "no 'v'"), (6, 24, "'k' has no initial value"), (7, 10, "stops where an operand"), (8, 11, "must be a number above 0"),
                                   (10, 10, "exclude each other"), (10, 10, "expected a whole number"), (11, 14, "no output 'y'"), (12, 9, "no method 'dopri6'"), (13, 9, "'z' is no column")):
            self.assertRegex(said, rf"scene.yaml:{line}:{column}: error\[E\d+\]: .*{what}", (line, column))
        self.assertEqual(said.count(": error["), 14, said)
        self.assertIn("the model has x, x_dot", said)

    def test_a_wrong_option_leaves_the_mistakes_of_the_scene_to_be_seen(self):
        self.write("scene.yaml", SCENE.replace("initial: {x: 0.5}", "initial: {y: 1}"))
        said = self.refused(2, "run", "scene.yaml", "--set", "zz=1")
        self.assertIn("scene.yaml:5:11: error[E024]: the model has no 'y'", said)
        self.assertIn("--set: the model has no 'zz'", said)
        said = self.refused(2, "run", "scene.yaml", "--outputs", "x,zz")
        self.assertIn("scene.yaml:5:11: error[E024]: the model has no 'y'", said)
        self.assertIn("--outputs: the model has no output 'zz'", said)
        self.assertEqual(said.count("'zz'"), 1)

    def test_counts_that_the_model_has_not_are_said_with_their_place(self):
        said = self.mistake(f"gauss: 1\nmodel: {MODELS / 'chain.yaml'}\ncounts: {{N: 3, nn: 2}}\n")
        self.assertIn("scene.yaml:3:10: error[E024]: the model has no count 'N'", said)
        self.assertIn("scene.yaml:3:16: error[E024]: the model has no count 'nn'", said)

    def test_what_the_parser_of_options_refuses_is_json_too(self):
        for words in (("--tolerance", "1e-9x"), ("--nonsense",), ("--every", "1", "--samples", "4")):
            [line] = self.refused(2, "run", "spring.yaml", *words, "--diagnostics", "json").splitlines()
            self.assertEqual(json.loads(line)["severity"], "error", words)

    def test_counts_of_the_command_line_go_before_those_of_the_scene(self):
        self.write("scene.yaml", f"gauss: 1\nscene: links\nmodel: {MODELS / 'chain.yaml'}\ncounts: {{n: 4}}\nduration: 0.1\nsamples: 2\n")
        for words, links in ((), 4), (("--count", "n=2"), 2):
            self.ok("run", "scene.yaml", *words, "-q")
            self.assertEqual(sum(name.startswith("energy") is False and "_dot" not in name for name in self.table("links.csv")) - 1, links)
        self.assertIn("--count: the model has no count 'N'", self.refused(2, "run", "scene.yaml", "--count", "N=2"))
        self.assertIn("a whole number", self.refused(2, "run", "scene.yaml", "--count", "n=two"))

    def test_values_belong_where_they_stand(self):
        said = self.mistake(SCENE.replace("parameters: {k: 2}", "parameters: {x: 2, kk: 1}").replace("initial: {x: 0.5}", "initial: {m: 1}"))
        self.assertIn("scene.yaml:4:14: error[E024]: 'x' is no parameter of the model", said)
        self.assertIn("scene.yaml:4:20: error[E024]", said)
        self.assertIn("scene.yaml:5:11: error[E024]: 'm' has no initial value", said)

    def test_an_output_that_the_model_lacks_is_an_error(self):
        said = self.mistake(SCENE.replace("outputs: [x]", "outputs: [x, x_dott]"))
        self.assertIn("scene.yaml:8:14: error[E024]", said)
        self.assertIn("did you mean 'x_dot'?", said)

    def test_an_unknown_output_is_answered_by_all_that_there_could_be(self):
        scene = f"gauss: 1\nmodel: {MODELS / 'double_pendulum.yaml'}\noutputs: [{{}}]\n"
        self.assertIn("did you mean 'quantities.tip'?", self.mistake(scene.format("tip")))
        self.assertIn("did you mean 'energy.total'?", self.mistake(scene.format("total")))
        for other in ("tip.z", "points.tip"):
            self.assertIn("did you mean 'quantities.tip'?", self.mistake(scene.format(other)))
        self.assertIn("did you mean 'poses.upper'?", self.mistake(scene.format("upper")))
        said = self.mistake(scene.format("nothing_like_it"))
        for group in ("state", "accelerations", "joint_reactions", "energy", "mass_matrix", "jacobian", "quantities", "poses"):
            self.assertRegex(said, rf"there are .*\b{group}, ")
        self.assertNotIn(" reactions,", said)
        self.assertIn("did you mean 'quantities.tip'?", self.refused(2, "run", MODELS / "double_pendulum.yaml", "--outputs", "tip"))

    def test_names_of_scenes_lead_nowhere_else(self):
        for name in ("../evil", "/tmp/evil", "a/b", "'a\\b'", "..", ".", "''", '"a\\nb"'):
            with self.subTest(name):
                said = self.mistake(SCENE.replace("slow_swing", name))
                self.assertIn("scene.yaml:2:8: error[E020]", said)
                self.assertIn("cannot name files", said)
        self.write("scene.yaml", SCENE.replace("slow_swing", "../ev..il").replace("../", ""))
        self.ok("run", "scene.yaml", "-q")
        self.assertIn("ev..il.csv", self.files())

    def test_an_input_keeps_its_value_and_the_hint_says_what_to_do_instead(self):
        pushed = SPRING.replace("  k: {", "  w: {value: 1, unit: rad/s}\n  F: {value: 2, unit: N}\n  k: {").replace("forces:\n", "inputs: {push: {value: 4, unit: N}}\nforces:\n  hand: {generalized: {x: push}}\n")
        self.write("pushed.yaml", pushed)
        scene = "gauss: 1\nscene: pushed\nmodel: pushed.yaml\noutputs: [x]\n"
        said = self.mistake(scene + "inputs: {push: F*sin(w*t)}\n")
        self.assertIn("scene.yaml:5:10: error[E024]: 't' is not a parameter of the model", said)
        self.assertIn("write what changes with t or the motion into the force of the model, in place of the input, as F*sin(w*t)", said)
        self.write("scene.yaml", scene)
        self.write("pushed.yaml", pushed.replace("{x: push}", "{x: F*sin(w*t)}").replace("inputs: {push: {value: 4, unit: N}}\n", ""))
        self.ok("run", "scene.yaml", "-q")
        table = self.table("pushed.csv")
        for t, x in zip(table["t [s]"], table["x [m]"]):
            self.assertAlmostEqual(x, math.cos(2 * t) + math.sin(t) / 3 - math.sin(2 * t) / 6, delta=1e-7)
        with self.subTest("the value of the model counts where the scene says nothing"):
            self.write("pushed.yaml", pushed)
            self.ok("run", "scene.yaml", "-q")
            table = self.table("pushed.csv")
            for t, x in zip(table["t [s]"], table["x [m]"]):
                self.assertAlmostEqual(x, (1 + math.cos(2 * t)) / 2, delta=1e-7)

    def test_closed_forms_are_of_columns_over_time_and_parameters(self):
        said = self.mistake(SCENE + "exact: {x: cos(w*t), x_dot: 1}\n")
        self.assertIn("scene.yaml:10:12: error[E024]: a closed form is made of t", said)
        self.assertIn("scene.yaml:10:22: error[E024]: 'x_dot' is no column", said)

    def test_other_formulations_are_read_whole(self):
        said = self.mistake(SCENE + "formulations:\n  as given: {modle: other.yaml}\n  b: {strategy: treee}\n")
        self.assertIn("scene.yaml:11:3: error[E016]: 'as given' is the scene itself", said)
        self.assertIn("did you mean 'model'?", said)
        self.assertIn("scene.yaml:12:17: error[E015]", said)

    def test_times_must_have_values(self):
        self.assertIn("scene.yaml:6:11: error[E017]", self.mistake(SCENE.replace("2*pi*sqrt(m/k)", "-m")))
        self.assertIn("scene.yaml:6:11: error[E017]", self.mistake(SCENE.replace("2*pi*sqrt(m/k)", "2*nothing")))
        self.assertIn("error[E016]", self.mistake(SCENE + "every: 0.1\n"))
        self.assertIn("is the same time", self.mistake(SCENE + "start: 1e300\n"))
        self.assertIn("scene.yaml:6:11: error[E017]: the end is beyond", self.mistake(SCENE.replace("2*pi*sqrt(m/k)", "1e308") + "start: 1e308\n"))
        self.assertIn("scene.yaml:10:8: error[E017]: in float, ", self.mistake(SCENE + "start: 1e8\nnumber: float\n"))

    def test_what_does_not_go_together_has_its_place_all_at_once(self):
        said = self.mistake(SCENE + "method: verlet\nnumber: float\nprojection: energy\nstep: 0.1\nerror: 1e-3\nformulations: {b: {model: sprin.yaml}}\nexact: {x: 1/0}\n")
        for words in ("11:9: error[E016]: method 'verlet': it does not compute in float", "14:8: error[E016]: 'step' and 'error' exclude each other",
                      "15:27: error[E091]: there is no file 'sprin.yaml'", "did you mean 'spring.yaml'?", "16:12: error[E054]: the closed form of 'x' has no value"):
            self.assertIn(words, said)
        for choices, words in (("method: cvode_adams\nprojection: full\n", ["11:13: error[E016]: method 'cvode_adams': it does not project"]),
                               ("method: taylor\nprojection: energy\nengine: interpreted\n", ["11:13: error[E016]: method 'taylor': series take", "12:9: error[E016]: method 'taylor': it has no series"]),
                               ("number: float128\nprojection: velocities\n", ["11:13: error[E016]: in float128 there is full projection, or none"]),
                               ("projection: gains\nengine: interpreted\n", ["11:9: error[E016]: gains are for compiled models"])):
            said = self.mistake(SCENE + choices)
            self.assertEqual(said.count("error["), len(words), said)
            for one in words:
                self.assertIn(one, said)
        with self.subTest("beside an option, the scene has the place"):
            self.write("scene.yaml", SCENE + "number: float\n")
            self.assertIn("scene.yaml:10:9: error[E016]: method 'verlet'", self.refused(1, "run", "scene.yaml", "--method", "verlet"))

    def test_what_is_not_used_has_its_place(self):
        self.write("scene.yaml", SCENE + "step: 0.1\ngain: 3\n")
        said = self.run_it("run", "scene.yaml", "-q")
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertIn("scene.yaml:10:7: warning[W064]: a method that is chosen for the model takes its steps by the tolerance: the step is not used", said.stderr)
        self.assertIn("scene.yaml:11:7: warning[W064]: a gain is for 'projection: gains', and not used", said.stderr)

    def test_what_float_does_not_hold_is_refused(self):
        """It would be 0, or infinite, and all errors would be 0 as well."""
        for change in ("k=1e-50", "x=1e-50", "x_dot=1e50", "m=1e39"):
            self.assertIn(f"--number: float does not hold {change.split('=')[0].replace('x_dot', 'the rate of x')} = 1e", self.refused(2, "run", "spring.yaml", "--number", "float", "--set", change))
            self.ok("run", "spring.yaml", "-q", "--set", change)
        self.assertIn("scene.yaml:10:9: error[E017]: float does not hold x = 1e-50", self.mistake(SCENE.replace("initial: {", "initial: {x: 1e-50, ").replace("x: 1e-50, x: 0.5", "x: 1e-50") + "number: float\n"))

    def test_a_model_that_is_not_there_has_a_place_and_a_neighbour(self):
        self.write("spring.yaml", SPRING)
        said = self.mistake("gauss: 1\nmodel: sprin.yaml\n")
        self.assertIn(":2:8: error[E091]: there is no file 'sprin.yaml'", said)
        self.assertIn("did you mean 'spring.yaml'?", said)
        self.assertIn("nowhere.yaml", self.mistake(SCENE.replace("spring.yaml", "nowhere.yaml")))
        self.write("other.yaml", SCENE)
        self.assertIn("scene.yaml:2:8: error[E091]: 'other.yaml' is a scene itself", self.mistake("gauss: 1\nmodel: other.yaml\n"))

    def test_a_folder_is_no_model_and_no_outputs_are_no_table(self):
        self.write("scene.yaml", "gauss: 1\nscene: nothing\nmodel: .\noutputs: []\n")
        ended = self.run_it("run", "scene.yaml")
        self.assertEqual(ended.returncode, 1)
        for words in ("scene.yaml:3:8: error[E091]: '.' is a directory", "scene.yaml:4:10: error[E013]: there is no output in the list"):
            self.assertIn(words, ended.stderr)

    def test_time_for_no_search_is_said(self):
        self.write("spring.yaml", SPRING)
        said = self.run_it("run", "spring.yaml", "--budget", "5", "-q").stderr
        self.assertIn("warning: --budget is time of a search for a setting", said)
        self.assertNotIn("--budget", self.run_it("run", "spring.yaml", "--error", "1e-3", "--budget", "50", "-q").stderr)

    def test_what_a_method_does_not_do_is_said_and_nothing_is_written(self):
        self.assertIn("series take full projection", self.refused(2, "run", "spring.yaml", "--method", "taylor", "--projection", "energy"))
        self.assertIn("it does not compute in float128", self.refused(2, "run", "spring.yaml", "--method", "fehlberg78", "--number", "float128"))
        self.assertIn("the model has no constraints", self.refused(2, "run", "spring.yaml", "--projection", "velocities"))
        self.assertIn("interpreted", self.refused(2, "run", "spring.yaml", "--method", "taylor", "--engine", "interpreted"))

    def test_wrong_options_are_usage(self):
        for words in (("--method", "dopri6"), ("--duration", "-1"), ("--samples", "1"), ("--outputs", "y"), ("--set", "y=1"), ("--duration", "2*")):
            self.assertNotEqual(self.refused(2, "run", "spring.yaml", *words), "", words)

    def test_a_time_that_an_option_says_wrong_is_told_of_the_option(self):
        self.write("scene.yaml", SCENE)
        for words, why in ((("--every", "20"), "this makes 1 samples"), (("--every", "0"), "must be a number above 0"), (("--start", "nonsense"), "must be a number; it may be made of"),
                           (("--start", "1e300"), "is the same time"), (("--duration", "-m"), "must be a number above 0"), (("--duration", "1/0"), "--duration")):
            for file in ("spring.yaml", "scene.yaml"):
                with self.subTest((file, words)):
                    said = self.refused(2, "run", file, *words)
                    self.assertIn(f"{words[0]}", said)
                    self.assertIn(why, said)
                    self.assertNotIn(f"{file}:", said)


if __name__ == "__main__":
    unittest.main()
