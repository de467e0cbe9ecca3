"""What emitted code pays for hard cases: the second way to accelerations, projection, held partitions, rules against cancellation."""

import datetime
import re
from dataclasses import dataclass

from . import build, machine, measure, results
from .targets import number

RESULTS = build.ROOT / "bench/results/remedies.json"
KIND = "along its motion"  # no kind of drivers/cases.hpp: states are those of the model's own motion
OUTPUTS = "rhs,initial_state,project"


@dataclass(frozen=True)
class Model:
    path: str  # below the root
    arguments: tuple = ("--fold",)

    @property
    def name(self):
        return self.path.split("/")[-1].split(".")[0] + ("" if "--fold" in self.arguments else ", symbols")


def folded(*paths):
    return [Model(f"models/{path}.yaml") for path in paths]


# Ordinary states of closed loops, of rolling and of quaternions; where parameters as symbols leave open what a file settles, with both.
MODELS = [
    *folded("four_bar", "slider_crank", "iftomm_a02", "iftomm_a02_parallel", "families/n_four_bar"),
    Model("hard_cases/models/parallelogram.yaml"), Model("hard_cases/models/bennett.yaml"),
    *folded("bicycle", "rolling_disc", "chaplygin_sleigh", "skater_quaternion", "sphere_in_cylinder", "sphere_in_cylinder_quaternion",
            "sphere_turntable", "free_top", "double_pendulum"),
    *(Model(f"models/{name}.yaml", ()) for name in ("four_bar", "rolling_disc", "chaplygin_sleigh", "sphere_in_cylinder")),
]

RULES = {"cosines": "cam", "roots": "taut_string", "exponentials": "rubber_stop", "logarithms": "strained_bar", "squares": "sail",
         "angles": "detent", "limits": "bent_rod"}


class Measured:
    def __init__(self, builder, found, options):
        self.builder = builder
        self.found = found
        self.options = options

    def header(self, model, name_space, *arguments):
        path = build.ROOT / model
        folder = self.builder.headers / build.digest(self.builder.generator_digest, path.read_bytes(), name_space, *arguments)
        if not list(folder.glob("*.hpp")):
            folder.mkdir(parents=True, exist_ok=True)
            build.run([self.builder.generator, path, *arguments, "--outputs", OUTPUTS, "--namespace", name_space, "-o", folder])
        return next(folder.glob("*.hpp"))

    def object(self, header, flags, tool, name_space, *defines):
        return self.builder.object("remedies.cpp", flags, (f'HEADER="{header}"', f"MODEL={name_space}", f'TOOL="{tool}"', *defines),
                                   [header.parent], header.read_bytes())

    def program(self, name, flags, objects):
        return self.builder.program(name.replace("/", "_").replace(", ", "_"), [self.builder.object("main.cpp", flags), *objects(flags)])

    def measure(self, name, objects):
        """Times and instructions of all that is linked, in one run, once they agree about accelerations."""
        key = (name, 1)
        program = self.program(f"remedies_{name}", build.FLAGS, objects)
        try:
            build.run([program, KIND, 1, "--check"])
        except build.BuildError as error:
            raise measure.Disagreement(f"{name}: the accelerations differ\n{error}") from error
        for row in measure.lines(build.run([program, KIND, 1, "--time", self.options.rounds, self.options.milliseconds], timeout=900)):
            self.found.add(key, row["tool"], "ns_" + row["metric"], row["median"], "ns", low=row["low"], high=row["high"])
        if not self.options.has("valgrind"):
            return
        portable = self.program(f"remedies_{name}_portable", build.PORTABLE_FLAGS, objects)
        for row in measure.lines(build.run([portable, KIND, 1, "--time", 1, 0.01], timeout=900)):
            few, many = (measure.instructions_of(portable, KIND, 1, row["tool"], row["metric"], calls)
                         for calls in (measure.STATES, 3 * measure.STATES))
            self.found.add(key, row["tool"], "instructions_" + row["metric"], round((many - few) / (2 * measure.STATES), 1), "instructions")

    def model(self, model):
        header = self.header(model.path, "measured", *model.arguments)
        text = header.read_text(encoding="utf-8")
        rule = re.search(r"rhs_general\(const.*?(rank_o[a-z]+_[a-z]+)<S>\((\d+)\)", text, re.S)
        defines = ["WITH_STEPS"]
        if rule and "rhs_regular" in text:
            defines.append(f"RULE=gauss::{rule[1]}<double>({rule[2]})")
        ways = 2 if "rhs_regular" in text else 1
        self.found.add((model.name, 1), "gauss", "ways", ways, "ways to accelerations")
        self.found.add((model.name, 1), "gauss", "carries_general", int("struct LinearSystem" in text and ways == 1), "1: a general way alone")
        self.measure(model.name, lambda flags: [self.object(header, flags, "gauss", "measured", *defines)])

    def rule(self, rule, model):
        headers = {"with": self.header(f"bench/models/{model}.yaml", "with_rules", "--fold"),
                   "without": self.header(f"bench/models/{model}.yaml", "without_rules", "--fold", "--as-written", rule)}
        self.measure(rule, lambda flags: [self.object(header, flags, tool, f"{tool}_rules") for tool, header in headers.items()])
        for tool, header in headers.items():
            row = re.search(r"^// +rhs +(.*)$", header.read_text(encoding="utf-8"), re.M)
            self.found.add((rule, 1), tool, "operations", sum(int(count) for count in row[1].split()), "operations")

    def unchanged(self):
        """Of our models, those whose code is the same without any rule."""
        same = other = 0
        for path in sorted((build.ROOT / "models").glob("*.yaml")):
            model = path.relative_to(build.ROOT)
            texts = [self.body(self.header(model, "measured", "--fold", *arguments)) for arguments in
                     ((), ("--as-written", ",".join(RULES)))]
            same += texts[0] == texts[1]
            other += texts[0] != texts[1]
        self.found.add(("all models", 1), "gauss", "same_without_rules", same, "models")
        self.found.add(("all models", 1), "gauss", "other_without_rules", other, "models")

    @staticmethod
    def body(header):
        """Without the lines that say how it was made."""
        return re.sub(r"^// Command:(?:.*\n)(?:// .*\n)*", "", header.read_text(encoding="utf-8"), count=1, flags=re.M)


def measure_all(options, found):
    measured = Measured(options.builder, found, options)
    wanted = [model for model in MODELS if not options.only or any(word in model.name for word in options.only)]
    for model in wanted:
        print(f"bench: {model.name}", flush=True)
        measured.model(model)
    for rule, model in RULES.items():
        if not options.only or rule in options.only:
            print(f"bench: {rule}", flush=True)
            measured.rule(rule, model)
    if not options.only:
        measured.unchanged()
        results.write(RESULTS, found, machine.description(), datetime.date.today().isoformat(), "remedies")


# --- the page --------------------------------------------------------------------------------------------

ABOUT = """## What the remedies cost

`./run bench --remedies` measures this part alone, at 64 states along each model's own motion from its initial state, one after the other in
one run. **Second way**: `rhs`, which looks whether its cheap way has lost its digits, against that way alone (`rhs_regular`). "one" has no second: the generator knows
that it is not needed, and nothing is emitted for it; "general" has only the one that bears any rank. **Projection**: a step of the classical
Runge-Kutta method with `project` behind it, against one without. **Held partition**: `PartitionedModel` with one choice, against `rhs`.
At most 1.25 is to be reached where a remedy is not needed.

"""
RULES_ABOUT = """## What rules against cancellation cost

Each in a whole model in which it acts (`bench/models/`): `rhs` with the rule against `rhs` with `--as-written` and its name. A rule that costs more than 5 % is an option by that.

"""


def ratio(document, name, metric, over, tool="gauss", other=None):
    values = document.value(name, 1, tool, metric), document.value(name, 1, other or tool, over)
    return None if None in values else values[0] / values[1]


def ratios(document, name, metric, over, **tools):
    """In time, and in instructions."""
    found = [ratio(document, name, f"{unit}_{metric}", f"{unit}_{over}", **tools) for unit in ("ns", "instructions")]
    return [number(value) for value in found]


def table(head, rows):
    lines = ["| " + " | ".join(line) + " |" for line in [head, *rows]]
    return "\n".join([lines[0], "|" + "---|" * len(head), *lines[1:]]) + "\n"


def where(document):
    """This part has a machine of its own, which need not be that of the rest of the page."""
    if not document.machine:
        return ""
    found = document.machine
    return (f"Measured on {found['processor']}, {found['cores']} cores, load {found['load']} when it ended, {document.date}, commit {found['commit']}: "
            "not the machine of the tables above, unless it is named there, too.\n\n")


def block(document):
    rows = []
    for model in MODELS:
        ways = document.value(model.name, 1, "gauss", "ways")
        if ways is None:
            continue
        word = "two" if ways == 2 else "general" if document.value(model.name, 1, "gauss", "carries_general") else "one"
        rows.append([model.name, word, number(document.value(model.name, 1, "gauss", "ns_rhs")),
                     *ratios(document, model.name, "rhs", "rhs_regular"), *ratios(document, model.name, "step_projected", "step"),
                     *ratios(document, model.name, "held", "rhs")])
    text = ABOUT + where(document) + table(["model", "ways", "ns of rhs", "second way, time", "instructions", "projection, time", "instructions",
                          "held, time", "instructions"], rows)
    rows = []
    for rule, model in RULES.items():
        if document.value(rule, 1, "with", "ns_rhs") is None:
            continue
        operations = [number(document.value(rule, 1, tool, "operations")) for tool in ("with", "without")]
        rows.append([rule, model, *operations, *(number(document.value(rule, 1, tool, "ns_rhs")) for tool in ("with", "without")),
                     *ratios(document, rule, "rhs", "rhs", tool="with", other="without")])
    text += "\n" + RULES_ABOUT + table(["rule", "model", "operations with", "without", "ns with", "without", "time", "instructions"], rows)
    same, other = (document.value("all models", 1, "gauss", f"{word}_without_rules") for word in ("same", "other"))
    if same is not None:
        text += f"\nOf the {same + other} models in `models/`, {same} have the same code without any rule.\n"
    return text + "\n"


def block_of_file():
    return block(results.read(RESULTS)) if RESULTS.exists() else ""
