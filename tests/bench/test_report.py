"""The page of figures and its charts, from documents made up here."""

import json
import os
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

SOURCE = Path(os.environ["GAUSS_SOURCE_DIR"])
sys.path.insert(0, str(SOURCE / "bench"))

from harness import cases, charts, report, results, targets  # noqa: E402

MACHINE = {"processor": "one", "cores": 2, "load": 0.5, "compiler": "g++ 12", "flags": "-O3", "flags_of_instruction_counts": "-O3",
           "peers": {"SymPy": "1.11"}, "commit": "abc"}


def made_of(*rows, skipped=()):
    found = results.Results()
    for model, size, tool, metric, value in rows:
        found.add((model, size), tool, metric, value, "ns", low=value, high=2 * value)
    for what in skipped:
        found.skip(what, "it is not here\n")
    with tempfile.TemporaryDirectory(prefix="gauss bench ") as folder:
        path = Path(folder) / "a/found.json"
        results.write(path, found, MACHINE, "2000-01-01", "all")
        return json.loads(path.read_text(encoding="utf-8"))


class Results(unittest.TestCase):
    def test_what_is_written_is_read(self):
        for document in (made_of(), made_of(("sphere", 1, "gauss", "ns_rhs", 20.5)), made_of(("sphere", 1, "gauss", "ns_rhs", 20.5),
                                                                                            ("sphere", 1, "sympy", "ns_rhs", 30), skipped=["mujoco"])):
            self.assertEqual(results.faults(document), [])
        self.assertEqual(results.Document(document).value("sphere", 1, "sympy", "ns_rhs"), 30)
        self.assertEqual(document["skipped"], [{"what": "mujoco", "why": "it is not here"}])

    def test_a_shape_that_is_not_as_it_should_be_is_named(self):
        document = made_of(("sphere", 1, "gauss", "ns_rhs", 20.5))
        del document["machine"]
        self.assertEqual(results.faults(document), ["no 'machine'"])
        document = made_of(("sphere", 1, "gauss", "ns_rhs", 20.5), ("sphere", 1, "gauss", "ns_rhs", 21))
        self.assertEqual(len(results.faults(document)), 1)
        document["rows"][0]["value"] = "fast"
        self.assertIn("'value'", results.faults(document)[0])


    def test_a_part_takes_the_place_of_what_it_measures(self):
        old = made_of(("sphere", 1, "gauss", "ns_rhs", 20), ("sphere", 1, "sympy", "ns_rhs", 90), ("four_bar", 1, "gauss", "ns_rhs", 50),
                      skipped=["sphere_1: batch of 8", "mujoco"])
        found, machine, date, selection = results.merged(old, made_of(("sphere", 1, "gauss", "ns_rhs", 15)))
        self.assertEqual([(row["model"], row["tool"], row["value"]) for row in found.rows], [("four_bar", "gauss", 50), ("sphere", "gauss", 15)])
        self.assertEqual([entry["what"] for entry in found.skipped], ["mujoco"])
        self.assertEqual((machine, date), (MACHINE, "2000-01-01"))
        self.assertIn("anew at abc", selection)


class Page(unittest.TestCase):
    def page(self, *rows, **more):
        return report.text_of(results.Document(made_of(*rows, **more)))

    def test_a_figure_is_met_or_not(self):
        self.assertIn("| operations, sphere, 1 | ≤ 85 | 80 | yes |", self.page(("sphere", 1, "gauss", "operations", 80)))
        self.assertIn("| operations, sphere, 1 | ≤ 85 | 86 | **no** |", self.page(("sphere", 1, "gauss", "operations", 86)))
        self.assertIn("| operations, sphere, 1 | ≤ 85 | not measured | **no** |", self.page())

    def test_a_peer_is_beaten_by_a_factor(self):
        def against(ours):
            return self.page(("sphere", 1, "gauss", "ns_rhs", ours), ("sphere", 1, "sympy", "ns_rhs", 100))
        self.assertIn("| time against SymPy, sphere, 1 | ≤ 1/5 | 1/8 | yes |", against(12.5))
        self.assertIn("| time against SymPy, sphere, 1 | ≤ 1/5 | 1/4 | **no** |", against(25))
        self.assertIn("| time against SymPy, sphere, 1 | ≤ 1/5 | 2 times slower | **no** |", against(200))

    def test_code_by_hand_is_the_best_of_its_ways(self):
        page = self.page(("planar_chain", 5, "gauss", "ns_rhs", 100), ("planar_chain", 5, "by hand", "ns_rhs", 120),
                         ("planar_chain", 5, "by hand, dense", "ns_rhs", 80))
        self.assertIn("| time against code by hand, planar_chain, 5 | ≤ 1.03 times | 1.25 times | **no** |", page)

    def test_what_is_lost_is_said(self):
        page = self.page(("sphere", 1, "gauss", "ns_rhs", 30), ("sphere", 1, "by hand", "ns_rhs", 20), ("sphere", 1, "sympy", "ns_rhs", 25))
        self.assertIn("| sphere, 1 | time | by hand | 1.5 times |", page)
        self.assertIn("Nothing, in this run.", self.page(("sphere", 1, "gauss", "ns_rhs", 10), ("sphere", 1, "by hand", "ns_rhs", 20)))

    def test_what_was_left_out_is_said(self):
        self.assertIn("- mujoco: it is not here", self.page(skipped=["mujoco"]))

    def test_numbers_have_three_digits(self):
        self.assertEqual([targets.number(value) for value in (0.01234, 1.5, 99.94, 1234.5, 12345678, 0, None)],
                         ["0.0123", "1.5", "99.9", "1 234", "12 345 678", "0", "–"])

    def test_a_page_that_was_changed_is_found(self):
        document = results.Document(made_of(*(("planar_chain", n, "gauss", "ns_rhs", 10 * n) for n in (1, 2))))
        with tempfile.TemporaryDirectory(prefix="gauss bench ") as folder:
            page = Path(folder) / "docs/performance.md"
            report.write(document, page)
            self.assertEqual(report.differences(document, page), [])
            self.assertTrue((page.parent / "performance/planar_chain.svg").is_file())
            page.write_text(page.read_text(encoding="utf-8").replace("10", "9"), encoding="utf-8")
            self.assertIn("performance.md is not what the JSON gives", report.differences(document, page)[0])


class Charts(unittest.TestCase):
    def test_they_are_svg_with_a_line_a_mark_and_a_name_for_each(self):
        text = charts.lines_chart("a < b", "rods", "ns", [("gauss", [(1, 2.0), (50, 900.0)]), ("by <hand>", [(2, 0.01)])])
        root = xml.fromstring(text)
        words = "".join(root.itertext())
        for word in ("a < b", "gauss", "by <hand>", "1000", "0.01", "50"):
            self.assertIn(word, words)

    def test_names_do_not_cover_each_other(self):
        places = [label[0] for label in charts.apart([[100, 0, "a", ""], [101, 0, "b", ""], [90, 0, "c", ""]])]
        self.assertTrue(all(b - a >= 15 for a, b in zip(places, places[1:])), places)


class Cases(unittest.TestCase):
    def test_models_are_there(self):
        for entry in cases.CASES:
            for emitted in entry.emitted:
                self.assertTrue((SOURCE / f"models/{emitted.model}.yaml").is_file(), emitted)
        for entry in cases.GENERATIONS:
            self.assertTrue((SOURCE / f"models/{entry.model}.yaml").is_file(), entry)

    def test_a_part_is_chosen_by_name_or_kind(self):
        class Options:
            quick, only = False, ["planar_chain_2", "sphere"]
        names = [case.name for case in cases.selected(cases.CASES, Options)]
        self.assertEqual(names, ["planar_chain_2", "sphere_1", "sphere_quaternion_1"])


if __name__ == "__main__":
    unittest.main()
