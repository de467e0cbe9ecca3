"""An effect that a scene does not call for costs nothing: its absence is that of a model which never had it, to the byte."""

import itertools
import json
import re
import unittest
from concurrent.futures import ThreadPoolExecutor

from gauss_gen import Program, without_poles

EPSILON = 2.0 ** -52

PROJECTILE = {
    "gauss": 1, "name": "projectile",
    "parameters": {"m": {"value": 0.145, "unit": "kg", "about": "mass of the ball"},
                   "r": {"value": 0.037, "unit": "m", "about": "its radius"}},
    "coordinates": {"x": {"unit": "m", "initial_rate": 31.7}, "y": {"unit": "m", "initial_rate": 1.3},
                    "z": {"unit": "m", "initial": 1.8, "initial_rate": 9.1}},
    "orientations": {"attitude": {"quaternion": ["e0", "e1", "e2", "e3"], "angular_velocity": ["wx", "wy", "wz"],
                                  "frame": "space", "initial_angular_velocity": [11, -130, 27]}},
    "bodies": {"ball": {"mass": "m", "inertia": "2/5*m*r^2", "position": ["x", "y", "z"], "orientation": "attitude"}},
    "effects": {
        "gravity": {"about": "weight of the ball", "default": "on",
                    "parameters": {"g_earth": {"value": 9.81, "unit": "m/s^2"}},
                    "forces": {"weight": {"uniform": [0, 0, "-g_earth"]}}},
        "stokes": {"about": "drag of a thick medium", "parameters": {"b_lin": {"value": 0.0031, "unit": "N*s/m"}},
                   "forces": {"thick": {"generalized": {"x": "-b_lin*dot(x)", "y": "-b_lin*dot(y)", "z": "-b_lin*dot(z)"}}}},
        "newton": {"about": "drag of a thin medium", "parameters": {"b_quad": {"value": 0.0013, "unit": "kg/m"}},
                   "forces": {"thin": {"on": "ball", "force": [
                       f"-b_quad*dot({c})*sqrt(dot(x)^2 + dot(y)^2 + dot(z)^2)" for c in "xyz"]}}},
        "magnus": {"about": "force across spin and way", "parameters": {"k_magnus": {"value": 0.00021, "unit": "kg"}},
                   "forces": {"curve": {"on": "ball", "force": ["k_magnus*(wy*dot(z) - wz*dot(y))",
                                                                "k_magnus*(wz*dot(x) - wx*dot(z))",
                                                                "k_magnus*(wx*dot(y) - wy*dot(x))"]}}},
        "brake": {"about": "air slows the spin", "parameters": {"d_spin": {"value": 2e-6, "unit": "N*m*s"}},
                  "forces": {"slowing": {"generalized": {c: f"-d_spin*{c}" for c in ("wx", "wy", "wz")}}}},
        "rope": {"about": "an elastic rope to the pitcher", "parameters": {"k_rope": {"value": 0.7, "unit": "N/m"}},
                 "points": {"hand": {"at": [0, 0, 0]}},
                 "forces": {"leash": {"spring": ["hand", "ball"], "stiffness": "k_rope"}}},
    },
}
COEFFICIENTS = {"gravity": "g_earth", "stokes": "b_lin", "newton": "b_quad", "magnus": "k_magnus", "brake": "d_spin",
                "rope": "k_rope"}

# Constraints, inertias, alternatives, inputs, a table, reactions.
CRANE = {
    "gauss": 1, "name": "crane",
    "parameters": {"m_hook": {"value": 3, "unit": "kg"}, "l_0": {"value": 2, "unit": "m"}, "g": {"value": 9.81, "unit": "m/s^2"}},
    "coordinates": {"cart": {"unit": "m"}, "s": {"unit": "m"}, "theta": {"unit": "rad", "initial": 0.3}},
    "particles": {"hook": {"mass": "m_hook", "position": ["cart + s*sin(theta)", 0, "-s*cos(theta)"]},
                  "trolley": {"mass": "m_hook", "position": ["cart", 0, 0]}},
    "forces": {"gravity": {"uniform": [0, 0, "-g"]}},
    "outputs": ["rhs", "reactions", "energy", "initial_state"],
    "effects": {
        "stiff": {"one_of": "rope", "default": "on", "coordinates": {"s": {"held_at": "l_0"}}},
        "elastic": {"one_of": "rope", "parameters": {"k_rope": {"value": 900, "unit": "N/m"}},
                    "coordinates": {"s": {"initial": "1.01*l_0"}},
                    "forces": {"stretch": {"spring": "s", "stiffness": "k_rope", "rest": "l_0"}}},
        "load": {"about": "something stands on the cart", "default": "on",
                 "parameters": {"m_load": {"value": 7, "unit": "kg"}},
                 "particles": {"crate": {"mass": "m_load", "position": ["cart", 0, 0]}}},
        "brake": {"about": "the cart stands", "constraints": {"stands": {"velocity": "dot(cart)"}}},
        "motor": {"requires": ["load"], "excludes": ["brake"],
                  "inputs": {"duty": {"value": 1, "unit": "1"}},
                  "tables": {"push": {"of": [-1, 0, 1], "values": [-30, 0, 30], "of_unit": 1, "unit": "N"}},
                  "forces": {"pull": {"generalized": {"cart": "push(duty)"}}}},
        "friction": {"parameters": {"d_pivot": {"value": 0.3, "unit": "N*m*s"}},
                     "forces": {"pivot": {"generalized": {"theta": "-d_pivot*dot(theta)"}}},
                     "quantities": {"lost": {"value": "d_pivot*dot(theta)^2"}}},
    },
}

# Bodies that roll, or do not.
SLED = {
    "gauss": 1, "name": "sled", "counts": {"n": 2},
    "parameters": {"m": 2, "J": 0.4, "a": 0.3},
    "coordinates": {"x": {}, "y": {}, "psi": {"initial": 0.2, "initial_rate": 0.7}},
    "frames": {"body": {"position": ["x", "y", 0], "orientation": {"axis": "z", "angle": "psi"}}},
    "bodies": {"hull": {"mass": "m", "inertia": ["J", "J", "J"], "frame": "body", "centre": ["a", 0, 0]}},
    "effects": {
        "blade": {"default": "on", "constraints": {"blade": {"no_slip": "body", "at": "body", "direction": "y", "in": "body"}}},
        "passengers": {"particles": {"passenger_$i": {"count": "n", "frame": "body", "mass": 0.5, "centre": ["0.1*$i", 0, 0]}}},
        "thrust": {"inputs": {"u": 4}, "forces": {"thrust": {"force": ["u", 0, 0], "on": "body", "in": "body"}}},
        "drag": {"parameters": {"c": 0.6}, "forces": {"drag": {"generalized": {"x": "-c*dot(x)", "y": "-c*dot(y)"}}}},
    },
}
MODELS = {"projectile": PROJECTILE, "crane": CRANE, "sled": SLED}


def subsets(names):
    for size in range(len(names) + 1):
        yield from (set(chosen) for chosen in itertools.combinations(names, size))


def goes_together(model, chosen):
    effects = model["effects"]
    rivals = {}
    for name in chosen:
        about = effects[name]
        if not set(about.get("requires", ())) <= chosen or set(about.get("excludes", ())) & chosen:
            return False
        if "one_of" in about:
            rivals.setdefault(about["one_of"], []).append(name)
    groups = {about["one_of"] for about in effects.values() if "one_of" in about}
    return rivals.keys() == groups and all(len(one) == 1 for one in rivals.values())


def choices(model):
    return [chosen for chosen in subsets(list(model["effects"])) if goes_together(model, chosen)]


def without_effects(model, chosen):
    """The same model by somebody who never heard of the others: entries stand in their sections."""
    plain = json.loads(json.dumps({key: value for key, value in model.items() if key != "effects"}))
    for name, effect in model["effects"].items():
        if name not in chosen:
            continue
        for section, entries in json.loads(json.dumps(effect)).items():
            if section in ("about", "default", "requires", "excludes", "one_of"):
                continue
            for entry, value in entries.items():
                there = plain.setdefault(section, {}).setdefault(entry, {})
                if isinstance(value, dict):
                    there.update(value)
                else:
                    plain[section][entry] = value
    return plain


def lines_of(model):
    """A line for each entry, so that each has a number of its own; an effect may be left out of the text without moving any."""
    yield from (f"{json.dumps(key)}: {json.dumps(value)}" for key, value in model.items() if key != "effects")
    yield "effects:"
    yield from (f"  {json.dumps(name)}: {json.dumps(effect)}" for name, effect in model.get("effects", {}).items())


def without_provenance(header):
    """But for the lines that say what the code was made from."""
    lines = header.splitlines()
    kept = [line for line in lines if not line.startswith(("// Generated by gauss-gen", "// Command: "))]
    assert len(lines) - len(kept) == 2
    return "\n".join(kept)


def without_lines(header):
    """Nor where in the model something stands."""
    return re.sub(r",? ?model line \d+", "", without_provenance(header))


def operations(header):
    """Per function."""
    counts = {}
    for name, *numbers in re.findall(r"(?m)^//   (\w+) +(\d+) +(\d+) +(\d+) +(\d+) +(\d+)", header):
        counts[name] = sum(map(int, numbers))
    return counts


class Effects(Program):
    def header(self, text, *options):
        result = self.run_it("-", "-o", "-", *options, stdin=text)
        self.assertEqual((result.returncode, re.findall(r"error.*", result.stderr)), (0, []), result.stderr)
        return result.stdout

    def each(self, work):
        """`work` on every choice of every model, two at a time."""
        cases = [(name, model, chosen) for name, model in MODELS.items() for chosen in choices(model)]
        with ThreadPoolExecutor(2) as pool:
            return list(zip(cases, pool.map(lambda case: work(*case), cases)))

    def test_every_choice_is_tried(self):
        self.assertEqual({name: len(choices(model)) for name, model in MODELS.items()},
                         {"projectile": 64, "crane": 20, "sled": 16})

    def test_code_without_an_effect_is_that_of_a_model_that_never_had_it(self):
        def headers(name, model, chosen):
            with_all = "\n".join(lines_of(model))
            effects = set(model["effects"]) - chosen
            lean = "\n".join("" if any(line.startswith(f'  "{e}":') for e in effects) else line for line in lines_of(model))
            option = "--effects=" + ",".join(["none", *sorted(chosen)])
            plain = json.dumps(without_effects(model, chosen))
            usual = json.loads(json.dumps(model["effects"]))
            # Those that are left act by default, so that nobody has to choose.
            for one in chosen:
                lean = lean.replace(f'  "{one}": ' + json.dumps(usual[one]),
                                    f'  "{one}": ' + json.dumps({"default": "on", **{k: v for k, v in usual[one].items() if k not in (
                                        "default", "requires", "excludes", "one_of")}}))
            return self.header(with_all, option), self.header(lean), self.header(plain)

        for (name, model, chosen), (chosen_here, lean, plain) in self.each(headers):
            with self.subTest(model=name, effects=sorted(chosen)):
                self.assertEqual(without_provenance(chosen_here), without_provenance(lean))
                self.assertEqual(without_lines(chosen_here), without_lines(plain))

    def test_no_word_of_an_absent_effect_is_left(self):
        own = {"projectile": {"gravity": ["g_earth"], "stokes": ["b_lin"], "newton": ["b_quad"], "magnus": ["k_magnus"],
                              "brake": ["d_spin"], "rope": ["k_rope", "leash", "hand"]},
               "crane": {"elastic": ["k_rope", "stretch"], "load": ["m_load", "crate"], "brake": ["stands"],
                         "motor": ["duty", "push"], "friction": ["d_pivot", "lost"], "stiff": ["rope"]},
               "sled": {"blade": ["blade"], "passengers": ["passenger_1"], "thrust": ["u", "thrust"], "drag": ["c", "drag"]}}

        def header(_, model, chosen):
            return self.header("\n".join(lines_of(model)), "--effects=" + ",".join(["none", *sorted(chosen)]))

        for (name, model, chosen), text in self.each(header):
            body = without_provenance(text)
            # The prelude, which all headers share, has words of its own.
            body = body[:body.index("#ifndef")] + body[body.index(f"namespace gauss::{name}"):]
            for effect in set(model["effects"]) - chosen:
                with self.subTest(model=name, effects=sorted(chosen), absent=effect):
                    for word in own[name][effect]:
                        self.assertIsNone(re.search(rf"\b{word}\b", body), word)

    def test_fewer_effects_take_no_more_operations_than_all(self):
        """Of each model whose effects are forces: without a constraint there is more motion, and more to compute."""
        most = operations(self.header("\n".join(lines_of(PROJECTILE)), "--effects=all"))
        for chosen in choices(PROJECTILE):
            of_fewer = operations(self.header("\n".join(lines_of(PROJECTILE)), "--effects=" + ",".join(["none", *sorted(chosen)])))
            # What is computed once may take over a product from what is computed at each call.
            for function, count in of_fewer.items():
                with self.subTest(effects=sorted(chosen), function=function):
                    if function == "prepare":
                        self.assertLessEqual(count + of_fewer["rhs"], most["prepare"] + most["rhs"])
                    else:
                        self.assertLessEqual(count, most[function])

    def test_a_coefficient_of_zero_is_as_good_as_none(self):
        def values(*options):
            printed = json.loads(self.run_it("evaluate", "-", "--format", "json", *options,
                                             stdin="\n".join(lines_of(PROJECTILE))).stdout)
            return {name: float(one["value"]) for name, one in printed["accelerations"].items()}

        everything = set(PROJECTILE["effects"])
        for chosen in subsets(list(everything)):
            zeros = [f"--set={COEFFICIENTS[effect]}=0" for effect in everything - chosen]
            off = values("--effects=" + ",".join(["none", *sorted(chosen)]))
            zero = values("--effects=all", *zeros)
            scale = max(map(abs, off.values())) or 1.0
            for name, value in off.items():
                with self.subTest(effects=sorted(chosen), acceleration=name):
                    self.assertLessEqual(abs(value - zero[name]), 8 * EPSILON * scale)

    def test_what_is_wrong_with_a_choice_is_said(self):
        text = "\n".join(lines_of(CRANE))
        result = self.run_it("-", "--effects=motr", stdin=text)
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("--effects motr: there is no effect 'motr'; did you mean 'motor'?", result.stderr)
        result = self.run_it("evaluate", "-", "--effects=+motor,+brake", stdin=text)
        self.assertIn("--effects +brake: 'motor' excludes 'brake', which acts, too; leave one of the two out", result.stderr)
        self.assertNotEqual(result.returncode, 0)
        self.assertEqual(result.stdout, "")

    def test_a_parameter_that_only_an_absent_effect_uses_earns_a_hint(self):
        model = json.loads(json.dumps(PROJECTILE))
        model["parameters"]["b_lin"] = model["effects"]["stokes"].pop("parameters")["b_lin"]
        result = self.run_it("--check", "-", stdin="\n".join(lines_of(model)))
        self.assertIn("no expression uses the parameter 'b_lin'", result.stderr)
        self.assertIn("the effect 'stokes', which does not act, mentions it: declare it there", result.stderr)
        self.assertEqual(without_poles(self.run_it("--check", "-", "--effects=+stokes", stdin="\n".join(lines_of(model))).stderr), "")

    def test_setting_what_is_absent_names_its_effect(self):
        result = self.run_it("evaluate", "-", "--set=b_lin=1", stdin="\n".join(lines_of(PROJECTILE)))
        self.assertIn("'b_lin' is of the effect 'stokes', which does not act", result.stderr)

    def test_a_scene_stands_for_its_model_with_what_it_chooses(self):
        (self.folder / "ball.yaml").write_text("\n".join(lines_of(PROJECTILE)))
        (self.folder / "yonder.yaml").write_text("gauss: 1\nscene: yonder\nmodel: ball.yaml\neffects: [gravity, newton]\n"
                                              "parameters: {m: 0.2}\nmethod: rk4\n")
        scene = self.ok("yonder.yaml", "-o", "-")
        model = self.run_it("ball.yaml", "--effects=gravity,newton", "-o", "-").stdout
        self.assertIn("Command: gauss-gen yonder.yaml\n", scene)
        # Another name and another value, else the same code.
        scene = re.sub(r"S m = .*", "S m;", scene).replace("YONDER", "PROJECTILE").replace("yonder", "projectile")
        model = re.sub(r"S m = .*", "S m;", model)
        self.assertEqual(without_provenance(scene), without_provenance(model))
        self.assertEqual(self.ok("yonder.yaml", "--list-outputs"), "yonder.hpp\n")

    def test_mistakes_of_a_scene_have_their_places(self):
        (self.folder / "ball.yaml").write_text("\n".join(lines_of(PROJECTILE)))
        (self.folder / "far.yaml").write_text("gauss: 1\nscene: far\nmodel: ball.yaml\neffects: [gravity, newtn]\n")
        said = self.run_it("far.yaml")
        self.assertEqual(said.returncode, 1)
        self.assertIn("far.yaml:4:20: error[E093]: there is no effect 'newtn'", said.stderr)
        self.assertIn("did you mean 'newton'?", said.stderr)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["ball.yaml", "far.yaml"])

    def test_each_variant_is_a_header_and_equal_sets_share_one(self):
        (self.folder / "ball.yaml").write_text("\n".join(lines_of(PROJECTILE)))
        variants = ["--variant", "near=all", "--variant", "far=gravity", "--variant", "away=default"]
        self.ok("ball.yaml", *variants, "--outputs=rhs,initial_state")
        names = [f"projectile_{one}.hpp" for one in ("near", "far", "away", "variants")]
        self.assertEqual(self.ok("ball.yaml", *variants, "--list-outputs"), "\n".join(names) + "\n")
        self.assertEqual({path.name for path in self.folder.iterdir()}, {"ball.yaml", *names})
        far = (self.folder / "projectile_far.hpp").read_text()
        alone = self.ok("ball.yaml", "--effects=gravity", "-o", "-", "--outputs=rhs,initial_state")
        alone = alone.replace("PROJECTILE", "PROJECTILE_FAR").replace("projectile", "projectile_far")
        self.assertEqual(without_provenance(far), without_provenance(alone))
        away = (self.folder / "projectile_away.hpp").read_text()
        self.assertIn("namespace projectile_away = ::gauss::projectile_far;", away)
        self.assertLess(len(away.splitlines()), 20)

    def bodies(self, instances, more="effects: [gravity]\nparameters: {m: 0.2}\n"):
        (self.folder / "ball.yaml").write_text("\n".join(lines_of(PROJECTILE)))
        text = "gauss: 1\nscene: balls\nmodel: ball.yaml\n" + more + "instances:\n"
        (self.folder / "balls.yaml").write_text(text + "".join(f"  {name}: {says}\n" for name, says in instances.items()))

    def test_bodies_of_a_scene_share_the_functions_of_their_effects(self):
        self.bodies({"near": "{effects: [+newton, +magnus]}", "far": "{}", "away": "{initial: {x: 2*50, 'dot(z)': r}, parameters: {r: 0.04}}",
                     "too": "{effects: [magnus, gravity, newton], parameters: {b_quad: 0.002, b_lin: 7}}"})
        self.ok("balls.yaml", "--outputs=rhs,initial_state,project")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["ball.yaml", "balls.yaml", "balls_variants.hpp"])
        self.assertEqual(self.ok("balls.yaml", "--list-outputs"), "balls_variants.hpp\n")
        text = (self.folder / "balls_variants.hpp").read_text()
        # The functions of two sets, as a scene has them that says for itself what the first of each set says.
        self.assertEqual(re.findall(r"^namespace gauss::(\w+) {", text, re.M), ["balls_variants_near", "balls_variants_far", "balls_variants"])
        for name, effects in (("near", "gravity, newton, magnus"), ("far", "gravity")):
            (self.folder / "one.yaml").write_text(
                f"gauss: 1\nscene: balls_variants_{name}\nmodel: ball.yaml\neffects: [{effects}]\nparameters: {{m: 0.2}}\n")
            alone = without_provenance(self.ok("one.yaml", "-o", "-", "--outputs=rhs,initial_state,project"))
            self.assertIn(alone[alone.index("#ifndef"):], text)
        rows = re.findall(r'^    {"(\w+)", &variants\[(\d)\]', text, re.M)
        self.assertEqual(rows, [("near", "0"), ("far", "1"), ("away", "1"), ("too", "0")])
        self.assertIn("namespace balls_variants_too = ::gauss::balls_variants_near;", text)
        self.assertIn('start_of_away[] = {{"x", 100}, {"z_dot", 0.04}, {nullptr, 0}}', text)
        self.assertIn('values_of_away[] = {{"r", 0.04}, {nullptr, 0}}', text)
        # Of an effect that does not act there is no value.
        self.assertIn('values_of_too[] = {{"b_quad", 0.002}, {nullptr, 0}}', text)

    def test_a_namespace_holds_all_of_them(self):
        # Some compilers have macros called near and far.
        self.bodies({"near": "{effects: [+newton]}", "far": "{}", "away": "{}"})
        text = self.ok("balls.yaml", "--namespace", "game", "-o", "-")
        for name in ("near", "far"):
            self.assertIn(f"GAUSS_MODEL(model_{name}, ::game::{name}_);", text)
        self.assertEqual(re.findall(r"^namespace (game[\w:]*) {", text, re.M), ["game::near_", "game::far_", "game", "game::balls_variants"])
        self.assertIn("namespace away = ::game::far_;", text)

    def test_one_body_is_a_scene_of_its_own(self):
        self.bodies({"near": "{effects: [+newton], parameters: {m: 0.3}}", "far": "{}"})
        alone = self.ok("balls.yaml", "--instance", "near", "-o", "-")
        self.assertIn("namespace gauss::balls_near {", alone)
        self.assertIn("S m = S(3) / S(10);", alone)
        self.assertEqual(self.ok("balls.yaml", "--instance", "near", "--list-outputs"), "balls_near.hpp\n")
        said = self.run_it("balls.yaml", "--instance", "neat")
        self.assertEqual((said.returncode, "did you mean 'near'?" in said.stderr), (2, True), said.stderr)
        said = self.run_it("ball.yaml", "--instance", "near")
        self.assertEqual((said.returncode, "is a model" in said.stderr), (2, True), said.stderr)

    def test_what_no_value_says_at_run_time_is_a_set_of_its_own(self):
        self.bodies({"a": "{effects: [+elastic]}"})
        model = {**CRANE, "parameters": {**CRANE["parameters"]}}
        formula = next(iter(model["parameters"]))
        model["parameters"]["twice"] = {"value": f"2*{formula}"}
        model["quantities"] = {"shown": "twice"}
        (self.folder / "crane.yaml").write_text("\n".join(lines_of(model)))
        (self.folder / "cranes.yaml").write_text("gauss: 1\nscene: cranes\nmodel: crane.yaml\ninstances:\n  a: {}\n  b: {parameters: {twice: 3}}\n")
        text = self.ok("cranes.yaml", "-o", "-")
        self.assertEqual(re.findall(r'^    {"(\w+)", &variants\[(\d)\]', text, re.M), [("a", "0"), ("b", "1")])

    def test_mistakes_of_bodies_have_their_places(self):
        self.bodies({"near": "{effects: [+newtn]}", "far": "{initial: {q: 1}, parameters: {m: x}}", "9th": "{}", "variants": "{}"})
        said = self.run_it("balls.yaml")
        self.assertEqual(said.returncode, 1)
        for text in ("balls.yaml:9:3: error[E020]", "balls.yaml:10:3: error[E021]"):
            self.assertIn(text, said.stderr)
        self.bodies({"near": "{effects: [+newtn]}", "far": "{initial: {q: 1}, parameters: {m: x}}"})
        said = self.run_it("balls.yaml")
        self.assertEqual(said.returncode, 1)
        for text in ("balls.yaml:7:20: error[E093]: there is no effect 'newtn'", "balls.yaml:8:19: error[E024]: the model has no 'q'",
                     "balls.yaml:8:39: error[E024]"):
            self.assertIn(text, said.stderr)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["ball.yaml", "balls.yaml"])
        self.bodies({"near": "{}", "far": "{}"}, more="effects: [gravty]\nparameters: {mm: 2}\n")
        self.assertEqual(self.run_it("balls.yaml").stderr.count("gravty'"), 1)
        self.bodies({"near": "{}"})
        for options in (["--split", "double"], ["--dump", "model"]):
            self.assertIn("--instance NAME takes one of them", self.run_it("balls.yaml", *options).stderr)

    def test_values_for_effects_that_do_not_act_are_passed_over(self):
        (self.folder / "ball.yaml").write_text("\n".join(lines_of(PROJECTILE)))
        (self.folder / "one.yaml").write_text("gauss: 1\nscene: one\nmodel: ball.yaml\neffects: gravity\nparameters: {b_lin: 2, m: 1}\ninitial: {x_dot: 5}\n")
        header = self.ok("one.yaml", "-o", "-")
        self.assertIn("S m = S(1);", header)
        self.assertIn("S(5)", header)

    def test_mistakes_of_variants_name_them(self):
        (self.folder / "ball.yaml").write_text("\n".join(lines_of(PROJECTILE)))
        for said, arguments in {
                "--variant far: --effects graviti: there is no effect 'graviti'": ["--variant", "far=graviti"],
                "--variant: 'far' is given twice": ["--variant", "far=none", "--variant", "far=all"],
                "it is a part of names in C++": ["--variant", "far-away=all"],
                "leave --effects out": ["--variant", "far=all", "--effects=none"],
                "goes with none of -o -": ["--variant", "far=all", "-o", "-"]}.items():
            result = self.run_it("ball.yaml", *arguments)
            self.assertEqual((result.returncode, said in result.stderr), (2, True), result.stderr)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["ball.yaml"])


if __name__ == "__main__":
    unittest.main()
