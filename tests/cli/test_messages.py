"""How messages on standard error look: for people, in colour on terminals, or as JSON lines for programs."""

import json
import os
import pty
import re
import subprocess
import unittest
from pathlib import Path

from gauss_gen import BROKEN, NO_UNITS, PARTICLE, PROGRAM, SKEW, SOURCE, Program

WARNED = PARTICLE.replace("value: 2, unit: kg", "value: 2, unit: g")
COMMANDS = ([], ["evaluate"], ["derivation"])
KEYS = ["severity", "code", "message", "hint", "file", "line", "column", "end_line", "end_column", "begin", "end"]


class Json(Program):
    def lines(self, *arguments, stdin=None):
        result = self.run_it(*arguments, "--diagnostics=json", stdin=stdin)
        self.assertTrue(result.stderr.isascii())
        return result.returncode, [json.loads(line) for line in result.stderr.splitlines()]

    def test_a_finding_is_an_object_with_its_place(self):
        self.write("m.yaml", BROKEN)
        begin = BROKEN.index("mm")
        for command in (*COMMANDS, ["--check"], ["--list-outputs"]):
            code, [found] = self.lines(*command, "m.yaml")
            self.assertEqual(code, 1)
            self.assertEqual(list(found), KEYS)
            self.assertEqual({key: found[key] for key in found if key not in ("message", "hint")},
                             {"severity": "error", "code": "E031", "file": "m.yaml", "line": 9, "column": 13, "end_line": 9,
                              "end_column": 15, "begin": begin, "end": begin + 2})
            self.assertIn("'mm'", found["message"])
            self.assertIn("'m'", found["hint"])

    def test_findings_say_the_same_as_for_people(self):
        for path in sorted((SOURCE / "tests/diagnostics").glob("*.yaml")):
            with self.subTest(path.name):
                code, objects = self.lines(path)
                result = self.run_it(path, errors="replace")
                self.assertEqual(code, result.returncode)
                heads = re.findall(r"(?m)^.*:(\d+):(\d+): (error|warning)\[(\w+)\]: ", result.stderr)
                self.assertEqual([(str(o["line"]), str(o["column"]), o["severity"], o["code"]) for o in objects], heads)
                self.assertEqual(len(re.findall(r"(?m)^ *= hint: ", result.stderr)), sum(o["hint"] != "" for o in objects))
                for found in objects:
                    size = Path(found["file"]).stat().st_size  # of a submodel, perhaps
                    self.assertLessEqual(found["begin"], found["end"])
                    self.assertLessEqual(found["end"], size + 3)
                    self.assertLessEqual((found["line"], found["column"]), (found["end_line"], found["end_column"]))

    def test_an_expression_on_the_command_line_is_found_fault_with_as_one_in_a_model(self):
        code, [found] = self.lines("evaluate", SKEW, "--set", "m=2*")
        self.assertEqual((code, found["code"], list(found)), (2, "E033", ["severity", "code", "message", "hint"]))
        self.assertEqual(found["message"], "--set m: the expression stops where an operand should follow")

    def test_columns_count_characters_and_spans_bytes(self):
        text = PARTICLE.replace("mass: m", 'about: "ä€", mass: mm')
        _, [found] = self.lines("-", stdin=text)
        line = text.splitlines()[8]
        self.assertEqual((found["file"], found["column"]), ("<stdin>", line.index("mm") + 1))
        self.assertEqual(text.encode()[found["begin"]:found["end"]], b"mm")

    def test_warnings_leave_the_rest_as_it_is(self):
        code, [found] = self.lines("-", "-o", "-", stdin=WARNED)
        self.assertEqual((code, found["severity"], found["code"]), (0, "warning", "W055"))
        self.assertEqual(self.run_it("-", "-o", "-", "--diagnostics", "json", stdin=WARNED).stdout,
                         self.run_it("-", "-o", "-", stdin=WARNED).stdout)
        self.assertEqual(self.lines("-", "--check", stdin=PARTICLE), (0, []))

    def test_other_messages_are_lines_too(self):
        self.assertEqual(self.lines("nowhere.yaml"),
                         (3, [{"severity": "error", "message": "nowhere.yaml: No such file or directory"}]))
        code, [found] = self.lines(SKEW, "--bogus")
        self.assertEqual((code, found["severity"], found["hint"]), (2, "error", "Run gauss-gen --help for the options."))
        code, [found] = self.lines("evaluate", SKEW, "--set", "nothing=1")
        self.assertEqual((code, found["severity"]), (2, "error"))
        code, notes = self.lines(SKEW, "--check", "--timings")
        self.assertEqual((code, {note["severity"] for note in notes}), (0, {"note"}))
        code, warnings = self.lines("evaluate", "-", "--set", "m=-1", stdin=PARTICLE)
        self.assertEqual((code, {found["severity"] for found in warnings}), (0, {"warning"}))

    def test_a_name_of_a_file_that_is_not_utf8_breaks_no_line(self):
        name = b"caf\xe9\n.yaml"
        (self.folder / os.fsdecode(name)).write_text(BROKEN)
        result = subprocess.run([PROGRAM, name, "--diagnostics=json"], cwd=self.folder, capture_output=True, check=False)
        self.assertEqual(json.loads(result.stderr)["file"], "caf\ufffd\n.yaml")

    def test_a_terminal_obeys_no_name_of_a_file(self):
        for name, shown in (("red\x1b[31m.yaml", "red\ufffd[31m.yaml"), ("back\r.yaml", "back\ufffd.yaml")):
            self.assertEqual(self.refused(3, name), f"gauss-gen: {shown}: No such file or directory\n")

    def test_many_findings_end_with_a_note_of_their_number(self):
        text = NO_UNITS + "forces:\n" + "".join(f"  f{i}: {{potential: x{i}}}\n" for i in range(300))
        _, objects = self.lines("-", stdin=text)
        self.assertEqual(objects[-1], {"severity": "note", "message": "200 more findings"})
        self.assertEqual(len(objects), 101)

    def test_the_form_is_a_choice(self):
        self.assertIn("did you mean 'json'?", self.refused(2, SKEW, "--diagnostics", "jsn"))
        self.assertIn("choose from auto, always, never", self.refused(2, SKEW, "--color", "sometimes"))


class Colour(Program):
    def on_terminal(self, text, *arguments, **environment):
        """What a terminal gets as standard error."""
        self.write("m.yaml", text)
        master, slave = pty.openpty()
        surroundings = {key: value for key, value in os.environ.items() if key not in ("NO_COLOR", "TERM")}
        subprocess.run([PROGRAM, "m.yaml", *arguments], cwd=self.folder, stderr=slave, stdout=subprocess.DEVNULL, check=False,
                       env={**surroundings, "TERM": "xterm-256color", **environment})
        os.close(slave)
        shown = b""
        try:
            while block := os.read(master, 65536):
                shown += block
        except OSError:  # the other end is closed
            pass
        os.close(master)
        return shown.decode().replace("\r\n", "\n")

    def test_a_terminal_shows_errors_in_red_and_warnings_in_magenta(self):
        shown = self.on_terminal(BROKEN)
        self.assertIn("\x1b[1mm.yaml:9:13:\x1b[0m \x1b[1;31merror[E031]:\x1b[0m ", shown)
        self.assertIn(" | " + " " * 12 + "\x1b[1;31m^~\x1b[0m\n", shown)
        self.assertIn("= \x1b[1mhint:\x1b[0m ", shown)
        shown = self.on_terminal(WARNED)
        self.assertIn("\x1b[1;35mwarning[W055]:\x1b[0m ", shown)
        self.assertIn("\x1b[1;35m^\x1b[0m\n", shown)

    def test_nothing_but_colour_is_added(self):
        shown = self.on_terminal(BROKEN)
        self.assertEqual(re.sub(r"\x1b\[[0-9;]*m", "", shown), self.run_it("m.yaml").stderr)

    def test_a_terminal_that_wants_none_gets_none(self):
        for environment in ({"NO_COLOR": "1"}, {"TERM": "dumb"}, {"TERM": ""}):
            self.assertNotIn("\x1b", self.on_terminal(BROKEN, **environment), environment)
        self.assertNotIn("\x1b", self.on_terminal(BROKEN, "--color=never"))
        self.assertNotIn("\x1b", self.on_terminal(BROKEN, "--diagnostics=json"))
        self.assertIn("\x1b", self.on_terminal(BROKEN, NO_COLOR=""))

    def test_a_file_gets_none_unless_it_is_asked_for(self):
        self.write("m.yaml", BROKEN)
        for command in COMMANDS:
            self.assertNotIn("\x1b", self.refused(1, *command, "m.yaml"))
            self.assertIn("\x1b[1;31m", self.refused(1, *command, "m.yaml", "--color=always"))
            self.assertIn("\x1b[1;31m", self.refused(1, *command, "m.yaml", "--color", "always",
                                                      env={**os.environ, "NO_COLOR": "1", "TERM": "dumb"}))

    def test_text_of_a_model_brings_no_colour(self):
        self.assertNotIn("\x1b", self.refused(1, "-", stdin=BROKEN.replace("mm", "m\x1b[31mm")))


if __name__ == "__main__":
    unittest.main()
