"""Macros of the compilers at hand: none of them is a name in an emitted header, where it would replace a member."""

import os
import re
import shutil
import subprocess
import unittest

from gauss_gen import Program

COMPILERS = [os.environ["GAUSS_CXX"], *filter(shutil.which, ("g++", "clang++"))]
MODES = ("c++17", "gnu++17", "c++20")

# What programs include beside an emitted header; those that are not there are left out.
STANDARD = """algorithm any array atomic bitset cassert cctype cerrno cfenv cfloat charconv chrono cinttypes climits clocale cmath
    complex condition_variable csetjmp csignal cstdarg cstddef cstdint cstdio cstdlib cstring ctime cuchar cwchar cwctype deque
    exception execution filesystem fstream functional future iomanip iostream iterator limits list locale map memory mutex numeric
    numbers optional random ratio regex set shared_mutex span sstream stdexcept string string_view system_error thread tuple
    type_traits utility valarray variant vector version
    complex.h fenv.h math.h signal.h stdio.h stdlib.h string.h tgmath.h time.h
    dirent.h fcntl.h pthread.h sys/resource.h sys/stat.h sys/time.h sys/types.h sys/wait.h unistd.h""".split()
LIBRARIES = ("boost/numeric/odeint.hpp", "Eigen/Dense", "Eigen/Sparse")
EIGEN = ("-I/usr/include/eigen3",)


def macros(compiler, mode, headers):
    """(name, what it stands for) of each macro that a program with these headers sees."""
    source = "".join(f"#if __has_include(<{header}>)\n#include <{header}>\n#endif\n" for header in headers)
    result = subprocess.run([compiler, f"-std={mode}", *EIGEN, "-w", "-dM", "-E", "-x", "c++", "-"], input=source, capture_output=True,
                            text=True, check=True)
    return re.findall(r"(?m)^#define ([A-Za-z]\w*)(?:\([^)]*\))?(.*)$", result.stdout)


def is_name(name):
    """What a model may call something."""
    return len(name) <= 64 and "__" not in name and not name.endswith("_")


class Macros(Program):
    def unprotected(self, names):
        """Those of `names` that a header contains as they are."""
        names = sorted(filter(is_name, names))
        parameters = "".join(f"  '{name}': 1\n" for name in names)
        text = f"gauss: 1\nname: host\nparameters:\n{parameters}coordinates: {{host_x: {{}}}}\n" \
               "particles: {host_p: {mass: 1, position: [host_x, 0, 0]}}\n"
        refused = set(re.findall(r"error\[E02[01]\]: '(\w+)'", self.run_it("-", "--list-outputs", stdin=text).stderr))
        for name in refused:
            text = text.replace(f"  '{name}': 1\n", "")
        # Nothing uses them, which each gets a word for.
        done = self.run_it("-", "-o", "-", stdin=text)
        self.assertEqual((done.returncode, set(re.findall(r"\[(\w+)\]: ", done.stderr))), (0, {"W064"}))
        header = re.sub(r'"(\\.|[^"\\\n])*"|//[^\n]*|/\*.*?\*/', "", done.stdout, flags=re.S)
        words = set(re.findall(r"[A-Za-z]\w*", header))
        self.assertLessEqual({name + "_" for name in ("EOF", "errno")}, words)
        return [name for name in names if name in words]

    def test_no_macro_of_the_standard_libraries_is_a_name(self):
        found = {"EOF", "errno"}
        for compiler in COMPILERS:
            for mode in MODES:
                found |= {name for name, _ in macros(compiler, mode, STANDARD)}
        self.assertGreater(len(found), 500)
        self.assertEqual(self.unprotected(found), [], "add them to generator/emit/macros.cpp")

    def test_no_macro_of_libraries_that_the_documents_name_is_one(self):
        found = {"EOF", "errno"}
        for compiler in COMPILERS:
            for header in LIBRARIES:
                # Guards of headers stand for nothing, and nobody calls a parameter so.
                found |= {name for name, text in macros(compiler, "c++17", [header]) if text.strip()}
        self.assertEqual(self.unprotected(found), [], "add them to generator/emit/macros.cpp")


if __name__ == "__main__":
    unittest.main()
