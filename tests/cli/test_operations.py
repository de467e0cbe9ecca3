"""How many operations emitted code takes, and that this grows with the model and no faster. Counts are the same on every machine."""

import json
import re
import resource
import unittest
from fractions import Fraction

from gauss_gen import MODELS, Program

FAMILIES = MODELS / "families"
CHAIN = FAMILIES / "planar_chain_relative.yaml"
SPATIAL = FAMILIES / "spatial_chain.yaml"

# Of rhs, parameters folded in: what the project set out to stay below.
MOST = [
    (85, MODELS / "sphere_in_cylinder.yaml"), (50, MODELS / "rolling_disc.yaml"), (1000, MODELS / "bicycle.yaml"),
    (220, CHAIN, "--count", "n=5"), (520, CHAIN, "--count", "n=10"), (1090, CHAIN, "--count", "n=20"), (2780, CHAIN, "--count", "n=50"),
    (280, SPATIAL, "--count", "n=2"), (960, SPATIAL, "--count", "n=4"), (1620, SPATIAL, "--count", "n=6"),
]
# Families whose constraints are on the tree, and the counts between which they are compared.
GROWING = [(CHAIN, 50, 200), (SPATIAL, 10, 40), (FAMILIES / "planar_chain_maximal.yaml", 10, 40), (FAMILIES / "planar_pendulum.yaml", 20, 80), (FAMILIES / "n_four_bar.yaml", 5, 20),
           (FAMILIES / "road_train.yaml", 2, 8)]
# Functions of the chain that take what all links do: these too.
GROWING_FUNCTIONS = ["joint_reactions", "energy", "compulsion"]
# How much more than rhs alone a function takes that has all reactions of a model. (The four-bar's takes two calls of sine and cosine less
# instead, as sines of sums come from those of their parts then.)
ADDED = [
    (1.40, "joint_reactions", "joint_reactions", CHAIN, "--count", "n=10"), (1.18, "reactions", "rhs_and_reactions", MODELS / "sphere_in_cylinder.yaml"),
    (1.30, "reactions", "rhs_and_reactions", MODELS / "four_bar.yaml"), (1.52, "joint_reactions", "joint_reactions", MODELS / "four_bar.yaml"),
    (1.47, "joint_reactions", "joint_reactions", SPATIAL, "--count", "n=6"),
]

# A hanging bridge in space: a chain of universal joints from one fixed point to another, which one 'coincide' closes.
BRIDGE = """gauss: 1
name: bridge
counts: {n: 5}
parameters:
  m: {value: 1.3, unit: kg}
  L: {value: 0.7, unit: m}
  J: {value: m*L^2/12, unit: kg*m^2}
  Ja: {value: 0.01, unit: kg*m^2}
  g: {value: 9.81, unit: m/s^2}
frames:
  link_0: {position: [-L, 0, 0]}
joints:
  first: {type: universal, parent: link_0, child: link_1, at: [L, 0, 0], axes: [z, y], coordinates: [a_1, b_1], initial_guess: [0, -0.6]}
  joint_$(i+1): {count: $(n-1), type: universal, parent: link_$i, child: link_$(i+1), at: [L, 0, 0], axes: [z, y], coordinates: [a_$(i+1), b_$(i+1)], initial_guess: [0, 1.2/$n]}
bodies:
  body_$i: {count: n, frame: link_$i, mass: m, inertia: [Ja, J, J], centre: [L/2, 0, 0]}
points:
  end: {on: link_$n, at: [L, 0, 0]}
  pin: {on: space, at: [0.94*L*$n, 0, 0]}
constraints:
  closed: {coincide: [end, pin]}
forces:
  gravity: {uniform: [0, 0, -g]}
"""

# A chain of universal joints in space with a linkage that closes on each of its links, or on the last one only, or open.
ARM = """gauss: 1
name: arm
counts: {n: 5}
parameters: {g: 9.81, L: 0.5, m: 1, J: 0.1}
joints:
  turntable: {type: revolute, child: b_0, axis: z, initial: 0.1}
  j_$i: {count: n, type: universal, parent: b_$(i-1), child: b_$i, at: [L, 0, 0], axes: [y, z], initial: [0.3, 0.1]}
%s
bodies:
  b_0: {mass: m, inertia: J, centre: [L/2, 0, 0]}
  b_$i: {count: n, mass: m, inertia: [J, 1.2*J, 0.7*J], centre: [L/2, 0, 0]}
%s
forces:
  gravity: {uniform: [0, 0, -g]}
"""
LINKAGE = ("""
  bucket_{i}: {{{count}type: revolute, parent: b_{i}, child: bucket_{i}, at: [L, 0, 0], axis: -y, initial_guess: -0.3}}
  rocker_{i}: {{{count}type: revolute, parent: b_{i}, child: rocker_{i}, at: [0.1, 0, 0], axis: -y, initial: 1.4}}
  coupler_{i}: {{{count}type: revolute, parent: rocker_{i}, child: coupler_{i}, at: [0.45, 0, 0], axis: -y, initial_guess: -1.3}}
points:
  end_{i}: {{{count}on: coupler_{i}, at: [0.42, 0, 0]}}
  ear_{i}: {{{count}on: bucket_{i}, at: [0, 0, 0.4]}}
""", """
  bucket_{i}: {{{count}mass: m, inertia: J, centre: [0.4, 0, 0]}}
  rocker_{i}: {{{count}mass: m, inertia: J, centre: [0.2, 0, 0]}}
  coupler_{i}: {{{count}mass: m, inertia: J, centre: [0.2, 0, 0]}}
""")
CLOSED = """constraints:
  linkage_{i}: {{{count}coincide: [end_{i}, ear_{i}], in: {axes}}}
"""

# A force at the tip, drag of every link, and springs between neighbours, on the chains of the families.
LOADED = """gauss: 1
name: loaded
counts: {n: 10}
parameters: {m: 1.3, L: 0.7, J: 0.05, Ja: 0.004, g: 9.81}
frames:
  link_0: {position: [0, 0, L]}
joints:
  joint_$i: {count: n, type: %s, parent: link_$(i-1), child: link_$i, at: [0, 0, -L], %s}
bodies:
  body_$i: {count: n, frame: link_$i, mass: m, inertia: [J, J, Ja], centre: [0, 0, -L/2]}
points:
  tip: {on: link_$n, at: [0, 0, -L]}
  side_$i: {count: n, on: link_$i, at: [0.1, 0, -L/3]}
forces:
  gravity: {uniform: [0, 0, -g]}
  %s
"""
REVOLUTE = ("revolute", "axis: y, coordinates: q_$i, initial: 0.1")
UNIVERSAL = ("universal", "coordinates: [a_$i, b_$i], initial: [0.1, 0.2]")
# With how many times the operations four times the links may take: vectors of springs whose damper is across them are sums from the ground on, of which passes share
# a part only.
LOADS = [(5, "push: {on: tip, force: [1, 0, 2]}"), (6, "muscle_$i: {count: n-1, spring: [side_$i, side_$(i+1)], stiffness: 2, damping: 0.3}"),
         (5, "drag_$i: {count: n, on: side_$i, force: [-0.3*dot(side_$i.x), 0, -0.3*dot(side_$i.z)]}")]

# Chains whose first link hangs on a frame that held coordinates move: a trolley in the plane of a chain of rods, and a pivot that is shaken
# and turns, with universal and ball joints.
HELD = """gauss: 1
name: held_chain
counts: {n: 10}
parameters: {m: 1.3, L: 0.7, J: 0.05, Ja: 0.004, g: 9.81, A: 0.1, w: 9}
coordinates:
  x: {held_at: A*sin(w*t)}
  z: {held_at: A*cos(2*w*t)}
"""
TROLLEY = HELD + """
frames:
  link_0: {position: [x, 0, z]}
joints:
  hinge_1: {type: revolute, parent: link_0, child: link_1, axis: y, coordinates: q_1, initial: 0.3}
  hinge_$(i+1): {count: $(n-1), type: revolute, parent: link_$i, child: link_$(i+1), at: [0, 0, -L], axis: y, coordinates: q_$(i+1), initial: 0.1}
bodies:
  body_$i: {count: n, frame: link_$i, mass: m, inertia: [J, J, Ja], centre: [0, 0, -L/2]}
forces:
  gravity: {uniform: [0, 0, -g]}
"""
PIVOT = HELD + """
  turn: {held_at: 2*t + A*sin(w*t)}
frames:
  link_0: {position: [x, 0.1, z], orientation: {axis: z, angle: turn}}
joints:
  hook_$i: {count: n, type: universal, parent: link_$(i-1), child: arm_$i, at: [0, 0, -L], axes: [x, y], coordinates: [u_$i, v_$i], initial: [0.4, 0.3]}
  ball_$i: {count: n, type: spherical, parent: arm_$i, child: link_$i, at: [0, 0, -L], initial_angular_velocity: [0.4, 0.2*$i, -0.6]}
bodies:
  arm_$i: {count: n, mass: m, inertia: [J, 1.02*J, Ja], centre: [0, 0, -L/2]}
  link_$i: {count: n, mass: m, inertia: [J, 1.02*J, Ja], centre: [L/9, 0, -L/2]}
forces:
  gravity: {uniform: [0, 0, -g]}
"""


def small_stack():
    resource.setrlimit(resource.RLIMIT_STACK, (256 * 1024, 256 * 1024))


# A planet on an arm meshes with a sun, the arm at any angle in its own axes: the same motion.
PLANET = """gauss: 1
name: planet_on_arm
parameters: {{r: {{value: 0.02, unit: m}}, R: {{value: 0.05, unit: m}}, m: {{value: 2, unit: kg}}, J: {{value: 1e-3, unit: kg*m^2}}, at: {{value: {at}, unit: rad}}}}
joints:
  arm_axis: {{type: revolute, child: arm, axis: z, coordinates: a, initial: 0.7, initial_rate: 2}}
  sun_axis: {{type: revolute, child: sun, axis: z, coordinates: s, initial_rate: 9}}
  planet_axis: {{type: revolute, parent: arm, child: planet, at: [(r+R)*cos(at), (r+R)*sin(at), 0], coordinates: p}}
bodies: {{arm: {{mass: m, inertia: J}}, sun: {{mass: m, inertia: 2*J}}, planet: {{mass: m, inertia: 3*J}}}}
points: {{mesh: {{on: arm, at: [r*cos(at), r*sin(at), 0]}}}}
constraints: {{tooth: {{no_slip: planet, on: sun, at: mesh, direction: [-sin(at), cos(at), 0], in: arm}}}}
forces: {{drive: {{torque: [0, 0, 0.4], on: sun}}}}
"""


# By outputs, text of the model and options: some functions of one header are counted one by one.
HEADERS = {}


class Operations(Program):
    def header(self, *arguments, **more):
        return self.ok("--fold", *arguments, "-o", "-", **more)

    def operations(self, model, *options, function="rhs", output="rhs"):
        key = (output, model.read_text(encoding="utf-8"), *options)
        if key not in HEADERS:
            HEADERS[key] = self.header("--outputs", output, model, *options)
        row = re.search(rf"^//   {function} +(.*)$", HEADERS[key], re.M)
        return sum(int(number) for number in row[1].split())

    def test_no_more_than_intended(self):
        for most, *arguments in MOST:
            with self.subTest(arguments):
                found = self.operations(*arguments)
                self.assertLessEqual(found, most)
                self.assertGreater(found, most / 3)

    def test_they_grow_with_the_number_of_links(self):
        for model, few, many in GROWING:
            with self.subTest(model.name):
                count = [self.operations(model, "--count", f"n={n}") for n in (few, many)]
                self.assertLess(count[1], 4.5 * count[0])

    def test_stages_make_as_many_nodes_for_each_link(self):
        for model, few, many in GROWING + [(SPATIAL, 25, 100), (FAMILIES / "planar_chain_absolute.yaml", 25, 100), (FAMILIES / "balls_in_cylinder.yaml", 5, 20)]:
            with self.subTest(model.name):
                made = [self.nodes_made(model, n) for n in (few, many)]
                self.assertLess(made[1]["strategy"] + made[1]["passes"], 4.6 * (made[0]["strategy"] + made[0]["passes"]))
                # Rows of rolling are over all speeds before a wheel.
                if model.name != "road_train.yaml": self.assertLess(made[1]["kinematics"], 4.6 * made[0]["kinematics"])

    def nodes_made(self, model, n):
        result = self.run_it(model, "--count", f"n={n}", "--fold", "--outputs", "rhs", "--timings", "--diagnostics", "json", "-o", "-")
        rows = [row for row in map(json.loads, result.stderr.splitlines()) if row.get("stage", "total") != "total"]
        return {row["stage"]: row["nodes_out"] - row["nodes_in"] for row in rows}

    def test_long_chains_do_not_wait_for_divisions(self):
        text = " ".join(self.header("--outputs", "rhs", CHAIN, "--count", "n=20").split("\n// "))
        waiting = re.search(r"postponed so that results wait for each other for some (\d+) cycles and not (\d+)", text)
        self.assertLess(int(waiting[1]), 0.75 * int(waiting[2]))
        self.assertNotIn("postponed", self.header("--outputs", "rhs", SPATIAL, "--count", "n=4"))

    def test_so_do_those_of_other_functions(self):
        for function in GROWING_FUNCTIONS:
            with self.subTest(function):
                count = [self.operations(CHAIN, "--count", f"n={n}", function=function, output=function) for n in (50, 200)]
                self.assertLess(count[1], 4.5 * count[0])

    def test_what_moves_a_pivot_follows_the_links_of_the_chain_on_it(self):
        for text, few in ((TROLLEY, 20), (PIVOT, 4)):
            model = self.write("held.yaml", text)
            with self.subTest(f"{few} links and twice as many"):
                count = [self.operations(model, "--count", f"n={n}", function="reactions", output="reactions") for n in (few, 2 * few)]
                self.assertLess(count[1], 2.3 * count[0])
                self.assertLess(count[1], 1.35 * self.operations(model, "--count", f"n={2 * few}"))

    def test_so_do_they_with_forces_at_places(self):
        for joint, few in ((REVOLUTE, 20), (UNIVERSAL, 6)):
            for most, load in LOADS:
                model = self.write("loaded.yaml", LOADED % (*joint, load))
                with self.subTest(f"{joint[0]}: {load}"):
                    count = [self.operations(model, "--count", f"n={n}") for n in (few, 4 * few)]
                    self.assertLess(count[1], most * count[0])

    def test_what_bodies_feel_follows_the_links_of_the_chain(self):
        model = self.write("held.yaml", TROLLEY)
        count = [self.operations(model, "--count", f"n={n}", function="reaction_forces", output="reaction_forces") for n in (20, 40)]
        self.assertLess(count[1], 2.3 * count[0])
        self.assertLess(count[1], 1.6 * self.operations(model, "--count", "n=40"))

    def bridge(self, n, function, output):
        return self.operations(self.write("bridge.yaml", BRIDGE), "--count", f"n={n}", function=function, output=output)

    def test_searches_for_states_follow_the_links_of_a_closed_chain(self):
        # `project` counts each of the six steps that its search may take, where each step ends the search that has arrived.
        most_of = [("project_positions", 1.2), ("project_speeds", 2), ("project", 6 * 1.2 + 2),
                   ("initial_state_positions", 1.2), ("initial_state_speeds", 2)]
        for function, most in most_of:
            with self.subTest(function):
                output = "project" if function.startswith("project") else "initial_state"
                count = [self.bridge(n, function, output) for n in (10, 40)]
                # The sizes of terms that a residual counts beside are sums over the links, too.
                self.assertLess(count[1], 4.8 * count[0])
                self.assertLess(count[0], most * self.bridge(10, "rhs", "rhs"))

    def test_steps_of_a_search_are_emitted_once(self):
        header = self.header("--outputs", "initial_state", self.write("bridge.yaml", BRIDGE))
        self.assertEqual(header.count("StatusOf<S> initial_state_positions("), 1)
        self.assertRegex(header, r"step < 8 && initial_state_positions_steps\.goes_on\(\); \+\+step\) \{\n.*\n *status = Math<S>::worse\(status, initial_state_positions_steps\.take\(initial_state_positions\(")

    def test_nodes_follow_the_links_of_a_closed_chain(self):
        for stage in ("kinematics", "check"):
            with self.subTest(stage):
                made = []
                for n in (10, 40):
                    run = self.run_it(self.write("bridge.yaml", BRIDGE), "--count", f"n={n}", "--outputs", "rhs", "--timings", "-o", self.folder)
                    nodes = re.search(rf"^{stage} +\S+ +(\d+) +(\d+)", run.stdout + run.stderr, re.M)
                    made.append(int(nodes[2]) - int(nodes[1]))
                self.assertLess(made[1], 5.2 * made[0])

    def arm(self, n, *constraints, each=False):
        where = {"i": "$i" if each else "$n", "count": "count: n, " if each else ""}
        parts = [part.format(**where) for part in LINKAGE]
        closed = "".join(CLOSED.format(axes=axes.format(**where), **where) for axes in constraints)
        return self.write("arm.yaml", ARM % (parts[0], parts[1] + closed)), "--count", f"n={n}"

    def test_a_loop_costs_the_same_wherever_on_a_chain_it_closes(self):
        added = [self.operations(*self.arm(n, "b_{i}")) - self.operations(*self.arm(n)) for n in (4, 16)]
        self.assertLess(added[1], 1.1 * added[0] + 20)

    def test_loops_on_every_link_leave_a_chain_linear(self):
        models = [self.arm(n, "b_{i}", each=True) for n in (3, 12)]
        count = [self.operations(self.arm(n, "b_{i}", each=True)[0], "--count", f"n={n}") for n in (3, 12)]
        self.assertLess(count[1], 4.5 * count[0])
        made = [self.nodes_made(models[0][0], n) for n in (3, 12)]
        self.assertLess(made[1]["strategy"] + made[1]["passes"], 4.5 * (made[0]["strategy"] + made[0]["passes"]))

    # Places and axes that turn with the arm are constants there: nothing is left of the angle, which in space is in every term.
    def test_a_tooth_costs_the_same_wherever_on_an_arm_it_is(self):
        for at in (0, 0.3):
            with self.subTest(at=at):
                text = self.ok("-", "--outputs", "rhs", "-o", "-", stdin=PLANET.format(at=at))
                counts = re.search(r"(?m)^//   rhs +(.*)$", text)[1].split()
                self.assertLessEqual(sum(map(int, counts)), 10)

    # Unknowns a, s, p and the force of the tooth, along r a - r s - R p = 0: by the velocity of the planet at the tooth, (r + R) a - R (a + p).
    def test_a_tooth_turns_what_it_should(self):
        r, R, m, J = Fraction(2, 100), Fraction(5, 100), 2, Fraction(1, 1000)
        arm = J + m * (r + R) ** 2 + 3 * J
        # By the force F on the planet: s = (0.4 - r F) / 2J, 3J (a + p) = -R F, arm a + 3J p = r F.
        per_force_a = (r + R) / (arm - 3 * J)
        per_force_p = -R / (3 * J) - per_force_a
        force = r * Fraction("0.4") / (2 * J) / (r * per_force_a + r * r / (2 * J) - R * per_force_p)
        expected = {"a_ddot": per_force_a * force, "s_ddot": (Fraction("0.4") - r * force) / (2 * J), "p_ddot": per_force_p * force}
        for at in (0, 0.3, 2):
            with self.subTest(at=at):
                found = json.loads(self.ok("evaluate", "-", "--format=json", stdin=PLANET.format(at=at)))["accelerations"]
                for name, value in expected.items():
                    self.assertAlmostEqual(float(found[name]["value"]) / float(value), 1, 14)

    def test_an_entry_of_the_mass_matrix_takes_few(self):
        for n in (20, 60):
            self.assertLess(self.operations(CHAIN, "--count", f"n={n}", function="mass_matrix", output="mass_matrix"), 3.5 * n * n)

    def test_reactions_add_little(self):
        for most, output, function, *model in ADDED:
            with self.subTest(f"{function} of {model}"):
                self.assertLessEqual(self.operations(*model, function=function, output=output), most * self.operations(*model))

    def test_long_chains_need_no_long_stack(self):
        for model, n in ((CHAIN, 300), (SPATIAL, 60), (FAMILIES / "n_four_bar.yaml", 20)):
            self.header("--outputs", "rhs", model, "--count", f"n={n}", preexec_fn=small_stack)

    def test_each_strategy_is_said(self):
        said = {"tree": "Z minimised body by body along the tree", "metric": "elimination", "multipliers": "multiplier form (3.4)"}
        for strategy, words in said.items():
            text = self.header("--outputs", "rhs", MODELS / "chaplygin_sphere.yaml" if strategy == "tree" else MODELS / "sphere_in_cylinder.yaml", "--strategy", strategy)
            self.assertIn(f"--strategy={strategy}", text)
            self.assertIn(words, text)

    def test_a_strategy_that_a_model_does_not_have_is_an_error(self):
        model = self.write("gear.yaml", "gauss: 1\nname: gear\ncoordinates: {a: {}, b: {}}\nparticles:\n  p: {mass: 1, position: [a, 0, 0]}\n"
                           "constraints:\n  gear: {velocity: dot(b) - 2*dot(a)}\n")
        said = self.refused(1, model, "--strategy", "tree", "-o", "-")
        self.assertIn("error[E069]", said)
        self.assertIn("an acceleration has no inertia of its own", said)


if __name__ == "__main__":
    unittest.main()
