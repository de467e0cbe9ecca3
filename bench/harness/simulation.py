"""What gauss-sim costs, on the page: bench/driver.py and bench/accuracy_time.py measure it, each into a JSON of its own."""

import datetime
import json

from . import build, machine
from .targets import at_most, faster, number

DRIVER = build.ROOT / "bench/results/driver.json"
ACCURACY = build.ROOT / "bench/results/accuracy_time.json"

# Instructions are counted for processors with AVX2, wherever that is: valgrind does not know all that others have.
COUNTED = "-march=x86-64-v3"


def counting_compiler(folder):
    """What gauss-sim compiles with where instructions are counted, for $CXX."""
    compiler = folder / "compiler"
    compiler.write_text(f'#!/bin/sh\nexec c++ "$@" {COUNTED}\n', encoding="utf-8")
    compiler.chmod(0o755)
    return str(compiler)


ABOUT_DRIVER = """### The driver

One call of the right-hand side of the double pendulum (4 states, compiled engine) in a run of 10 s, beside a loop by hand over the same stepper of Boost.Odeint in the same
steps, compiled with the same options: with all that a step costs besides. Medians of ratios of times, which move by some hundredths from run to run; instructions by callgrind repeat. "Odeint's checker": the loop
measures errors as Odeint offers it, in steps of its own.

"""
ABOUT_PENDULUM = """
### The double pendulum to 1e-6 rad

Both angles at 501 times in 10 s, against a run in float128; of each method the cheapest setting that delivers. Processor time of the integration with its samples.

"""
ABOUT_BALL = """
### The ball in the cylinder to 1e-9

Its attitude, all other coordinates, speeds and reactions at 501 times in 10 s, each relative to what it ranges over, by power series.

"""


def where():
    """For a JSON: the machine, and when."""
    return {"machine": machine.description(), "date": datetime.date.today().isoformat()}


def write(path, results):
    path.write_text(json.dumps({**where(), **results}, indent=1) + "\n", encoding="utf-8")


def table(head, rows):
    lines = ["| " + " | ".join(line) + " |" for line in [head, *rows]]
    return "\n".join([lines[0], "|" + "---|" * len(head), *lines[1:]]) + "\n"


def targets(driver, accuracy):
    for method, row in driver.get("methods", {}).items():
        yield at_most(f"driver, {method}: time of a call to that by hand", row["time_per_call_to_hand"], 1.1)
        if "instructions_per_call_to_hand" in row:
            yield at_most(f"driver, {method}: its instructions to those by hand", row["instructions_per_call_to_hand"], 1.1)
    pendulum = accuracy.get("double_pendulum", {})
    theirs = pendulum.get("mujoco", {}).get("delivers")
    if theirs:
        yield faster("double pendulum to 1e-6 rad, time against MuJoCo's RK4, in turns", 1, pendulum["mujoco_to_best"], 80)
    forms = accuracy.get("ball", {}).get("forms", {})
    if forms.get("quaternion"):
        yield at_most("ball to 1e-9 by quaternion, 501 samples", 1e3 * forms["quaternion"]["seconds"], 0.4, " ms")
    for form, row in accuracy.get("sampling_reactions", {}).items():
        yield at_most(f"a sample of all reactions, {form}", row["ns_per_sample"], 100, " ns")


def driver_block(driver):
    rows = []
    for method, row in driver["methods"].items():
        counts = [number(row[who]["instructions_per_call"]) if "instructions_per_call" in row.get(who, {}) else "–" for who in ("ours", "hand", "usual")]
        usual = number(row["ns_per_call_to_usual"]) if "ns_per_call_to_usual" in row else "–"
        rows.append([f"`{method}`", number(row["calls"]), number(row["time_per_call_to_hand"]), usual, *counts])
    return ABOUT_DRIVER + table(["method", "calls", "time to that by hand", "to Odeint's checker", "instructions", "by hand", "with Odeint's checker"], rows)


def pendulum_block(found):
    rows = [[f"`{method}`", f"tolerance {row['tolerance']:g}", f"{1e3 * row['seconds']:.3f}", number(row["steps"]), f"{row['error']:.1e}"]
            for method, row in found["gauss"].items() if row]
    theirs = found["mujoco"].get("delivers")
    if theirs:
        rows.append(["MuJoCo, RK4", f"step {theirs['step']:.3g} s", f"{1e3 * theirs['seconds']:.1f}", number(round(10 / theirs["step"])), f"{theirs['error']:.1e}"])
    return ABOUT_PENDULUM + table(["method", "setting", "ms", "steps", "error, rad"], rows)


def instructions(row, key):
    return number(round(row[key])) if key in row else "–"


def ball_block(found, reactions):
    rows = []
    for form, row in found["forms"].items():
        if row:
            by = row["seconds_by_samples"]
            rows.append([form, f"{1e3 * row['seconds']:.3f}", f"{1e3 * by['2']:.3f}", f"{1e3 * by['5001']:.3f}", number(row["steps"]), f"{row['tolerance']:g}",
                         f"{row['error']:.1e}", instructions(row, "instructions"), number(round(row["ns_per_sample"])),
                         instructions(row, "instructions_per_sample"), number(round(reactions[form]["ns_per_sample"])),
                         instructions(reactions[form], "instructions_per_sample")])
    head = ["form", "ms", "with 2 samples", "with 5 001", "steps", "tolerance", "error", "instructions", "ns a sample", "instructions", "of reactions alone, ns",
            "instructions"]
    return ABOUT_BALL + table(head, rows)


def machine_line(*documents):
    lines = []
    for name, document in documents:
        found = document["machine"]
        lines.append(f"{name}: {found['processor']}, {found['cores']} cores, load {found['load']} when it ended, {document['date']}, commit {found['commit']}.")
    return "\n".join(lines) + "\n\n"


def block(driver, accuracy):
    text = "## Simulations\n\n" + machine_line(("`bench/driver.py`", driver), ("`bench/accuracy_time.py`", accuracy))
    rows = [[one.work, one.target, one.reached, "yes" if one.is_met else "**no**"] for one in targets(driver, accuracy)]
    text += table(["work", "target", "reached", "met"], rows) + "\n" + driver_block(driver)
    text += pendulum_block(accuracy["double_pendulum"])
    return text + ball_block(accuracy["ball"], accuracy["sampling_reactions"]) + "\n"


def block_of_files():
    if not (DRIVER.exists() and ACCURACY.exists()):
        return ""
    return block(json.loads(DRIVER.read_text(encoding="utf-8")), json.loads(ACCURACY.read_text(encoding="utf-8")))
