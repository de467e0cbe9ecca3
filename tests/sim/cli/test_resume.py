"""gauss-sim run --resume: what was interrupted goes on as if nothing had happened."""

import json
import math
import signal
import subprocess
import time
import unittest

from gauss_sim import PROGRAM, SPRING, Program

BY_STEPS = ["--method", "rk4", "--step", "1e-7", "--duration", "2", "--samples", "20001"]
BY_TOLERANCE = ["--method", "prince87", "--tolerance", "1e-12", "--duration", "500", "--samples", "300001", "--projection", "energy",
                "--set", "x_dot=1"]


class Resuming(Program):
    def setUp(self):
        super().setUp()
        self.write("spring.yaml", SPRING)

    def interrupted(self, *arguments, rows=100):
        """Ctrl-C after some rows more than there are now: to the process and to its group, as `timeout` has it."""
        table = self.folder / "spring.csv"
        before = table.stat().st_size if table.exists() else 0
        process = subprocess.Popen([PROGRAM, "run", "spring.yaml", "-q", *arguments], cwd=self.folder, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline and process.poll() is None:
            if any(path.stat().st_size > before + 60 * rows for path in self.folder.glob("spring.csv.*")):
                break
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGINT)
        said = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, 130, said)
        self.assertIn("--resume", said)
        return self.summary("spring.json")

    def test_steps_of_one_length_have_the_same_bits_after_two_interruptions(self):
        self.ok("run", "spring.yaml", "-q", "-o", "whole.csv", *BY_STEPS)
        first = self.interrupted(*BY_STEPS)
        second = self.interrupted(*BY_STEPS, "--resume")
        self.assertLess(first["samples"], second["samples"])
        self.assertLess(second["samples"], 20001)
        self.ok("run", "spring.yaml", "-q", "--resume", *BY_STEPS)
        self.assertEqual((self.folder / "whole.csv").read_bytes(), (self.folder / "spring.csv").read_bytes())
        whole, parts = self.summary("whole.json"), self.summary("spring.json")
        for key in ("outcome", "reached", "samples", "steps", "calls", "drift", "last_state", "resume"):
            self.assertEqual(whole[key], parts[key], key)
        self.assertEqual(self.files(), ["spring.csv", "spring.json", "spring.yaml", "whole.csv", "whole.json"])

    def test_a_run_that_has_taken_its_steps_goes_on_with_as_many_again(self):
        how = ["--method", "rk4", "--step", "1e-3", "--duration", "2", "--samples", "21", "--max-steps", "950"]
        self.ok("run", "spring.yaml", "-q", "-o", "whole.csv", *how[:-2])
        for more in ([], ["--resume"]):
            stopped = self.run_it("run", "spring.yaml", "-q", *more, *how)
            self.assertEqual(stopped.returncode, 5)
            self.assertIn("--resume goes on from the last row", stopped.stderr)
        self.ok("run", "spring.yaml", "-q", "--resume", *how)
        self.assertEqual((self.folder / "whole.csv").read_bytes(), (self.folder / "spring.csv").read_bytes())
        with self.subTest("there is nothing to go on with in what has stopped for another reason"):
            self.write("spring.json", json.dumps({**self.summary("spring.json"), "outcome": "step too small"}))
            self.assertIn("has stopped by itself: step too small", self.refused(2, "run", "spring.yaml", "-q", "--resume", *how))

    def test_steps_by_tolerance_agree_within_it_and_the_energy_is_that_of_the_first_start(self):
        self.ok("run", "spring.yaml", "-q", "-o", "whole.csv", *BY_TOLERANCE)
        first = self.interrupted(*BY_TOLERANCE)
        said = self.ok("run", "spring.yaml", "--resume", *BY_TOLERANCE)
        self.assertIn("error   not estimated: the run went on from an earlier one\n", said)
        whole, parts = self.table("whole.csv"), self.table("spring.csv")
        self.assertEqual(whole["t [s]"], parts["t [s]"])
        for column in ("x [m]", "x_dot [m/s]", "energy.total [J]"):
            self.assertLess(max(abs(a - b) for a, b in zip(whole[column], parts[column])), 1e-8, column)
        summary = self.summary("spring.json")
        self.assertEqual(summary["outcome"], "finished")
        self.assertGreater(summary["steps"], first["steps"])
        # Steps after another start are other ones: the bits of the last state, which `end` tells, are the same by chance only, after rounding has led to the same orbit.
        expected = {**self.summary("whole.json")["resume"], "end": summary["resume"]["end"]}
        self.assertEqual(summary["resume"], expected)
        self.assertEqual(summary["resume"]["kept_energy"], "5")
        self.assertLess(summary["drift"]["energy"]["largest_change"], 1e-14)

    def test_series_with_many_samples_go_on_too(self):
        """Four samples at a time, from another first one: rows before are the same, and those behind it are the motion x = cos(2 t)."""
        how = ["--method", "taylor", "--duration", "100", "--samples", "20001", "--tolerance", "1e-12", "--outputs", "x,energy.total"]
        self.ok("run", "spring.yaml", "-q", "-o", "whole.csv", *how)
        stopped = self.run_it("run", "spring.yaml", "-q", "--max-steps", "13", *how)
        self.assertEqual(stopped.returncode, 5, stopped.stderr)
        first = self.summary("spring.json")["samples"]
        self.assertGreater(first, 1000)
        self.assertLess(first, 20001)
        self.ok("run", "spring.yaml", "-q", "--resume", *how)
        whole, parts = (self.folder / name for name in ("whole.csv", "spring.csv"))
        self.assertEqual(whole.read_text().splitlines()[:first + 1], parts.read_text().splitlines()[:first + 1])
        table = self.table("spring.csv")
        self.assertEqual(len(table["x [m]"]), 20001)
        self.assertLess(max(abs(x - math.cos(2 * t)) for t, x in zip(table["t [s]"], table["x [m]"])), 1e-10)

    def test_ctrl_c_need_not_wait_for_a_sample(self):
        table = self.folder / "spring.csv"
        asked = ["run", "spring.yaml", "-q", "--method", "rk4", "--step", "1e-7", "--duration", "2"]
        process = subprocess.Popen([PROGRAM, *asked, "--samples", "2"], cwd=self.folder, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline and process.poll() is None and not list(self.folder.glob("spring.csv.*")):
            time.sleep(0.01)
        time.sleep(0.2)
        process.send_signal(signal.SIGINT)
        begin = time.monotonic()
        self.assertIn("--resume", process.communicate(timeout=60)[1])
        self.assertLess(time.monotonic() - begin, 1)
        self.assertEqual(process.returncode, 130)
        summary = self.summary("spring.json")
        self.assertEqual((summary["outcome"], summary["reached"], summary["samples"], summary["steps"]), ("interrupted", 0, 1, 0))
        self.assertEqual(len(table.read_text().splitlines()), 2)
        self.ok(*asked, "--samples", "2", "--resume")
        self.assertEqual(self.summary("spring.json")["steps"], 20_000_000)
        self.assertAlmostEqual(self.table("spring.csv")["x [m]"][-1], math.cos(4), delta=1e-8)

    def test_drift_is_the_largest_of_both_parts(self):
        self.interrupted(*BY_STEPS)
        summary = self.summary("spring.json")
        summary["drift"]["energy"]["largest_change"] = 0.25
        summary["resume"]["start_energy"] = "3.875"
        self.write("spring.json", json.dumps(summary))
        self.ok("run", "spring.yaml", "-q", "--resume", *BY_STEPS)
        self.assertEqual(self.summary("spring.json")["drift"]["energy"]["largest_change"], 0.25)
        summary["drift"]["energy"]["largest_change"] = 0.0625
        self.write("spring.json", json.dumps(summary))
        table = (self.folder / "spring.csv").read_text().splitlines(keepends=True)
        self.write("spring.csv", "".join(table[:summary["samples"] + 1]))
        self.ok("run", "spring.yaml", "-q", "--resume", *BY_STEPS)
        self.assertAlmostEqual(self.summary("spring.json")["drift"]["energy"]["largest_change"], 0.125)

    def test_the_energy_that_is_kept_is_that_of_the_summary(self):
        summary = self.interrupted(*BY_TOLERANCE)
        summary["resume"]["kept_energy"] = "5.000001"
        self.write("spring.json", json.dumps(summary))
        self.ok("run", "spring.yaml", "-q", "--resume", *BY_TOLERANCE, "--outputs", "state,energy")
        self.assertAlmostEqual(self.table("spring.csv")["energy.total [J]"][-1], 5.000001, delta=1e-12)

    def test_another_run_is_refused_with_what_is_other(self):
        self.interrupted(*BY_STEPS)
        before = (self.folder / "spring.csv").read_bytes()
        usual = dict(zip(BY_STEPS[::2], BY_STEPS[1::2]))
        for option, value, said in (("--step", "1e-6", "step was 1e-07 and is 1e-06 now"), ("--method", "gauss_legendre4", "method was 'rk4'"),
                                    ("--number", "long-double", "number was 'double'"), ("--duration", "3", "duration was 2"),
                                    ("--samples", "11", "samples was 20001"), ("--set", "m=3", "has changed"), ("--set", "x=2", "has changed"),
                                    ("--outputs", "x", "other columns"), ("--projection", "off", "projection was 'full'")):
            words = [word for pair in {**usual, option: value}.items() for word in pair]
            self.assertIn(said, self.refused(2, "run", "spring.yaml", "--resume", *words), option)
        self.assertEqual((self.folder / "spring.csv").read_bytes(), before)
        with self.subTest("columns of other functions are other columns, and no other model"):
            said = self.refused(2, "run", "spring.yaml", "--resume", *BY_STEPS, "--outputs", "x,accelerations")
            self.assertIn("other columns", said)
        self.write("spring.yaml", SPRING.replace("value: 8", "value: 9"))
        self.assertIn("has changed", self.refused(2, "run", "spring.yaml", "--resume", *BY_STEPS))

    def test_a_comment_in_the_model_changes_nothing(self):
        self.interrupted(*BY_STEPS)
        self.write("spring.yaml", "# A word.\n" + SPRING)
        self.ok("run", "spring.yaml", "-q", "--resume", *BY_STEPS)

    def test_what_is_not_there_or_not_whole_is_said(self):
        self.assertIn("no such file", self.refused(3, "run", "spring.yaml", "--resume"))
        for more in ((), ("--error", "1e-6")):
            self.assertIn("standard output", self.refused(2, "run", "spring.yaml", "--resume", "-o", "-", *more))
        self.interrupted(*BY_STEPS)
        table = (self.folder / "spring.csv").read_text()
        self.write("spring.csv", table[:table.rindex("\n", 0, -1) + 1])
        self.assertIn("rows where its summary says", self.refused(3, "run", "spring.yaml", "--resume", *BY_STEPS))
        for text in ("{}", "no JSON", json.dumps({**self.summary("spring.json"), "last_state": ["1"]})):
            self.write("spring.json", text)
            self.refused(3, "run", "spring.yaml", "--resume", *BY_STEPS)

    def test_rows_that_are_no_numbers_are_not_gone_on_from(self):
        self.interrupted(*BY_STEPS)
        lines = (self.folder / "spring.csv").read_text().splitlines(keepends=True)
        cells = lines[4].rstrip("\n").split(",")
        for row in ("rubbish", "", ",".join(cells[:-1]), ",".join([*cells, "1"]), ",".join([*cells[:-1], "1x"]), ",".join([*cells[:-1], ""])):
            with self.subTest(row):
                self.write("spring.csv", "".join([*lines[:4], row + "\n", *lines[5:]]))
                self.assertIn("spring.csv: line 5 is no row of", self.refused(3, "run", "spring.yaml", "-q", "--resume", *BY_STEPS))
        with self.subTest("what overflows is a number"):
            self.write("spring.csv", "".join([*lines[:4], ",".join([*cells[:-1], "-nan"]) + "\n", *lines[5:]]))
            self.ok("run", "spring.yaml", "-q", "--resume", *BY_STEPS)

    def test_a_state_that_is_no_number_is_not_gone_on_from(self):
        self.interrupted(*BY_STEPS)
        summary = self.summary("spring.json")
        summary["last_state"][0] = "abc"
        (self.folder / "spring.json").write_text(json.dumps(summary), encoding="utf-8")
        self.assertIn("no summary", self.refused(3, "run", "spring.yaml", "-q", "--resume", *BY_STEPS))

    def test_a_table_and_a_summary_of_two_runs_are_not_taken_for_one(self):
        self.interrupted(*BY_STEPS)
        table, summary = (self.folder / "spring.csv").read_text(encoding="utf-8"), self.summary("spring.json")
        lines = table.splitlines(keepends=True)
        cells = lines[-1].split(",")
        self.write("spring.csv", "".join([*lines[:-1], ",".join([cells[0], "0.5", *cells[2:]])]))
        self.assertIn("its last row is not that of the run in spring.json", self.refused(3, "run", "spring.yaml", "-q", "--resume", *BY_STEPS))
        self.write("spring.csv", table)
        self.write("spring.json", json.dumps({**summary, "last_state": ["0.5", *summary["last_state"][1:]]}))
        self.assertIn("its last row is not that", self.refused(3, "run", "spring.yaml", "-q", "--resume", *BY_STEPS))
        self.write("spring.json", json.dumps(summary))
        self.ok("run", "spring.yaml", "-q", "--resume", *BY_STEPS)

    def test_a_summary_that_somebody_has_edited_is_none(self):
        whole = self.interrupted(*BY_STEPS)
        for change in ({"samples": "a"}, {"outcome": 3}, {"resume": {**whole["resume"], "end": 7}}, {"resume": 1}, {"steps": -5}, {"reached": 1e9}, {"outcome": "finished"}):
            with self.subTest(change):
                self.write("spring.json", json.dumps({**whole, **change}))
                self.refused(3, "run", "spring.yaml", "-q", "--resume", *BY_STEPS)

    def test_a_run_with_an_error_goes_on_with_what_was_found(self):
        asked = ["--error", "1e-6", "--duration", "500", "--samples", "300001", "--method", "prince87"]
        first = self.interrupted(*asked)
        self.ok("run", "spring.yaml", "-q", "--resume", *asked)
        self.assertEqual(self.summary("spring.json")["tolerance"], first["tolerance"])
        self.assertEqual(self.summary("spring.json")["outcome"], "finished")

    def test_another_error_is_another_run(self):
        """What was found for one of 1e-3 delivers no 1e-10."""
        part = ["--duration", "60", "--max-steps", "10"]
        self.assertEqual(self.run_it("run", "spring.yaml", "-q", "--error", "1e-3", *part).returncode, 5)
        said = self.refused(2, "run", "spring.yaml", "-q", "--error", "1e-10", "--duration", "60", "--resume")
        self.assertIn("it was asked for an error of 0.001, so --error 0.001 goes on with it", said)
        self.assertIn("--error 0.001 goes on with it", self.refused(2, "run", "spring.yaml", "-q", "--duration", "60", "--resume"))
        self.ok("run", "spring.yaml", "-q", "--error", "1e-3", "--duration", "60", "--resume")
        self.assertEqual(self.summary("spring.json")["asked_for"]["error"], 1e-3)
        self.ok("run", "spring.yaml", "-q", "-o", "plain.csv")
        self.assertIn("it was asked for no error", self.refused(2, "run", "spring.yaml", "-q", "--error", "1e-3", "--resume", "-o", "plain.csv"))

    def test_a_run_that_does_not_get_to_the_next_row_has_no_hint(self):
        how = ["--method", "rk4", "--step", "0.001", "--max-steps", "1"]
        self.assertNotIn("--resume", self.run_it("run", "spring.yaml", "-q", *how).stderr)
        self.assertNotIn("--resume", self.run_it("run", "spring.yaml", "-q", *how, "--resume").stderr)

    def test_a_finished_run_is_left_alone(self):
        self.ok("run", "spring.yaml", "-q")
        before = (self.folder / "spring.csv").read_bytes()
        result = self.run_it("run", "spring.yaml", "--resume")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("has finished already", result.stderr)
        self.assertEqual((self.folder / "spring.csv").read_bytes(), before)


if __name__ == "__main__":
    unittest.main()
