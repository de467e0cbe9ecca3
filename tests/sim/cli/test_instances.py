"""Scenes with several bodies of one model: each moves as if it were alone, and those with the same effects share their code."""

import csv
import json
import math
import os
import random
import shutil
import signal
import subprocess
import time
import unittest

from gauss_sim import MODELS, PROGRAM, Program

G = 9.81

BALL = """gauss: 1
name: ball
parameters:
  m: {value: 0.5, unit: kg}
  h: {value: 1, unit: m}
  u: {value: 3, unit: m/s}
  v: {value: 2, unit: m/s}
  aside: {value: 0.3, unit: m, about: only starts mention it}
coordinates:
  x: {unit: m, initial_rate: u}
  y: {unit: m, initial: aside, initial_rate: 0}
  z: {unit: m, initial: h, initial_rate: v}
bodies: {ball: {mass: m, position: [x, y, z]}}
effects:
  gravity:
    default: on
    parameters: {g: {value: 9.81, unit: m/s^2}}
    forces: {weight: {uniform: [0, 0, -g]}}
  oil:
    parameters: {c: {value: 0.2, unit: kg/s}}
    forces: {oil: {drag: ball, linear: c}}
  wind:
    requires: [oil]
    inputs: {w: {value: 1, unit: N}}
    forces: {gust: {generalized: {x: w}}}
  spin:
    parameters: {k: {value: 0.01, unit: kg}, r: {value: 0.1, unit: m}, J: {value: 2/5*m*r^2, unit: kg*m^2}}
    orientations:
      attitude: {quaternion: [e0, e1, e2, e3], angular_velocity: [wx, wy, wz], frame: space, initial_angular_velocity: [1, -20, 2]}
    bodies: {ball: {inertia: J, orientation: attitude}}
    forces: {magnus: {magnus: ball, coefficient: k}}
"""

# By name: what the instance says, and the same scene written out by hand.
BODIES = {
    "near": ("{effects: [+oil, +spin], parameters: {c: 0.4}, initial: {x: 1, wz: 5}}",
             "effects: [gravity, oil, spin]\nparameters: {u: 4, c: 0.4}\ninitial: {x: 1, wz: 5}\n"),
    "blown": ("{effects: [+oil, +wind], inputs: {w: 2}, method: dopri5, tolerance: 1e-7}",
              "effects: [gravity, oil, wind]\nparameters: {u: 4}\ninputs: {w: 2}\nmethod: dopri5\ntolerance: 1e-7\n"),
    "plain": ("{}", "effects: gravity\nparameters: {u: 4}\n"),
    "far_1": ("{initial: {x: 50, z_dot: 7}, parameters: {u: 5}}",
              "effects: gravity\nparameters: {u: 5}\ninitial: {x: 50, z_dot: 7}\n"),
    "far_2": ("{initial: {y: 2*aside + h, x_dot: u/3}, parameters: {h: 0.7}}",
              "effects: gravity\nparameters: {u: 4, h: 0.7}\ninitial: {y: 2*aside + h, x_dot: u/3}\n"),
    "afloat": ("{effects: [-gravity], longest_step: 0.1}", "effects: none\nparameters: {u: 4}\nlongest_step: 0.1\n"),
    "heavy": ("{effects: oil, parameters: {m: 2, c: 0.9}}", "effects: oil\nparameters: {u: 4, m: 2, c: 0.9}\n"),
    "oiled": ("{effects: oil}", "effects: oil\nparameters: {u: 4}\n"),
    "steps": ("{effects: oil, method: rk4, step: 0.01}", "effects: oil\nparameters: {u: 4}\nmethod: rk4\nstep: 0.01\n"),
}
HEAD = "gauss: 1\nscene: balls\nmodel: ball.yaml\nduration: 1.5\nsamples: 16\n"


def scene(bodies, more="effects: gravity\nparameters: {u: 4}\n"):
    return HEAD + more + "instances:\n" + "".join(f"  {name}: {says}\n" for name, says in bodies.items())


class Instances(Program):
    def setUp(self):
        super().setUp()
        self.write("ball.yaml", BALL)

    def cells(self, name):
        """Columns as texts, by their names without units."""
        with open(self.folder / name, encoding="utf-8", newline="") as file:
            rows = list(csv.reader(file))
        return {head.split(" [")[0]: [row[i] for row in rows[1:]] for i, head in enumerate(rows[0])}

    def play(self, bodies, *options, **more):
        self.write("balls.yaml", scene(bodies, **more))
        self.ok("run", "balls.yaml", "-q", *options)
        return self.cells("balls.csv"), self.summary("balls.json")

    def events(self, name):
        with open(self.folder / name, encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))


class SameNumbers(Instances):
    """Of each instance, and of the scene that says for itself what it says."""

    def check(self, bodies, *options):
        table, summary = self.play({name: BODIES[name][0] for name in bodies}, *options)
        for name in bodies:
            self.write("alone.yaml", HEAD + BODIES[name][1])
            self.ok("run", "alone.yaml", "-q", "-o", "alone.csv", *options)
            alone, own = self.cells("alone.csv"), self.summary("alone.json")
            self.assertEqual(table["t"], alone.pop("t"))
            self.assertEqual({f"{name}.{key}": cells for key, cells in alone.items()},
                             {key: cells for key, cells in table.items() if key.startswith(name + ".")}, name)
            said = summary["instances"][name]
            for key in ("effects", "outcome", "method", "tolerance", "step", "longest_step", "steps", "rejected", "calls",
                        "drift", "error_estimate", "projection", "number", "reached", "samples"):
                self.assertEqual(said.get(key), own.get(key), (name, key))
        return table, summary

    def test_they_are_the_same_to_the_bit(self):
        self.check(BODIES)

    def test_interpreted_too(self):
        self.check(BODIES, "--engine", "interpreted")

    def test_in_other_number_types(self):
        for number in ("float", "long-double", "float128"):
            with self.subTest(number):
                self.check(["plain", "far_1", "far_2"], "--number", number)

    def test_with_folded_and_expanded_code(self):
        for code in ("folded", "expanded"):
            with self.subTest(code):
                self.check(["near", "plain", "far_1", "far_2", "heavy", "oiled"], "--code", code)

    def test_with_other_outputs(self):
        self.check(["near", "plain", "far_2"], "--outputs", "z,x_ddot,energy.kinetic,mass_matrix")

    def test_one_instance_alone_is_an_ordinary_scene(self):
        table, _ = self.play({name: says for name, (says, _) in BODIES.items()})
        for name in BODIES:
            self.ok("run", "balls.yaml", "-q", "--instance", name)
            alone = self.cells(f"balls.{name}.csv")
            self.assertEqual({f"{name}.{key}": cells for key, cells in alone.items() if key != "t"},
                             {key: cells for key, cells in table.items() if key.startswith(name + ".")})
            self.assertEqual(self.summary(f"balls.{name}.json")["instance"], name)

    def test_their_order_is_that_of_the_columns_and_nothing_else(self):
        table, summary = self.play({name: says for name, (says, _) in BODIES.items()})
        names = list(BODIES)
        for seed in range(3):
            random.Random(seed).shuffle(names)
            other, said = self.play({name: BODIES[name][0] for name in names})
            self.assertEqual(other, table)
            seen = list(dict.fromkeys(head.split(".")[0] for head in other if head != "t"))
            self.assertEqual(seen, names)
            for name in names:
                for key in ("steps", "calls", "error_estimate", "drift", "effects"):
                    self.assertEqual(said["instances"][name].get(key), summary["instances"][name].get(key))


    def test_shipped_models_do_too(self):
        """With other values of all parameters and another start: of trees, of loops, and of what rolls."""
        given = {"double_pendulum": ("{m1: 0.9, m2: 2.1, l1: 0.7}", "{pivot: 0.4}"), "kepler": ("{}", "{}"), "free_top": ("{A: 1.5}", "{}"),
                 "spring_pendulum": ("{}", "{}"), "sphere_in_cylinder": ("{R: 0.7, m: 0.7}", "{chi: 0.2}"),
                 "pendulum_cartesian": ("{L: 2}", "{y: -1.6}"), "lagrange_top_euler": ("{}", "{}"), "rolling_disc": ("{}", "{}")}
        for model, (parameters, initial) in given.items():
            with self.subTest(model):
                says = f"parameters: {parameters}\ninitial: {initial}\n"
                head = f"gauss: 1\nmodel: {MODELS / model}.yaml\nduration: 0.1\nsamples: 4\n"
                self.write("two.yaml", f"{head}scene: two\ninstances:\n  a: {{}}\n  b: {{parameters: {parameters}, initial: {initial}}}\n")
                self.write("one.yaml", f"{head}scene: one\n{says}")
                for scene_of in ("two", "one"):
                    self.ok("run", f"{scene_of}.yaml", "-q", "--engine", "interpreted")
                one, two = self.cells("one.csv"), self.cells("two.csv")
                self.assertEqual({"b." + key: cells for key, cells in one.items() if key != "t"},
                                 {key: cells for key, cells in two.items() if key.startswith("b.")})


class Codes(Instances):
    def compiled(self, bodies, **more):
        """How many libraries a run makes in an empty cache, and what it says."""
        cache = self.folder / "cache"
        shutil.rmtree(cache, ignore_errors=True)
        self.write("balls.yaml", scene(bodies, **more))
        said = self.ok("run", "balls.yaml", env={**os.environ, "XDG_CACHE_HOME": str(cache)})
        return len(list((cache / "gauss").glob("*/model.so"))), said, self.summary("balls.json")

    def test_each_set_is_derived_and_compiled_once(self):
        bodies = {"near": "{effects: [+oil]}", "also_near": "{effects: [gravity, oil], parameters: {c: 0.3}}"}
        bodies |= {f"far_{k}": f"{{initial: {{x: {k}, y: aside*{k}}}, parameters: {{m: {k + 1}}}}}" for k in range(20)}
        libraries, said, summary = self.compiled(bodies)
        self.assertEqual((libraries, summary["derivations"], len(summary["codes"])), (2, 2, 2))
        self.assertEqual([code["instances"] for code in summary["codes"]],
                         [["near", "also_near"], [f"far_{k}" for k in range(20)]])
        self.assertEqual([code["effects"] for code in summary["codes"]], [["gravity", "oil"], ["gravity"]])
        self.assertEqual({one["code"] for name, one in summary["instances"].items() if name.startswith("far")}, {1})
        self.assertIn("2 for 22 instances", said)

    def test_one_set_is_one_code_whatever_order_its_words_have(self):
        bodies = {"a": "{effects: [oil, gravity]}", "b": "{effects: [+oil]}", "c": "{effects: [all, -wind, -spin]}"}
        libraries, _, summary = self.compiled(bodies)
        self.assertEqual((libraries, summary["derivations"]), (1, 1))

    def test_without_a_cache_they_share_what_was_compiled(self):
        # A compiler is asked what it is, too; what it compiles is told by -o.
        counter = self.write("cxx", '#!/bin/sh\ncase "$*" in *" -o "*) echo x >> "$COUNT";; esac\nexec c++ "$@"\n')
        counter.chmod(0o755)
        self.write("balls.yaml", scene({"a": "{}", "b": "{parameters: {m: 2}}", "c": "{initial: {x: 4}}"}))
        environment = {**os.environ, "COUNT": str(self.folder / "count"), "HOME": "", "XDG_CACHE_HOME": ""}
        link = self.folder.parent / f"gauss-cxx-{os.getpid()}"
        link.symlink_to(counter)
        self.addCleanup(link.unlink)
        self.ok("run", "balls.yaml", "-q", env={**environment, "CXX": str(link)})
        self.assertEqual((self.folder / "count").read_text(encoding="utf-8").count("x"), 1)

    def test_a_number_in_place_of_a_formula_is_another_code(self):
        bodies = {"a": "{effects: [+spin]}", "b": "{effects: [+spin], parameters: {J: 0.002}}", "c": "{effects: [+spin], parameters: {J: 0.003}}"}
        _, _, summary = self.compiled(bodies)
        self.assertEqual([code["instances"] for code in summary["codes"]], [["a"], ["b", "c"]])
        self.assertEqual(summary["derivations"], 2)

    def test_other_outputs_are_another_code(self):
        _, _, summary = self.compiled({"a": "{}", "b": "{outputs: [x, mass_matrix]}", "c": "{outputs: [x, mass_matrix]}"})
        self.assertEqual([code["instances"] for code in summary["codes"]], [["a"], ["b", "c"]])

    def test_where_constraints_are_solved_what_is_compiled_is_shared(self):
        """Bounds of rank may come from values, so equations are derived for each; the text is the same of a and b."""
        self.write("bob.yaml", """gauss: 1
name: bob
parameters: {m: 1, l: 1, g: 9.81}
coordinates: {x: {initial: 0.6}, z: {initial: -0.8}}
particles: {p: {mass: m, position: [x, 0, z]}}
constraints: {rod: {equation: x^2 + z^2 - l^2}}
forces: {w: {uniform: [0, 0, -g]}}
""")
        cache = self.folder / "cache"
        self.write("bobs.yaml", "gauss: 1\nscene: bobs\nmodel: bob.yaml\nduration: 1\nsamples: 5\ninstances:\n"
                                "  a: {}\n  b: {initial: {x: 0.8, z: -0.6}}\n  c: {parameters: {l: 5}, initial: {x: 3, z: -4}}\n")
        self.ok("run", "bobs.yaml", "-q", env={**os.environ, "XDG_CACHE_HOME": str(cache)})
        table, summary = self.cells("bobs.csv"), self.summary("bobs.json")
        self.assertEqual([code["instances"] for code in summary["codes"]], [["a", "b"], ["c"]])
        self.assertEqual(summary["derivations"], 3)
        self.assertEqual(len(list((cache / "gauss").glob("*/model.so"))), 2)
        self.write("alone.yaml", "gauss: 1\nscene: alone\nmodel: bob.yaml\nduration: 1\nsamples: 5\n"
                                 "parameters: {l: 5}\ninitial: {x: 3, z: -4}\n")
        self.ok("run", "alone.yaml", "-q")
        self.assertEqual(self.cells("alone.csv")["x"], table["c.x"])


class Choices(Instances):
    def effects_of(self, of_scene, own):
        self.write("balls.yaml", scene({"one": f"{{effects: {own}}}"}, more=f"effects: {of_scene}\n"))
        self.ok("run", "balls.yaml", "-q", "--engine", "interpreted")
        return self.summary("balls.json")["instances"]["one"]["effects"]

    def test_signs_change_what_the_scene_chooses(self):
        self.assertEqual(self.effects_of("[gravity, oil]", "[-gravity]"), ["oil"])
        self.assertEqual(self.effects_of("[oil]", "[+wind]"), ["oil", "wind"])
        self.assertEqual(self.effects_of("[oil]", "[-oil]"), [])
        self.assertEqual(self.effects_of("default", "[+oil]"), ["gravity", "oil"])
        self.assertEqual(self.effects_of("[-gravity, +oil]", "[+gravity]"), ["gravity", "oil"])
        self.assertEqual(self.effects_of("all", "[-wind, -spin]"), ["gravity", "oil"])
        self.assertEqual(self.effects_of("[all, -wind]", "[-spin]"), ["gravity", "oil"])

    def test_a_list_without_signs_takes_its_place(self):
        self.assertEqual(self.effects_of("[oil]", "[gravity]"), ["gravity"])
        self.assertEqual(self.effects_of("[oil]", "none"), [])
        self.assertEqual(self.effects_of("[oil]", "default"), ["gravity"])
        self.assertEqual(self.effects_of("[oil]", "[all, -spin]"), ["gravity", "oil", "wind"])

    def test_options_have_precedence(self):
        _, summary = self.play({"a": "{effects: [+oil]}", "b": "{}"}, "--effects", "none")
        self.assertEqual([one["effects"] for one in summary["instances"].values()], [[], []])

    def test_a_value_for_an_effect_is_for_those_in_which_it_acts(self):
        table, _ = self.play({"a": "{effects: [+oil]}", "b": "{}"}, "--set", "c=3")
        self.write("alone.yaml", HEAD + "effects: [gravity, oil]\nparameters: {u: 4, c: 3}\n")
        self.ok("run", "alone.yaml", "-q", "-o", "alone.csv")
        self.assertEqual(self.cells("alone.csv")["x"], table["a.x"])
        said = self.refused(2, "run", "balls.yaml", "--set", "w=3")
        self.assertIn("--set w=3: it is of an effect that acts for none of the instances", said)

    def test_what_one_of_them_uses_is_no_warning(self):
        more = "effects: gravity\nparameters: {c: 0.5, k: 0.02}\n"
        self.write("balls.yaml", scene({"a": "{effects: [+oil]}", "b": "{}", "d": "{parameters: {k: 1}}"}, more=more))
        said = self.run_it("run", "balls.yaml", "-q").stderr
        self.assertEqual(said.count("'c' is of"), 0, said)
        # Of the scene for all of them, which the value of 'd' hides there, and of 'd' itself.
        self.assertEqual(said.count("'k' is of the effect 'spin', which does not act here"), 1, said)
        self.write("balls.yaml", scene({"a": "{effects: [+oil]}", "b": "{}"}, more=more))
        said = self.run_it("run", "balls.yaml", "-q").stderr
        self.assertEqual(said.count("'k' is of the effect 'spin', which does not act here"), 1, said)

    def test_rates_of_coordinates_that_absent_effects_mention_are_given_all_the_same(self):
        self.write("oiled.yaml", BALL.replace("{drag: ball, linear: c}", "{generalized: {x: -c*dot(x)}}"))
        self.write("one.yaml", "gauss: 1\nscene: one\nmodel: oiled.yaml\neffects: gravity\ninitial: {x_dot: 7}\nduration: 1\nsamples: 3\n")
        result = self.run_it("run", "one.yaml", "-q")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertAlmostEqual(float(self.cells("one.csv")["x"][-1]), 7, delta=1e-12)


STOPS = """gauss: 1
name: faller
parameters: {m: 1, k: 1}
coordinates: {x: {initial: 1, initial_rate: 0}}
particles: {p: {mass: m, position: [x, 0, 0]}}
forces: {pull: {generalized: {x: -k/x^2}}}
"""

BOUNCING = """gauss: 1
name: bouncing
parameters: {m: 1, g: 9.81, e: 0.5, h: 1}
coordinates: {z: {initial: h, initial_rate: 0}}
particles: {p: {mass: m, position: [0, 0, z]}}
contacts: {floor: {gap: z, restitution: e}}
effects:
  weight: {default: on, forces: {w: {uniform: [0, 0, -g]}}}
"""


class Ends(Instances):
    def test_one_that_stops_early_leaves_the_others_whole(self):
        self.write("faller.yaml", STOPS)
        self.write("fall.yaml", "gauss: 1\nscene: fall\nmodel: faller.yaml\nduration: 2\nsamples: 21\nmethod: prince87\n"
                                "instances:\n  low: {}\n  high: {initial: {x: 10}}\n")
        result = self.run_it("run", "fall.yaml", "--max-steps", "20000")
        self.assertEqual(result.returncode, 5, result.stderr)
        self.assertIn("the motion of 'low' of 'faller' stops at t = 1.11", result.stderr)
        self.assertNotIn("resume", result.stderr)
        table, summary = self.cells("fall.csv"), self.summary("fall.json")
        # A fall from x = 1 takes pi/(2 sqrt 2) s = 1.1107 s.
        self.assertEqual([cell == "" for cell in table["low.x"]], [False] * 12 + [True] * 9)
        self.assertTrue(all(table["high.x"]))
        self.assertEqual(len(table["t"]), 21)
        self.assertEqual(summary["outcome"], "some stopped")
        self.assertEqual(summary["instances"]["high"]["outcome"], "finished")
        self.assertNotEqual(summary["instances"]["low"]["outcome"], "finished")
        self.assertEqual(summary["instances"]["low"]["samples"], 12)
        self.assertIn("stops at 1.11", result.stdout)
        self.ok("plot", "fall.csv")

    def test_one_that_has_no_start_leaves_the_others_whole(self):
        self.write("faller.yaml", STOPS)
        self.write("fall.yaml", "gauss: 1\nscene: fall\nmodel: faller.yaml\nduration: 1\nsamples: 3\n"
                                "instances:\n  low: {method: verlet, step: 0.01}\n  high: {initial: {x: 10}}\n")
        self.ok("run", "fall.yaml")
        self.assertEqual(self.summary("fall.json")["instances"]["low"]["method"], "verlet")

    def test_a_method_that_does_not_take_one_is_refused_by_its_name(self):
        self.write("balls.yaml", scene({"a": "{}", "b": "{effects: [+oil], method: verlet}"}))
        said = self.refused(2, "run", "balls.yaml", "-q")
        self.assertIn("b: ", said)

    def test_each_has_regimes_of_its_own(self):
        self.write("bouncing.yaml", BOUNCING)
        self.write("two.yaml", "gauss: 1\nscene: two\nmodel: bouncing.yaml\nduration: 1\nsamples: 11\n"
                               "instances:\n  b: {initial: {z: 2}}\n  a: {}\n  free: {effects: none}\n")
        said = self.ok("run", "two.yaml")
        rows = self.events("two.events.csv")
        self.assertEqual(list(rows[0]), ["t [s]", "instance", "event", "impulse"])
        self.assertEqual([float(row["t [s]"]) for row in rows], sorted(float(row["t [s]"]) for row in rows))
        for name, height in (("a", 1), ("b", 2)):
            first = [float(row["t [s]"]) for row in rows if row["instance"] == name][0]
            self.assertAlmostEqual(first, math.sqrt(2 * height / G), delta=1e-10)
        self.assertFalse([row for row in rows if row["instance"] == "free"])
        self.assertIn("events", said)
        self.write("alone.yaml", "gauss: 1\nscene: alone\nmodel: bouncing.yaml\nduration: 1\nsamples: 11\ninitial: {z: 2}\n")
        self.ok("run", "alone.yaml", "-q")
        self.assertEqual(self.cells("alone.csv")["z"], self.cells("two.csv")["b.z"])
        alone = [(row["t [s]"], row["event"], row["impulse"]) for row in self.events("alone.events.csv")]
        self.assertEqual(alone, [(row["t [s]"], row["event"], row["impulse"]) for row in rows if row["instance"] == "b"])
        self.assertEqual(self.summary("two.json")["instances"]["b"]["regimes"], self.summary("alone.json")["regimes"])

    def test_regimes_of_one_code_are_compiled_once(self):
        self.write("bouncing.yaml", BOUNCING)
        self.write("two.yaml", "gauss: 1\nscene: two\nmodel: bouncing.yaml\nduration: 1\nsamples: 11\n"
                               "instances:\n  a: {}\n  b: {initial: {z: 2}}\n  c: {parameters: {e: 0.7, m: 3}}\n")
        counts = []
        for options in ([], ["--instance", "a"]):
            cache = self.folder / "cache"
            shutil.rmtree(cache, ignore_errors=True)
            self.ok("run", "two.yaml", "-q", *options, env={**os.environ, "XDG_CACHE_HOME": str(cache)})
            counts.append(len(list((cache / "gauss").glob("*/model.so"))))
        self.assertEqual(counts[0], counts[1])
        self.assertEqual(self.summary("two.json")["derivations"], 1)

    def test_permuted_they_have_the_same_events(self):
        self.write("bouncing.yaml", BOUNCING)
        head = "gauss: 1\nscene: two\nmodel: bouncing.yaml\nduration: 1\nsamples: 11\ninstances:\n"
        texts = []
        for bodies in (["a", "b", "c"], ["c", "a", "b"]):
            self.write("two.yaml", head + "".join(f"  {name}: {{}}\n" for name in bodies))
            self.ok("run", "two.yaml", "-q")
            texts.append((self.folder / "two.events.csv").read_text(encoding="utf-8"))
        self.assertEqual(*texts)

    def test_after_ctrl_c_nothing_is_written(self):
        self.write("balls.yaml", scene({"a": "{}", "b": "{method: rk4, step: 1e-7}"}).replace("duration: 1.5", "duration: 1000"))
        process = subprocess.Popen([PROGRAM, "run", "balls.yaml", "-q"], cwd=self.folder, stderr=subprocess.PIPE, text=True)
        self.wait_for_processor(process, 0.5)
        process.send_signal(signal.SIGINT)
        said = process.communicate(timeout=60)[1]
        self.assertEqual((process.returncode, said), (130, "interrupted; nothing is written\n"))
        self.assertEqual(self.files(), ["ball.yaml", "balls.yaml"])

    def test_one_instance_goes_on_where_it_was_interrupted(self):
        self.write("balls.yaml", scene({"a": "{}", "b": "{method: rk4, step: 0.001, effects: [+oil]}"}))
        self.ok("run", "balls.yaml", "-q")
        whole = self.cells("balls.csv")
        result = self.run_it("run", "balls.yaml", "-q", "--instance", "b", "--max-steps", "900")
        self.assertEqual(result.returncode, 5)
        self.ok("run", "balls.yaml", "-q", "--instance", "b", "--resume", "--max-steps", "900")
        self.assertEqual(self.cells("balls.b.csv")["x"], whole["b.x"])
        other = self.refused(2, "run", "balls.yaml", "-q", "--instance", "a", "--resume", "-o", "balls.b.csv")
        self.assertIn("instance was 'b' and is 'a' now", other)

    def test_all_of_them_do_not_go_on(self):
        self.write("balls.yaml", scene({"a": "{}"}))
        said = self.refused(2, "run", "balls.yaml", "--resume")
        self.assertIn("--instance NAME goes on with one of them", said)


class ClosedForms(Instances):
    def test_each_may_have_its_own(self):
        bodies = {"near": "{effects: [+oil], exact: {x: u*m/c*(1 - exp(-c/m*t))}}", "far": "{exact: {z: h + v*t - g/2*t^2}}", "plain": "{}"}
        _, summary = self.play(bodies)
        said = {name: one.get("from_closed_forms", {}) for name, one in summary["instances"].items()}
        self.assertEqual({name: one.get("output") for name, one in said.items()}, {"near": "x", "far": "z", "plain": None})
        for name in ("near", "far"):
            self.assertLess(said[name]["relative"], 1e-8)

    def test_one_that_is_another_motion_is_told_by_the_instance(self):
        self.write("balls.yaml", scene({"near": "{effects: [+oil]}", "far": "{}"}, more="effects: gravity\nexact: {x: u*t}\n"))
        result = self.run_it("run", "balls.yaml", "-q")
        self.assertEqual(result.returncode, 0)
        self.assertEqual(result.stderr.count("is another motion"), 1, result.stderr)
        self.assertIn("the closed form of 'near.x' is another motion", result.stderr)


class OneMotion(Instances):
    """What takes one motion says how to have one."""

    def test_commands_for_one_motion_refuse_several(self):
        self.write("balls.yaml", scene({"near": "{effects: [+oil]}", "far": "{}"}))
        for words in (["effects"], ["study", "--budget", "1"], ["advise", "--error", "1e-3"], ["ensemble"]):
            with self.subTest(words[0]):
                said = self.refused(1, words[0], "balls.yaml", *words[1:])
                self.assertIn("balls.yaml:8:1: error[E016]: these are several motions", said)
                self.assertIn("--instance near takes that one; there are near, far", said)

    def test_an_error_is_looked_for_of_one(self):
        self.write("balls.yaml", scene({"near": "{effects: [+oil]}", "far": "{}"}))
        self.assertIn("--instance near takes one of them", self.refused(2, "run", "balls.yaml", "--error", "1e-3"))
        self.write("balls.yaml", scene({"near": "{effects: [+oil]}", "far": "{}"}, more="effects: gravity\nerror: 1e-4\n"))
        said = self.refused(1, "run", "balls.yaml")
        self.assertIn("balls.yaml:7:8: error[E016]: a setting is looked for of one motion", said)
        self.ok("run", "balls.yaml", "-q", "--instance", "near")
        self.assertLess(self.summary("balls.near.json")["error_estimate"]["relative"], 1e-4)
        self.ok("run", "balls.yaml", "-q", "--tolerance", "1e-9")

    def test_each_command_takes_one(self):
        self.write("balls.yaml", scene({"near": "{effects: [+oil], parameters: {c: 0.3}}", "far": "{}"}))
        said = self.ok("effects", "balls.yaml", "--instance", "near", "--need", "1e-3")
        self.assertIn("balls.near: 1.5 s", said)
        self.assertIn("effects gravity, oil", said)
        self.assertNotIn("balls.lean.yaml", self.files())
        said = self.ok("advise", "balls.yaml", "--instance", "near", "--error", "1e-4")
        self.assertIn("method: ", said)
        self.ok("study", "balls.yaml", "--instance", "far", "--budget", "0.2", "--methods", "rk4", "-q")
        self.assertEqual(self.summary("study.json")["problems"][0]["name"], "balls.far")

    def test_an_ensemble_of_one(self):
        vary = "ensemble: {parameters: {m: {values: [1, 2]}}}\n"
        self.write("balls.yaml", scene({"near": "{effects: [+oil]}", "far": "{}"}, more="effects: gravity\n" + vary))
        self.ok("ensemble", "balls.yaml", "-q", "--instance", "near")
        rows = self.cells("balls.near.ensemble.csv")
        k = 0.2 / 2
        self.assertAlmostEqual(float(rows["x"][1]), 3 / k * (1 - math.exp(-k * 1.5)), delta=1e-7)
        self.write("balls.yaml", scene({"near": "{parameters: {m: 3}}", "far": "{}"}, more="effects: gravity\n" + vary))
        said = self.refused(1, "ensemble", "balls.yaml", "--instance", "near")
        self.assertIn("the scene's 'ensemble' varies 'm'", said)

    def test_of_many_names_some_are_said(self):
        self.write("balls.yaml", scene({f"far_{k}": "{}" for k in range(200)}))
        said = self.refused(1, "advise", "balls.yaml", "--error", "1e-3")
        self.assertIn("far_10, far_11 and 188 more", said)

    def test_names_that_are_not_there(self):
        self.write("balls.yaml", scene({"near": "{}", "far": "{}"}))
        self.assertIn("has no instance 'neer'; did you mean 'near'?", self.refused(2, "run", "balls.yaml", "--instance", "neer"))
        self.assertIn("'ball.yaml' has no instances", self.refused(2, "run", "ball.yaml", "--instance", "near"))


class Mistakes(Instances):
    def said(self, bodies, code=1, options=(), **more):
        self.write("balls.yaml", scene(bodies, **more))
        return self.refused(code, "run", "balls.yaml", *options)

    def test_they_have_their_places_and_all_are_said(self):
        said = self.said({"near": "{effects: [+oyl], colour: red}", "9far": "{}", "far": "{initial: {q: 1}, parameters: {mm: 2}}",
                          "torn": "{effects: [wind], method: rk5}", "flat": "7"})
        for text in ("balls.yaml:9:20: error[E093]: there is no effect 'oyl'", "did you mean 'oil'?",
                     "balls.yaml:9:27: error[E010]: instance 'near' has no key 'colour'",
                     "balls.yaml:10:3: error[E020]: '9far' is not a valid name",
                     "balls.yaml:11:19: error[E024]", "did you mean 'm'?", "balls.yaml:11:39: error[E024]",
                     "balls.yaml:12:20: error[E093]: 'wind' requires 'oil', which does not act",
                     "balls.yaml:12:35: error[E015]: there is no method 'rk5'",
                     "balls.yaml:13:9: error[E012]"):
            self.assertIn(text, said)
        self.assertEqual(said.count(": error["), 8, said)
        lines = [int(line.split(":")[1]) for line in said.splitlines() if ": error[" in line]
        self.assertEqual(lines, sorted(lines))

    def test_what_the_scene_says_for_all_is_wrong_once(self):
        said = self.said({"a": "{}", "b": "{}", "c": "{effects: [+oil]}"}, more="effects: [gravity, spinn]\nparameters: {v_x: 3}\n")
        self.assertEqual(said.count("there is no effect 'spinn'"), 1, said)
        self.assertEqual(said.count("v_x"), 2, said)  # the message, and the line

    def test_what_the_scene_says_for_all_may_be_wrong_for_some(self):
        bodies = {"near": "{effects: [+spin]}", "far_1": "{}", "far_2": "{effects: none}"}
        said = self.said(bodies, more="effects: gravity\noutputs: [x, wx]\n")
        self.assertIn("balls.yaml:7:14: error[E024]: the model has no output 'wx', of far_1, far_2", said)
        self.assertEqual(said.count("error["), 1, said)
        said = self.said({"near": "{}", "far": "{}"}, more="effects: gravity\noutputs: [x, wq]\n")
        self.assertIn("the model has no output 'wq'\n", said)

    def test_none_and_contradictions(self):
        self.write("balls.yaml", HEAD + "instances: {}\n")
        self.assertIn("balls.yaml:6:12: error[E013]: there is no instance", self.refused(1, "run", "balls.yaml"))
        self.write("balls.yaml", HEAD + "instances: [near]\n")
        self.assertIn("error[E012]", self.refused(1, "run", "balls.yaml"))
        said = self.said({"a": "{effects: [+oil, -oil]}"})
        self.assertIn("'oil' is chosen twice", said)
        said = self.said({"a": "{effects: [-oil, +wind]}"}, more="effects: [gravity, oil]\n")
        self.assertIn("balls.yaml:8:17: error[E093]: 'wind' requires 'oil'", said)

    def test_times_that_differ(self):
        self.write("balls.yaml", scene({"a": "{}", "b": "{parameters: {v: 4}}"}).replace("duration: 1.5", "duration: v"))
        said = self.refused(1, "run", "balls.yaml")
        self.assertIn("balls.yaml:4:11: error[E016]: 'duration' is 2 s for 'a' and 4 s for 'b': instances have the same rows", said)

    def test_masses_that_no_ball_has(self):
        said = self.said({"a": "{parameters: {m: -1}}", "b": "{}"})
        self.assertIn("balls.yaml:9:", said)
        self.assertIn("E055", said)

    def test_the_same_in_json(self):
        self.write("balls.yaml", scene({"near": "{effects: [+oyl]}"}))
        result = self.run_it("run", "balls.yaml", "--diagnostics", "json")
        first = json.loads(result.stderr.splitlines()[0])
        self.assertEqual((first["code"], first["line"], first["column"]), ("E093", 9, 20))


if __name__ == "__main__":
    unittest.main()
