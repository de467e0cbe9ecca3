"""What gauss-sim costs, on the page: driver.py, accuracy_time.py, ensemble.py, delivered.py, start.py, taylor.py and effects.py of bench/ measure it, each into a JSON of its own."""

import datetime
import json
import statistics

from . import build, machine
from .targets import at_most, faster, number

DRIVER = build.ROOT / "bench/results/driver.json"
ACCURACY = build.ROOT / "bench/results/accuracy_time.json"
ENSEMBLE = build.ROOT / "bench/results/ensemble.json"
DELIVERED = build.ROOT / "bench/results/delivered.json"
START = build.ROOT / "bench/results/start.json"
TAYLOR = build.ROOT / "bench/results/taylor.json"
EFFECTS = build.ROOT / "bench/results/effects.json"

# With AVX2, and nothing that valgrind does not know.
AVX2 = "x86-64-v3"


def compiler_for(folder, processor, *flags):
    """What gauss-sim compiles with for some processors (-march), for $CXX."""
    compiler = folder / "".join([f"compiler-for-{processor}", *flags])
    compiler.write_text(f'#!/bin/sh\nexec c++ "$@" {" ".join([f"-march={processor}", *flags])}\n', encoding="utf-8")
    compiler.chmod(0o755)
    return str(compiler)


def counting_compiler(folder):
    """What gauss-sim compiles with where instructions are counted, wherever that is."""
    return compiler_for(folder, AVX2)


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
ABOUT_ENSEMBLE = """
### Ensembles

Trajectories per second of `gauss-sim ensemble` by power series, whose initial speeds are drawn, with all that is compiled for the same processors: {lanes}. The best of {repeats} runs of each way, relative to one at a
time as `gauss-sim` compiles it. That takes vector registers, too, for the sums of products within one series, so that lanes bring less than their number, and how much less depends on the processor. "Scalar": one
at a time, where the compiler is told to make no vectors (`-fno-tree-vectorize -fno-tree-slp-vectorize`). "To scalar": all lanes and threads, to that.

"""
ABOUT_DELIVERED = """
### What `run --error` delivers

{rows} runs: {models} shipped models, each asked for 1e-3 to 1e-10 of the range of every column, over 10 s or what it can be followed for{ends}. Against runs in float128 that the search has not seen, {late}{failed}. The time of a
run, over that of the fastest point of a study of {budget:g} s that delivers the error: {median:.2f} in the median, {most:.2f} at most, {dear} of {compared} above 2. Below 1, the search has found a tolerance between those
of the study; above it, margins are paid for, or methods that were not tried.

"""


def where():
    """For a JSON: the machine, and when."""
    return {"machine": machine.description(), "date": datetime.date.today().isoformat()}


def write(path, results):
    path.write_text(json.dumps({**where(), **results}, indent=1) + "\n", encoding="utf-8")


def table(head, rows):
    lines = ["| " + " | ".join(line) + " |" for line in [head, *rows]]
    return "\n".join([lines[0], "|" + "---|" * len(head), *lines[1:]]) + "\n"


def targets(driver, accuracy, ensemble, delivered, start, taylor, effects):
    for way, limit in (("interpreted", 0.1), ("compiled the first time", 4), ("compiled before", 0.1)):
        yield at_most(f"from a command to the table of the ball, {way}", start["seconds"][way], limit, " s")
    for error, limit in (("1e-09", 0.75), ("1e-11", 0.67)):
        yield at_most(f"power series to fehlberg78 at {error}, geometric mean of six problems", taylor["contract off"]["ratios to fehlberg78"]["taylor"][error], limit)
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
    for processor, problems in ensemble["processors"].items():
        ways = [all_lanes(one) for one in problems.values()]
        of = "AVX2" if processor == AVX2 else "this processor"
        work = f"ensembles, two threads and all {ways[0]['lanes']} lanes of {of}, least of {len(ways)} models"
        yield faster(f"{work}, against one thread of scalar code", 1, min(map(to_scalar, problems.values())), 6)
        yield faster(f"{work}, against one thread whose series use the registers, too", 1, min(way["ratio"] for way in ways), 6)
    theirs = effects["mujoco"].get("ratio")
    beside = f" (MuJoCo with such a floor, in the same run: {number(theirs)})" if theirs else ""
    yield at_most(f"chain of 10 with contacts that never act, time to that without{beside}", effects["gauss"]["ratio"], 1.1)
    found = [row for row in delivered["rows"] if row.get("delivered") is not None]
    if found:
        yield at_most("`run --error`: delivered over asked for, largest", max(row["delivered"] / row["asked"] for row in found), 1)
        yield at_most("`run --error`: time over the best of the study, largest", max(row["ratio"] for row in found if row["ratio"]), 2)


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


def all_lanes(problem):
    """The row with all threads and lanes."""
    return next(row for row in reversed(problem["rows"]) if not row["is_scalar"])


def to_scalar(problem):
    """How many times as many trajectories all threads and lanes run as one thread of code without vectors."""
    scalar = next(row for row in problem["rows"] if row["is_scalar"])
    return all_lanes(problem)["trajectories_per_s"] / scalar["trajectories_per_s"]


def some(count, what):
    return f"{count} {what}{'' if count == 1 else 's'}"


def ensemble_block(found):
    lanes = [f"{all_lanes(next(iter(problems.values())))['lanes']} lanes for `-march={processor}`" for processor, problems in found["processors"].items()]
    text = ABOUT_ENSEMBLE.format(lanes=", ".join(lanes), repeats=found["repeats"])
    head, columns = ["model"], []
    for processor, problems in found["processors"].items():
        one = next(iter(problems.values()))["rows"]
        head += [f"{processor}: one at a time"] + [f"{some(row['lanes'], 'lane')}, {some(row['threads'], 'thread')}" for row in one[1:] if not row["is_scalar"]]
        head += ["scalar", "to scalar"]
        columns.append(problems)
    rows = []
    for model in columns[0]:
        row = [f"`{model}`"]
        for problems in columns:
            first, *rest = problems[model]["rows"]
            row += [number(round(first["trajectories_per_s"])) + "/s"] + [f"{one['ratio']:.2f} times" for one in rest]
            row.append(f"{to_scalar(problems[model]):.2f} times")
        rows.append(row)
    return text + table(head, rows)


def delivered_block(found):
    rows = found["rows"]
    known = [row for row in rows if row.get("delivered") is not None]
    late = sum(row["delivered"] > row["asked"] for row in known)
    failed = [row for row in rows if row.get("delivered") is None]
    ratios = [row["ratio"] for row in known if row["ratio"]]
    return ABOUT_DELIVERED.format(
        rows=len(rows), models=len({row["model"] for row in rows}), budget=found["budget"],
        late=f"{late} do not deliver it" if late else "each delivers it", ends="".join(f", `{model}` {seconds:g} s" for model, seconds in found["ends"].items()),
        failed="".join(f"; `{row['model']}` to {row['asked']:.0e}: {row['why']}" for row in failed), median=statistics.median(ratios), most=max(ratios),
        dear=sum(ratio > 2 for ratio in ratios), compared=len(ratios)).rstrip("\n") + "\n"


def machine_line(*documents):
    lines = []
    for name, document in documents:
        found = document["machine"]
        lines.append(f"{name}: {found['processor']}, {found['cores']} cores, load {found['load']} when it ended, {document['date']}, commit {found['commit']}.")
    return "\n".join(lines) + "\n\n"


def block(*found):
    driver, accuracy, ensemble, delivered, start, taylor, effects = found
    scripts = {"`bench/driver.py`": driver, "`bench/accuracy_time.py`": accuracy, "`bench/ensemble.py`": ensemble, "`bench/delivered.py`": delivered,
               "`bench/start.py`": start, "`bench/taylor.py`": taylor, "`bench/effects.py`": effects}
    text = "## Simulations\n\n" + machine_line(*scripts.items())
    rows = [[one.work, one.target, one.reached, "yes" if one.is_met else "**no**"] for one in targets(*found)]
    text += table(["work", "target", "reached", "met"], rows) + "\n" + driver_block(driver)
    text += pendulum_block(accuracy["double_pendulum"]) + ball_block(accuracy["ball"], accuracy["sampling_reactions"])
    return text + ensemble_block(ensemble) + delivered_block(delivered) + "\n"


def block_of_files():
    files = [DRIVER, ACCURACY, ENSEMBLE, DELIVERED, START, TAYLOR, EFFECTS]
    if not all(file.exists() for file in files):
        return ""
    return block(*(json.loads(file.read_text(encoding="utf-8")) for file in files))
