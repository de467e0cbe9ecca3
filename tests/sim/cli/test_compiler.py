"""What gauss-sim does with the compiler of the system: which one it takes, how it ends it, and what is left in the cache."""

import os
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

from gauss_sim import MODELS, PROGRAM, SPRING, Program

SCENE = """gauss: 1
scene: many
model: spring.yaml
outputs: [x]
ensemble: {trajectories: 10, parameters: {m: {uniform: [1, 3]}}}
"""

# A compiler that takes longer than anybody waits, by a program that it starts, as g++ starts cc1plus.
SLOW = """#!/bin/sh
sleep 100 &
echo $$ $! > {folder}/ids.$$
mv {folder}/ids.$$ {folder}/ids
wait
"""

COMMANDS = (("run", "spring.yaml"), ("run", "spring.yaml", "--error", "1e-6"), ("advise", "spring.yaml", "--error", "1e-6"),
            ("ensemble", "scene.yaml"), ("study", "spring.yaml"))


def goes_on(process):
    try:
        return Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


class Compilers(Program):
    def setUp(self):
        super().setUp()
        self.write("spring.yaml", SPRING)
        self.write("scene.yaml", SCENE)
        self.cache = self.folder / "cache/gauss"
        self.compiler = self.write("slow-cxx", SLOW.format(folder="."))
        self.compiler.chmod(0o755)
        self.inputs = sorted([*self.files(), "cache"])

    def environment(self, compiler):
        return {**os.environ, "XDG_CACHE_HOME": str(self.folder / "cache"), "CXX": str(compiler)}

    def builds(self):
        return [path.name for path in self.cache.glob("build-*")]

    def started(self, *arguments):
        """While it compiles, and the processes that do."""
        process = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, env=self.environment(self.compiler), stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True)
        ids, deadline = self.folder / "ids", time.monotonic() + 60
        while not ids.exists() and time.monotonic() < deadline:
            time.sleep(0.01)
        compilers = [int(word) for word in ids.read_text(encoding="utf-8").split()]
        ids.unlink()
        return process, compilers

    def assert_gone(self, compilers, message):
        deadline = time.monotonic() + 10
        while any(map(goes_on, compilers)) and time.monotonic() < deadline:
            time.sleep(0.01)
        self.assertEqual([one for one in compilers if goes_on(one)], [], message)


class Ending(Compilers):
    def test_a_signal_ends_compilers_too_and_leaves_nothing(self):
        for arguments in COMMANDS:
            for how in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                with self.subTest(arguments, how=how):
                    process, compilers = self.started(*arguments)
                    self.assertTrue(self.builds())
                    process.send_signal(how)
                    said = process.communicate(timeout=30)[1]
                    self.assertEqual(process.returncode, 130, said)
                    self.assertIn("interrupted", said)
                    self.assert_gone(compilers, arguments)
                    self.assertEqual(self.builds(), [])
                    for other in self.folder.glob("ids*"):  # of compilers that were ended before they had told their own
                        other.unlink()
                    self.assertEqual(self.files(), self.inputs)

    def test_programs_are_told_in_json(self):
        process, _ = self.started("run", "spring.yaml", "--diagnostics", "json")
        process.send_signal(signal.SIGINT)
        self.assertIn('"severity":"note"', process.communicate(timeout=30)[1])

    def test_a_budget_ends_compilers(self):
        for arguments in (COMMANDS[1], COMMANDS[2]):
            begin = time.monotonic()
            result = self.run_it(*arguments, "--budget", "1", env=self.environment(self.compiler), timeout=60)
            self.assertEqual(result.returncode, 6, result.stderr)
            self.assertIn("--budget", result.stderr)
            self.assertLess(time.monotonic() - begin, 30)
            self.assertEqual(self.builds(), [])

    def test_what_killed_processes_have_left_goes_with_the_next_build(self):
        process, compilers = self.started("run", "spring.yaml")
        process.kill()
        process.communicate(timeout=30)
        for one in compilers:
            os.kill(one, signal.SIGKILL)
        killed = self.builds()
        self.assertEqual(len(killed), 1)
        other, _ = self.started("run", "spring.yaml")
        self.addCleanup(other.communicate, timeout=30)
        self.addCleanup(other.send_signal, signal.SIGTERM)
        at_work = [name for name in self.builds() if name not in killed]
        an_hour_ago = time.time() - 3600
        for name in (*killed, *at_work):
            os.utime(self.cache / name, (an_hour_ago, an_hour_ago))
        (self.cache / "build-new").mkdir()
        self.ok("run", "spring.yaml", "-q", env=self.environment("c++"))
        self.assertEqual(sorted(self.builds()), sorted([*at_work, "build-new"]))


class Keeping(Compilers):
    def test_what_a_full_disk_has_left_is_not_loaded(self):
        """A library that ends too early ends the program that reads what should be there."""
        run = ("run", "spring.yaml", "-q")
        self.ok(*run, env=self.environment("c++"))
        self.ok(*run, env=self.environment("c++"))
        self.assertTrue(self.summary("spring.json")["seconds"]["cached"])
        [library] = self.cache.glob("*/model.so")
        whole = library.read_bytes()
        for left in (whole[:len(whole) // 2], b"", whole[:-1] + bytes([whole[-1] ^ 1])):
            library.write_bytes(left)
            self.ok(*run, env=self.environment("c++"))
            self.assertFalse(self.summary("spring.json")["seconds"]["cached"])
            self.ok(*run, env=self.environment("c++"))
            self.assertTrue(self.summary("spring.json")["seconds"]["cached"])
        library.unlink()
        library.mkdir()
        for is_cached in (False, True):
            self.ok(*run, env=self.environment("c++"))
            self.assertEqual(self.summary("spring.json")["seconds"]["cached"], is_cached)


class Choosing(Compilers):
    def engine_with(self, compiler, *options):
        result = self.run_it("run", "spring.yaml", "-q", *options, env=self.environment(compiler))
        self.assertEqual(result.returncode, 0, result.stderr)
        return self.summary("spring.json")["engine"], result.stderr

    def test_cxx_may_have_arguments(self):
        compiler = shutil.which("c++")
        self.assertEqual(self.engine_with(f"{compiler} -DA=1 -DB='a b'"), ("compiled", ""))
        self.assertEqual(self.engine_with(" c++\t-DA=\"1 2\" -DB=\\'x"), ("compiled", ""))
        with self.subTest("other arguments make another plugin"):
            self.assertEqual(len(list(self.cache.glob("*/model.so"))), 2)
        with self.subTest("the compiler gets them"):
            self.write("own.hpp", "#error this is own.hpp\n")
            self.assertIn("this is own.hpp", self.engine_with(f"c++ -include '{self.folder}/own.hpp'")[1])

    @unittest.skipUnless(shutil.which("clang++"), "there is no clang++")
    def test_what_clang_compiles_runs_with_the_same_bits(self):
        """By power series of numbers that are anywhere in memory, in double and float, one sample at a time and several."""
        for number, every in (("double", "0.05"), ("double", "1e-4"), ("float", "0.05")):
            tables = []
            for compiler in ("clang++", "g++"):
                self.ok("run", MODELS / "sphere_in_cylinder_quaternion.yaml", "--engine", "compiled", "--method", "taylor", "--number", number,
                        "--tolerance", "1e-5", "--duration", "1.1", "--every", every, "--outputs", "state,reactions", "-o", "table.csv", "-q",
                        env=self.environment(compiler))
                tables.append((self.folder / "table.csv").read_text())
            self.assertEqual(*tables, (number, every))

    def test_a_path_may_have_blanks(self):
        link = self.folder / "my c++"
        link.symlink_to(shutil.which("c++"))
        self.assertEqual(self.engine_with(link), ("compiled", ""))

    def test_a_compiler_that_is_named_and_not_there_is_missed(self):
        for compiler in ("no-such-compiler", "/no/such/compiler", "no-such-compiler -m64"):
            engine, said = self.engine_with(compiler)
            self.assertEqual(engine, "interpreted")
            self.assertIn(f"warning: CXX is '{compiler}'", said)
            refused = self.run_it("run", "spring.yaml", "--engine", "compiled", env=self.environment(compiler))
            self.assertEqual(refused.returncode, 3)
            self.assertIn(f"CXX is '{compiler}'", refused.stderr)

    def test_where_there_is_none_and_none_is_named_nobody_misses_it(self):
        without = {**self.environment(""), "PATH": str(self.folder)}
        result = self.run_it("run", "spring.yaml", "-q", env=without)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(self.summary("spring.json")["engine"], "interpreted")
        self.assertIn("no C++ compiler", self.run_it("run", "spring.yaml", "--engine", "compiled", env=without).stderr)


if __name__ == "__main__":
    unittest.main()
