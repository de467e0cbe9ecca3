#!/usr/bin/env python3
"""Compiles every function of emitted headers as CUDA device code, called from a kernel.

    check_device.py nvcc HEADER...          where there is CUDA
    check_device.py CLANG++ HEADER...       where there is not: to PTX, with the declarations of device_functions.hpp

Prints "skipped: ..." where the compiler cannot.
"""

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
FUNCTION = re.compile(r"^template <class S>\nGAUSS_FUNCTION [^(]*?(\w+)\((.*?)\) noexcept \{", re.M | re.S)
BODY = re.compile(r"^namespace ([\w:]+) \{\n\ninline constexpr int n_q(.*)^\}  // namespace \1$", re.M | re.S)
ARGUMENT = re.compile(r"((?:const )?\w+(?:<S>)?)& (?:\w+|/\*\w+\*/)$")


def types_of(arguments):
    """Of references to scalars and structs; none where something else is among them, as an array."""
    found = [ARGUMENT.match(" ".join(one.split())) for one in arguments.split(",")]
    return [one[1] for one in found] if all(found) else None


def kernels(text, scalar):
    for number, (name, arguments) in enumerate(FUNCTION.findall(text)):
        types = types_of(arguments)
        if types is None:
            continue
        parameters = ", ".join(re.sub(r"\bS\b", scalar, one) + f"* a{i}" for i, one in enumerate(types))
        values = ", ".join(f"*a{i}" for i in range(len(types)))
        yield f"__global__ void {scalar}_{name}_{number}({parameters}) {{ (void){name}<{scalar}>({values}); }}"


def program(headers):
    lines, count = [f'#include "{Path(header).resolve()}"' for header in headers], 0
    for header in headers:
        name_space, text = BODY.search(Path(header).read_text(encoding="utf-8")).groups()
        found = [kernel for scalar in ("double", "float") for kernel in kernels(text, scalar)]
        count += len(found)
        lines += [f"namespace {name_space} {{", *found, "}"]
    if count < 8 * len(headers):
        sys.exit(f"only {count} functions were found in {len(headers)} headers")
    return "\n".join(lines) + "\n", count


def flags_of(compiler):
    if "clang" not in Path(compiler).name:
        return ["-std=c++17", "-Werror=all-warnings"]
    # As nvcc has it: a constexpr function is one of the host.
    return ["-x", "cuda", "--cuda-device-only", "--cuda-gpu-arch=sm_70", "-nocudainc", "-nocudalib", "-Xclang", "-fno-cuda-host-device-constexpr",
            "-std=c++17", "-O1", "-S", "-Wno-unknown-cuda-version", "-Werror", f"-include{HERE / 'device_functions.hpp'}"]


def compiled(compiler, text, output):
    with tempfile.TemporaryDirectory() as folder:
        source, built = Path(folder) / "kernels.cu", Path(folder) / "built"
        source.write_text(text, encoding="utf-8")
        kind = ["-c"] if "clang" not in Path(compiler).name else []
        run = subprocess.run([compiler, *flags_of(compiler), *kind, source, "-o", built], capture_output=True, text=True, check=False)
        output.append(built.read_text(encoding="utf-8", errors="replace") if built.exists() else "")
        return run


def main():
    compiler, *headers = sys.argv[1:]
    if not shutil.which(compiler):
        print(f"skipped: there is no {compiler} on this machine")
        return
    output = []
    trial = compiled(compiler, "__global__ void nothing() {}\n", output)
    if trial.returncode != 0:
        print(f"skipped: {compiler} does not compile CUDA here: {trial.stderr.strip()[:200]}")
        return
    text, count = program(headers)
    run = compiled(compiler, text, output)
    if run.returncode != 0:
        sys.exit("\n".join(line for line in run.stderr.splitlines() if "error" in line)[:4000] or run.stderr[:4000])
    if "clang" in Path(compiler).name and output[1].count(".entry") != count:
        sys.exit(f"{output[1].count('.entry')} kernels came out of {count}")
    print(f"{count} functions on the device")


main()
