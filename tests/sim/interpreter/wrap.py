#!/usr/bin/env python3
"""Writes a C++ file that calls every function of an emitted header by pointers to scalars, as the interpreter is called.

    wrap.py MODEL HEADER SCALAR... > file.cpp

MODEL is what the test compiles again to get the tree of the same header: FILE, and the options that matter, separated by blanks.
"""

import re
import sys

FUNCTION = re.compile(r"^template <class S>\nGAUSS_FUNCTION (.*?) (\w+)\(([^{]*?)\) noexcept \{", re.M | re.S)
STRUCT = re.compile(r"^template <class S>\nstruct (\w+) \{\n(.*?)^\};", re.M | re.S)
BODY = re.compile(r"^namespace ([\w:]+) \{\n\ninline constexpr int n_q(.*)^\}  // namespace \1$", re.M | re.S)
ARGUMENT = re.compile(r"^(const )?(\w+(?:<S>)?)(&?) (?:/\*)?\w+(?:\*/)?$")


class Argument:
    def __init__(self, text):
        match = ARGUMENT.match(" ".join(text.split()))
        self.is_known = match is not None
        if match:
            self.is_const, self.type = bool(match.group(1)), match.group(2)


def wrapper(kind, name, arguments):
    lines = ["template <class S>", f"gauss::Status call_{name}(S* const* a) {{"]
    for i, argument in enumerate(arguments):
        lines.append(f"  auto v{i} = headertest::read<{argument.type}>(a[{i}]);")
    call = f"{name}<S>({', '.join(f'v{i}' for i in range(len(arguments)))})"
    if kind == "StatusOf<S>":
        lines.append(f"  const gauss::Status status = {call};")
    else:
        lines.append(f"  headertest::write({call}, a[{len(arguments)}]);")
        lines.append("  const gauss::Status status = gauss::Status::ok;")
    for i, argument in enumerate(arguments):
        if not argument.is_const:
            lines.append(f"  headertest::write(v{i}, a[{i}]);")
    return lines + ["  return status;", "}"]


def defaults(name):
    return ["template <class S>", f"gauss::Status call_{name}(S* const* a) {{",
            f"  headertest::write({name}<S>{{}}, a[0]);", "  return gauss::Status::ok;", "}"]


def main():
    model, header, scalars = sys.argv[1], sys.argv[2], sys.argv[3:]
    with open(header, encoding="utf-8") as file:
        body = BODY.search(file.read())
    names, lines = [], []
    for name, members in STRUCT.findall(body.group(2)):
        if re.search(r"^  S \w+ = ", members, re.M):
            names.append(name)
            lines += defaults(name)
    for kind, name, text in FUNCTION.findall(body.group(2)):
        # What only other functions can give stays among them, and what is the beginning of another one is compared there.
        if kind == "void" or "LinearSolution<" in text or name.endswith("_regular"):
            continue
        arguments = [Argument(one) for one in re.split(r",\s+", text)]
        if not all(argument.is_known for argument in arguments):
            sys.exit(f"{header}: {name}({text}) is not understood")
        names.append(name)
        lines += wrapper(kind, name, arguments)
    if "prepare" not in names:
        sys.exit(f"{header}: no function found")
    if "__float128" in scalars:
        print('#include "gauss/scalar/float128.hpp"')
    print(f'#include "{header}"', '#include "sim/interpreter/compiled.hpp"', sep="\n")
    print(f"namespace {body.group(1)} {{", "namespace {", *lines, sep="\n")
    for scalar in scalars:
        entries = ", ".join(f'{{"{name}", call_{name}<{scalar}>}}' for name in names)
        identifier = re.sub(r"\W", "_", scalar)
        print(f'const headertest::Registered<{scalar}> k_in_{identifier}{{"{model}", {{{entries}}}}};')
    print("}", "}", sep="\n")


main()
