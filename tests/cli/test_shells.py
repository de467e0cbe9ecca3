"""The manual page and the completions of shells say all that --help says."""

import re
import shutil
import subprocess
import unittest

from gauss_gen import MODELS, Program

COMMANDS = ["", "evaluate", "linearize", "derivation", "explain", "init", "schema", "completion"]
BASH_WORDS = """
source ./completion
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=(); _gauss_gen; printf '%s\\n' "${COMPREPLY[@]}"
"""


class Page(Program):
    def options(self, command):
        """Long names in --help."""
        page = self.ok(*([command] if command else []), "--help")
        return re.findall(r"(?m)^  (?:-\w,)?(--[a-z-]+)", page)

    def all_options(self):
        return {(command, option) for command in COMMANDS for option in self.options(command)}

    def run_tool(self, *command, **more):
        if shutil.which(command[0]) is None:
            self.skipTest(f"there is no {command[0]}")
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=False, timeout=60, **more)


class Manual(Page):
    def test_it_has_every_option_and_every_command(self):
        page = self.ok("--man")
        parts = re.split(r"(?m)^\.SS (\w+)\n", page.split(".SH EXIT STATUS")[0])
        sections = {"": parts[0], **dict(zip(parts[1::2], parts[2::2]))}
        self.assertEqual(set(sections), set(COMMANDS))
        self.assertGreater(len(self.all_options()), 30)
        for command, option in self.all_options():
            self.assertIn(f"\\fB{option}\\fR".replace("-", "\\-"), sections[command], (command, option))

    def test_it_is_the_same_every_day(self):
        self.assertEqual(self.ok("--man"), self.ok("--man"))
        self.assertNotRegex(self.ok("--man"), r"20\d\d")

    def test_it_is_set_without_warnings(self):
        page = self.write("gauss-gen.1", self.ok("--man"))
        result = self.run_tool("groff", "-man", "-ww", "-Tutf8", page)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        shown = re.sub(r"\x1b\[[0-9;]*m|.\x08", "", result.stdout)
        for word in ("gauss-gen evaluate [OPTIONS] MODEL", "--diagnostics FORMAT", "EXIT STATUS", "NO_COLOR", "'dot(chi)=2'"):
            self.assertIn(word, shown)

    def test_man_shows_it_without_warnings(self):
        page = self.write("gauss-gen.1", self.ok("--man"))
        result = self.run_tool("man", "--warnings", "-l", page)
        self.assertEqual((result.returncode, result.stderr), (0, ""))


class Completion(Page):
    def script(self, shell):
        return self.write("completion", self.ok("completion", shell))

    def test_every_shell_reads_its_script(self):
        for shell in ("bash", "zsh", "fish"):
            with self.subTest(shell):
                result = self.run_tool(shell, "-n", self.script(shell))
                self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_every_option_and_every_command_is_in_each(self):
        for shell in ("bash", "zsh", "fish"):
            text = self.ok("completion", shell)
            for command, option in self.all_options():
                name = f" -l {option[2:]} " if shell == "fish" else option
                self.assertIn(name, text, (shell, command))
            for command in COMMANDS:
                self.assertRegex(text, rf"\b{command}\b")

    def bash(self, *words):
        return set(self.run_tool("bash", "-c", BASH_WORDS, "bash", "gauss-gen", *words).stdout.split("\n")) - {""}

    def test_bash_completes_what_can_follow(self):
        self.script("bash")
        self.write("a.yaml", "")
        self.write("b.txt", "")
        self.assertEqual(self.bash("ev"), {"evaluate"})
        self.assertEqual(self.bash(""), {"a.yaml", *COMMANDS[1:]})
        self.assertEqual(self.bash("evaluate", ""), {"a.yaml"})
        self.assertEqual(self.bash("--ro"), {"--route"})
        self.assertEqual(self.bash("--route", ""), {"emitted", "paper"})
        self.assertEqual(self.bash("--route", "="), {"emitted", "paper"})
        self.assertEqual(self.bash("--route", "=", "pa"), {"paper"})
        self.assertEqual(self.bash("--outputs", "rhs,ener"), {"rhs,energy"})
        self.assertEqual(self.bash("evaluate", "--format", ""), {"table", "json"})
        self.assertEqual(self.bash("derivation", "--format", ""), {"markdown", "latex"})
        self.assertEqual(self.bash("explain", "E01"), {f"E01{i}" for i in range(8)})
        self.assertEqual(self.bash("completion", ""), {"bash", "zsh", "fish"})
        for command in COMMANDS:
            self.assertGreaterEqual(self.bash(*([command] if command else []), "--"), set(self.options(command)))

    def fish(self, line):
        result = self.run_tool("fish", "-c", f"source completion; complete -C '{line}'", env={"HOME": str(self.folder), "PATH": "/usr/bin:/bin"})
        return {row.split("\t")[0] for row in result.stdout.splitlines()}

    def test_fish_completes_what_can_follow(self):
        self.script("fish")
        self.write("a.yaml", "")
        self.assertEqual(self.fish("gauss-gen --route "), {"emitted", "paper"})
        self.assertEqual(self.fish("gauss-gen evaluate --format "), {"table", "json"})
        self.assertGreaterEqual(self.fish("gauss-gen "), {"a.yaml", *COMMANDS[1:]})
        for command in COMMANDS:
            self.assertGreaterEqual(self.fish(f"gauss-gen {command} --"), set(self.options(command)))

    def test_bash_has_no_finding(self):
        result = self.run_tool("shellcheck", "-s", "bash", "-e", "SC2207", self.script("bash"))
        self.assertEqual(result.stdout, "")

    def test_a_shell_that_is_not_known_is_refused(self):
        self.assertIn("a shell is needed: bash, zsh or fish", self.refused(2, "completion"))
        self.assertIn("did you mean 'zsh'?", self.refused(2, "completion", "zhs"))
        self.refused(2, "completion", "bash", MODELS)


if __name__ == "__main__":
    unittest.main()
