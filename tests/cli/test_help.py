"""--help and --version, of the program and of its commands."""

import re
import unittest

from gauss_gen import SKEW, SOURCE, Program

OPTIONS = {"": ["--count", "--output", "--check", "--list-outputs", "--depfile", "--depfile-target", "--namespace", "--outputs", "--sensitivities", "--fold", "--route", "--strategy", "--parts", "--split",
                "--no-optimise", "--as-written", "--max-nodes", "--max-seconds", "--dump", "--timings", "--diagnostics", "--color", "--man", "--help", "--version"],
           "evaluate": ["--count", "--set", "--equilibrium", "--accelerate", "--time", "--digits", "--format", "--max-seconds", "--diagnostics", "--color", "--help"],
           "linearize": ["--count", "--at", "--set", "--assemble", "--time", "--digits", "--format", "--max-seconds", "--diagnostics", "--color", "--help"],
           "derivation": ["--count", "--output", "--format", "--max-seconds", "--diagnostics", "--color", "--help"],
           "explain": ["--format", "--help"], "init": ["--help"], "schema": ["--help"], "completion": ["--help"]}


class Help(Program):
    def pages(self):
        for command, options in OPTIONS.items():
            yield self.ok(*([command] if command else []), "--help"), options

    def test_every_option_is_there_with_a_word_about_it(self):
        for page, options in self.pages():
            for option in options:
                self.assertRegex(page, rf"(?m){option}\b.*  [A-Za-z].*$")

    def test_every_command_is_in_the_usage(self):
        page = self.ok("--help")
        for command in filter(None, OPTIONS):
            self.assertRegex(page, rf"(?m)^  gauss-gen {command}\b.*  [a-zA-Z].*$")

    def test_it_fits_100_columns(self):
        for page, _ in self.pages():
            self.assertLessEqual(max(map(len, page.splitlines())), 100)

    def test_nothing_of_the_option_parser_shows(self):
        for page, _ in self.pages():
            for word in ("TEXT", "INT", "{", "...", "Positionals", "SUBCOMMAND", "\n\n\n"):
                self.assertNotIn(word, page)

    def test_the_exit_codes_are_stated(self):
        self.assertIn("0 ok, 1 error in the model, 2 usage, 3 input or output, 4 too large, 70 internal", self.ok("-h"))

    def test_every_status_of_evaluate_is_stated_there_and_in_the_documents(self):
        code = (SOURCE / "generator/evaluation.cpp").read_text()
        found = set(re.findall(r'doubt\("(\w+)"\)', code))
        self.assertGreaterEqual(found, {"not_finite", "impossible_bodies"})
        page, document = self.ok("evaluate", "--help"), (SOURCE / "docs/emitted-code.md").read_text()
        for status in found:
            self.assertRegex(page, rf"(?m)^  {status}  +[a-z]")
            self.assertIn(f"`{status}`", document)

    def test_it_needs_no_model_and_looks_at_none(self):
        self.assertEqual(self.ok("--help"), self.ok("nowhere.yaml", "--help"))
        self.assertEqual(self.files(), [])

    def test_the_version_is_one_line(self):
        self.assertRegex(self.ok("--version"), r"^gauss-gen \d+\.\d+\.\d+\n$")
        self.assertIn(self.ok("--version").strip(), self.ok(SKEW, "-o", "-"))


if __name__ == "__main__":
    unittest.main()
