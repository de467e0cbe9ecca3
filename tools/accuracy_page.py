"""Writes docs/accuracy.md and its charts from a study: tools/accuracy_page.py STUDY.json SVG_SCRIPT DOCS.

Every figure in the text comes from the study; run `./run study` to make it anew.
"""

import json
import math
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ERRORS = [1e-3, 1e-6, 1e-9, 1e-12]


def done(problem):
    return [point for point in problem["points"] if point["status"] == "ok" and point["error"] is not None]


def own_form(problem):
    return problem["points"][0]["formulation"]


def is_plain(point, problem):
    """The scene as it is written, in double, by optimised code."""
    return (point["formulation"], point["number"], point["code"]) == (own_form(problem), "double", "optimised")


def cheapest(points, error):
    return min((point for point in points if point["error"] <= error), key=lambda point: point["time_s"], default=None)


def time(seconds):
    if seconds is None:
        return "–"
    for unit, size in (("s", 1), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"


def short(number):
    return f"{number:.2g}" if 0.01 <= number < 1000 else f"{number:.0e}".replace("e-0", "e-").replace("e+0", "e")


def setting(point):
    size = f"tolerance {short(point['tolerance'])}" if point["tolerance"] else f"step {point['step']:.2g} s"
    more = [point["number"]] if point["number"] != "double" else []
    more += [point["code"]] if point["code"] != "optimised" else []
    more += [f"projection {point['projection']}"] if point["projection"] != "full" else []
    return ", ".join([f"`{point['method']}`", size, *more, point["formulation"]])


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows])


def picture(name, words, folder):
    """A chart that the study has; nothing where it has none."""
    return f"![{words}](accuracy/{name}.svg)\n" if (folder / f"{name}.svg").exists() else ""


def summary(problems):
    rows = []
    for problem in problems:
        for error in ERRORS:
            best = cheapest(done(problem), error)
            usual = next((p for p in problem["points"] if p["is_default"] and p["status"] == "ok"), None)
            rows.append([problem["name"] if error == ERRORS[0] else "", short(error), time(best["time_s"]) if best else "not reached",
                         setting(best) if best else "",
                         f"{short(usual['error'])} in {time(usual['time_s'])}" if usual and error == ERRORS[0] else ""])
    return table(["problem", "error asked for", "least time", "setting", "the default delivers"], rows)


def tolerance_is_not_error(problems):
    """By how much delivered errors exceed the tolerance of 1e-6: with the projection that a method has by default."""
    methods = ["taylor", "prince87", "fehlberg78", "dopri5", "bulirsch_stoer", "cvode_adams", "cvode_bdf", "ida"]
    rows = []
    for problem in problems:
        points = [point for point in done(problem) if is_plain(point, problem) and point["tolerance"] == 1e-6]
        ratios = {point["method"]: point["error"] / point["tolerance"] for projection in ("off", "full") for point in points if point["projection"] == projection}
        rows.append([problem["name"], *[short(ratios[m]) if m in ratios else "–" for m in methods]])
    return table(["delivered / asked for, 1e-6", *[f"`{m}`" for m in methods]], rows)


def one_more_digit(problems):
    """Factor in time for ten times less error, between 1e-3 and 1e-9 or what of it there is."""
    methods = ["taylor", "prince87", "fehlberg78", "dopri5", "rk4"]
    rows = []
    for problem in problems:
        row = [problem["name"]]
        for method in methods:
            points = [p for p in done(problem) if is_plain(p, problem) and p["method"] == method and p["projection"] == "full"]
            ends = [cheapest(points, error) for error in (1e-4, 1e-9)]
            if None in ends or ends[0] is ends[1]:
                row.append("–")
            else:
                row.append(f"{(ends[1]['time_s'] / ends[0]['time_s']) ** (1 / 5):.2f}")
        rows.append(row)
    return table(["one more digit", *[f"`{m}`" for m in methods]], rows)


def ratio_rows(problems, key, values, usual):
    """Time to 1e-9 and calls of other values of one setting, beside the usual one, for the cheapest of the usual methods."""
    rows = []
    for problem in problems:
        base = [p for p in done(problem) if p["code"] == "optimised" or key == "code"]
        for value in values(problem):
            row = [problem["name"], value]
            for error in (1e-3, 1e-6, 1e-9):
                same = [p for p in base if all(p[k] == v for k, v in usual(problem).items() if k != key)]
                mine = cheapest([p for p in same if p[key] == value], error)
                other = cheapest([p for p in same if p[key] == usual(problem)[key]], error)
                row.append(f"{mine['time_s'] / other['time_s']:.2f}" if mine and other else "–")
            if any(cell != "–" for cell in row[2:]):
                rows.append(row)
    return rows


def usual(problem):
    point = next((p for p in problem["points"] if p["is_default"]), problem["points"][0])
    return {"formulation": own_form(problem), "number": "double", "code": "optimised", "projection": point["projection"],
            "method": point["method"]}


def drift_rows(problems):
    """What projection costs and buys, by the method that takes all kinds, at the tolerance of 1e-9."""
    rows = []
    for problem in problems:
        points = {p["projection"]: p for p in done(problem) if is_plain(p, problem) and p["method"] == "prince87" and p["tolerance"] == 1e-9}
        off = points.get("off")
        if len(points) < 2 or off is None:
            continue
        for kind in ("off", "positions", "velocities", "full", "energy", "gains"):
            if kind not in points:
                continue
            point = points[kind]
            drift = point["drift"] or {}
            rows.append([problem["name"], kind, f"{point['time_s'] / off['time_s']:.2f}", short(point["error"]),
                         short(drift["energy"]) if drift.get("energy") is not None else "–",
                         short(drift["constraints"]) if drift.get("constraints") is not None else "–"])
    return table(["problem", "projection", "time, off = 1", "error", "drift of energy", "drift of constraints"], rows)


def others(values_of):
    return lambda problem: [value for value in dict.fromkeys(p[values_of] for p in problem["points"]) if value != usual(problem)[values_of]]


def build_rows(problems):
    rows = []
    for problem in problems:
        for build in problem["builds"]:
            rows.append([problem["name"], build["formulation"], build["operations"] or "–", time(build["generate_s"]),
                         time(build["compile_s"]) if build["compile_s"] is not None else "cached"])
    return table(["problem", "formulation", "operations of rates", "generate", "compile"], rows)


def lane_rows(problems):
    rows = [[problem["name"], lane["number"], lane["lanes"], lane["threads"], f"{lane['trajectories_per_s']:.3g}", f"{lane['ratio']:.2f}"]
            for problem in problems for lane in problem.get("lanes", [])]
    return table(["problem", "number", "lanes", "threads", "trajectories per s", "beside one after the other"], rows) if rows else ""


def percent(part):
    return f"{100 * part:.2g} %" if part < 0.995 else "100 %"


def effect_rows(problem):
    """All effects, all but one, and none: what they cost and change."""
    effects = problem["effects"]
    sets = [{**effects["all"], "what": "all"}, *effects["each"], {**effects["none"], "what": "none"}]
    rows = []
    for one in sets:
        if "operations" not in one:
            rows.append([one["what"], "–", "–", "–", "–", one["why"]])
            continue
        change = "" if one["what"] == "all" else f"{short(one['change'])} of `{one['output']}`" if "output" in one else "nothing"
        rows.append([one["what"], one["operations"], f"{one['ns']:.3g} ns" if "ns" in one else "–", time(one["run_seconds"]),
                     percent(one["run_seconds"] / effects["all"]["run_seconds"]), change])
    return table([problem["name"], "operations of rates", "a call", "a run", "of the time", "changes the motion by"], rows)


def effects_of(problems, folder):
    """Of each scene that has some."""
    parts = []
    for problem in problems:
        if "all" not in problem.get("effects", {}):
            continue
        effects = problem["effects"]
        parts += [f"{problem['name']}: {effects['duration']:g} s by `{effects['method']}`, good to {short(effects['good_to'])}." if "good_to" in effects else "",
                  effect_rows(problem), picture(f"{problem['name']}-effect-ladder", f"{problem['name']}: model error removed against time paid", folder)]
    if not parts:
        return []
    return ["## What effects cost and change",
            "The scene with all its effects, and without each of them (with those that need it); a change is the largest difference of an output over its range. "
            "The ladder leaves out one effect after the other, each time the one whose absence changes the motion least; [effects.md](effects.md#which-ones-a-scene-needs) has the command for one scene.",
            *parts]


def reference_rows(problems):
    return table(["problem", "reference", "good to"], [[p["name"], "; ".join(p["reference"]["methods"]), short(p["reference"]["agreement"])]
                                                       for p in problems])


def lessons(problems):
    """Sentences with figures of this study."""
    by_name = {problem["name"]: problem for problem in problems}
    said = []

    def best(name, error, **keys):
        points = [p for p in done(by_name[name]) if all(p[k] == v for k, v in keys.items())]
        return cheapest(points, error)

    if "sphere" in by_name:
        plain = {"code": "optimised", "number": "double", "method": "taylor", "projection": "full"}
        one, two = (best("sphere", 1e-9, formulation=form, **plain) for form in ("quaternion", "Euler angles"))
        if one and two:
            said.append(f"**Formulation**: the sphere to 1e-9 takes {time(one['time_s'])} by its quaternion and {time(two['time_s'])} by Euler "
                        f"angles, {two['time_s'] / one['time_s']:.1f} times as long, in {two['calls'] / one['calls']:.1f} times as many calls.")
    if "stiff_spring_pendulum" in by_name:
        problem = by_name["stiff_spring_pendulum"]
        stiff = cheapest([p for p in done(problem) if p["method"].startswith(("cvode_bdf", "ida", "arkode_trbdf2", "arkode_esdirk4", "arkode_kvaerno5"))], 1e-6)
        other = cheapest([p for p in done(problem) if p["method"] in ("taylor", "prince87", "fehlberg78", "dopri5") and p["number"] == "double"], 1e-6)
        if stiff and other:
            said.append(f"**Stiffness**: to 1e-6 the stiff spring takes {time(stiff['time_s'])} by `{stiff['method']}` and {time(other['time_s'])} by the best "
                        f"explicit method, `{other['method']}`.")
    slow = [(p["name"], best(p["name"], 1e-6, method="cvode_adams"), best(p["name"], 1e-6, method="prince87", number="double")) for p in problems]
    slow = [(name, a["time_s"] / b["time_s"]) for name, a, b in slow if a and b]
    if slow:
        mean = math.exp(sum(math.log(ratio) for _, ratio in slow) / len(slow))
        said.append(f"**Overhead**: `cvode_adams` takes {mean:.1f} times as long as `prince87` to 1e-6 (geometric mean of {len(slow)} problems).")
    pairs = [(best(p["name"], 1e-9, method="taylor", number="double", code="optimised"), best(p["name"], 1e-9, method="fehlberg78")) for p in problems]
    ratios = [a["time_s"] / b["time_s"] for a, b in pairs if a and b]
    if ratios:
        mean = math.exp(sum(map(math.log, ratios)) / len(ratios))
        said.append(f"**Power series**: to 1e-9 `taylor` takes {mean:.2f} of the time of `fehlberg78` (geometric mean of {len(ratios)} problems).")
    return "\n".join(f"- {sentence}" for sentence in said)


def page(study, folder):
    problems = [problem for problem in study["problems"] if problem["points"]]
    machine = study["machine"]
    parts = [
        "# What accuracy costs in time",
        "Written by `./run study` from `build/release/study.json`: do not edit. The same study as a page that can be filtered, with the motions themselves, is "
        "`build/release/study.html` after that command; [study-format.md](study-format.md) describes the rows.",
        f"{machine['processor']}, {machine['cores']} cores, {machine['system']}, {machine['compiler']} `{machine['flags']}`, {study['tool']}. Times are medians of the "
        "processor's, for one run with all its samples, without generation and compilation. An error is the largest difference from the reference over all outputs and "
        "samples, relative to the range of each output.",
        "## What it teaches",
        lessons(problems),
        "## What each error costs",
        picture("summary", "Least time for each error, all problems", folder),
        "Settings without projection let constraints drift, by a part of the error. The default keeps them: it is on the front of the settings that do, and what is faster below it has `projection off`, another code or another formulation.",
        summary(problems),
        *[picture(f"{problem['name']}-error-time", f"{problem['name']}: error and time of all runs", folder) for problem in problems
          if problem["name"] in ("sphere", "double_pendulum", "stiff_spring_pendulum")],
        "## Tolerance is not error",
        "A tolerance bounds the error of a step. What arrives at the end is what the motion makes of the sum of them.",
        tolerance_is_not_error(problems),
        picture("double_pendulum-tolerance", "double_pendulum: error delivered over tolerance asked for", folder),
        "## What one more digit costs",
        "Factor in time for an error ten times as small, on the way from 1e-4 to 1e-9.",
        one_more_digit(problems),
        picture("double_pendulum-digit-cost", "double_pendulum: factor in time for one more digit", folder),
        "## Formulations and code",
        "Time beside the scene as it is written, by the default method, to three errors.",
        table(["problem", "other formulation", "1e-3", "1e-6", "1e-9"], ratio_rows(problems, "formulation", others("formulation"), usual)),
        table(["problem", "other code", "1e-3", "1e-6", "1e-9"], ratio_rows(problems, "code", others("code"), usual)),
        picture("sphere-formulations", "sphere: formulations", folder),
        "## Number types",
        "Time beside double, by the default method.",
        table(["problem", "number type", "1e-3", "1e-6", "1e-9"], ratio_rows(problems, "number", others("number"), usual)),
        "## Projection",
        "What it costs and what it buys, by `prince87` at a tolerance of 1e-9. All but `gains` act once after a step; `gains` pulls in each call of the right-hand side, where it solves for accelerations with the whole mass matrix and all constraints.",
        drift_rows(problems),
        picture("four_bar-projections", "four_bar: what projection costs and brings", folder),
        "## Many at once",
        "Lanes are as many as the compiler's options above allow, of `-march=native`; [performance.md](performance.md) has those of AVX2.",
        lane_rows(problems),
        *effects_of(study["problems"], folder),
        "## Generation and compilation",
        build_rows(problems),
        "## References",
        reference_rows(problems),
    ]
    return "\n\n".join(part.strip() for part in parts if part.strip()) + "\n"


def main():
    study_file, script, docs = (Path(argument) for argument in sys.argv[1:4])
    study = json.loads(study_file.read_text(encoding="utf-8"))
    folder = docs / "accuracy"
    with tempfile.TemporaryDirectory() as drawn:
        subprocess.run(["node", script, study_file, drawn], check=True, stdout=subprocess.DEVNULL)
        text = page(study, Path(drawn))
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        for chart in sorted(Path(drawn).glob("*.svg")):
            if f"accuracy/{chart.name}" in text:
                shutil.copyfile(chart, folder / chart.name)
    (docs / "accuracy.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
