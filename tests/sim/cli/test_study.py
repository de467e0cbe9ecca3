"""gauss-sim study: figures that hold together."""

import csv
import json
import math
import unittest

from gauss_sim import SPRING, Program


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
        with self.subTest("nobody on the front is beaten"):
            for point in points:
                beaten = [other for other in points if other["time_s"] <= point["time_s"] and other["error"] <= point["error"]
                          and (other["time_s"] < point["time_s"] or other["error"] < point["error"])]
                self.assertEqual(point["pareto"], not beaten, point)
        with self.subTest("tighter tolerances deliver less error, up to rounding"):
            for method in {point["method"] for point in points if point["tolerance"]}:
                errors = [(p["tolerance"], p["error"]) for p in points if p["method"] == method]
                self.assertLess(min(errors)[1], max(max(errors)[1], 1e-11), method)
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
            self.assertIn('"name": "spring"', page)
            self.assertNotIn("@STUDY@", page)
        with self.subTest("drift of the best is there over time"):
            for trace in self.problem["drifts"]:
                self.assertEqual(len(trace["t"]), self.problem["samples"])
                self.assertTrue(all(math.isfinite(value) for value in trace["energy"]))


if __name__ == "__main__":
    unittest.main()
