"""`gauss-gen schema` and the program accept and reject the same files, as far as the shape of a file goes."""

import json
import re
import unittest
from concurrent.futures import ThreadPoolExecutor

from gauss_gen import MODELS, SOURCE, Program

try:
    import jsonschema
    import yaml
except ImportError:
    jsonschema = yaml = None

# Codes of what a schema says of a file: its YAML, its keys, the kinds of their values.
SHAPE = {f"E{i:03}" for i in (*range(4, 8), *range(9, 17), 20, 39)}

# Likewise of counts; the same code tells of indices inside of names and expressions, which no schema looks into.
OF_COUNTS = {"E090"}

# Mistakes of shape that a JSON schema cannot tell, by their messages.
BEYOND_A_SCHEMA = [
    r"(body|particle) '\w+' needs the key 'position'",  # unless a frame has its name
    r"'initial_angular_velocity' has no key ",  # its keys are names of the model
    r"the rate of '\w+' follows from the speeds",  # of which the keys are elsewhere
    r"the coordinate '\w+' is declared in line",  # in another section
    r"a line ends with CR alone here",  # which YAML allows
    r"'\w+' is there already",  # written out by 'count'
    r"there is no index '\w+' here",  # of 'counts', or of a 'count' around
    r"force '\w+' has 'static_limit' beside 'smooth'",  # keys that only do not go together
    r"this does not belong to a whole number",  # 2.0, which is 2 to a schema; likewise 'gauss: +1' is 1
]

# Names and expressions of an effect that does not act are not read.
IN_ABSENT_EFFECT = re.compile(r"effects/(push|oil)/.*: (true|7|1|1.0)$")

# {value: max(a, b)}: the program puts together what YAML takes apart at the comma, and other readers of YAML do not.
COMMAS_WITHOUT_QUOTES = {"functions.yaml"}


class Refused(Exception):
    """Not the YAML of a model."""


if yaml:
    class Loader(yaml.SafeLoader):
        """YAML 1.2 as editors read it: keys are texts; no anchors, tags or repeated keys."""

        yaml_implicit_resolvers = {}

        def compose_node(self, parent, index):
            event = self.peek_event()
            if isinstance(event, yaml.AliasEvent) or event.anchor or (getattr(event, "tag", None) or "!") != "!":
                raise Refused("anchor, alias or tag")
            return super().compose_node(parent, index)

        def construct_mapping(self, node, deep=False):
            keys = [key.value for key, _ in node.value if isinstance(key, yaml.ScalarNode)]
            if len(keys) != len(node.value) or len(set(keys)) != len(keys):
                raise Refused("keys")
            return {key.value: self.construct_object(value, deep=True) for key, value in node.value}

    for tag, pattern, first in (("null", r"(?:~|null|Null|NULL|)$", ["~", "n", "N", ""]),
                                ("bool", r"(?:true|True|TRUE|false|False|FALSE)$", list("tTfF")),
                                ("int", r"[-+]?[0-9]+$", list("-+0123456789")),
                                ("float", r"[-+]?(?:\.[0-9]+|[0-9]+(?:\.[0-9]*)?)(?:[eE][-+]?[0-9]+)?$", list("-+.0123456789"))):
        Loader.add_implicit_resolver(f"tag:yaml.org,2002:{tag}", re.compile(pattern), first)
    Loader.add_constructor("tag:yaml.org,2002:int", lambda loader, node: int(node.value))
    Loader.add_constructor("tag:yaml.org,2002:float", lambda loader, node: float(node.value))
    Loader.add_constructor("tag:yaml.org,2002:map", lambda loader, node: loader.construct_mapping(node))


def places_in(document, path=()):
    """Every map, list and value with the path to it."""
    yield path, document
    items = document.items() if isinstance(document, dict) else enumerate(document) if isinstance(document, list) else ()
    for key, value in items:
        yield from places_in(value, (*path, key))


def changed(document, path, change):
    """A copy in which `change` was done to the container at the end of `path` and its last key."""
    copy = json.loads(json.dumps(document))
    at = copy
    for key in path[:-1]:
        at = at[key]
    change(at, path[-1])
    return copy


# What YAML reads as something else than a text, or as nothing.
OTHER_VALUES = (None, True, 1.0, 1, "", [], {})


def slips_in(document):
    """The document with one slip in its shape, in every place: (what, document)."""
    def put(value):
        return lambda owner, key: owner.__setitem__(key, value)

    for path, value in places_in(document):
        where = "/".join(map(str, path))
        if isinstance(value, dict):
            yield f"{where}: unknown key", changed(document, (*path, "unknwon"), put(1))
        if not path:
            continue
        if isinstance(path[-1], str):
            yield f"{where}: left out", changed(document, path, lambda owner, key: owner.pop(key))
        for other in ([value], {"a": value}, "oneword", *([] if isinstance(value, (list, dict)) else [7]), *OTHER_VALUES):
            yield f"{where}: {json.dumps(other)[:20]}", changed(document, path, put(other))
        if isinstance(value, list):
            yield f"{where}: longer", changed(document, path, lambda owner, key: owner[key].append(owner[key][-1]))
            yield f"{where}: shorter", changed(document, path, lambda owner, key: owner[key].pop())


@unittest.skipIf(jsonschema is None, "python3-jsonschema and python3-yaml are not installed")
class Schema(Program):
    def setUp(self):
        super().setUp()
        self.schema = json.loads(self.ok("schema"))
        self.validator = jsonschema.Draft7Validator(self.schema)

    def accepts(self, document):
        return self.validator.is_valid(document)

    def load(self, text):
        documents = list(yaml.load_all(text, Loader))
        if len(documents) != 1:
            raise Refused("several documents")
        return documents[0]

    def accepts_text(self, raw):
        try:
            return self.accepts(self.load(raw.decode()))
        except (Refused, UnicodeDecodeError, yaml.YAMLError):
            return False

    def codes(self, document):
        """Whether the program takes it, and the codes of what it says of its shape."""
        result = self.run_it("--list-outputs", "-", stdin=json.dumps(document))
        found = re.findall(r"error\[(E\d+)\]: (.*)", result.stderr)
        return result.returncode == 0, {code for code, text in found
                                        if code in SHAPE | OF_COUNTS and not any(re.match(known, text) for known in BEYOND_A_SCHEMA)}

    def test_it_is_a_schema_of_draft_07(self):
        jsonschema.Draft7Validator.check_schema(self.schema)
        self.assertEqual(self.schema["$schema"], "http://json-schema.org/draft-07/schema#")

    def test_every_model_of_the_project_is_accepted(self):
        models = [*MODELS.rglob("*.yaml"), *(SOURCE / "tests").rglob("*.yaml")]
        models = [path for path in models if "diagnostics" not in path.parts]
        self.assertGreaterEqual(len(models), 10)
        for path in models:
            with self.subTest(path.name):
                document = self.load(path.read_text(encoding="utf-8"))
                said = [error.message for error in self.validator.iter_errors(document)]
                if path.name in COMMAS_WITHOUT_QUOTES:
                    self.assertNotEqual(said, [])
                else:
                    self.assertEqual(said, [])

    def test_faulty_models_are_rejected_where_the_fault_is_one_of_shape(self):
        found = set()
        for path in sorted((SOURCE / "tests/diagnostics").glob("*.yaml")):
            text = path.with_suffix(".txt").read_text(encoding="utf-8", errors="replace")
            # Of this file, not of those that it names.
            found_here = re.findall(rf"(?m)/{path.name}:\d+:\d+: (?:error|warning)\[(\w+)\]: (.*)", text)
            codes = {code for code, said in found_here if not any(re.match(known, said) for known in BEYOND_A_SCHEMA)}
            if not codes:
                continue
            with self.subTest(path.name):
                accepted = self.accepts_text(path.read_bytes())
                if codes & SHAPE:
                    found |= codes & SHAPE
                    self.assertFalse(accepted)
                elif not any(code[0] == "E" for code in codes):
                    self.assertTrue(accepted)
        self.assertGreaterEqual(found, SHAPE - {"E008"})

    def judge_slips(self, text, beyond, at_least):
        document = self.load(text)
        self.assertEqual(self.run_it("--list-outputs", "-", stdin=json.dumps(document)).stderr.count("error["), 0)
        slips = list(slips_in(document))
        self.assertGreater(len(slips), at_least)
        with ThreadPoolExecutor(2) as pool:
            answers = list(pool.map(self.codes, [slip for _, slip in slips]))
        for (what, slip), (is_taken, codes) in zip(slips, answers):
            with self.subTest(slip=what, codes=codes):
                accepted = self.accepts(slip)
                if codes - beyond:
                    self.assertFalse(accepted, "the schema accepts it")
                if is_taken and not IN_ABSENT_EFFECT.match(what):
                    self.assertTrue(accepted, "the schema rejects it")

    def test_program_and_schema_judge_every_slip_of_shape_alike(self):
        """Whatever the program says of keys and kinds, the schema says; and what the schema rejects, the program does."""
        self.write("part.yaml", PART)
        self.judge_slips(EVERYTHING, set(), 1000)

    def test_so_they_do_of_effects(self):
        """But for keys that are missing: effects may bring them."""
        self.judge_slips(EFFECTS, {"E011"}, 500)


PART = """
gauss: 1
name: part
parameters: {r: 1}
joints: {hinge: {type: revolute, child: bar}}
bodies: {bar: {mass: 1, inertia: 1, centre: [r, 0, 0]}}
forces: {gravity: {uniform: [0, 0, -9]}}
"""

# Every section, every law, every type of joint.
EVERYTHING = """
gauss: 1
name: everything
about: all keys of the format
counts: {n: 2}
submodels:
  s_$i: {count: n, file: part.yaml, on: a, parameters: {r: L}, without: [gravity], about: part}
parameters: {m: {value: 1, unit: kg, about: mass}, J: 1, L: {value: 2}}
inputs: {F: {value: 1}, G: 2}
tables:
  T: {of: [0, 1, 2], values: [0, 1, 4], kind: spline, outside: hold, of_unit: m, unit: N, about: a curve}
coordinates:
  x: {unit: m, about: along, initial: 1}
  z: {initial: 1, initial_rate: 1}
  y: {initial_guess: 1}
  z2: {initial_rate_guess: 1}
  h: {held_at: L}
speeds: {u1: {is: dot(x), unit: m/s, initial: 1, about: s}, u2: {is: dot(y), initial_guess: 1}}
orientations:
  o: {quaternion: [e0, e1, e2, e3], angular_velocity: [wx, wy, wz], frame: space, initial: [1, 0, 0, 0],
      initial_angular_velocity: [0, 0, 0]}
  p: {quaternion: [f0, f1, f2, f3], angular_velocity: [vx, vy, vz], initial_angular_velocity: {vx: 1}}
frames:
  a: {parent: space, position: [x, y, h], orientation: {euler: zxz, angles: [y, 0, 0]}, about: a}
  b: {position: [x, y, 0], orientation: {axis: z, angle: y}}
  c: {position: [x, 0, 0], orientation: o}
joints:
  j1: {type: revolute, parent: a, child: k1, at: [0, 0, 1], axis: x, coordinates: q1, initial: 1, initial_rate: 0, about: j}
  j2: {type: prismatic, parent: a, child: k2, axis: [1, 0, 1], coordinates: [q2], initial: [1]}
  j3: {type: cylindrical, parent: k1, child: k3, coordinates: [q3, q4], initial_guess: [0, 1]}
  j4: {type: universal, parent: k1, child: k4, axes: [x, [0, 1, 0]], coordinates: [q5, q6]}
  j5: {type: spherical, parent: k1, child: k5, initial_angular_velocity: [0, 0, 0]}
  j6: {type: planar, parent: k1, child: k6, axis: y}
  j7: {type: free, child: k7, orientation: p}
  j8: {type: fixed, parent: k7, child: k8, orientation: {axis: x, angle: pi}}
points:
  P: {on: a, at: [1, 0, 0], about: point}
  Q: {at: [0, 0, 0]}
bodies:
  b1: {mass: m, inertia: J, position: [x, 0, 0], orientation: o, about: body}
  b2: {mass: m, inertia: [J, J, J], frame: k1, centre: [0, 0, 1]}
  b3: {mass: m, inertia: [[J, 0, 0], [0, J, 0], [0, 0, J]], frame: k2}
  k3: {mass: m, inertia: J}
  k4: {mass: m, inertia: J}
  k5: {mass: m, inertia: J}
  k6: {mass: m, inertia: J}
  k7: {mass: m, inertia: J}
particles:
  p1: {mass: m, position: [x + z, y + z2, h], about: particle}
  p2: {mass: m, frame: k3, centre: [0, 0, 1]}
  p3_$i_$j: {count: [n, 2], mass: $(i*j), position: [x, y, h]}
  p4_$i: {count: n, mass: m, position: [x, y, h]}
constraints:
  c1: {velocity: dot(x) - dot(y), point: [x, 0, 0], about: law}
  c2: {equation: x - y - L}
  c3: {rolls: k7, on: space, at: [0, 0, 0]}
  c4: {no_slip: k6, on: space, at: P, in: a, direction: x}
  c5: {coincide: [P, Q]}
  c6: {distance: [P, Q], is: L}
forces:
  f1: {uniform: [0, 0, -1], about: gravity}
  f2: {potential: y^2}
  f3: {generalized: {x: F, wx: 1}}
  f4: {force: [F, 0, 0], on: b1, at: [0, 0, 1], from: a, in: a}
  f5: {torque: [0, 0, 1], on: b1, from: a, in: a}
  f6: {spring: [P, Q], stiffness: 1, length: 1, damping: 1}
  f7: {spring: x, stiffness: 1, rest: 1}
quantities: {h: x, v: [x, y, 0], w: {value: dot(x), unit: m/s, about: rate}}
outputs: [rhs, energy]
sensitivities: [m]
"""

# What acts, and what does not.
EFFECTS = """
gauss: 1
name: effects
counts: {n: 2}
coordinates: {x: {}, y: {about: across}}
particles:
  p: {position: [x, y, 0]}
effects:
  pull:
    about: along x
    default: on
    excludes: [push]
    parameters: {k: {value: 1, unit: N/m}, m: 1}
    coordinates: {x: {initial: 1}}
    particles: {p: {mass: m}}
    forces: {f: {spring: x, stiffness: k}, g_$i: {count: n, generalized: {y: -y}}}
    quantities: {length: {value: x}}
  push:
    requires: [drag]
    parameters: {P: {value: 1, unit: N}, Q: 2}
    forces: {push: {generalized: {x: P}}, side: {force: [0, P, 0], on: p}}
    constraints: {line: {velocity: dot(y), about: straight}}
  drag: {one_of: medium, default: on, forces: {d: {generalized: {x: -dot(x)}}}}
  oil: {one_of: medium, frames: {f: {orientation: {axis: z, angle: x}}}, points: {P: {on: f, at: [0, 0, 0]}}}
  nothing:
"""


if __name__ == "__main__":
    unittest.main()
