"""The complete models in the documents can be copied whole and do what is said of them."""

import json
import math
import re
import textwrap
import unittest

from gauss_gen import MODELS, SOURCE, Program


def models_in(page):
    """Indented blocks that begin with the version of the format, by name."""
    found, block = {}, []
    for line in [*page.read_text(encoding="utf-8").splitlines(), "end"]:
        if line.startswith("    ") or (block and not line.strip()):
            block.append(line)
            continue
        text = textwrap.dedent("\n".join(block)).strip() + "\n"
        if text.startswith("gauss: 1\nname: "):
            found[text.splitlines()[1].split()[1]] = text
        block = []
    return found


def anchors_of(page):
    """What a heading is called in a link."""
    headings = re.findall(r"(?m)^#+ (.*)$", page.read_text(encoding="utf-8"))
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


class Documents(Program):
    def setUp(self):
        super().setUp()
        self.models = {}
        for page in [SOURCE / "README.md", *sorted((SOURCE / "docs").rglob("*.md"))]:
            self.models.update(models_in(page))

    def test_every_model_is_right(self):
        self.assertGreaterEqual(self.models.keys(), {"pendulum", "ball_on_slope"})
        for name, text in self.models.items():
            with self.subTest(name):
                self.ok("-", "--check", stdin=text)

    def test_every_effect_of_a_model_is_right(self):
        """Formulas of effects are read where they act: with all of them, and each alternative in its turn."""
        with_effects = {name: text for name, text in self.models.items() if "\neffects:\n" in text}
        self.assertGreaterEqual(with_effects.keys(), {"thrown_ball", "spinning_ball", "pulled_block"})
        for name, text in with_effects.items():
            section = re.split(r"(?m)^(?=\S)", text.partition("\neffects:\n")[2])[0]
            effects = re.findall(r"(?m)^  (\w+):", section)
            self.assertGreater(len(effects), 1, name)
            for choice in ["all", *(f"all,{effect}" for effect in effects)]:
                with self.subTest(name, choice=choice):
                    self.ok("-", "--check", f"--effects={choice}", stdin=text)

    def test_the_ball_on_the_slope_moves_as_stated(self):
        found = self.evaluated("ball_on_slope")
        m, g, alpha = 0.5, 9.81, math.pi / 6
        stated = {"accelerations.x_ddot": 5 / 7 * g * math.sin(alpha), "multipliers.rolling_x": -2 / 7 * m * g * math.sin(alpha),
                  "reactions.z": m * g * math.cos(alpha)}
        for name, value in stated.items():
            self.assertAlmostEqual(found[name], value, 12, name)

    def evaluated(self, name, *settings):
        """group.name: value, of a model in the documents."""
        document = json.loads(self.ok("evaluate", "-", "--format=json", *settings, stdin=self.models[name]))
        self.assertEqual(document["status"], "ok")
        return {f"{group}.{key}": float(entry["value"]) for group in ("state", "accelerations", "multipliers", "reactions")
                for key, entry in document.get(group, {}).items()}

    def test_the_driven_turntable_does_what_the_page_says(self):
        found = self.evaluated("driven_turntable")
        m, omega, x, y = 0.7, 3, 0.5, 0.1
        ax, ay = -2 / 7 * omega * 0.8, 2 / 7 * omega * 0.3
        stated = {"accelerations.x_ddot": ax, "accelerations.y_ddot": ay, "multipliers.contact_x": m * ax,
                  "multipliers.contact_y": m * ay, "reactions.turn": m * (x * ay - y * ax)}
        for name, value in stated.items():
            self.assertAlmostEqual(found[name], value, 12, name)

    def test_the_ball_in_the_bowl_does_what_the_page_says(self):
        self.assertNotEqual(self.evaluated("ball_in_bowl")["multipliers.along"], 0)
        found = self.evaluated("ball_in_bowl", "--set", "Omega=0", "--set", "dot(psi)=0")
        m, g, theta = 0.7, 9.81, 0.5
        stated = {"accelerations.theta_ddot": -5 / 7 * g * math.sin(theta) / 0.8, "reactions.s": -m * g * math.cos(theta),
                  "multipliers.along": 2 / 7 * m * g * math.sin(theta)}
        for name, value in stated.items():
            self.assertAlmostEqual(found[name], value, 12, name)

    def test_the_sliding_ball_does_what_the_page_says(self):
        sliding, rolling = self.evaluated("sliding_ball"), self.evaluated("sliding_ball", "--set", "wy=8/r")
        for name, value in (("accelerations.x_ddot", -0.2 * 9.81), ("accelerations.wy_dot", 2.5 * 0.2 * 9.81 / 0.11)):
            self.assertTrue(math.isclose(sliding[name], value, rel_tol=1e-7), name)  # v_s^2 / (2 v^2) is 8e-9
            self.assertEqual(rolling[name], 0)

    def test_the_friction_of_the_page_is_0_at_rest(self):
        page = (SOURCE / "docs/model-format.md").read_text(encoding="utf-8")
        drag = textwrap.dedent(re.search(r"(?m)^    drag:\n(?:     .*\n)+", page)[0])
        self.models["puck"] = ("gauss: 1\nname: puck\nparameters: {m: {value: 2, unit: kg}, F: {value: 3, unit: N}}\n"
                               "coordinates: {x: {unit: m, initial_rate: 3}, y: {unit: m, initial_rate: 4}}\n"
                               "particles: {puck: {mass: m, position: [x, y, 0]}}\nforces:\n" + textwrap.indent(drag, "  "))
        moving, at_rest = self.evaluated("puck"), self.evaluated("puck", "--set", "dot(x)=0", "--set", "dot(y)=0")
        for name, part in (("accelerations.x_ddot", 0.6), ("accelerations.y_ddot", 0.8)):
            self.assertAlmostEqual(moving[name], -1.5 * part, 12)
            self.assertEqual(at_rest[name], 0)

    def test_every_function_of_a_header_is_in_the_page_of_headers(self):
        page = (SOURCE / "docs/emitted-code.md").read_text(encoding="utf-8")
        outputs = re.search(r"--outputs LIST .*?:\s+(.*?)\n  --", self.ok("--help"), re.S)[1]
        names = {"prepare", "rhs_and_reactions", *re.findall(r"\w+", outputs)}
        self.assertGreaterEqual(names, {"rhs", "quantities", "project"})
        self.assertEqual(names, set(re.findall(r"(?m)^\| `(\w+)` \|", page.partition("## Status")[0])))

    def test_every_model_is_in_the_table_of_oracles(self):
        page = (SOURCE / "docs/verification.md").read_text(encoding="utf-8").partition("## Models")[2]
        rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in page.splitlines() if line.startswith("| `")]
        models = sorted(str(path.relative_to(MODELS).with_suffix("")) for path in MODELS.rglob("*.yaml"))
        self.assertEqual([row[0].strip("`") for row in rows], models)
        margins = "".join((SOURCE / f"tests/physics/{shared}.hpp").read_text(encoding="utf-8") for shared in ("follow", "states"))
        for model, oracle, where, tolerance in rows:
            with self.subTest(model):
                test = (SOURCE / where.strip("`")).read_text(encoding="utf-8")
                for reference in re.findall(r"`(\w+)\.json`", oracle):
                    self.assertTrue((SOURCE / f"tests/reference/{reference}.json").is_file())
                    self.assertIn(f'"{reference}"', test)
                for number in re.findall(r"`([^`]*)`", tolerance):
                    self.assertRegex(test + margins, rf"\b{number}\b")

    def test_files_that_recipes_name_are_there(self):
        recipes = (SOURCE / "CONTRIBUTING.md").read_text(encoding="utf-8").partition("## Recipes")[2].partition("\n## ")[0]
        self.assertGreaterEqual(len(re.findall(r"(?m)^\*\*", recipes)), 10)
        named = [name for name in re.findall(r"`([\w.<>-]+/[\w./<>-]*)`", recipes) if not name.startswith("./")]
        self.assertGreater(len(named), 40)
        for name in named:
            with self.subTest(name):
                self.assertTrue(list(SOURCE.glob(re.sub(r"<\w+>", "*", name.rstrip("/")))))

    def test_words_of_code_in_recipes_are_in_the_files_that_they_name(self):
        for file, words in {"generator/model/model.hpp": ["JointType", "Spring", "Force"],
                            "generator/model/format.cpp": ["joint_types", "joint_rule", "outputs"],
                            "generator/artefacts.cpp": ["output_kinds", "build_artefact"],
                            "generator/artefacts_motion.cpp": ["CoordinateSpring"],
                            "generator/emit/plan.cpp": ["PreparationSplit"],
                            "generator/emit/functions.cpp": ["schedule", "share"]}.items():
            text = (SOURCE / file).read_text(encoding="utf-8")
            for word in words:
                self.assertRegex(text, rf"\b{word}\b", file)

    def test_links_of_documents_lead_somewhere(self):
        for page in [SOURCE / "README.md", SOURCE / "CONTRIBUTING.md", *sorted((SOURCE / "docs").rglob("*.md"))]:
            text = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.M | re.S)
            for target in re.findall(r"\]\(([^)\s]+)\)", re.sub(r"`[^`\n]*`", "", text)):
                if "://" in target:
                    continue
                path, _, anchor = target.partition("#")
                file = page.parent / path if path else page
                with self.subTest(f"{page.name}: {target}"):
                    self.assertTrue(file.exists())
                    if anchor:
                        self.assertIn(anchor, anchors_of(file))

    def test_a_planar_body_and_a_wheel_are_written_as_stated(self):
        page = (SOURCE / "docs/model-format.md").read_text(encoding="utf-8")
        planar, wheel = "{euler: zyx, angles: [psi, 0, 0]}", "{euler: zyx, angles: [psi, phi, 0]}"
        push, dependent = "push: {generalized: {x: F, psi: -F*a*sin(psi)}}", "{dependent: [x, y]}"
        for idiom in (planar, wheel, push, dependent):
            self.assertIn(f"`{idiom}`", page)
        place = "mass: 1, inertia: 1, position: [x + a*cos(psi), y + a*sin(psi), 0]"
        model = ("gauss: 1\nname: idioms\nparameters: {F: 2, a: 0.5}\ncoordinates: {x: {}, y: {}, psi: {}, phi: {}}\n"
                 f"bodies:\n  b: {{{place}, orientation: {planar}}}\n  w: {{{place}, orientation: {wheel}}}\n"
                 "constraints:\n  first: {velocity: dot(x) - a*dot(phi)}\n"
                 "  second: {velocity: dot(y) - a*dot(psi)}\n"
                 f"forces:\n  {push}\nelimination: {dependent}\n")
        self.ok("-", "--check", stdin=model)


if __name__ == "__main__":
    unittest.main()
