"""Code by SymPy, kept under a name that its derivation has given: to derive it again takes seconds to minutes."""

import json
from pathlib import Path

from . import build, machine, measure

PYTHON = "/usr/bin/python3"  # the one that sees Debian's packages
HERE = Path(__file__).parent
TOOLS = {"numbers": "sympy", "symbols": "sympy, symbols"}  # by how parameters stand in the code


def path_of(case, folder, parameters):
    key = build.digest((HERE / "sympy_systems.py").read_bytes(), (HERE / "sympy_main.py").read_bytes(),
                       machine.package_version("python3-sympy"), case.kind, case.size, parameters)
    return folder / key / f"{case.name}_by_sympy.hpp"


def existing(case, folder, parameters):
    path = path_of(case, folder, parameters)
    return path if path.exists() else None


def header(case, folder, parameters, options, results):
    """`parameters`: numbers or symbols."""
    path = path_of(case, folder, parameters)
    report = path.with_suffix(".json")
    if not path.exists():
        if case.is_long and options.quick:
            raise build.BuildError("takes minutes: in the full run only")
        path.parent.mkdir(parents=True, exist_ok=True)
        scratch = path.with_suffix(".new")
        took = measure.launched(options.builder, [PYTHON, "-B", HERE / "sympy_main.py", case.kind, case.size, parameters, scratch], 900)
        report.write_text(json.dumps(took), encoding="utf-8")
        scratch.rename(path)
    took = json.loads(report.read_text(encoding="utf-8"))
    known = {(row["model"], row["size"], row["tool"], row["metric"]) for row in results.rows}
    tool = TOOLS[parameters]
    if (case.kind, case.size, tool, "derive_wall") not in known:
        results.add((case.kind, case.size), tool, "derive_wall", round(took["wall"], 3), "s")
        results.add((case.kind, case.size), tool, "derive_cpu", round(took["cpu"], 3), "s")
        results.add((case.kind, case.size), tool, "derive_memory", round(took["memory"] * 1.024e-3, 2), "MB")
    return path
