"""Names of a model against the names that an emitted header uses itself: each compiles, changed if need be, or is refused."""

import os
import re
import subprocess
import unittest

from gauss_gen import MODELS, Program

COMPILER = os.environ["GAUSS_CXX"]

# Every kind of thing that has a name, so that the header has every kind of text.
EVERYTHING = """gauss: 1
name: everything
parameters: {m: 1, twice: 2*m}
inputs: {push: 0}
coordinates: {x: {initial: 1}, y: {}, s: {held_at: 0}}
orientations: {o: {quaternion: [e0, e1, e2, e3], angular_velocity: [p, q, r]}}
bodies: {ball: {mass: m, inertia: twice, position: [x + s, y, 0], orientation: o}}
constraints: {roll: {velocity: dot(x) - x*q + sin(y)*p}}
forces: {f: {generalized: {x: push}}}
"""


def model(name="host", parameters="", inputs="", coordinates="", particles="", constraints=""):
    return (f"gauss: 1\nname: '{name}'\nparameters: {{k_host: 1, {parameters}}}\ninputs: {{u_host: 0, {inputs}}}\n"
            f"coordinates: {{x_host: {{}}, y_host: {{}}, {coordinates}}}\n"
            f"particles: {{p_host: {{mass: k_host, position: [x_host, y_host, 0]}}, {particles}}}\n"
            "forces: {f_host: {generalized: {x_host: u_host*sin(y_host)}}}\n"
            f"constraints: {{c_host: {{velocity: dot(x_host) - y_host*dot(y_host)}}, {constraints}}}\n")


# How one name enters a model in each role; as many as fit go into one model.
ROLES = {
    "parameter": lambda names, host: model(host, parameters=", ".join(f"'{n}': 1" for n in names)),
    "input": lambda names, host: model(host, inputs=", ".join(f"'{n}': 0" for n in names)),
    "coordinate": lambda names, host: model(
        host, coordinates=", ".join(f"'{n}': {{}}" for n in names),
        particles=", ".join(f"p{i}: {{mass: 1, position: ['{n}', 'sin({n})', 0]}}" for i, n in enumerate(names))),
    "held coordinate": lambda names, host: model(
        host, coordinates=", ".join(f"'{n}': {{held_at: sin(t)}}" for n in names),
        particles=", ".join(f"p{i}: {{mass: 1, position: ['x_host*{n}', 0, 0]}}" for i, n in enumerate(names))),
    "body": lambda names, host: model(
        host, particles=", ".join(f"'{n}': {{mass: 1, position: [x_host, 0, 0]}}" for n in names)),
    "constraint": lambda names, host: model(
        host, coordinates=", ".join(f"z{i}: {{}}" for i in range(len(names))),
        particles=", ".join(f"p{i}: {{mass: 1, position: [z{i}, 0, 0]}}" for i in range(len(names))),
        constraints=", ".join(f"'{n}': {{velocity: dot(z{i}) - x_host*dot(y_host)}}" for i, n in enumerate(names))),
    "joint": lambda names, host: model(host) + (
        "joints: {" + ", ".join(f"'{n}': {{type: prismatic, child: f{i}, axis: x}}" for i, n in enumerate(names)) +
        "}\nbodies: {" + ", ".join(f"f{i}: {{mass: 1, inertia: 1}}" for i in range(len(names))) + "}\n"),
    "frame": lambda names, host: model(host) + (
        "frames: {" + ", ".join(f"'{n}': {{position: [x_host, {i}, 0]}}" for i, n in enumerate(names)) +
        "}\nbodies: {" + ", ".join(f"'{n}': {{mass: 1, inertia: 1}}" for n in names) + "}\n"),
    "point": lambda names, host: model(host) + (
        "points: {" + ", ".join(f"'{n}': {{on: p_host, at: [1, {i}, 0]}}" for i, n in enumerate(names)) +
        "}\nquantities: {" + ", ".join(f"q{i}: {n}.x" for i, n in enumerate(names)) + "}\n"),
    "table": lambda names, host: model(host) + (
        "tables: {" + ", ".join(f"'{n}': {{of: [0, 1, 2], values: [0, 1, {i}]}}" for i, n in enumerate(names)) +
        "}\nquantities: {" + ", ".join(f"q{i}: '{n}(x_host)'" for i, n in enumerate(names)) + "}\n"),
    "quantity": lambda names, host: model(host) + (
        "quantities: {" + ", ".join(f"'{n}': [x_host, {i}, 0]" for i, n in enumerate(names)) + "}\n"),
    "speed": lambda names, host: model(
        host, coordinates=", ".join(f"z{i}: {{}}" for i in range(len(names))),
        particles=", ".join(f"p{i}: {{mass: 1, position: [z{i}, 0, 0]}}" for i in range(len(names)))) + (
        "speeds: {w_host: {is: dot(x_host)}, v_host: {is: dot(y_host)}, " +
        ", ".join(f"'{n}': {{is: 2*dot(z{i})}}" for i, n in enumerate(names)) + "}\n"),
    "orientation": lambda names, host: model(host) + (
        "orientations: {" + ", ".join(f"'{n}': {{quaternion: [a{i}, b{i}, c{i}, d{i}], angular_velocity: [p{i}, q{i}, r{i}]}}"
                                      for i, n in enumerate(names)) +
        "}\nbodies: {" + ", ".join(f"k{i}: {{mass: 1, inertia: 1, position: [0, 0, 0], orientation: '{n}'}}"
                                   for i, n in enumerate(names)) + "}\n"),
}
LARGEST = {"parameter": 400, "input": 400, "coordinate": 40, "held coordinate": 40, "body": 100, "constraint": 12, "joint": 40,
           "frame": 100, "point": 100, "table": 100, "quantity": 100, "speed": 40, "orientation": 40}


def without_comments(header):
    return re.sub(r'"(\\.|[^"\\\n])*"', '""', re.sub(r"//[^\n]*|/\*.*?\*/", "", header, flags=re.S))


class Names(Program):
    def identifiers(self):
        text = without_comments(self.ok("-", "-o", "-", stdin=EVERYTHING))
        names = {n for n in re.findall(r"[A-Za-z]\w*", text) if "__" not in n and not n.endswith("_") and len(n) < 60}
        self.assertGreater(len(names), 200)
        return sorted(names | {"int", "class", "linux", "main", "printf", "std", "gauss", "errno", "NULL", "BYTE_ORDER",
                              "SEEK_SET", "issubnormal", "GAUSS_MODEL_HOST_HPP"})

    def accepted(self, role, names, host):
        """A header with those of `names` that are not refused; those are checked to be refused with a hint."""
        for _ in range(4):
            result = self.run_it("-", "-o", "headers", stdin=ROLES[role](names, host))
            if result.returncode == 0:
                return
            self.assertEqual(result.returncode, 1, result.stderr)
            refused = set(re.findall(r"error\[E02[0-3]\]: '(\w+)'", result.stderr))
            self.assertTrue(refused, result.stderr)
            self.assertEqual(result.stderr.count("error["), result.stderr.count("= hint:"), result.stderr)
            names = [n for n in names if n not in refused and n + "_dot" not in refused]
        self.fail(f"{role}: still refused\n{result.stderr}")

    def compiles(self):
        headers = sorted((self.folder / "headers").glob("*.hpp"))
        self.assertTrue(headers)
        source = self.write("all.cpp", "".join(f'#include "{header}"\n' for header in headers))
        result = subprocess.run([COMPILER, "-std=c++17", "-fsyntax-only", source], capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 0, result.stderr[:3000])

    def test_names_in_every_role(self):
        names = self.identifiers()
        for role, size in LARGEST.items():
            for part in range(0, len(names), size):
                self.accepted(role, names[part:part + size], f"{role.replace(' ', '_')}_{part}")
        self.compiles()

    def test_names_of_models(self):
        accepted = 0
        for name in self.identifiers():
            result = self.run_it("-", "-o", "headers", stdin=model(name))
            self.assertIn(result.returncode, (0, 1), (name, result.stderr))
            accepted += result.returncode == 0
            if result.returncode == 1:
                self.assertRegex(result.stderr, r"error\[E02[01]\]: '\w+' is (a name of emitted code|not a valid name)(.|\n)*= hint: ")
        self.assertGreater(accepted, 150)
        self.compiles()

    # What is prepared once has one name; a reader who meets two looks for a difference.
    def test_each_prepared_value_has_one_name(self):
        headers = [self.ok(MODELS / name, "-o", "-") for name in ("bicycle.yaml", "rattleback.yaml", "families/quadruped.yaml")]
        for text in headers:
            prepared = re.findall(r"(?m)^  prepared\.(\w+) = (\w+);$", text)
            self.assertGreater(len(prepared), 10)
            values = [value for _, value in prepared]
            self.assertEqual(sorted(set(values)), sorted(values))

    def test_headings_are_not_repeated(self):
        text = self.ok(MODELS / "families" / "road_train.yaml", "-o", "-")
        headings = 0
        for body in re.findall(r"(?ms)^GAUSS_FUNCTION .*?^}", text):
            found = re.findall(r"(?m)^  // (.*)$", body)
            headings += len(found)
            self.assertFalse([a for a, b in zip(found, found[1:]) if a == b])
        self.assertGreater(headings, 50)


if __name__ == "__main__":
    unittest.main()
