"""Exit codes other than 0: 1 for the model, 2 for the command line, 3 for files, 4 for size; and nothing is ever written."""

import os
import resource
import signal
import stat
import subprocess
import unittest

from gauss_gen import BROKEN, PARTICLE, PROGRAM, SKEW, SOURCE, Program

USAGE = {
    "no model": [],
    "two models": [SKEW, SKEW],
    "an unknown option": [SKEW, "--bogus"],
    "an unknown output": [SKEW, "--outputs", "rhs,energi"],
    "an empty list": [SKEW, "--outputs="],
    "an unknown route": [SKEW, "--route", "papr"],
    "a strategy on the paper's route": [SKEW, "--route", "paper", "--strategy", "tree"],
    "an unknown stage": [SKEW, "--dump", "modell"],
    "a namespace with a blank": [SKEW, "--namespace", "a b"],
    "a namespace that begins with a digit": [SKEW, "--namespace", "1x"],
    "a namespace that ends early": [SKEW, "--namespace", "a::"],
    "a namespace with code in it": [SKEW, "--namespace", 'a;system("x")'],
    "a namespace with a line break": [SKEW, "--namespace", "a\n#include <x>"],
    "an empty namespace": [SKEW, "--namespace", ""],
    "a keyword as namespace": [SKEW, "--namespace", "acme::class"],
    "a macro as namespace": [SKEW, "--namespace", "linux"],
    "a macro of emitted headers": [SKEW, "--namespace", "acme::GAUSS_FUNCTION"],
    "a name of emitted headers": [SKEW, "--namespace", "gauss::name"],
    "the standard library's namespace": [SKEW, "--namespace", "std"],
    "a name of the compiler": [SKEW, "--namespace", "a__b"],
    "another name of the compiler": [SKEW, "--namespace", "_a"],
    "a dependency of standard output": [SKEW, "-o", "-", "--depfile", "m.d"],
    "a value for a flag": [SKEW, "--check=no"],
    "a value for a flag of evaluate": ["evaluate", SKEW, "--equilibrium=yes"],
    "a word that is no command": ["frob", SKEW],
    "an option without its argument": [SKEW, "-o"],
    "an empty folder": [SKEW, "-o", ""],
    "an empty folder, in one word": [SKEW, "--output="],
    "an empty file": ["derivation", SKEW, "-o", ""],
    "an empty model": [""],
    "an empty name": ["init", ""],
    "an empty code": ["explain", ""],
    "an option of evaluate": [SKEW, "--digits", "3"],
    "an option before a command": ["--fold", "evaluate", SKEW],
    "a model before a command": [SKEW, "evaluate", SKEW],
    "evaluate without a model": ["evaluate"],
    "no digits": ["evaluate", SKEW, "--digits", "0"],
    "digits in words": ["evaluate", SKEW, "--digits", "many"],
    "an unknown format": ["evaluate", SKEW, "--format", "xml"],
    "the format of another command": ["derivation", SKEW, "--format", "json"],
}


class CommandLine(Program):
    def test_what_cannot_be_meant_is_refused_with_2(self):
        for what, arguments in USAGE.items():
            with self.subTest(what):
                self.assertRegex(self.refused(2, *arguments), r"(?s)^gauss-gen: .*\nRun gauss-gen --help for the options\.\n$")

    def test_a_slip_of_the_pen_is_named(self):
        self.assertIn("did you mean 'energy'?", self.refused(2, SKEW, "--outputs", "energi"))
        self.assertIn("did you mean 'paper'?", self.refused(2, SKEW, "--route", "papr"))
        self.assertIn("choose from model, kinematics, paper", self.refused(2, SKEW, "--dump", "nothing"))

    def test_the_words_are_ours_and_not_those_of_the_parser(self):
        for arguments, words in (
                ([SKEW, "--max-nodes", "9" * 20], "--max-nodes: a number from 1 to 1000000000 is needed, not '99999999999999999999'"),
                (["evaluate", SKEW, "--digits", "many"], "--digits: a number from 1 to 10000 is needed, not 'many'"),
                ([SKEW, "-o"], "--output: a value is missing behind it"),
                ([SKEW, "-o", "a", "--output", "b"], "--output: it is given more than once"),
                ([SKEW, "b", "a"], "not expected here: 'b', 'a'"),
                ([SKEW, "--bogus", "x"], "there is no option '--bogus'"),
                ([SKEW, "--chek"], "there is no option '--chek'; did you mean '--check'?"),
                ([SKEW, "--digits", "3"], "'--digits' is an option of evaluate, and goes after that word"),
                (["evaluate", SKEW, "--fold"], "'--fold' is no option of this command")):
            with self.subTest(words):
                self.assertEqual(self.refused(2, *arguments).splitlines()[0], "gauss-gen: " + words)

    def test_a_misspelt_command_is_not_taken_for_a_model(self):
        self.assertIn("there is no command or file 'evaluat'; did you mean 'evaluate'?", self.refused(2, "evaluat", SKEW))
        self.assertIn("did you mean 'evaluate'?", self.refused(2, "evaluat", SKEW, "--set", "m1=2"))
        self.assertIn("did you mean 'derivation'?", self.refused(2, "derivaton"))
        self.assertIn("did you mean '--check'?", self.refused(2, "check", SKEW))
        self.assertIn("did you mean 'evaluate'?", self.refused(2, "eval", SKEW))
        self.assertIn("there is no command or file 'frob'; the commands are evaluate, ", self.refused(2, "frob", SKEW))
        self.assertIn("--equilibrium: it takes no value", self.refused(2, "evaluate", SKEW, "--equilibrium=yes"))
        self.write("evaluat", PARTICLE)
        self.ok("evaluat", "--check")
        self.assertIn("skew.yaml: No such file", self.refused(3, "skew.yaml"))


class Model(Program):
    def test_an_error_stands_on_standard_error_with_its_place(self):
        self.write("m.yaml", BROKEN)
        for arguments in (["m.yaml"], ["m.yaml", "--check"], ["m.yaml", "--list-outputs"], ["evaluate", "m.yaml"],
                          ["derivation", "m.yaml"], ["m.yaml", "--depfile", "m.d"], ["m.yaml", "-o", "new folder"]):
            self.assertTrue(self.refused(1, *arguments).startswith("m.yaml:9:13: error[E031]: "), arguments)
        self.assertTrue(self.refused(1, "-", stdin=BROKEN).startswith("<stdin>:9:13: error[E031]: "))

    def test_all_errors_come_at_once(self):
        text = BROKEN.replace("[x, y, 0]", "[x, yy, 0]").replace("unit: kg", "unti: kg")
        self.assertEqual(self.refused(1, "-", stdin=text).count(": error[E"), 3)

    def test_a_model_that_the_papers_route_does_not_take_is_an_error_of_the_model(self):
        names = [f"x{i}" for i in range(13)]
        text = PARTICLE.split("coordinates:")[0] + "coordinates:\n" + "".join(f"  {name}: {{unit: m}}\n" for name in names)
        text += "particles:\n" + "".join(f"  p{name}: {{mass: m, position: [{name}, 0, 0]}}\n" for name in names)
        self.assertEqual(self.ok("-", "--check", stdin=text), "<stdin>: ok\n")
        for arguments in (["-", "--route=paper"], ["derivation", "-"]):
            self.assertTrue(self.refused(1, *arguments, stdin=text).startswith("<stdin>:2:7: error[E060]: "))

    def test_an_old_header_outlives_an_error(self):
        old = self.write("particle.hpp", "old")
        self.refused(1, "-", stdin=BROKEN)
        self.assertEqual(old.read_text(), "old")

    def test_no_faulty_model_is_an_internal_error(self):
        # `evaluate` shows numbers of a bad start, too, and warns of them.
        # Of outputs it knows nothing.
        not_of_evaluate = {"w066", "e070", "e080", "w051", "w052", "w053", "w054", "w057", "w058", "w059", "w060", "w070", "w080"}
        for model in sorted((SOURCE / "tests/diagnostics").glob("*.yaml")):
            for arguments in ([model], ["evaluate", model]):
                result = self.run_it(*arguments)
                is_warned = len(arguments) > 1 and (model.name[:4] in not_of_evaluate or "series_of" in model.name)
                is_error = model.name[0] == "e" and not is_warned
                self.assertIn(result.returncode, (1, 4) if is_error else (0,), (model.name, result.stderr))
                if not is_warned:
                    self.assertRegex(result.stderr, r":\d+:\d+: (error\[E|warning\[W)\d{3}\]: ")


class Files(Program):
    def test_what_cannot_be_read_is_refused_with_3(self):
        self.write("secret.yaml", PARTICLE).chmod(0)
        cases = ["nowhere.yaml", ".", "/dev/null/model.yaml"] + (["secret.yaml"] if os.geteuid() != 0 else [])
        for model in cases:
            for command in ([], ["evaluate"], ["derivation"]):
                self.assertRegex(self.refused(3, *command, model), r"^gauss-gen: .*: \w")

    def test_a_closed_standard_input_is_not_an_empty_one(self):
        for command in ("", "evaluate"):
            result = subprocess.run(["sh", "-c", f'"$0" {command} - <&-', PROGRAM], capture_output=True, text=True, check=False)
            self.assertEqual((result.returncode, result.stderr), (3, "gauss-gen: <stdin>: cannot be read\n"))

    def test_what_cannot_be_written_is_refused_with_3(self):
        self.write("file", "")
        (self.folder / "taken/skew_chart.hpp").mkdir(parents=True)
        cases = [["-o", "file"], ["-o", "file/deeper"], ["-o", "/dev/null"], ["-o", "taken"], ["-o", "/proc/self/nowhere"],
                 ["--depfile", "file/m.d"], ["--depfile", "taken"]]
        if os.geteuid() != 0:
            (self.folder / "locked").mkdir(mode=0o555)
            cases.append(["-o", "locked"])
        for arguments in cases:
            self.assertRegex(self.refused(3, SKEW, *arguments), r"^gauss-gen: .*: \w")

    def test_a_full_disk_is_an_error(self):
        for arguments in ([SKEW, "-o", "-"], ["evaluate", SKEW], ["derivation", SKEW], [SKEW, "--dump=model"], [SKEW, "--check"], ["--help"],
                          ["evaluate", "--help"], ["--version"], ["--man"], ["schema"], ["completion", "bash"], ["explain"]):
            with open("/dev/full", "w", encoding="ascii") as full:
                result = subprocess.run([PROGRAM, *map(str, arguments)], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
            self.assertEqual((result.returncode, result.stderr), (3, "gauss-gen: standard output: cannot be written\n"))
        self.refused(3, "derivation", SKEW, "-o", "/dev/full")

    def test_a_disk_that_fills_up_leaves_the_old_files(self):
        def few_bytes():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (5000, 5000))

        old = self.write("skew_chart.hpp", "old")
        error = self.refused(3, SKEW, "--depfile", "m.d", preexec_fn=few_bytes)
        self.assertIn("skew_chart.hpp: File too large", error)
        self.assertEqual(old.read_text(), "old")

    def test_a_device_stays_a_device(self):
        self.ok("derivation", SKEW, "-o", "/dev/null")
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))
        self.assertEqual(self.ok("derivation", SKEW, "-o", "/dev/stdout"), self.ok("derivation", SKEW))


class Size(Program):
    def test_a_model_beyond_the_limits_is_refused_with_4(self):
        self.assertIn("error[E003]", self.refused(4, "-", stdin=PARTICLE + "#" * (5 << 20)))
        self.assertIn("error[E003]", self.refused(4, "/dev/zero"))
        self.assertIn("error[E038]", self.refused(4, "-", stdin=PARTICLE.replace("[x,", "[" + "(" * 500 + "x" + ")" * 500 + ",")))

    def test_an_error_beside_it_makes_it_1(self):
        deep = BROKEN.replace("[x,", "[" + "(" * 500 + "x" + ")" * 500 + ",")
        self.refused(1, "-", stdin=deep)


if __name__ == "__main__":
    unittest.main()
