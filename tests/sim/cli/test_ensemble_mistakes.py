"""What is wrong with ensembles: each is said with its place, and nothing is written."""

import json
import unittest

from gauss_sim import SPRING, Program

HEAD = """gauss: 1
scene: many
model: spring.yaml
duration: 1
"""


class Mistakes(Program):
    def setUp(self):
        super().setUp()
        self.write("spring.yaml", SPRING)

    def mistake(self, ensemble, *options, code=1, head=HEAD):
        self.write("scene.yaml", head + ensemble)
        return self.refused(code, "ensemble", "scene.yaml", *options)

    def one(self, distribution, *said, name="m", section="parameters", more="trajectories: 3, "):
        text = self.mistake(f"ensemble: {{{more}{section}: {{{name}: {distribution}}}}}\n")
        for words in said:
            self.assertIn(words, text, distribution)

    def test_distributions(self):
        self.one("{uniform: [2, 1]}", "scene.yaml:5:55: error[E017]: the first number must be below the second one")
        self.one("{uniform: [1, 1]}", "error[E017]")
        self.one("{uniform: [1]}", "error[E013]")
        self.one("{uniform: 1}", "error[E012]", "a list of two numbers")
        self.one("{uniform: [1, q]}", "error[E017]: expected a number, which may be made of numbers and pi")
        self.one("{uniform: [1, 2*]}", "error[E033]")
        self.one("{uniform: [1, 1/0]}", "error[")
        self.one("{normal: [1, 0]}", "error[E017]: a standard deviation is above 0")
        self.one("{normal: [1, -1]}", "error[E017]: a standard deviation is above 0")
        self.one("{log_uniform: [0, 1]}", "error[E017]: only numbers above 0 have a logarithm")
        self.assertEqual(self.mistake("ensemble: {trajectories: 3, parameters: {m: {log_uniform: [-1, 2]}}}\n").count("error["), 1)
        self.one("{unifrom: [1, 2]}", "error[E010]", "did you mean 'uniform'?")
        self.one("{uniform: [1, 2], normal: [1, 2]}", "error[E016]: 'uniform' and 'normal' exclude each other")
        self.one("{}", "error[E011]: 'm' does not say how it varies")
        self.one("2", "error[E012]")

    def test_sweeps(self):
        for sweep, said in (("{from: 1, to: 2}", "error[E011]"), ("{from: 1, to: 1, count: 3}", "error[E017]: a sweep has two different ends"),
                            ("{from: 1, to: 2, count: 1}", "error[E017]: expected a whole number from 2"),
                            ("{from: 1, to: 2, count: 2.5}", "error[E017]"), ("{from: 1, count: 3}", "error[E011]"),
                            ("{from: 0, to: 2, count: 3, spacing: logarithmic}", "only numbers above 0 have a logarithm"),
                            ("{from: 1, to: 2, count: 3, spacing: log}", "error[E015]: there is no spacing 'log'"),
                            ("{from: 1, to: 2, number: 3}", "error[E010]"), ("[1, 2]", "error[E012]")):
            self.one(f"{{sweep: {sweep}}}", said, more="")
        self.one("{values: []}", "error[E013]", more="")
        self.one("{values: 3}", "error[E012]", more="")

    def test_numbers_of_trajectories(self):
        self.assertIn("E011]: the ensemble does not say how many values are drawn", self.mistake("ensemble: {parameters: {m: {uniform: [1, 2]}}}\n"))
        self.assertIn("E016]: nothing is drawn", self.mistake("ensemble: {trajectories: 3, parameters: {m: {values: [1, 2]}}}\n"))
        self.assertIn("E011]: the ensemble varies nothing", self.mistake("ensemble: {trajectories: 3}\n"))
        self.one("{uniform: [1, 2]}", "error[E017]", more="trajectories: 0, ")
        self.one("{uniform: [1, 2]}", "error[E017]", more="trajectories: 10000001, ")
        self.one("{uniform: [1, 2]}", "error[E017]", more="trajectories: 3, seed: -1, ")
        self.one("{uniform: [1, 2]}", "error[E015]: there is no record 'all'", more="trajectories: 3, record: all, ")
        self.one("{uniform: [1, 2]}", "error[E010]", "did you mean 'trajectories'?", more="trajectorys: 3, ")
        grid = "{sweep: {from: 1, to: 2, count: 10000}}"
        self.assertIn("E017]: these are 1e+08 trajectories; there may be 10000000",
                      self.mistake(f"ensemble: {{parameters: {{m: {grid}, k: {grid}}}}}\n"))

    def test_names(self):
        ok = "{uniform: [1, 2]}"
        self.one(ok, "scene.yaml:5:42: error[E024]: 'mm' is no parameter of the model", "did you mean 'm'?", name="mm")
        self.one(ok, "error[E024]: 'x' is no parameter", name="x")
        self.one(ok, "error[E024]: 'm' has no initial value", "it belongs under 'parameters'", section="initial")
        self.one(ok, "error[E024]: the model has no 'x_dott'", "did you mean 'x_dot'?", section="initial", name="x_dott")
        self.one(ok, "error[E024]: 'm' is no input", section="inputs")

    def test_what_the_scene_gives_is_not_varied(self):
        text = self.mistake("ensemble: {trajectories: 3, parameters: {m: {uniform: [1, 2]}}}\n", head=HEAD + "parameters: {m: 1}\n")
        self.assertIn("scene.yaml:6:42: error[E016]: 'm' has a value under 'parameters' of the scene", text)
        self.assertIn("--set m", self.mistake("ensemble: {trajectories: 3, parameters: {m: {uniform: [1, 2]}}}\n", "--set", "m=2", code=2))

    def test_one_quantity_is_not_varied_twice(self):
        self.assertIn("x_dot", self.mistake("ensemble: {initial: {x_dot: {values: [1]}, dot(x): {values: [2]}}}\n"))

    def test_all_mistakes_are_said_at_once(self):
        text = self.mistake("ensemble:\n  seed: x\n  parameters:\n    m: {uniform: [2, 1]}\n    k: {sweep: {from: 1}}\n  initial: {x: {}}\n",
                            head=HEAD.replace("duration: 1", "durations: 1"))
        for place in ("4:1: error[E010]", "6:9: error", "8:18: error[E017]", "9:9: error[E011]", "10:13: error[E011]"):
            self.assertIn("scene.yaml:" + place, text)
        text = self.mistake("ensemble: {parameters: {mm: {values: [1]}}, initial: {y: {values: [2]}}}\n")
        self.assertEqual(text.count("error[E024]"), 2, text)

    def test_values_that_no_model_has_are_found_before_anything_runs(self):
        text = self.mistake("ensemble:\n  trajectories: 1000\n  parameters:\n    k: {uniform: [1, 2]}\n    m: {normal: [1, 1]}\n")
        self.assertIn("scene.yaml:9:5: error[E055]: trajectory ", text)
        self.assertRegex(text, r"m = -[0-9.]+: .*\(and 1[0-9]{2} more\)")
        self.one("{values: [1, -1]}", "error[E055]: trajectory 1 cannot be, with m = -1", more="")

    def test_a_formula_without_a_value_is_found_too(self):
        self.write("spring.yaml", SPRING.replace("k: {value: 8, unit: N/m}", "p: 1\n  k: sqrt(p)"))
        self.assertIn("scene.yaml:5:25: error[E054]: trajectory 0 cannot be, with p = -1: 'k' is not a real number",
                      self.mistake("ensemble: {parameters: {p: {values: [-1, 2, 3]}}}\n"))

    def test_a_file_without_an_ensemble_is_refused(self):
        self.assertIn("'ensemble'", self.mistake("", code=2))
        self.assertIn("'ensemble'", self.refused(2, "ensemble", "spring.yaml"))

    def test_options(self):
        text = "ensemble: {trajectories: 3, parameters: {m: {uniform: [1, 2]}}}\n"
        self.assertIn("one trajectory at a time", self.mistake(text, "--method", "rk4", "--lanes", "4", code=2))
        self.assertIn("lanes are of double", self.mistake(text, "--number", "long-double", "--lanes", "4", code=2))
        self.assertIn("one trajectory at a time", self.mistake(text, "--engine", "interpreted", "--lanes", "4", code=2))
        self.assertIn("--lanes 64: this processor has", self.mistake(text, "--lanes", "64", code=2))
        self.assertIn("auto", self.mistake(text, "--lanes", "many", code=2))
        self.assertIn("--seed", self.mistake(text, "--seed", "-1", code=2))
        self.assertIn("--threads", self.mistake(text, "--threads", "0", code=2))
        self.assertIn("--trajectories", self.mistake(text, "--trajectories", "0", code=2))
        self.assertIn("nothing is drawn", self.mistake("ensemble: {parameters: {m: {values: [1]}}}\n", "--trajectories", "5", code=2))

    def test_mistakes_are_json_where_somebody_asks(self):
        said = json.loads(self.mistake("ensemble: {trajectories: 3, parameters: {m: {uniform: [2, 1]}}}\n", "--diagnostics", "json"))
        self.assertIn("E017", json.dumps(said))

    def test_what_an_ensemble_does_not_use_is_said(self):
        text = "ensemble: {trajectories: 3, parameters: {m: {uniform: [1, 2]}}}\nerror: 1e-6\n"
        self.write("scene.yaml", HEAD + text)
        result = self.run_it("ensemble", "scene.yaml")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("warning: an error is for 'run'", result.stderr)

    def test_outputs_take_the_place_of_tables_alone(self):
        self.write("scene.yaml", HEAD + "ensemble: {trajectories: 3, parameters: {m: {uniform: [1, 2]}}}\n")
        for path, said in (("scene.yaml", "what the run reads"), ("spring.yaml", "what the run reads"), ("x.json", "where the summary goes"),
                           ("/dev/null", "no file that a table")):
            self.assertIn(said, self.refused(2, "ensemble", "scene.yaml", "-o", path), path)

    def test_what_a_method_does_not_do_is_said_and_nothing_is_written(self):
        text = "ensemble: {trajectories: 3, parameters: {m: {uniform: [1, 2]}}}\n"
        self.assertIn("series take full projection", self.mistake(text, "--method", "taylor", "--projection", "energy", code=2))


if __name__ == "__main__":
    unittest.main()
