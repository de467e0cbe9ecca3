"""What gauss-sim does where nobody says anything is a good choice: on the front of error and time.

Of some shipped models, which compilers are soon done with; with GAUSS_ALL_MODELS=1, as `./run test --thorough` has it, of all of them (twenty minutes)."""

import json
import os
import unittest
from concurrent.futures import ThreadPoolExecutor

from gauss_sim import MODELS, Program

# What people would take instead. Where rates are stiff, what is made for that.
RIVALS = ["taylor", "prince87", "fehlberg78", "dopri5", "bulirsch_stoer"]
STIFF = {"spring_pendulum": ["cvode_bdf", "arkode_kvaerno5"]}

SOME = ["chaplygin_sleigh", "double_pendulum", "kepler", "lagrange_top", "sphere_in_cylinder", "sphere_in_cylinder_quaternion", "spherical_pendulum",
        "spring_pendulum"]

# Seconds that motions can be followed for: friction that jumps holds the wagon, a blade comes to stand upright, and an arm without control turns over and over.
ENDS = {"functions": 2, "skater_quaternion": 0.4, "robot_arm": 1}

# Times move on a busy machine. What is beaten by less than this, in one of some tries, is not beaten.
MARGIN = 1.5
TRIES = 3


class Defaults(Program):
    def points(self, model, number):
        methods = ",".join(RIVALS + STIFF.get(model.stem, []))
        scene = self.write(f"{model.stem}-{number}.scene.yaml", f"gauss: 1\nscene: {model.stem}\nmodel: {model}\nduration: {ENDS.get(model.stem, 10)}\n")
        self.ok("study", scene, "--methods", methods, "--budget", "40", "--loosest", "1e-5", "--tightest", "1e-12", "-q",
                "-o", f"{model.stem}-{number}", timeout=600)
        problem = json.loads((self.folder / f"{model.stem}-{number}.json").read_text(encoding="utf-8"))["problems"][0]
        return [p for p in problem["points"] if p["status"] == "ok" and p["error"] is not None]

    def beaten_by(self, model):
        """Points that are as exact as the default in less time, each time that somebody looks."""
        for number in range(TRIES):
            points = self.points(model, number)
            default = [p for p in points if p["is_default"]]
            if not points:
                return ["no run has arrived: " + json.loads((self.folder / f"{model.stem}-{number}.json").read_text(encoding="utf-8"))["problems"][0].get("why", "")]
            if not default:
                return ["the default did not arrive"]
            better = [p for p in points if p["error"] <= default[0]["error"] and MARGIN * p["time_s"] < default[0]["time_s"]]
            if not better:
                return []
        return [(p["method"], p["tolerance"], p["time_s"] / default[0]["time_s"]) for p in better]

    def test_defaults_are_on_the_front(self):
        is_wanted = (lambda path: True) if os.environ.get("GAUSS_ALL_MODELS") == "1" else (lambda path: path.stem in SOME)
        models = sorted(filter(is_wanted, MODELS.glob("*.yaml")))
        self.assertGreaterEqual(len(models), len(SOME))
        with ThreadPoolExecutor(min(8, os.cpu_count() or 1)) as pool:
            found = list(pool.map(self.beaten_by, models))
        for model, better in zip(models, found):
            with self.subTest(model.stem):
                self.assertEqual(better, [])


if __name__ == "__main__":
    unittest.main()
