"""gauss-sim effects: what each effect costs and changes, and which a wanted accuracy needs."""

import json
import math
import os
import re
import unittest
from pathlib import Path

import jsonschema

from gauss_sim import Program

SCHEMA = jsonschema.Draft7Validator(json.loads((Path(os.environ["GAUSS_SOURCE_DIR"]) / "apps/sim/report/study.schema.json").read_text(encoding="utf-8")))

# Unforced, x = cos(w t). What the others change is known in closed form.
SPRING = """gauss: 1
name: bench
about: mass on a spring
parameters: {m: {value: 2, unit: kg}}
coordinates: {x: {unit: m, initial: 1}}
particles: {bob: {mass: m, position: [x, 0, 0]}}
effects:
  spring:
    about: what it hangs on
    default: on
    parameters: {k: {value: 8, unit: N/m}}
    forces: {spring: {potential: k*x^2/2}}
  push:
    about: a constant force
    parameters: {F: {value: 0.004, unit: N}}
    forces: {push: {generalized: {x: F}}}
  damper:
    about: of a thin medium
    parameters: {c: {value: 1e-5, unit: N*s/m}}
    forces: {damper: {generalized: {x: -c*dot(x)}}}
  heat:
    about: makes the medium thicker
    requires: [damper]
    parameters: {h: {value: 1e-7, unit: N*s/m^2}}
    forces: {heat: {generalized: {x: -h*x*dot(x)}}}
"""
ROD = """gauss: 1
name: swing
parameters: {m: {value: 1, unit: kg}, l: {value: 1, unit: m}, g: {value: 9.81, unit: m/s^2}}
coordinates: {theta: {unit: rad, initial: 1}, s: {unit: m}}
particles: {bob: {mass: m, position: [s*sin(theta), 0, -s*cos(theta)]}}
forces: {weight: {uniform: [0, 0, -g]}}
effects:
  rigid: {about: a rod, one_of: rod, default: on, coordinates: {s: {held_at: l}}}
  elastic:
    about: a rod that bends
    one_of: rod
    parameters: {k: {value: 1e5, unit: N/m}}
    coordinates: {s: {initial: l}}
    forces: {rod: {spring: s, stiffness: k, rest: l}}
"""
SCENE = """gauss: 1   # version
scene: hang
# What it hangs on.
model: bench.yaml
duration: pi   # a full turn
effects:       # all of them
  - all

samples: 41
outputs: [x]
"""


class EffectsNeeded(Program):
    def setUp(self):
        super().setUp()
        self.write("bench.yaml", SPRING)
        self.write("swing.yaml", ROD)
        self.write("hang.yaml", SCENE)

    def report(self, *arguments):
        self.ok("effects", *arguments, "-o", "shown")
        return self.summary("shown.json")

    def x_of(self, scene, *arguments):
        self.ok("run", scene, *arguments, "-q", "-o", "run.csv")
        return self.table("run.csv")["x [m]"]

    def change(self, scene, effects, reference="all"):
        """Of x over its range, from two runs."""
        of_all = self.x_of(scene, f"--effects={reference}")
        other = self.x_of(scene, f"--effects={effects}")
        return max(abs(a - b) for a, b in zip(of_all, other)) / (max(of_all) - min(of_all))

    def test_changes_are_those_of_closed_forms(self):
        each = {one["what"]: one for one in self.report("hang.yaml")["each"]}
        # x = F/k + (1 - F/k) cos(2 t), so without it x is off by F/k (1 - cos), of a range of 2.
        self.assertAlmostEqual(each["without push"]["change"], 0.0005, delta=1e-3 * 0.0005)
        # The envelope is exp(-c t/(2 m)): off by c t/(2 m) cos(2 t), at the end of a turn.
        known = 1e-5 * math.pi / 4 / 2
        self.assertAlmostEqual(each["without damper (and heat)"]["change"], known, delta=0.05 * known)

    def test_changes_are_those_of_two_runs(self):
        shown = self.report("hang.yaml")
        words = {"without spring": "all,-spring", "without push": "all,-push",
                 "without damper (and heat)": "all,-damper,-heat", "without heat": "all,-heat"}
        self.assertEqual({one["what"] for one in shown["each"]}, set(words))
        for one in shown["each"]:
            self.assertAlmostEqual(one["change"], self.change("hang.yaml", words[one["what"]]), delta=1e-9, msg=one["what"])
            self.assertEqual(one["output"], "x")

    def test_each_rung_takes_no_more_operations_and_one_effect_less(self):
        ladder = self.report("hang.yaml")["ladder"]
        for before, after in zip(ladder, ladder[1:]):
            self.assertLess(set(after["effects"]), set(before["effects"]) | {"none"})
            self.assertLessEqual(after["operations"], before["operations"])
        self.assertEqual(ladder[0]["effects"], ["spring", "push", "damper", "heat"])
        self.assertEqual(ladder[-1]["effects"], [])
        self.assertEqual(ladder[1]["what"], "without heat")  # the least of all

    def test_shared_operations_are_what_no_effect_saves_by_itself(self):
        shown = self.report("hang.yaml")
        # Heat falls with the damper, whose line has both.
        saved = sum(shown["all"]["operations"] - one["operations"] for one in shown["each"] if one["what"] != "without heat")
        self.assertEqual(shown["shared_operations"], shown["all"]["operations"] - shown["none"]["operations"] - saved)

    def test_the_leaner_scene_is_that_of_the_user_and_as_good_as_it_was_asked_for(self):
        self.ok("effects", "hang.yaml", "--need", "1e-4")
        lean = self.folder / "hang.lean.yaml"
        text = SCENE.replace("effects:       # all of them\n  - all\n", "effects: [spring, push]\n")
        self.assertEqual(lean.read_text(), text)
        off = max(abs(a - b) for a, b in zip(self.x_of("hang.yaml"), self.x_of("hang.lean.yaml"))) / 2
        self.assertLess(off, 1e-4)
        self.assertGreater(off, 1e-7)
        self.assertGreater(self.change("hang.yaml", "spring"), 1e-4)  # less is not enough

    def test_an_elastic_rod_that_is_stiff_enough_may_be_a_rigid_one(self):
        arguments = ["swing.yaml", "--effects", "elastic", "--duration", "2", "--outputs", "theta"]
        shown = self.report(*arguments, "--need", "1e-3")
        self.assertEqual(shown["need"]["chosen"]["effects"], ["rigid"])
        self.assertLess(shown["need"]["chosen"]["operations"], shown["all"]["operations"])
        shown = self.report(*arguments, "--need", "1e-6")
        self.assertEqual(shown["need"]["chosen"]["effects"], ["elastic"])
        self.assertEqual(shown["each"][0]["what"], "rigid instead of elastic")
        lean = (self.folder / "swing.lean.yaml").read_text()
        self.assertEqual(lean, "gauss: 1\nscene: swing_lean\nmodel: swing.yaml\neffects: [elastic]\n")

    def test_what_the_run_cannot_tell_is_refused(self):
        said = self.refused(6, "effects", "hang.yaml", "--method", "rk4", "--step", "0.5", "--need", "1e-6")
        self.assertIn("it cannot tell a change of 1e-06", said)

    def study_in(self, page):
        """What a page shows."""
        text = (self.folder / page).read_text(encoding="utf-8")
        return json.loads(re.search(r'<script type="application/json" id="study">(.*?)</script>', text, re.S)[1])

    def test_the_page_is_a_study_without_runs_that_has_what_the_summary_has(self):
        said = self.ok("effects", "hang.yaml", "--need", "1e-4", "--html", "-o", "shown.html")
        self.assertIn("wrote shown.json, shown.svg and shown.html, and the scene", said)
        study = self.study_in("shown.html")
        self.assertEqual([error.message for error in SCHEMA.iter_errors(study)], [])
        [problem] = study["problems"]
        self.assertEqual({key: problem[key] for key in ("name", "about", "file", "scene")},
                         {"name": "hang", "about": "mass on a spring", "file": "bench.yaml", "scene": "hang.yaml"})
        self.assertEqual(problem["effects"], self.summary("shown.json"))
        self.assertEqual(problem["effects"]["about"]["push"], "a constant force")
        self.assertEqual(problem["effects"]["need"]["chosen"]["effects"], ["spring", "push"])
        (self.folder / "shown.html").unlink()
        self.ok("effects", "hang.yaml", "-o", "shown")
        self.assertNotIn("shown.html", self.files())

    def test_a_scene_or_a_model_may_come_from_standard_input(self):
        before = self.files()
        of_file = self.report("hang.yaml")
        self.ok("effects", "-", "--need", "1e-4", "-o", "shown", input=SCENE)
        self.assertEqual([one["change"] for one in self.summary("shown.json")["each"]], [one["change"] for one in of_file["each"]])
        self.assertIn("effects: [spring, push]\n", (self.folder / "hang.lean.yaml").read_text())
        result = self.run_it("effects", "-", "--effects", "all", "--duration", "pi", "--need", "1e-4", "-o", "shown", input=SPRING)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("standard input is no file that a scene could name", result.stderr)
        self.assertEqual(self.files(), sorted([*before, "hang.lean.yaml", "shown.json", "shown.svg"]))

    def test_mistakes_are_said(self):
        self.write("plain.yaml", SPRING[:SPRING.index("effects:")])
        self.assertIn("has no effects", self.refused(2, "effects", "plain.yaml"))
        self.assertIn("none of the effects acts", self.refused(2, "effects", "hang.yaml", "--effects", "none"))
        self.assertIn("there is no effect 'wind'", self.refused(2, "effects", "hang.yaml", "--effects", "all,-wind"))


if __name__ == "__main__":
    unittest.main()
