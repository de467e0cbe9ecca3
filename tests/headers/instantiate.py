#!/usr/bin/env python3
"""Writes a C++ file that instantiates every function and struct of emitted headers.

    instantiate.py TYPE[,TYPE...] HEADER...  > file.cpp

Explicit instantiations are made from the text of each header, so that no list of functions has to be kept.
"""

import re
import sys

STRUCT = re.compile(r"^template <class S>\nstruct (\w+) \{", re.M)
FUNCTION = re.compile(r"^template <class S>\nGAUSS_FUNCTION (.*?) noexcept \{", re.M | re.S)
BODY = re.compile(r"^namespace ([\w:]+) \{\n\ninline constexpr int n_q(.*)^\}  // namespace \1$", re.M | re.S)


def instantiations(text, scalar):
    def with_scalar(declaration):
        return re.sub(r"\bS\b", scalar, declaration)

    for name in STRUCT.findall(text):
        yield f"template struct {name}<{scalar}>;"
    for signature in FUNCTION.findall(text):
        yield f"template {with_scalar(signature)} noexcept;"


def main():
    scalars = sys.argv[1].split(",")
    headers = sys.argv[2:]
    for header in headers:
        print(f'#include "{header}"')
    for header in headers:
        with open(header, encoding="utf-8") as file:
            body = BODY.search(file.read())
        if body is None:
            sys.exit(f"{header}: no model found")
        lines = [line for scalar in scalars for line in instantiations(body.group(2), scalar)]
        if not any(" prepare(" in line for line in lines):
            sys.exit(f"{header}: no function found")
        print("", f"namespace {body.group(1)} {{", *lines, "}", sep="\n")


main()
