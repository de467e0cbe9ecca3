#!/usr/bin/env python3
"""Compiles a file that uses float only, and fails where the object computes in double or calls a function of double.

    check_float.py COMPILER OBJDUMP FILE
"""

import os
import re
import subprocess
import sys
import tempfile

# Conversions to and from double, and arithmetic in double (x86). Other processors are judged by their calls alone.
DOUBLE = re.compile(r"\t(v?cvt\w*(?:ss2sd|sd2ss|ps2pd|pd2ps|si2sd)\w*|v?(?:add|sub|mul|div|sqrt|comi|ucomi|max|min|fn?m\w+)[sp]d)\b")
CALL = re.compile(r"R_\w+\t(\w+)")
FUNCTIONS = "sin cos tan asin acos atan atan2 exp log sinh cosh tanh sqrt pow sincos".split()


def main():
    compiler, objdump, source = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        built = os.path.join(folder, "float.o")
        subprocess.run([compiler, "-std=c++17", "-O1", "-c", source, "-o", built], check=True)
        listing = subprocess.run([objdump, "-d", "-r", "-C", built], check=True, capture_output=True, text=True).stdout
    calls = {name for name in CALL.findall(listing)}
    if not calls & {name + "f" for name in FUNCTIONS}:
        sys.exit("no function of float is called: this test sees nothing")
    found = sorted(calls & (set(FUNCTIONS) | {name + "l" for name in FUNCTIONS}))
    where = ""
    for line in listing.splitlines():
        if line.endswith(">:"):
            where = line
        elif DOUBLE.search(line):
            found.append(f"{where} {line.strip()}")
    print("\n".join(found[:20]) or "float only")
    sys.exit(1 if found else 0)


main()
