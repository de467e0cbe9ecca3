"""Where the figures come from: processor, compiler, versions; no name of the machine, no paths."""

import os
import re
import subprocess
from pathlib import Path

from . import build


def processor():
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        return "unknown"
    found = re.search(r"^model name\s*: (.*)$", text, re.M)
    return found[1] if found else "unknown"


def package_version(name):
    result = subprocess.run(["dpkg-query", "-W", "-f=${Version}", name], capture_output=True, text=True, check=False)
    return result.stdout.strip() if result.returncode == 0 else ""


def commit():
    result = subprocess.run(["git", "-C", build.ROOT, "describe", "--always", "--dirty", "--abbrev=10"], capture_output=True, text=True,
                            check=False)
    return result.stdout.strip() or "unknown"


def description():
    peers = {"SymPy": "python3-sympy", "MuJoCo": "libmujoco-dev", "Simbody": "libsimbody-dev", "xsimd": "libxsimd-dev",
             "valgrind": "valgrind"}
    return {
        "processor": processor(),
        "cores": os.cpu_count(),
        "load": round(os.getloadavg()[0], 2),
        "compiler": build.version([build.COMPILER, "--version"]),
        "flags": " ".join(build.FLAGS),
        "flags_of_instruction_counts": " ".join(build.PORTABLE_FLAGS),
        "peers": {name: found for name, package in peers.items() if (found := package_version(package))},
        "commit": commit(),
    }
