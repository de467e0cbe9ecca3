"""gauss-gen model.yaml: every option, and what it writes."""

import json
import os
import re
import shutil
import subprocess
import unittest

from gauss_gen import MODELS, PARTICLE, SKATER, SKEW, SOURCE, SPHERE, Program, without_poles

STAGES = {"model": "  rolling_around: ", "kinematics": "body ball: dv/dt", "paper": "rolling_around",
          "strategy": "G_", "artefacts": "rhs", "header": "#ifndef"}


# Springs along coordinates beside a held one: forces that no body feels have to be spread over the bodies by the whole metric.
SPRUNG_CHAIN = """gauss: 1
name: sprung_$n
counts: {n: 10}
coordinates: {lift: {held_at: sin(t)/10}}
frames: {hand: {position: [0, 0, lift]}}
joints:
  j_1: {type: universal, parent: hand, child: link_1, axes: [x, y]}
  j_$(i+1): {count: n - 1, type: universal, parent: link_$i, child: link_$(i+1), at: [0, 0, -1/2], axes: [x, y]}
bodies: {link_$i: {count: n, mass: 2, inertia: [0.04, 0.04, 0.001], centre: [0, 0, -1/4]}}
forces:
  gravity: {uniform: [0, 0, -9.81]}
  bend_$i: {count: n, spring: j_$(i)_1, stiffness: 3}
"""


class LargeModels(Program):
    def test_series_of_thousands_of_factors_are_within_what_compilers_evaluate(self):
        """Instantiated: what is a constant in them is evaluated then, in so many steps at most."""
        self.ok(MODELS / "families/quadruped.yaml", "--outputs", "rhs,taylor", "-o", ".")
        name = "gauss::quadruped_4::"
        source = self.write("all.cpp", f'#include "quadruped_4.hpp"\ntemplate gauss::StatusOf<double> {name}taylor<double>(const double&, const {name}State<double>&, '
                            f"const {name}Inputs<double>&, const {name}Prepared<double>&, int, {name}TaylorSeries<double>&);\n")
        for compiler in {os.environ["GAUSS_CXX"], *filter(shutil.which, ("g++", "clang++"))}:
            result = subprocess.run([compiler, "-std=c++17", "-fsyntax-only", source], capture_output=True, text=True, check=False)
            self.assertEqual(result.returncode, 0, (compiler, result.stderr[:3000]))


class Output(Program):
    def test_no_options_write_the_header_into_the_working_folder(self):
        self.assertEqual(self.ok(SPHERE), "")
        self.assertEqual(self.files(), ["sphere_in_cylinder.hpp"])
        self.assertIn("namespace gauss::sphere_in_cylinder {", (self.folder / "sphere_in_cylinder.hpp").read_text())

    def test_the_header_is_called_after_the_model_not_after_the_file(self):
        self.ok(self.write("other file.yaml", PARTICLE))
        self.assertIn("particle.hpp", self.files())

    def test_a_folder_is_created_when_missing_blanks_and_all(self):
        for folder in ("new", "a b/c d", "slash/", "./dot/../dot"):
            self.ok(SKEW, "-o", folder)
            self.assertTrue((self.folder / folder / "skew_chart.hpp").is_file(), folder)
        self.ok(SKEW, "--output=equals")
        self.assertTrue((self.folder / "equals/skew_chart.hpp").is_file())

    def test_the_name_of_a_header_is_no_folder(self):
        for name, instead in {"foo.hpp": "-o .,", "foo.h": "-o .,", "a b/foo.hpp": "-o a b,"}.items():
            for more in ([], ["--list-outputs"]):
                message = self.refused(2, SKEW, "-o", name, *more)
                self.assertIn(f"-o: '{name}' is the name of a file", message)
                self.assertIn(f"write {instead} or -o - > {name}", message)

    def test_a_folder_may_have_such_a_name_where_it_is_clearly_one(self):
        (self.folder / "foo.hpp").mkdir()
        for folder in ("foo.hpp", "new.hpp/"):
            self.ok(SKEW, "-o", folder)
            self.assertTrue((self.folder / folder / "skew_chart.hpp").is_file(), folder)

    def test_a_dash_writes_to_standard_output_and_no_file(self):
        text = self.ok(SKEW, "-o", "-")
        self.assertEqual(self.files(), [])
        self.ok(SKEW)
        self.assertEqual(text, (self.folder / "skew_chart.hpp").read_text())

    def test_the_model_may_come_from_standard_input(self):
        self.ok("-", stdin=PARTICLE)
        self.assertEqual(self.files(), ["particle.hpp"])
        self.assertIn("gauss-gen -\n", (self.folder / "particle.hpp").read_text())

    def test_options_may_stand_before_and_after_the_model(self):
        before = self.ok("--outputs", "rhs,energy", "-o", "-", SKEW)
        self.assertEqual(before, self.ok(SKEW, "-o", "-", "--outputs", "rhs,energy"))

    def test_a_header_says_nothing_of_the_folder_it_was_made_in(self):
        here = self.ok(self.write("m.yaml", PARTICLE), "-o", "-")
        self.assertEqual(here, self.ok("m.yaml", "-o", "-"))
        self.assertNotIn(str(self.folder), here)

    def test_every_file_may_be_read_by_others_as_the_umask_allows(self):
        self.ok(SKEW)
        self.assertEqual((self.folder / "skew_chart.hpp").stat().st_mode & 0o444, 0o444)


class Size(Program):
    def said_of(self, model, *arguments):
        result = self.run_it("-", *arguments, stdin=model)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stderr

    def test_an_output_that_is_most_of_a_large_header_is_named_with_those_that_are_left(self):
        said = self.said_of(SPRUNG_CHAIN)
        found = re.fullmatch(r"'compulsion' is (\d+) of the (\d+) operations in sprung_10\.hpp; without it: --outputs (\S+) .*\n", said)
        self.assertIsNotNone(found, said)
        part, whole = int(found[1]), int(found[2])
        self.assertGreater(2 * part, whole)
        before = (self.folder / "sprung_10.hpp").stat().st_size
        self.assertEqual(self.said_of(SPRUNG_CHAIN, "--outputs", found[3]), "")
        header = (self.folder / "sprung_10.hpp").read_text()
        self.assertNotIn("struct Compulsion", header)
        self.assertIn("struct Energy", header)
        self.assertLess(len(header.encode()), 0.6 * before)
        row = next(line for line in header.splitlines() if line.startswith("//   rhs "))
        self.assertGreater(whole - part, sum(map(int, row.split()[2:])))

    def test_nothing_is_said_of_small_headers_and_of_what_was_asked_for(self):
        self.assertEqual(self.said_of(SPRUNG_CHAIN, "--count", "n=2"), "")
        self.assertEqual(self.said_of(SPRUNG_CHAIN, "--outputs", "rhs,compulsion"), "")


class WritingNothing(Program):
    def test_check_forms_no_output(self):
        said = self.run_it("-", "--check", "--timings", stdin=SPRUNG_CHAIN).stderr
        stages = [line.split()[0] for line in said.splitlines()]
        self.assertIn("strategy", stages)
        for stage in ("artefacts", "passes", "header", "compulsion"):
            self.assertNotIn(stage, stages)

    def test_check_warns_of_outputs_that_a_model_lacks_as_generation_does(self):
        outputs = "reactions,reaction_forces,joint_reactions,residuals,quantities,compulsion,sensitivities,jacobian,energy"
        warned = 0
        for model in sorted(MODELS.glob("*.yaml")):
            checked = self.run_it(model, "--check", "--outputs", outputs).stderr
            generated = self.run_it(model, "-o", "-", "--outputs", outputs).stderr if warned < 60 else checked
            self.assertEqual(checked, generated, model)
            warned += checked.count("warning[")
        self.assertGreater(warned, 10)

    def test_check_says_ok_and_writes_no_file(self):
        for model in sorted(MODELS.rglob("*.yaml")):
            remark = "" if "unit:" in model.read_text() else " (it states no units, so none are checked)"
            told = re.sub(r", mobility \d+ \(\d+ speeds?, \d+ constraints?( of rank \d+)?\)", "", self.ok(model, "--check"))
            self.assertEqual(told, f"{model}: ok{remark}\n")
        self.assertEqual(self.files(), [])

    def test_list_outputs_names_the_header_that_would_be_written(self):
        self.assertEqual(self.ok(SKEW, "--list-outputs"), "skew_chart.hpp\n")
        self.assertEqual(self.ok(SKEW, "--list-outputs", "-o", "a b"), "a b/skew_chart.hpp\n")
        self.assertEqual(self.ok(SKEW, "--list-outputs", "-o", "a/"), "a/skew_chart.hpp\n")
        self.assertEqual(self.ok(SKEW, "--list-outputs", "-o", "-"), "-\n")
        self.assertEqual(self.files(), [])

    def test_every_stage_can_be_printed_and_read(self):
        for stage, part in STAGES.items():
            text = self.ok(SPHERE, f"--dump={stage}")
            self.assertIn(part, text)
            self.assertGreater(text.count("\n"), 5, stage)
            self.assertFalse([c for c in text if c < " " and c != "\n"], stage)
        self.assertEqual(self.files(), [])

    def test_stages_have_titles_when_there_are_several(self):
        for arguments in (["--dump", "model,strategy"], ["--dump", "model", "--dump", "strategy"]):
            text = self.ok(*arguments, SPHERE)
            self.assertLess(text.index("=== model\n"), text.index("=== strategy\n"))

    def test_a_dump_of_the_header_is_the_header(self):
        self.assertEqual(self.ok(SKEW, "--dump=header"), self.ok(SKEW, "-o", "-"))

    def test_timings_go_to_standard_error(self):
        result = self.run_it(SPHERE, "--timings", "-o", "-")
        self.assertEqual(result.stdout, self.ok(SPHERE, "-o", "-"))
        head, *lines = without_poles(result.stderr).splitlines()
        self.assertEqual(head.split(), ["stage", "ms", "nodes", "in", "nodes", "out"])
        stages = lines[:lines.index(next(line for line in lines if line.startswith("total"))) + 1]
        self.assertEqual([line.split()[0] for line in stages],
                         ["model", "kinematics", "strategy", "start", "check", "artefacts", "passes", "header", "total"])
        for line in stages[:-1]:
            self.assertRegex(line, r"^\w+ +\d+\.\d{3} +\d+ +\d+")
        self.assertRegex(stages[-1], r"^total +\d+\.\d{3} +\d+\.\d MB at most")

    def test_a_stage_finds_the_nodes_that_the_one_before_it_made(self):
        rows = [row for row in self.facts(SPHERE) if row.get("stage", "total") != "total"]
        self.assertEqual(rows[0]["nodes_in"], 0)
        for before, after in zip(rows, rows[1:]):
            self.assertEqual(after["nodes_in"], before["nodes_out"], after["stage"])
            self.assertGreaterEqual(after["nodes_out"], after["nodes_in"])
        self.assertGreater(rows[-1]["nodes_out"], 100)

    def test_what_passes_saved_is_what_the_header_counts_less(self):
        steps = [row for row in self.facts(SPHERE, "--outputs", "rhs") if row.get("function") == "rhs_regular"]
        for before, after in zip(steps, steps[1:]):
            self.assertEqual(after["operations_before"], before["operations_after"], after["pass"])
            self.assertLessEqual(after["operations_after"], after["operations_before"])
        self.assertLess(steps[-1]["operations_after"], steps[0]["operations_before"])
        plain, optimised = (self.count_of_rhs("--outputs", "rhs", *more) for more in (["--no-optimise"], []))
        # The text divides once where the graph has a product of reciprocals, and the other way round.
        self.assertAlmostEqual(steps[0]["operations_before"], plain, delta=3)
        self.assertAlmostEqual(steps[-1]["operations_after"], optimised, delta=3)

    def test_what_is_tried_and_left_out_has_its_time_and_saves_nothing(self):
        steps = [row for row in self.facts(SPHERE, "--outputs", "rhs") if row.get("function") == "rhs_regular"]
        self.assertEqual([row["pass"] for row in steps if row["pass"] in ("left out", "checks")], ["left out", "checks"])
        self.assertEqual([row["pass"] for row in steps].count("prepare"), 3)
        left_out = next(row for row in steps if row["pass"] == "left out")
        self.assertEqual(left_out["operations_before"], left_out["operations_after"])
        self.assertGreater(left_out["milliseconds"], 0)

    def test_a_row_of_the_table_holds_one_pass_of_all_functions(self):
        sums, runs = {}, {}
        for row in self.facts(SPHERE, "--fold"):
            if "pass" not in row: continue
            function = row["function"], row["pass"]
            runs[function] = runs.get(function, 0) + 1
            before, after = sums.get((row["pass"], runs[function]), (0, 0))
            sums[row["pass"], runs[function]] = before + row["operations_before"], after + row["operations_after"]
        table = self.run_it(SPHERE, "--fold", "--timings", "-o", "-").stderr.split("\npass ")[1].split("\nfunction ")[0]
        rows = re.findall(r"^([a-z ]+?) +\d+\.\d{3} +(\d+) +(\d+) +-?\d+$", table, re.M)
        self.assertIn("units", [name for name, *_ in rows])
        self.assertEqual(sorted((name, int(before), int(after)) for name, before, after in rows),
                         sorted((name, before, after) for (name, _), (before, after) in sums.items()))

    def test_without_passes_there_is_nothing_to_say_of_them(self):
        self.assertFalse([row for row in self.facts(SPHERE, "--no-optimise") if "pass" in row])
        result = self.run_it(SPHERE, "--timings", "--no-optimise", "-o", "-")
        self.assertNotIn("saved", result.stderr)
        self.assertIn("--no-optimise", result.stdout)

    def test_what_stays_as_it_is_written_is_said_in_the_header(self):
        sums = SOURCE / "tests/headers/digits/sums.yaml"
        kept, written = (self.ok(sums, *more, "--outputs", "quantities", "-o", "-") for more in ([], ["--as-written", "cosines,roots"]))
        self.assertIn("const S cosine = S(1) - cos_x", written)
        self.assertNotIn("const S cosine = S(1) - cos_x", kept)
        self.assertIn("--as-written=cosines,roots", written)
        self.assertNotIn("--as-written", kept)
        self.assertEqual(self.run_it(sums, "--as-written", "cosine", "-o", "-").returncode, 2)

    def facts(self, *arguments):
        result = self.run_it(*arguments, "--timings", "--diagnostics", "json", "-o", "-")
        return [json.loads(line) for line in result.stderr.splitlines()]

    def count_of_rhs(self, *arguments):
        row = next(line for line in self.ok(SPHERE, *arguments, "-o", "-").splitlines() if re.match(r"^// +rhs +\d", line))
        return sum(int(number) for number in row.split()[2:])


class Depfile(Program):
    def test_it_names_the_header_and_the_model(self):
        model = self.write("m.yaml", PARTICLE)
        self.ok("m.yaml", "--depfile", "m.d")
        self.assertEqual((self.folder / "m.d").read_text(), "particle.hpp: m.yaml\n")
        self.ok(model, "-o", "out", "--depfile", "deep/m.d")
        self.assertIn("out/particle.hpp: ", (self.folder / "deep/m.d").read_text())

    def test_blanks_and_what_make_would_expand_are_escaped(self):
        self.write("a #1 $x.yaml", PARTICLE)
        self.ok("a #1 $x.yaml", "-o", "o p", "--depfile", "m.d")
        self.assertEqual((self.folder / "m.d").read_text(), "o\\ p/particle.hpp: a\\ \\#1\\ $$x.yaml\n")

    def test_a_line_break_in_a_name_is_refused(self):
        self.write("a\nb.yaml", PARTICLE)
        self.assertIn("--depfile: make has no way to write", self.refused(2, "a\nb.yaml", "--depfile", "m.d"))
        self.assertFalse((self.folder / "m.d").exists())

    def test_it_names_the_files_of_submodels_and_another_target(self):
        (self.folder / "parts").mkdir()
        self.write("parts/point.yaml", PARTICLE)
        self.write("m.yaml", "gauss: 1\nname: two\nsubmodels:\n  p_$i: {count: 2, file: parts/point.yaml}\n")
        self.ok("m.yaml", "--depfile", "m.d", "--depfile-target", "a stamp")
        self.assertEqual((self.folder / "m.d").read_text(), "a\\ stamp: m.yaml parts/point.yaml\n")
        # The header of a model that stands alone follows nothing else.
        self.ok("parts/point.yaml", "--depfile", "m.d")
        self.assertEqual((self.folder / "m.d").read_text(), "particle.hpp: parts/point.yaml\n")

    def test_standard_input_is_nothing_to_depend_on(self):
        self.ok("-", "--depfile", "m.d", stdin=PARTICLE)
        self.assertEqual((self.folder / "m.d").read_text(), "particle.hpp:\n")


class Contents(Program):
    def test_a_backslash_parts_no_folder_from_a_file(self):
        self.write("a\\b.yaml", PARTICLE)
        self.assertIn(" from a\\b.yaml (content hash ", self.ok("a\\b.yaml", "-o", "-"))

    def test_a_namespace_is_used_as_given(self):
        for name in ("acme", "acme::models", "a1::b_2", "gauss::mine"):
            self.assertIn(f"\nnamespace {name} {{\n", self.ok(SKEW, "-o", "-", "--namespace", name))

    def test_the_outputs_are_those_that_were_asked_for(self):
        text = self.ok(SPHERE, "-o", "-", "--outputs", "energy")
        self.assertIn(" energy(", text)
        self.assertIn(" rhs(", text)  # always there
        for absent in (" reactions(", " project(", " mass_matrix("):
            self.assertNotIn(absent, text)

    def test_the_order_of_the_request_does_not_matter(self):
        expected = self.ok(SPHERE, "-o", "-", "--outputs", "rhs,energy,residuals")
        self.assertEqual(expected, self.ok(SPHERE, "-o", "-", "--outputs", "residuals,rhs,energy"))
        self.assertEqual(expected, self.ok(SPHERE, "-o", "-", "--outputs", "energy", "--outputs=residuals,rhs"))
        self.assertEqual(expected, self.ok(SPHERE, "-o", "-", "--outputs=energy,energy,residuals,rhs"))

    def test_an_empty_word_in_a_list_of_outputs_is_refused(self):
        for words in (",", "rhs,,", ",rhs", "rhs,,energy"):
            error = self.refused(2, "--check", "--outputs", words, SPHERE)
            self.assertIn(f"--outputs: a word is missing beside a ',' in '{words}'", error)
        self.assertIn("--outputs: what is given for it is empty", self.refused(2, "--check", "--outputs", "", SPHERE))

    def test_fold_puts_the_parameters_in(self):
        plain, folded = self.ok(SKEW, "-o", "-"), self.ok(SKEW, "-o", "-", "--fold")
        self.assertIn("n_parameters = 6;", plain)
        self.assertNotIn("n_parameters = 6;", folded)
        self.assertLess(len(folded), len(plain))

    def test_the_papers_route_says_that_it_is_one(self):
        text = self.ok(SPHERE, "-o", "-", "--route", "paper")
        self.assertIn("--route=paper", text)
        self.assertIn("the paper's route", text)
        self.assertEqual(self.ok(SPHERE, "-o", "-", "--route", "emitted"), self.ok(SPHERE, "-o", "-"))

    def test_the_command_in_the_header_makes_the_same_header(self):
        options = ["--outputs", "energy,rhs", "--fold", "--namespace", "a::b"]
        text = self.ok(SKATER, "-o", "-", *options)
        command = next(line for line in text.splitlines() if "gauss-gen skater" in line).split("gauss-gen ")[1].split()
        self.assertEqual(text, self.ok(*command, "-o", "-", cwd=SKATER.parent))


if __name__ == "__main__":
    unittest.main()
