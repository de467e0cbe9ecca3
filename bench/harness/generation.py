"""gauss-gen from start to exit."""

import re
import statistics
import tempfile
from pathlib import Path

from . import build, cases, measure


def measure_all(generations, builder, results, options):
    for generation in generations:
        key = (generation.kind, generation.size)
        for what, outputs in (("derive", generation.outputs), ("derive_all", ())):
            try:
                one(key, what, outputs, generation, builder, results, options)
            except build.BuildError as error:
                results.skip(f"{generation.kind}, size {generation.size}: {what}", str(error))


def one(key, what, outputs, generation, builder, results, options):
    emitted = cases.Emitted("gauss", generation.model, generation.count)
    arguments = builder.generator_arguments(emitted, generation.size, outputs or ("rhs",))
    if not outputs:
        arguments = arguments[:arguments.index("--outputs")]
    runs = []
    with tempfile.TemporaryDirectory(prefix="gauss bench ") as folder:
        command = [builder.generator, *arguments, "-o", folder, "--max-seconds", options.max_seconds]
        while len(runs) < options.generations and sum(run["wall"] for run in runs) < 10:
            runs.append(measure.launched(builder, command, 2 * options.max_seconds))
        text = next(Path(folder).glob("*.hpp")).read_text(encoding="utf-8")

    def add(metric, name, unit, scale=1):
        values = sorted(run[name] * scale for run in runs)
        results.add(key, "gauss", f"{what}_{metric}", round(statistics.median(values), 4), unit, low=round(values[0], 4),
                    high=round(values[-1], 4))
    add("wall", "wall", "s")
    add("cpu", "cpu", "s")
    add("memory", "memory", "MB", 1.024e-3)
    if outputs:
        results.add(key, "gauss", "operations_by_header", operations_of(text), "operations")


def operations_of(header):
    """Of the right-hand side, by the table on top; quotients of constants, which compilers compute, are in it."""
    return sum(int(number) for number in re.search(r"^//   rhs +((?:\d+ *)+)$", header, re.M)[1].split())
