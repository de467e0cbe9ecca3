"""The manual page and the completions of shells say all that --help says; messages for programs."""

import json
import re
import shutil
import subprocess
import unittest

from gauss_sim import SPRING, Program

COMMANDS = ["", "run", "advise", "study", "ensemble", "effects", "plot", "methods", "completion"]
BASH_WORDS = """
source ./completion
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=(); _gauss_sim; printf '%s\\n' "${COMPREPLY[@]}"
"""


class Shells(Program):
    def tool(self, *command, **more):
        if shutil.which(command[0]) is None:
            self.skipTest(f"there is no {command[0]}")
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=False, timeout=60, **more)

    def options(self):
        for command in COMMANDS:
            page = self.ok(*([command] if command else []), "--help")
            for option in re.findall(r"(?m)^  (?:-\w,)?(--[a-z-]+)", page):
                yield command, option

    def test_the_manual_page_has_every_option_of_every_command(self):
        page = self.ok("--man")
        parts = re.split(r"(?m)^\.SS (\w+)\n", page.split(".SH EXIT STATUS")[0])
        sections = {"": parts[0], **dict(zip(parts[1::2], parts[2::2]))}
        self.assertEqual(set(sections), set(COMMANDS))
        found = list(self.options())
        self.assertGreater(len(found), 35)
        for command, option in found:
            self.assertIn(f"\\fB{option}\\fR".replace("-", "\\-"), sections[command], (command, option))

    def test_the_manual_page_is_set_without_warnings(self):
        result = self.tool("groff", "-man", "-ww", "-Tutf8", self.write("gauss-sim.1", self.ok("--man")))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        shown = re.sub(r"\x1b\[[0-9;]*m|.\x08", "", result.stdout)
        for words in ("gauss-sim run [OPTIONS] FILE", "gauss-sim plot [OPTIONS] CSV", "--diagnostics FORMAT", "EXIT STATUS", "interrupted"):
            self.assertIn(words, shown)

    def bash(self, *words):
        self.write("completion", self.ok("completion", "bash"))
        result = self.tool("bash", "-c", BASH_WORDS, "bash", "gauss-sim", *words)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return set(result.stdout.split())

    def test_bash_completes_commands_options_and_words(self):
        self.write("spring.yaml", SPRING)
        self.assertEqual(self.bash(""), set(COMMANDS) - {""})
        self.assertEqual(self.bash("run", "--to"), {"--tolerance"})
        self.assertEqual(self.bash("run", "--method", "ta"), {"taylor"})
        self.assertEqual(self.bash("run", "--projection", ""), {"full", "positions", "velocities", "energy", "gains", "off"})
        self.assertEqual(self.bash("run", "sp"), {"spring.yaml"})
        self.assertEqual(self.bash("completion", ""), {"bash", "zsh", "fish"})

    def test_scripts_are_read_by_their_shells(self):
        for shell in ("bash", "zsh", "fish"):
            with self.subTest(shell):
                text = self.ok("completion", shell)
                for command, option in self.options():
                    self.assertIn(option[2:], text, (command, option))
                result = self.tool(shell, "-n", self.write("completion", text))
                self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.refused(2, "completion", "tcsh")
        self.refused(2, "completion")
        self.refused(2)


class Messages(Program):
    def test_programs_read_them_as_json(self):
        self.write("spring.yaml", SPRING.replace("mass: m", "mass: mm"))
        for command in ("run", "study"):
            said = [json.loads(line) for line in self.refused(1, command, "spring.yaml", "--diagnostics", "json").splitlines()]
            self.assertEqual((said[0]["severity"], said[0]["file"], said[0]["line"]), ("error", "spring.yaml", 9))
        for command in ("run", "study", "plot"):
            said = json.loads(self.refused(3, command, "none", "--diagnostics", "json"))
            self.assertIn("none", said["message"])

    def test_colour_is_for_who_wants_it(self):
        self.write("spring.yaml", SPRING.replace("mass: m", "mass: mm"))
        self.assertIn("\x1b[", self.refused(1, "run", "spring.yaml", "--color", "always"))
        self.assertNotIn("\x1b[", self.refused(1, "run", "spring.yaml", "--color", "never"))
        self.assertNotIn("\x1b[", self.refused(1, "run", "spring.yaml"))


if __name__ == "__main__":
    unittest.main()
