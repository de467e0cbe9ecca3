"""docs/performance.md and its charts, from the JSON and nothing else."""

import json

from . import charts, reasons, remedies, simulation, targets
from .targets import number

INTRODUCTION = """# What it costs

Written by `./run bench` from `bench/results/latest.json`: do not edit. `bench/README.md` says how it is measured, and `./run bench` measures it
on your machine. Times move from machine to machine and from moment to moment: compare within a table. Instruction counts repeat. Neither
MuJoCo's nor Simbody's library in Debian has AVX code, which all the others may use.
"""
QUOTED = """## Peers that Debian does not ship

Not measured here: quoted from the measurements that this project began with, on another machine (2 cores, AMD EPYC of the Zen 4 class, the
same compiler and flags), where the code by hand of the time took 36.8, 155, 620, 2 240 and 15 500 ns for planar chains of 2, 5, 10, 20 and 50 rods. Only
ratios within one line can be compared.

| forward dynamics, ns | RBDL 3.3.1 | Pinocchio 3.7, ABA | MuJoCo 2.2.2 there |
|---|---|---|---|
| planar chain 2 / 10 / 50 | 388 / 2 190 / 11 500 | 556 / 3 030 / 15 400 | 552 / 2 610 / 26 900 |
| 3-D chain 2 / 4 / 6 | 842 / 1 760 / 2 620 | 800 / 1 660 / 2 530 | 807 / 1 600 / 2 590 |
| four-bar | 1 260 | 2 400 | 1 530 (and wrong) |

| operations / ns | CasADi | wrenfold |
|---|---|---|
| chain of 5 point masses, absolute angles | 441 / 139 | 342 / 159 |
| 10 | 1 441 / 371 | 1 112 / 467 |
| 20 | 6 091 / 1 447 | 4 140 / 2 121 |
| 3-D chain 2 / 4 / 6, recursive velocities | 124 / 527 / 1 202 ns | – |
"""
SECTIONS = [
    ("Time of a right-hand side", "ns_rhs", "ns, median of the rounds. Symbols: parameters are read in each call, as in the code that PyDy generates; else they are numbers in the code.",
     True),
    ("Instructions of a right-hand side", "instructions_rhs", "By callgrind, for x86-64-v3.", True),
    ("Operations of a right-hand side", "operations",
     "+ − × ÷, square roots, sines and cosines after sharing; what follows from constants alone is free, and so is a change of sign.",
     True),
    ("Operations by the table of the header", "operations_by_header", "As above, and quotients of constants, which compilers compute.", False),
    ("Bytes of code", "code", "Sections .text of one right-hand side, g++ -O2.", False),
    ("Compile time", "compile", "s of processor time, g++ -O2, one right-hand side with its header.", False),
    ("With joint reactions", "ns_joint_reactions", "ns; of MuJoCo and Simbody accelerations and reactions together, of ours the reactions alone, "
     "which contain the work of the accelerations.", False),
    ("With reactions", "ns_rhs_and_reactions", "ns; accelerations and all reactions of constraints.", False),
    ("A Jacobian", "ns_jacobian", "ns.", False),
    ("Sines and cosines together", "ns_rhs_vectorised", "ns of one right-hand side with `gauss::Vectorised<double>`, four sines and cosines at a time.",
     False),
    ("Four lanes", "ns_batch_4", "ns per trajectory by the driver of batches, AVX2.", False),
    ("Eight lanes", "ns_batch_8", "ns per trajectory by the driver of batches, AVX-512.", False),
    ("Largest difference of accelerations", "difference", "Against the first of the line, relative to the largest acceleration; 1e-9 is allowed. "
     "MuJoCo's loops are soft, so the four-bar is not the same problem there.", True),
]


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def cases_of(document, metric):
    return list(dict.fromkeys((row["model"], row["size"]) for row in document.rows if row["metric"] == metric))


def cell(row, metric):
    if row is None:
        return "–"
    value = row["value"]
    if metric == "difference":
        return "0" if value == 0 else f"{value:.1e}"
    text = number(value)
    spread = (row["high"] - row["low"]) / value if row.get("low") and value else 0
    return f"{text} (±{50 * spread:.0f} %)" if spread > 0.2 and metric.startswith("ns") else text


def section(document, title, metric, about, is_always):
    found = cases_of(document, metric)
    if not found and not is_always:
        return ""
    tools = list(dict.fromkeys(row["tool"] for row in document.rows if row["metric"] == metric))
    rows = [[f"{model}, {size}", *(cell(document.values.get((model, size, tool, metric)), metric) for tool in tools)] for model, size in found]
    return f"## {title}\n\n{about}\n\n{table(['model, size', *tools], rows)}\n"


def machine_block(document):
    machine = document.machine
    peers = ", ".join(f"{name} {version}" for name, version in machine["peers"].items())
    lines = [f"- {machine['processor']}, {machine['cores']} cores, load {machine['load']} when it began; {document.date}; commit {machine['commit']}",
             f"- {machine['compiler']}, `{machine['flags']}`; instructions with `{machine['flags_of_instruction_counts']}`", f"- {peers or 'no peers'}"]
    if document.selection != "all":
        lines.append(f"- a part of the whole: {document.selection}")
    return "## Machine\n\n" + "\n".join(lines) + "\n\n"


def target_block(document):
    outcomes = targets.all_of(document)
    met = sum(outcome.is_met for outcome in outcomes)
    rows = [[outcome.work, outcome.target, outcome.reached, "yes" if outcome.is_met else "**no**"] for outcome in outcomes]
    return f"## Figures to reach\n\n{met} of {len(outcomes)} are reached.\n\n" + table(["work", "target", "reached", "met"], rows) + "\n"


def missed(document):
    """Works with the same reason share it."""
    found = {}
    for outcome in targets.all_of(document):
        why = "" if outcome.is_met else reasons.of(document, outcome)
        if why:
            found.setdefault(why, []).append(f"{outcome.work} ({outcome.reached})")
    rows = "\n".join(f"- **{'; '.join(works)}**. {why}" for why, works in found.items())
    return f"## What is not reached, and why\n\n{rows}\n\n" if rows else ""


def losses(document):
    """Every case in which somebody is better than we are."""
    rows = []
    for metric, words in (("ns_rhs", "time"), ("instructions_rhs", "instructions"), ("operations", "operations"), ("compile", "compile time")):
        for model, size in cases_of(document, metric):
            ours = document.best(model, size, metric, "gauss")
            others = {tool: document.value(model, size, tool, metric) for tool in document.tools(model, metric) if not tool.startswith("gauss")}
            better = {tool: value for tool, value in others.items() if value is not None and ours and value < ours}
            if better:
                tool = min(better, key=better.get)
                rows.append([f"{model}, {size}", words, tool, f"{number(ours / better[tool])} times"])
    text = "Where somebody is better than the best of ours, and how much more ours takes.\n\n"
    return "## What we lose\n\n" + (text + table(["model, size", "what", "best", "ours"], rows) if rows else "Nothing, in this run.\n") + "\n"


def profile(document):
    """How much of a right-hand side the library's sines and cosines are, and how much would be left without."""
    rows = []
    for model, size in cases_of(document, "ns_sines"):
        values = [document.value(model, size, "gauss", f"{unit}_{what}") for unit in ("ns", "instructions") for what in ("rhs", "sines")]
        if None in values:
            continue
        time, sines, all_instructions, of_sines = values
        together = document.value(model, size, "gauss", "ns_rhs_vectorised")
        rows.append([f"{model}, {size}", number(time), f"{number(sines)} ({100 * sines / time:.0f} %)", number(together), number(all_instructions),
                     f"{number(of_sines)} ({100 * of_sines / all_instructions:.0f} %)"])
    if not rows:
        return ""
    about = ("A right-hand side, and the sines and cosines that it asks of the C library, called one after the other with nothing else. Where these do not wait for each other "
             "the processor works at other things meanwhile, so parts do not add up; instructions do. Together: with `gauss::Vectorised<double>`.\n\n")
    head = ["model, size", "ns", "ns of sines alone", "ns with sines together", "instructions", "of sines"]
    return "## Where the time goes\n\n" + about + table(head, rows) + "\n"


def generation_block(document):
    rows = []
    for metric, words in (("derive", "rhs"), ("derive_all", "all usual outputs")):
        for model, size in cases_of(document, f"{metric}_wall"):
            for tool in document.tools(model, f"{metric}_wall"):
                values = [document.value(model, size, tool, f"{metric}_{what}") for what in ("wall", "cpu", "memory")]
                if values[0] is not None:
                    rows.append([f"{model}, {size}", words, tool, *(number(value) for value in values)])
    about = "From the start of the program to its end, parameters as numbers. SymPy's time contains a second in which Python loads it.\n\n"
    return "## Generation\n\n" + about + table(["model, size", "what", "tool", "s", "s of processor", "MB"], rows) + "\n"


def left_out(document):
    if not document.skipped:
        return ""
    rows = "\n".join(f"- {row['what']}: {row['why']}" for row in document.skipped)
    return f"## Left out\n\n{rows}\n\n"


CHARTS = [("planar_chain", "Planar chain: time of a right-hand side", "rods", "ns", "ns_rhs", ("planar_chain",)),
          ("spatial_chain", "3-D chain on universal joints: time of a right-hand side", "rods", "ns", "ns_rhs", ("spatial_chain",)),
          ("generation", "Generation: planar chain", "rods", "s", "derive_wall", ("planar_chain", "planar_chain_relative"))]


def one_line(tool):
    """Of several ways of a peer, each size shows its best; our models are lines of their own."""
    return tool if tool.startswith("gauss") else tool.split(",")[0]


def chart(document, entry):
    _, title, across, up, metric, models = entry
    lines = {}
    for row in document.rows:
        if row["model"] in models and row["metric"] == metric and row["value"] > 0 and not row["tool"].endswith(", symbols"):
            points = lines.setdefault(one_line(row["tool"]), {})
            points[row["size"]] = min(row["value"], points.get(row["size"], row["value"]))
    found = [(tool, sorted(points.items())) for tool, points in sorted(lines.items(), key=lambda line: not line[0].startswith("gauss"))
             if len(points) > 1]
    return charts.lines_chart(title, across, up, found) if found else None


def pictures(document):
    """Name and text of each chart."""
    found = {f"performance/{entry[0]}.svg": chart(document, entry) for entry in CHARTS}
    return {name: text for name, text in found.items() if text}


def text_of(document, has_charts=True):
    text = INTRODUCTION + "\n" + machine_block(document)
    if has_charts:
        titles = {f"performance/{entry[0]}.svg": entry[1] for entry in CHARTS}
        text += "".join(f"![{titles[name]}]({name})\n\n" for name in pictures(document))
    text += target_block(document) + missed(document) + losses(document) + generation_block(document)
    text += "".join(section(document, *entry) for entry in SECTIONS) + profile(document)
    return text + simulation.block_of_files() + remedies.block_of_file() + QUOTED + "\n" + left_out(document).rstrip("\n") + "\n"


def files(document, page):
    return {page: text_of(document).rstrip("\n") + "\n", **{page.parent / name: text for name, text in pictures(document).items()}}


def write(document, page):
    for path, text in files(document, page).items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def load(path):
    return json.loads(path.read_text(encoding="utf-8"))


def differences(document, page):
    """Of the page and its charts from what the JSON gives."""
    return [f"{path.name} is not what the JSON gives: ./run bench --report" for path, text in files(document, page).items()
            if not path.exists() or path.read_text(encoding="utf-8") != text]
