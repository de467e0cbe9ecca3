"""docs/signs.md: every value in its tables is what gauss-gen gives, by the formula beside it."""

import json
import math
import re
import unittest

from gauss_gen import SOURCE, Program

PAGE = (SOURCE / "docs/signs.md").read_text(encoding="utf-8")
MODEL = re.compile(r"^```yaml (\S+)\n((?:(?!```).*\n)*)```$|\bFrom\s`(models/\S+)`:$", re.M)
PARAMETER = re.compile(r"^  (\w+): +\{value: ([\d.]+)[,}]", re.M)  # those that are numbers
FUNCTIONS = {"__builtins__": {}, "sqrt": math.sqrt, "sin": math.sin, "cos": math.cos}
AT_REST = ("crane", "beam", "brake")
TOLERANCE = 1e-12  # of the largest value of a structure, or of 1


def rows(text):
    """Cells of the tables, those in backquotes without them."""
    for line in text.splitlines():
        if line.startswith("| `"):
            yield [cell.strip().strip("`") for cell in line.strip("| ").split(" | ")]


def structures():
    """(name, model, what follows it on the page)"""
    found = list(MODEL.finditer(PAGE))
    ends = [match.start() for match in found[1:]] + [len(PAGE)]
    for match, end in zip(found, ends):
        name = match[1] or match[3]
        model = match[2] or (SOURCE / name).read_text(encoding="utf-8")
        yield name, model, PAGE[match.end():end]


def evaluate(formula, known):
    return eval(formula.replace("^", "**"), FUNCTIONS, known)


def parameters(model):
    section = model.partition("\nparameters:")[2].partition("\n\n")[0]
    return {name: float(value) for name, value in PARAMETER.findall(section)}


class Signs(Program):
    def values(self, model):
        """group.name: value, and group.name: vector where there are components."""
        document = json.loads(self.ok("evaluate", "-", "--format=json", stdin=model))
        self.assertEqual(document["status"], "ok")
        found = {}
        for group in ("multipliers", "reactions", "reaction_forces", "joint_reactions"):
            for name, entry in document.get(group, {}).items():
                found[f"{group}.{name}"] = [float(entry["value"])]
                vector, _, component = name.rpartition(".")
                if component in ("x", "y", "z"):
                    found.setdefault(f"{group}.{vector}", []).append(float(entry["value"]))
        if document["model"] in AT_REST:
            self.check([float(entry["value"]) for entry in document["accelerations"].values()],
                       [0] * len(document["accelerations"]), "rest")
        return found

    def check(self, found, expected, name):
        expected = expected if isinstance(expected, list) else [expected]
        self.assertEqual(len(found), len(expected), name)
        scale = max(1, *map(abs, expected))
        for a, b in zip(found, expected):
            self.assertLessEqual(abs(a - b), TOLERANCE * scale, (name, found, expected))

    def test_each_value_is_what_the_page_derives(self):
        compared = 0
        for name, model, text in structures():
            known, values = parameters(model), self.values(model)
            for cells in rows(text):
                if re.fullmatch(r"\w+", cells[0]):
                    known[cells[0]] = evaluate(cells[1], known)
                elif re.fullmatch(r"\w+(\.\w+)+", cells[0]):
                    with self.subTest(f"{name}: {cells[0]}"):
                        self.check(values[cells[0]], evaluate(cells[1], known), cells[0])
                        compared += 1
        self.assertGreaterEqual(compared, 28)

    def test_the_multiplier_follows_the_words_and_the_force_does_not(self):
        model, text = next((model, text) for name, model, text in structures() if name == "brake.yaml")
        variants = [cells for cells in rows(text) if cells[0].startswith("road:")]
        self.assertEqual(len(variants), 7)
        for line, multiplier, force in variants:
            with self.subTest(line):
                values = self.values(re.sub(r"^  road: .*", "  " + line, model, flags=re.M))
                self.check(values["multipliers.road"], evaluate(multiplier, parameters(model)), line)
                self.check(values["reaction_forces.road.force_on_wheel.x"], evaluate(force, parameters(model)), line)
                if "velocity" in line or "equation" in line:
                    self.check(values["reaction_forces.road.moment_on_wheel.y"],
                               evaluate("m*g*r*sin(alpha)", parameters(model)), line)

    def test_a_stated_point_is_where_the_moment_vanishes(self):
        model = next(model for name, model, _ in structures() if name == "brake.yaml")
        line = "  road: {velocity: dot(x) - r*dot(phi), point: [x, 0, 0]}"
        values = self.values(re.sub(r"^  road: .*", line, model, flags=re.M))
        self.check(values["reaction_forces.road.moment_on_wheel"], [0, 0, 0], line)

    def test_the_models_of_the_page_are_right(self):
        for name, model, _ in structures():
            self.ok("-", "--check", stdin=model)


if __name__ == "__main__":
    unittest.main()
