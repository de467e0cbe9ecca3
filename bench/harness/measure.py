"""Drivers: built, compared, then measured."""

import json
import os
import re
import shutil
import tempfile
from pathlib import Path

from . import build, sympy_code

STATES = 64  # of contender.hpp
OF_RESULT = {"joint_reactions": "JointReactions", "jacobian": "Jacobian", "rhs_and_reactions": "Reactions"}


class Disagreement(RuntimeError):
    pass


def lines(text):
    return [json.loads(line) for line in text.splitlines()]


class Driver:
    """One case with all who take part, in the flags of the machine or in portable ones."""

    def __init__(self, case, builder, results, options):
        self.case = case
        self.builder = builder
        self.results = results
        self.options = options
        self.key = (case.kind, case.size)
        self.left_out = set()
        self.libraries = [library for library in case.libraries if options.has(library)]

    def name_of(self, what):
        return f"{self.case.name}: {what}"

    def attempt(self, objects, what, make):
        """One that cannot be built is left out, and that is said once."""
        if what in self.left_out:
            return
        try:
            objects.append(make())
        except build.BuildError as error:
            self.left_out.add(what)
            self.results.skip(self.name_of(what), str(error))

    def right_hand_sides(self, flags):
        """Everything that has a text: its operations can be counted."""
        case, builder = self.case, self.builder
        objects = [builder.object("main.cpp", flags)]
        for emitted in case.emitted:
            self.attempt(objects, emitted.tool, lambda e=emitted: builder.emitted_object(
                "gauss.cpp", flags, e, case.size, ("rhs", "initial_state"), ("METRIC=rhs",)))
        if case.is_by_hand:
            objects.append(builder.object("by_hand.cpp", flags, (f"CASE_{case.kind}", f"SIZE={case.size}")))
        for parameters in self.sympy_codes():
            self.attempt(objects, sympy_code.TOOLS[parameters], lambda p=parameters: self.sympy_object(flags, p))
        return objects

    def sympy_codes(self):
        if not self.case.sympy or not self.options.has("sympy"):
            return ()
        return ("numbers", "symbols") if self.case.has_symbols else ("numbers",)

    def functions(self, flags):
        """What emitted code has besides the right-hand side, of its first model."""
        case, builder = self.case, self.builder
        names = list(case.reactions)
        if "jacobian" in self.options.outputs and case.size <= 10:
            names.append("jacobian")
        objects = []
        for name in names:
            outputs = ("rhs", "reactions" if name == "rhs_and_reactions" else name, "initial_state")
            more = ("WITH_DERIVATIVE",) if name == "rhs_and_reactions" else ()
            self.attempt(objects, name, lambda f=name, o=outputs, m=more: builder.emitted_object(
                "gauss.cpp", flags, case.emitted[0], case.size, o, (f"METRIC={f}", f"RESULT={OF_RESULT[f]}", *m)))
        self.attempt(objects, "sines", lambda: self.sines_object(flags))
        return objects

    def sines_object(self, flags):
        """What the first model's right-hand side asks of the library, alone."""
        emitted = self.case.emitted[0]
        header, _ = self.builder.header(emitted, self.case.size, ("rhs",))
        angles = len(set(re.findall(r"^  S (sin_\w+), cos_\w+;$", header.read_text(encoding="utf-8"), re.M)))
        if angles == 0:
            raise build.BuildError("it has none")
        return self.builder.object("sines.cpp", flags, (f"ANGLES={angles}", f'TOOL="{emitted.tool}"'))

    def batches(self, flags):
        objects = []
        if self.case.has_batches and self.options.has("xsimd") and self.case.emitted[0].tool not in self.left_out:
            for lanes, arch in build.lanes().items():
                self.attempt(objects, f"batch of {lanes}", lambda a=arch: self.builder.emitted_object(
                    "gauss_batch.cpp", flags, self.case.emitted[0], self.case.size, ("rhs", "initial_state"), (f"ARCH={a}",)))
        if self.case.has_many_angles and self.options.has("xsimd"):
            self.attempt(objects, "sines and cosines together", lambda: self.builder.emitted_object(
                "gauss_vectorised.cpp", flags, self.case.emitted[0], self.case.size, ("rhs", "initial_state")))
        return objects

    def sympy_object(self, flags, parameters):
        header = sympy_code.header(self.case, self.builder.folder / "sympy", parameters, self.options, self.results)
        return self.builder.object("sympy.cpp", flags, (f"CASE_{self.case.kind}", f"SIZE={self.case.size}", f'HEADER="{header}"',
                                                        f'TOOL="{sympy_code.TOOLS[parameters]}"'), [header.parent], header.read_bytes())

    def linked(self, suffix, flags, *groups):
        objects = self.right_hand_sides(flags)
        for group in groups:
            objects += group(flags)
        objects += [self.builder.library_object(library, flags) for library in self.libraries if groups]
        return self.builder.program(self.case.name + suffix, objects, self.libraries if groups else ())

    # --- what the program says ---------------------------------------------------------------------------

    def call(self, program, *arguments):
        return build.run([program, self.case.kind, self.case.size, *arguments], timeout=900)

    def check(self, program):
        """All have the same accelerations, or the figures mean nothing."""
        try:
            found = lines(self.call(program, "--check"))
        except build.BuildError as error:
            raise Disagreement(f"{self.case.name}: the accelerations differ\n{error}") from error
        for row in found:
            if row["metric"] == "rhs":
                self.results.add(self.key, row["tool"], "difference", row["difference"], "of the largest acceleration")

    def time(self, program):
        for row in lines(self.call(program, "--time", self.options.rounds, self.options.milliseconds)):
            metric = "ns_" + row["metric"] + (f"_{row['lanes']}" if row["lanes"] > 1 else "")
            self.results.add(self.key, row["tool"], metric, row["median"], "ns", low=row["low"], high=row["high"])

    def count(self, program):
        for row in lines(self.call(program, "--count")):
            self.results.add(self.key, row["tool"], "operations", row["operations"], "operations")
            self.results.add(self.key, row["tool"], "functions", row["functions"], "sines, cosines, roots")

    def instructions(self, program):
        """Per call, by the difference of two lengths."""
        for row in lines(self.call(program, "--time", 1, 0.01)):
            few, many = (self.callgrind(program, row["tool"], row["metric"], calls) for calls in (STATES, 3 * STATES))
            self.results.add(self.key, row["tool"], "instructions_" + row["metric"], round((many - few) / (2 * STATES), 1), "instructions")

    def callgrind(self, program, tool, metric, calls):
        return instructions_of(program, self.case.kind, self.case.size, tool, metric, calls)

    def measure(self):
        program = self.linked("", build.FLAGS, self.functions, self.batches)
        self.check(program)
        self.time(program)
        self.count(self.linked("_count", build.COUNTING_FLAGS))
        if self.options.has("valgrind"):
            self.instructions(self.linked("_portable", build.PORTABLE_FLAGS, self.functions))
        self.units()

    # --- as a user compiles it ---------------------------------------------------------------------------

    def units(self):
        case = self.case
        for emitted in case.emitted:
            if emitted.tool in self.left_out:
                continue
            header, name_space = self.builder.header(emitted, case.size)
            self.unit(emitted.tool, [f'-DHEADER="{header}"', f"-DMODEL={name_space}", f"-I{header.parent}"])
        if case.is_by_hand and not case.kind.startswith("sphere"):
            self.unit("by hand", [f"-DCASE_{case.kind}", f"-DSIZE={case.size}"])
        for parameters in self.sympy_codes():
            tool = sympy_code.TOOLS[parameters]
            header = None if tool in self.left_out else sympy_code.existing(case, self.builder.folder / "sympy", parameters)
            if header:
                self.unit(tool, [f"-I{header.parent}", f'-DHEADER="{header}"', f"-DSIZE={case.size}"], "sympy_unit.cpp")

    def unit(self, tool, flags, source="unit.cpp"):
        with tempfile.TemporaryDirectory(prefix="gauss bench ") as folder:
            path = Path(folder) / "unit.o"
            try:
                took = launched(self.builder, [shutil.which(build.COMPILER), "-std=c++17", "-O2", "-w", f"-I{build.DRIVERS}", *flags, "-c",
                                               build.DRIVERS / source, "-o", path], self.options.max_seconds)
            except build.BuildError as error:
                return self.results.skip(self.name_of(f"compile time of {tool}"), str(error))
            self.results.add(self.key, tool, "compile", round(took["cpu"], 3), "s")
            self.results.add(self.key, tool, "code", text_bytes(path), "bytes")
        return None


def instructions_of(program, kind, size, tool, metric, calls):
    with tempfile.TemporaryDirectory(prefix="gauss bench ") as folder:
        log = Path(folder) / "log"
        build.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", f"--log-file={log}", program, kind, size, "--run", tool,
                   metric, calls], timeout=900)
        return int(re.search(r"Collected : (\d+)", log.read_text())[1])


def text_bytes(path):
    return sum(int(size) for size in re.findall(r"^\.text\S*\s+(\d+)", build.run(["size", "-A", path]), re.M))


def launched(builder, command, timeout):
    """What a process took: wall and processor time in s, memory in kB."""
    launcher = builder.launcher()
    with tempfile.TemporaryDirectory(prefix="gauss bench ") as folder:
        report = Path(folder) / "report"
        build.run([launcher, *command], timeout=timeout, env={**os.environ, "LAUNCH_REPORT": str(report)})
        return json.loads(report.read_text())
