"""The sample of a study is what the schema says, and the schema refuses what the page could not show."""

import copy
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import jsonschema

SOURCE = Path(os.environ["GAUSS_SOURCE_DIR"])
HERE = SOURCE / "tests/sim/report"


def sample():
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "study.json"
        subprocess.run([os.environ["NODE"], HERE / "sample/study.mjs", file], check=True)
        return file.read_bytes()


class Schema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.bytes = sample()
        cls.study = json.loads(cls.bytes)
        # A few points of each kind are enough to be spoilt.
        first = cls.study["problems"][0]
        failed = next(point for point in first["points"] if point["status"] == "failed")
        cls.small = {**cls.study, "problems": [{**first, "points": [*first["points"][:5], failed]}]}
        cls.validator = jsonschema.Draft7Validator(json.loads((SOURCE / "apps/sim/report/study.schema.json").read_text(encoding="utf-8")))

    def refused(self, change):
        study = copy.deepcopy(self.small)
        self.assertEqual(list(self.validator.iter_errors(study)), [])
        change(study)
        self.assertNotEqual(list(self.validator.iter_errors(study)), [])

    def test_the_schema_is_a_schema(self):
        jsonschema.Draft7Validator.check_schema(self.validator.schema)

    def test_the_sample_is_a_study(self):
        self.assertEqual([error.message for error in self.validator.iter_errors(self.study)], [])

    def test_the_sample_is_always_the_same(self):
        self.assertEqual(self.bytes, sample())

    def test_the_sample_has_what_a_study_may_have(self):
        points = [point for problem in self.study["problems"] for point in problem["points"]]
        self.assertEqual(len(self.study["problems"]), 6)
        self.assertEqual({point["status"] for point in points}, {"ok", "failed", "refused"})
        self.assertTrue(any(point["is_default"] for point in points))
        self.assertGreater(len({point["formulation"] for point in points}), 2)

    def test_a_study_may_be_nearly_empty(self):
        self.assertEqual(list(self.validator.iter_errors({"format": 1, "problems": [{"name": "nothing"}]})), [])

    def test_other_formats_are_refused(self):
        self.refused(lambda study: study.update(format=2))

    def test_a_failure_has_a_reason_and_no_error(self):
        for key, value in (("why", ""), ("error", 1e-3), ("pareto", True)):
            def change(study, key=key, value=value):
                next(point for point in study["problems"][0]["points"] if point["status"] == "failed")[key] = value
            self.refused(change)

    def test_a_study_may_have_been_interrupted(self):
        self.assertEqual(list(self.validator.iter_errors({**self.small, "interrupted": True})), [])
        self.refused(lambda study: study.update(interrupted="yes"))

    def test_without_a_reference_there_is_a_reason_and_no_run(self):
        def without(study):
            study["problems"][0].update(why="it stops at 3 s", reference=None, points=[])

        study = copy.deepcopy(self.small)
        without(study)
        self.assertEqual(list(self.validator.iter_errors(study)), [])
        for key, value in (("why", ""), ("reference", {"kind": "float128"}), ("points", self.small["problems"][0]["points"])):
            def change(study, key=key, value=value):
                without(study)
                study["problems"][0][key] = value
            self.refused(change)

    def test_effects_are_measured_or_there_is_a_reason(self):
        of_effects = next(problem["effects"] for problem in self.study["problems"] if "effects" in problem)

        def changed(change=None):
            effects = copy.deepcopy(of_effects)
            if change:
                change(effects)
            return list(self.validator.iter_errors({"format": 1, "problems": [{"name": "top", "effects": effects}]}))

        self.assertEqual(changed(), [])
        self.assertEqual(changed(lambda effects: (effects.clear(), effects.update(why="it sticks"))), [])
        for change in (lambda effects: effects.clear(), lambda effects: effects.pop("ladder"), lambda effects: effects.update(why=""),
                       lambda effects: effects["each"][0].pop("effects"), lambda effects: effects["all"].update(opreations=3),
                       lambda effects: effects["need"].update(change=0)):
            self.assertNotEqual(changed(change), [])

    def test_misspelt_keys_are_refused(self):
        self.refused(lambda study: study["problems"][0]["points"][0].update(tolerence=1e-3))

    def test_a_shape_has_its_measures(self):
        self.refused(lambda study: study["problems"][0]["motion"]["bodies"][0]["shape"].pop("radius"))

    def test_places_have_three_parts(self):
        self.refused(lambda study: study["problems"][0]["motion"]["bodies"][0]["position"][0].pop())


if __name__ == "__main__":
    unittest.main()
