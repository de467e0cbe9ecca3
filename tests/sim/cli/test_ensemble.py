"""gauss-sim ensemble: trajectories against closed forms, the same for any number of threads, and what is written."""

import csv
import json
import math
import os
import signal
import statistics
import subprocess
import unittest

from gauss_sim import MODELS, PROGRAM, SPRING, Program

# k follows m, so that x = x_0 cos(w t) whatever m is.
TUNED = SPRING.replace("k: {value: 8, unit: N/m}", "w: {value: 2, unit: rad/s}\n  k: {value: m*w^2, unit: N/m}")

SCENE = """gauss: 1
scene: many
model: spring.yaml
duration: 5
outputs: [x, x_dot]
ensemble:
  trajectories: 50
  seed: 3
  parameters: {m: {uniform: [1, 3]}, k: {log_uniform: [4, 16]}}
  initial: {x: {normal: [1, 0.1]}, x_dot: {values: [-1, 1]}}
"""

# Straight into a sun: from rest at x after pi/2 sqrt(x^3/2).
FALL = """gauss: 1
name: fall
parameters: {p: 1}
coordinates:
  x: {initial: 1, initial_rate: sqrt(p)}
particles:
  stone: {mass: 1, position: [x, 0, 0]}
forces:
  sun: {potential: -1/sqrt(x^2)}
"""

NO_LANES = {**os.environ, "CXX": "", "PATH": "/nowhere"}

# A car on one track: its speed across the rear axle is 0, but for rounding.
CAR = """gauss: 1
name: car
parameters:
  m: {value: 500, unit: kg}
  J: {value: 600, unit: kg*m^2}
  b: {value: 2.6, unit: m}
  pace: {value: 0.8, unit: rad/s}
  swing: {value: 0.3, unit: rad}
coordinates: {steer: {unit: rad, held_at: swing*sin(pace*t)}}
joints:
  floor: {type: planar, child: car, coordinates: [x, y, yaw], initial: [0, 0, 0.2]}
  head: {type: revolute, parent: car, child: fork, at: [b, 0, 0], coordinates: steer}
points:
  front: {on: fork, at: [0, 0, 0]}
  rear: {on: car, at: [0, 0, 0]}
bodies:
  car: {mass: m, inertia: [0, 0, J], centre: [1.4, 0, 0]}
constraints:
  front_grip: {no_slip: fork, at: front, direction: y, in: fork}
  rear_grip: {no_slip: car, at: rear, direction: y, in: car}
forces:
  engine: {force: [200, 0, 0], on: rear, in: car}
speeds:
  u: {is: dot(x)*cos(yaw) + dot(y)*sin(yaw), unit: m/s, initial: 5}
  w: {is: dot(y)*cos(yaw) - dot(x)*sin(yaw), unit: m/s}
"""


class Ensembles(Program):
    def rows(self, name="many.ensemble.csv"):
        with open(self.folder / name, encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def numbers(self, row):
        return {key: float(value) for key, value in row.items() if key != "status" and value != ""}

    def run_ensemble(self, text, *options, model=SPRING, **more):
        self.write("spring.yaml", model)
        self.write("scene.yaml", text)
        return self.ok("ensemble", "scene.yaml", "-q", *options, **more)

    def bytes_with(self, text, *options, **more):
        self.run_ensemble(text, "-o", "table.csv", *options, **more)
        return (self.folder / "table.csv").read_bytes()


class Motions(Ensembles):
    def off(self, row):
        """From the closed form."""
        n = self.numbers(row)
        w = math.sqrt(n["parameters.k [N/m]"] / n["parameters.m [kg]"])
        a, b, t = n["initial.x [m]"], n["initial.x_dot [m/s]"] / w, n["t [s]"]
        x = a * math.cos(w * t) + b * math.sin(w * t)
        v = w * (b * math.cos(w * t) - a * math.sin(w * t))
        return max(abs(n["x [m]"] - x), abs(n["x_dot [m/s]"] - v))

    def test_what_is_said_names_the_scene(self):
        self.write("spring.yaml", SPRING)
        self.write("scene.yaml", SCENE)
        self.assertRegex(self.ok("ensemble", "scene.yaml"), r"^many: 100 trajectories by ")

    def test_each_trajectory_is_its_closed_form(self):
        for options in ((), ("--lanes", "1"), ("--method", "fehlberg78"), ("--number", "long-double")):
            self.run_ensemble(SCENE, *options)
            rows = self.rows()
            self.assertEqual([int(row["trajectory"]) for row in rows], list(range(100)))
            self.assertLess(max(map(self.off, rows)), 2e-7, options)

    def test_samples_are_the_closed_form(self):
        for lanes in ("auto", "1"):
            self.run_ensemble(SCENE, "--every-sample", "--samples", "41", "--lanes", lanes)
            rows = self.rows()
            self.assertEqual(len(rows), 100 * 41)
            self.assertEqual([float(row["t [s]"]) for row in rows[:41]], [5 * k / 40 for k in range(41)])
            self.assertLess(max(map(self.off, rows)), 2e-7, lanes)

    def test_a_formula_follows_what_is_drawn(self):
        text = SCENE.replace(", k: {log_uniform: [4, 16]}", "").replace(", x_dot: {values: [-1, 1]}", "")
        self.run_ensemble(text, model=TUNED)
        rows = self.rows()
        self.assertEqual(len({row["parameters.m [kg]"] for row in rows}), 50)
        for row in map(self.numbers, rows):
            self.assertAlmostEqual(row["x [m]"], row["initial.x [m]"] * math.cos(10), delta=1e-7)

    def test_a_formula_may_be_varied_itself(self):
        text = SCENE.replace("m: {uniform: [1, 3]}, k: {log_uniform: [4, 16]}", "k: {values: [2, 32]}").replace("  trajectories: 50\n", "")
        self.run_ensemble(text.replace("{normal: [1, 0.1]}", "{values: [1]}").replace(", x_dot: {values: [-1, 1]}", ""), model=TUNED)
        for row, w in zip(map(self.numbers, self.rows()), (1, 4)):
            self.assertAlmostEqual(row["x [m]"], math.cos(5 * w), delta=1e-7)

    def test_starts_are_put_on_the_constraints(self):
        self.write("scene.yaml", f"gauss: 1\nscene: bars\nmodel: {json.dumps(str(MODELS / 'four_bar.yaml'))}\nduration: 0.5\noutputs: [state, energy]\n"
                                 "ensemble: {initial: {alpha: {sweep: {from: 0.4, to: 0.9, count: 6}}}}\n")
        self.ok("ensemble", "scene.yaml", "-q")
        many = self.rows("bars.ensemble.csv")
        for row in many:
            start = row["initial.alpha [rad]"]
            self.ok("run", MODELS / "four_bar.yaml", "--set", f"alpha={start}", "--duration", "0.5", "--samples", "2", "--outputs", "state,energy",
                    "-o", "one.csv", "-q")
            for name, values in self.table("one.csv").items():
                self.assertAlmostEqual(float(row[name]), values[-1], delta=1e-7, msg=(start, name))

    def test_a_mechanism_that_cannot_be_assembled_in_the_middle_of_its_values_runs_elsewhere(self):
        self.write("scene.yaml", f"gauss: 1\nscene: bars\nmodel: {json.dumps(str(MODELS / 'four_bar.yaml'))}\nduration: 0.1\n"
                                 "ensemble: {parameters: {L3: {values: [0.5, 9, 0.51]}}}\n")
        self.ok("ensemble", "scene.yaml", "-q")
        self.assertEqual([row["status"] for row in self.rows("bars.ensemble.csv")], ["finished", "no initial state", "finished"])

    def test_inputs_vary_too(self):
        model = SPRING + "inputs:\n  push: {value: 0, unit: N}\n"
        model = model.replace("forces:\n", "forces:\n  hand: {generalized: {x: push}}\n")
        text = SCENE[:SCENE.index("ensemble:")] + "ensemble: {inputs: {push: {values: [0, 4]}}, initial: {x: {values: [0]}}}\n"
        self.run_ensemble(text, model=model)
        still, pushed = map(self.numbers, self.rows())
        self.assertAlmostEqual(still["x [m]"], 0, delta=1e-9)
        self.assertAlmostEqual(pushed["x [m]"], 0.5 * (1 - math.cos(10)), delta=1e-7)


class Sameness(Ensembles):
    def test_threads_change_nothing(self):
        for options in ((), ("--lanes", "1"), ("--every-sample", "--samples", "4"), ("--method", "prince87"), ("--number", "long-double"), ("--number", "float"),
                        ("--engine", "interpreted"), ("--projection", "off")):
            tables = {self.bytes_with(SCENE, "--threads", threads, *options) for threads in ("1", "2", "3")}
            self.assertEqual(len(tables), 1, options)

    def test_threads_change_nothing_where_trajectories_stop(self):
        text = SCENE.replace("outputs: [x, x_dot]", "outputs: [x]").replace("spring.yaml", "fall.yaml")
        text = text[:text.index("ensemble:")] + "ensemble: {trajectories: 60, initial: {x: {uniform: [1, 4]}, x_dot: {values: [0]}}}\n"
        self.write("fall.yaml", FALL)
        tables = {self.bytes_with(text, "--threads", threads) for threads in ("1", "2", "3")}
        self.assertEqual(len(tables), 1)

    def test_lanes_stay_within_the_tolerance(self):
        text = SCENE.replace("[x, x_dot]", "[x, x_dot, energy]")
        self.run_ensemble(text, "--lanes", "1", "-o", "one.csv")
        self.run_ensemble(text, "-o", "lanes.csv")
        self.assertGreater(self.summary("lanes.json")["lanes"], 1)
        self.assertEqual(self.summary("lanes.json")["left_lanes"], 0)
        for one, lanes in zip(self.rows("one.csv"), self.rows("lanes.csv")):
            for (name, a), b in zip(self.numbers(one).items(), self.numbers(lanes).values()):
                self.assertAlmostEqual(a, b, delta=1e-7, msg=name)

    def test_motions_from_rest_whose_series_have_few_terms_keep_their_energy(self):
        """x'' = F - x^n from rest at 0 has terms t^2, t^(2n+2), and so on: v^2/2 - F x + x^(n+1)/(n+1) stays 0, and x between 0 and ((n+1) F)^(1/n)."""
        for n, tolerance, most in ((3, "1e-6", 1e-4), (3, "1e-9", 1e-6), (5, "1e-6", 1e-3), (5, "1e-8", 1e-4), (7, "1e-6", 2e-3), (7, "1e-9", 1e-5), (7, "1e-12", 1e-8)):
            for lanes in ("1", "auto"):
                with self.subTest((n, tolerance, lanes)):
                    model = f"""gauss: 1
name: spring
parameters: {{k: {{value: 1, unit: N/m^{n}}}, F: {{value: 10, unit: N}}, m: {{value: 1, unit: kg}}}}
coordinates: {{x: {{unit: m}}}}
particles: {{p: {{mass: m, position: [x, 0, 0]}}}}
forces: {{f: {{generalized: {{x: F - k*x^{n}}}}}}}
"""
                    forces = [5, 6, 7, 8, 9, 10, 11, 12, 20]
                    self.run_ensemble(f"gauss: 1\nscene: many\nmodel: spring.yaml\nduration: 20\ntolerance: {tolerance}\nensemble:\n  parameters:\n    F: {{values: {forces}}}\n",
                                      "--lanes", lanes, "--outputs", "state", model=model)
                    rows = [self.numbers(row) for row in self.rows()]
                    self.assertEqual(len(rows), len(forces))
                    for force, row in zip(forces, rows):
                        x, v = row["x [m]"], row["x_dot [m/s]"]
                        self.assertLess(abs(v * v / 2 - force * x + x ** (n + 1) / (n + 1)), most * force)
                        self.assertTrue(-1e-3 < x < 1.001 * ((n + 1) * force) ** (1 / n))

    def test_a_force_that_jumps_without_a_word_is_passed_within_the_tolerance(self):
        """A mass on a line passes the end of its spring, which is sqrt(x^2) long: E = v^2/2 + k (|x| - L)^2/2 stays what it was."""
        model = """gauss: 1
name: passes
parameters: {m: {value: 1, unit: kg}, k: {value: 40, unit: N/m}, L: {value: 0.5, unit: m}}
coordinates: {x: {unit: m, initial: 0.7}}
points: {anchor: {on: space, at: [0, 0, 0]}}
particles: {p: {mass: m, position: [x, 0, 0]}}
forces: {spring: {spring: [anchor, p], stiffness: k, length: L}}
"""
        scene = "gauss: 1\nscene: many\nmodel: passes.yaml\nduration: 4\nensemble:\n  initial:\n    x_dot: {sweep: {from: -12, to: -4, count: 9}}\n"
        for lanes in ("1", "auto"):
            self.write("passes.yaml", model)
            self.write("many.yaml", scene)
            self.ok("ensemble", "many.yaml", "-q", "--lanes", lanes, "--method", "taylor", "--outputs", "state", "-o", f"{lanes}.csv")
            self.assertEqual(self.summary(f"{lanes}.json").get("left_lanes", 0), 0)
            for speed, row in zip(range(-12, -3), self.rows(f"{lanes}.csv")):
                x, v = self.numbers(row)["x [m]"], self.numbers(row)["x_dot [m/s]"]
                energy = speed * speed / 2 + 20 * 0.2**2
                self.assertLess(abs(v * v / 2 + 20 * (abs(x) - 0.5) ** 2 - energy), 3e-7 * energy)

    def test_roots_of_squares_jump(self):
        """A ball thrown up through a height above which its weight is another one, and back within a step of its series."""
        self.write("hop.yaml", """gauss: 1
name: hop
coordinates: {y: {initial: 0, initial_rate: 5}}
particles: {p: {mass: 1, position: [0, y, 0]}}
forces: {f: {generalized: {y: "-9.81 - 5*(y - 2.5)/sqrt((y - 2.5)^2)"}}}
""")
        self.write("hops.yaml", "gauss: 1\nscene: hops\nmodel: hop.yaml\nduration: 2.5\noutputs: [y]\nensemble: {initial: {y_dot: {sweep: {from: 4.95, to: 5.1, count: 8}}}}\n")
        self.ok("ensemble", "hops.yaml", "-q", "-o", "hops.csv")
        below, above = 9.81 - 5, 9.81 + 5
        for row in map(self.numbers, self.rows("hops.csv")):
            speed = row["initial.y_dot"]
            up = math.sqrt(speed**2 - 2 * below * 2.5)  # at the height, up and down
            left = 2.5 - (speed - up) / below - 2 * up / above
            self.assertAlmostEqual(row["y"], 2.5 - up * left - below * left**2 / 2, delta=1e-6)
        said = self.run_it("run", "hop.yaml", "--method", "taylor", "--duration", "2.5", "-q").stderr
        self.assertIn("'taylor' may step over a place where a force jumps, as by sqrt, without a word", said)

    def test_speeds_that_constraints_hold_at_0_keep_no_lane_back(self):
        """What rounding leaves of them is no size that a tolerance could be a part of."""
        self.write("car.yaml", CAR)
        self.write("cars.yaml", "gauss: 1\nscene: cars\nmodel: car.yaml\noutputs: [x, y, yaw]\nensemble: {trajectories: 64, seed: 3, parameters: {m: {uniform: [400, 700]}}}\n")
        for lanes, name in (("1", "one"), ("auto", "lanes")):
            self.ok("ensemble", "cars.yaml", "-q", "--lanes", lanes, "-o", f"{name}.csv")
        summary = self.summary("lanes.json")
        self.assertGreater(summary["lanes"], 1)
        self.assertEqual(summary["left_lanes"], 0)
        for one, other in zip(self.rows("one.csv"), self.rows("lanes.csv")):
            for (name, a), b in zip(self.numbers(one).items(), self.numbers(other).values()):
                self.assertAlmostEqual(a, b, delta=1e-6, msg=name)

    def test_a_trajectory_is_the_same_among_more(self):
        for lanes in ("1", "auto"):
            few = self.bytes_with(SCENE, "--trajectories", "20", "--lanes", lanes)
            many = self.bytes_with(SCENE, "--trajectories", "64", "--lanes", lanes)
            self.assertEqual(many[: len(few)], few, lanes)

    def test_another_seed_is_another_ensemble(self):
        first, again = self.bytes_with(SCENE), self.bytes_with(SCENE)
        self.assertEqual(first, again)
        self.assertNotEqual(first, self.bytes_with(SCENE, "--seed", "4"))

    def test_without_a_compiler_there_are_no_lanes(self):
        self.run_ensemble(SCENE, env=NO_LANES)
        summary = self.summary("many.ensemble.json")
        self.assertEqual((summary["lanes"], summary["engine"], summary["method"]), (1, "interpreted", "prince87"))


class Stopping(Ensembles):
    def fall(self, varied, *options, duration="2"):
        self.write("fall.yaml", FALL)
        self.write("scene.yaml", f"gauss: 1\nscene: falls\nmodel: fall.yaml\nduration: {duration}\noutputs: [x]\nensemble: {varied}\n")
        return self.run_it("ensemble", "scene.yaml", "-q", *options)

    def test_one_that_stops_does_not_stop_the_others(self):
        for lanes in ("1", "auto"):
            result = self.fall("{initial: {x: {values: [4, 1, 5, 1.1, 6]}, x_dot: {values: [0]}}}", "--lanes", lanes)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn("2 of 5 trajectories did not arrive", result.stderr)
            rows = self.rows("falls.ensemble.csv")
            self.assertEqual([row["status"] == "finished" for row in rows], [True, False, True, False, True])
            for row, x in ((rows[1], 1), (rows[3], 1.1)):
                self.assertLess(float(row["t [s]"]), math.pi / 2 * math.sqrt(x**3 / 2) + 1e-3)
                self.assertGreater(float(row["t [s]"]), 0.5)
            counts = self.summary("falls.ensemble.json")["by_status"]
            self.assertEqual(counts["finished"], 3)
            self.assertEqual(sum(counts.values()), 5)

    def test_one_without_a_start_has_no_numbers(self):
        for lanes in ("1", "auto"):
            result = self.fall("{parameters: {p: {values: [3, 4, -1, 6, 7]}}}", "--lanes", lanes, duration="0.1")
            self.assertEqual(result.returncode, 0, result.stderr)
            rows = self.rows("falls.ensemble.csv")
            self.assertEqual([row["status"] for row in rows], ["finished"] * 2 + ["no initial state"] + ["finished"] * 2)
            self.assertEqual((rows[2]["x"], rows[2]["t [s]"]), ("", "0"))
            self.assertEqual(self.summary("falls.ensemble.json")["statistics"][0]["count"], 4)

    def test_where_none_arrives_the_program_says_so(self):
        result = self.fall("{initial: {x: {values: [1, 1.1]}, x_dot: {values: [0]}}}")
        self.assertEqual(result.returncode, 5)
        self.assertEqual(len(self.rows("falls.ensemble.csv")), 2)
        self.assertEqual(self.summary("falls.ensemble.json")["statistics"][0], {"output": "x", "unit": "", "count": 0})

    def test_ctrl_c_leaves_what_is_finished(self):
        self.write("spring.yaml", SPRING)
        self.write("scene.yaml", SCENE.replace("trajectories: 50", "trajectories: 1000000"))
        for options in (("--method", "rk4", "--step", "1e-3"), ("--duration", "500"), ("--lanes", "1", "--every-sample", "--samples", "3")):
            with self.subTest(options):
                code, said = self.stopped_while_writing("many.ensemble.csv.*", "ensemble", "scene.yaml", "--threads", "4", "-q", *options)
                self.assertEqual(code, 130, said)
                self.assertIn("interrupted", said)
                rows, summary = self.rows(), self.summary("many.ensemble.json")
                self.assertEqual(summary["outcome"], "interrupted")
                self.assertGreater(len(rows), 0)
                with self.subTest("the first ones, without gaps"):
                    samples = 3 if "--samples" in options else 1
                    self.assertEqual([int(row["trajectory"]) for row in rows], [k // samples for k in range(len(rows))])
                    self.assertEqual((len(rows), summary["by_status"]), (samples * summary["run"], {"finished": summary["run"]}))
                    self.assertEqual(summary["statistics"][0]["count"], summary["run"])
                self.assertLess(summary["run"], 2000000)
                self.assertEqual(self.files(), ["many.ensemble.csv", "many.ensemble.json", "scene.yaml", "spring.yaml"])

    def test_ctrl_c_while_draws_are_checked_leaves_nothing(self):
        self.write("spring.yaml", SPRING)
        self.write("scene.yaml", SCENE.replace("trajectories: 50", "trajectories: 5000000"))
        process = subprocess.Popen([PROGRAM, "ensemble", "scene.yaml", "-q"], cwd=self.folder, stderr=subprocess.PIPE, text=True)
        self.wait_for_processor(process, 0.5)
        process.send_signal(signal.SIGINT)
        said = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, 130, said)
        self.assertIn("interrupted; nothing is written", said)
        self.assertEqual(self.files(), ["scene.yaml", "spring.yaml"])


class Writing(Ensembles):
    def test_the_summary_has_the_statistics_of_the_table(self):
        self.run_ensemble(SCENE)
        rows, summary = self.rows(), self.summary("many.ensemble.json")
        self.assertEqual([one["output"] for one in summary["statistics"]], ["x", "x_dot"])
        for one, name in zip(summary["statistics"], ("x [m]", "x_dot [m/s]")):
            values = [float(row[name]) for row in rows]
            self.assertEqual((one["count"], one["least"], one["most"]), (100, min(values), max(values)))
            self.assertAlmostEqual(one["mean"], statistics.mean(values), delta=1e-13)
            self.assertAlmostEqual(one["deviation"], statistics.stdev(values), delta=1e-13)
            expected = statistics.quantiles(values, n=20, method="inclusive")
            for quantile in one["quantiles"]:
                self.assertAlmostEqual(quantile["value"], expected[round(quantile["share"] * 20) - 1], delta=1e-13)

    def test_the_terminal_has_the_statistics_of_the_summary(self):
        self.write("spring.yaml", SPRING)
        self.write("s.yaml", "gauss: 1\nscene: some\nmodel: spring.yaml\noutputs: [x]\nensemble: {parameters: {k: {values: [2, 8, 18]}}}\n")
        said = self.ok("ensemble", "s.yaml").splitlines()
        self.assertTrue(said[0].startswith("some: 3 trajectories by"), said)
        self.assertEqual(said[2].split(), ["at", "the", "end", "mean", "deviation", "least", "median", "most"])
        statistics = self.summary("some.ensemble.json")["statistics"][0]
        name, unit, *numbers = said[3].split()
        self.assertEqual((name, unit), ("x", "[m]"))
        wanted = [statistics[key] for key in ("mean", "deviation", "least")] + [statistics["quantiles"][2]["value"], statistics["most"]]
        for shown, value in zip(map(float, numbers), wanted, strict=True):
            self.assertAlmostEqual(shown, value, delta=1e-3 * abs(value))

    def test_the_summary_says_how_it_went(self):
        self.run_ensemble(SCENE, "--threads", "2", "--tolerance", "1e-8")
        summary = self.summary("many.ensemble.json")
        self.assertEqual((summary["outcome"], summary["trajectories"], summary["run"], summary["seed"]), ("finished", 100, 100, 3))
        self.assertEqual((summary["threads"], summary["tolerance"], summary["method"], summary["record"]), (2, 1e-8, "taylor", "end"))
        self.assertEqual(summary["by_status"], {"finished": 100})
        self.assertEqual([one["name"] for one in summary["varied"]], ["m", "k", "x", "x_dot"])
        self.assertAlmostEqual(summary["trajectories_per_s"] * summary["seconds"]["run"], 100, delta=1e-6)
        self.assertAlmostEqual(summary["steps_per_s"] * summary["seconds"]["run"], summary["steps"], delta=1e-3)

    def test_sweeps_are_grids(self):
        text = SCENE[:SCENE.index("ensemble:")] + (
            "ensemble:\n  parameters: {k: {sweep: {from: 1, to: 100, count: 3, spacing: logarithmic}}}\n"
            "  initial: {dot(x): {sweep: {from: -1, to: 1, count: 3}}}\n")
        self.run_ensemble(text)
        pairs = [(row["parameters.k [N/m]"], row["initial.x_dot [m/s]"]) for row in self.rows()]
        self.assertEqual([(float(k), float(v)) for k, v in pairs],
                         [(k, v) for k in (1, 10.000000000000002, 100) for v in (-1, 0, 1)])

    def test_a_model_is_compiled_once_whatever_is_varied_to(self):
        self.run_ensemble(SCENE)
        self.run_ensemble(SCENE.replace("[1, 3]", "[2, 4]").replace("seed: 3", "seed: 9"))
        self.assertTrue(self.summary("many.ensemble.json")["seconds"]["cached"])

    def test_the_shipped_scene_runs(self):
        self.ok("ensemble", MODELS.parent / "examples/scenes/balls_in_cylinders.yaml", "--trajectories", "8", "-q")
        rows = self.rows("balls_in_cylinders.ensemble.csv")
        self.assertEqual({row["status"] for row in rows}, {"finished"})

    def test_standard_output_takes_the_table(self):
        lines = self.run_ensemble(SCENE, "-o", "-").splitlines()
        self.assertEqual(len(lines), 101)
        self.assertEqual(self.files(), ["scene.yaml", "spring.yaml"])


if __name__ == "__main__":
    unittest.main()
