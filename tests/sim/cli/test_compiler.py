"""Which compiler of the system gauss-sim takes."""

import os
import shutil
import unittest

from gauss_sim import SPRING, Program


class Compilers(Program):
    def setUp(self):
        super().setUp()
        self.write("spring.yaml", SPRING)
        self.cache = self.folder / "cache/gauss"

    def environment(self, compiler):
        return {**os.environ, "XDG_CACHE_HOME": str(self.folder / "cache"), "CXX": str(compiler)}


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
