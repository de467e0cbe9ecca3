"""Links that break, and what runs through regimes write, refuse and go on from."""

import math
import unittest

from gauss_sim import Regimes
from test_regimes import BLOCK, POOL
from test_regimes_impacts import BOUNCE, STOP, swing

G = 9.81

# From the level: the tension is 3 m g cos(angle), and breaks it at 2 m g.
LINK = """gauss: 1
name: link
parameters: {m: 2, l: 0.7, g: 9.81, T: 2}
coordinates: {x: {initial: l}, z: {initial: 0}}
particles: {bob: {mass: m, position: [x, 0, z]}}
constraints: {rod: {LAW, breaks_at: T*m*g}}
forces: {gravity: {uniform: [0, 0, -g]}}
"""
BY_EQUATION = LINK.replace("LAW", 'equation: "sqrt(x^2 + z^2) - l"')
BY_DISTANCE = LINK.replace("LAW", "distance: [space, bob], is: l")

# Two that share a load of t: the weaker one breaks first, and then the other has all of it.
CHAIN = """gauss: 1
name: chain
parameters: {m: 1}
coordinates: {x: {initial: 0}, y: {initial: 0}}
particles: {p: {mass: m, position: [x, 0, 0]}, q: {mass: m, position: [y, 0, 0]}}
constraints: {a: {equation: x, breaks_at: 4}, b: {equation: y - x, breaks_at: 3}}
forces: {pull: {generalized: {y: t}}}
"""


def after_the_break(t, tension=2, l=0.7):
    """Place and speeds of the bob."""
    angle = math.acos(tension / 3)  # from below
    # From rest at the level: that of an amplitude of a quarter, back to this angle.
    w = math.sqrt(G / l)
    breaks = swing(math.pi / 2, math.pi / 2, w) - swing(math.pi / 2, angle, w)
    v = math.sqrt(2 * G * l * math.cos(angle))
    x, z, vx, vz = l * math.sin(angle), -l * math.cos(angle), -v * math.cos(angle), -v * math.sin(angle)
    s = t - breaks
    return breaks, x + vx * s, z + vz * s - G * s * s / 2, vx, vz - G * s


class Runs(Regimes):
    def test_a_link_breaks_at_its_tension_and_the_bob_falls_freely(self):
        for text in (BY_EQUATION, BY_DISTANCE):
            table, events = self.go(text, "--duration", "1", "--tolerance", "1e-12", "--outputs", "state,reactions,modes")
            breaks = after_the_break(1)[0]
            ((t, words, _),) = events
            self.assertEqual(words, "rod broken")
            self.assertAlmostEqual(t, breaks, delta=1e-9)
            for i, t in enumerate(table["t"]):
                _, x, z, vx, vz = after_the_break(t)
                self.assertEqual(table["modes.rod"][i], 1 if t < breaks else 0)
                if t > breaks:
                    for name, value in (("x", x), ("z", z), ("x_dot", vx), ("z_dot", vz)):
                        self.assertAlmostEqual(table[name][i], value, delta=1e-8)
                    self.assertEqual(table["reactions.rod.multiplier"][i], 0)
                else:
                    self.assertAlmostEqual(math.hypot(table["x"][i], table["z"][i]), 0.7, delta=1e-12)
                    self.assertAlmostEqual(abs(table["reactions.rod.generalized[0]"][i]),
                                           3 * 2 * G * -table["z"][i] * table["x"][i] / 0.49, delta=1e-8)

    def test_a_link_that_is_strong_enough_holds(self):
        _, events = self.go(BY_EQUATION, "--duration", "3", "--set", "T=3.0001")
        self.assertEqual(events, [])
        _, events = self.go(BY_EQUATION, "--duration", "3", "--set", "T=2.9999")
        self.assertEqual([words for _, words, _ in events], ["rod broken"])

    def test_a_broken_link_does_not_drift(self):
        self.go(BY_EQUATION, "--duration", "1")
        self.assertLess(self.summary("x.json")["drift"]["constraints"]["positions"], 1e-9)

    def test_the_weaker_of_two_links_breaks_and_no_more(self):
        table, events = self.go(CHAIN, "--duration", "6")
        self.assertEqual([words for _, words, _ in events], ["b broken"])
        self.assertAlmostEqual(events[0][0], 3, delta=1e-10)
        self.assertEqual(set(table["x"]), {0.0})
        self.assertAlmostEqual(table["y"][-1], (6**3 - 27) / 6 - 4.5 * 3, delta=1e-9)  # y'' = t from 3 on
        table, events = self.go(CHAIN.replace("breaks_at: 4", "breaks_at: 2"), "--duration", "6")
        self.assertEqual([words for _, words, _ in events], ["a broken"])
        self.assertAlmostEqual(events[0][0], 2, delta=1e-10)
        # Both go on together: the other has half of the load, which reaches 3 at 6.
        self.assertAlmostEqual(table["x"][-1], ((6**3 - 8) / 6 - 2 * 4) / 2, delta=1e-9)
        self.assertAlmostEqual(table["y"][-1], table["x"][-1], delta=1e-12)

    def test_a_link_breaks_that_an_impact_leaves_with_too_much(self):
        """At rest on the floor the bar carries the weight of the upper mass, m g."""
        text = """gauss: 1
name: landing
parameters: {m: 1, g: 9.81, l: 1, F: 9}
coordinates: {z: {initial: 1}, w: {initial: 2}}
particles: {a: {mass: m, position: [0, 0, z]}, b: {mass: m, position: [0, 0, w]}}
constraints: {bar: {distance: [a, b], is: l, breaks_at: F}}
contacts: {floor: {gap: z}}
forces: {gravity: {uniform: [0, 0, -g]}}
"""
        lands = math.sqrt(2 / G)
        table, events = self.go(text, "--duration", "0.8")
        self.assertEqual([words for _, words, _ in events], ["floor hits", "bar broken", "floor closed"])
        fall = 0.8 - lands
        self.assertAlmostEqual(table["w"][-1], 1 - G * fall**2 / 2, delta=1e-9)
        table, events = self.go(text, "--duration", "0.8", "--set", "F=9.82")
        self.assertEqual([words for _, words, _ in events], ["floor hits", "floor closed"])
        self.assertAlmostEqual(table["w"][-1], 1, delta=1e-12)
        # Overloaded from the start on.
        _, events = self.go(text, "--duration", "0.1", "--set", "F=0.5", "--set", "z=0", "--set", "w=1")
        self.assertIn("bar broken", [words for _, words, _ in events])

    def test_friction_that_would_drive_is_refused_or_ends_the_run(self):
        """A bead on a hoop: its reaction on the hoop changes sign, and with it a limit that is proportional to it."""
        text = """gauss: 1
name: bead
parameters: {m: 1, g: 9.81, R: 1, mu: 0.3}
coordinates: {r: {held_at: R}, th: {initial: 2.5}}
particles: {b: {mass: m, position: [r*sin(th), 0, -r*cos(th)]}}
forces:
  gravity: {uniform: [0, 0, -g]}
  f: {friction: R*dot(th), limit: -mu*r.reaction}
"""
        self.write("model.yaml", text)
        result = self.run_it("run", "model.yaml", "--duration", "2", "-o", "x.csv")
        self.assertEqual(result.returncode, 5, result.stderr)
        self.assertIn("the limit of 'f' is below 0", result.stderr)
        self.write("model.yaml", BLOCK)
        self.assertIn("the limit of 'friction' is below 0", self.refused(2, "run", "model.yaml", "--set", "mu=-0.1", "-o", "x.csv"))
        weak = (self.folder / "model.yaml").read_text(encoding="utf-8").replace("limit: ", "static_limit: 0, limit: ", 1)
        self.write("weak.yaml", weak)
        self.assertIn("the static limit of 'friction' is below its limit", self.refused(1, "run", "weak.yaml", "-o", "x.csv"))

    def test_events_and_their_summary_agree(self):
        for text, regimes, arguments in ((BOUNCE, 2, ["--duration", "9"]), (POOL, 4, ["--duration", "1"]), (BY_EQUATION, 2, ["--duration", "1"])):
            _, events = self.go(text, *arguments)
            summary = self.summary("x.json")
            self.assertEqual(summary["events"], len(events))
            self.assertLessEqual(2, summary["regimes"])
            self.assertLessEqual(summary["regimes"], regimes)
            instants = [t for t, _, _ in events]
            self.assertEqual(instants, sorted(instants))
            self.assertNotIn("energy", summary["drift"])
            said = self.run_it("run", "model.yaml", "-o", "x.csv", *arguments).stdout
            for what in {words for _, words, _ in events}:
                count = len(self.instants(events, what))
                self.assertIn(f"{what} {count} times" if count > 1 else what, said)
            self.assertEqual(self.files(), ["model.yaml", "x.csv", "x.events.csv", "x.json"])

    def test_a_model_without_regimes_writes_no_events(self):
        self.write("model.yaml", BOUNCE.replace("contacts: {floor: {gap: z, restitution: e}}\n", "").replace(", e: 0.9", ""))
        self.ok("run", "model.yaml", "-q", "--duration", "1", "-o", "x.csv")
        self.assertEqual(self.files(), ["model.yaml", "x.csv", "x.json"])
        self.assertNotIn("events", self.summary("x.json"))

    def test_modes_are_columns(self):
        table, events = self.go(POOL, "--duration", "1", "--outputs", "x,modes", "--samples", "101")
        self.assertEqual(list(table), ["t", "x", "modes.cloth", "modes.friction"])
        (rolls,) = self.instants(events, "friction sticks")
        self.assertEqual(set(table["modes.cloth"]), {1})
        for t, mode in zip(table["t"][1:], table["modes.friction"][1:]):
            self.assertEqual(mode, 2 if t < rolls else 1)
        table, events = self.go(BLOCK, "--duration", "1", "--outputs", "x_dot,modes.friction", "--set", "v0=-3", "--set", "mu=0.3")
        self.assertEqual(list(table), ["t", "x_dot", "modes.friction"])
        for mode, v in zip(table["modes.friction"], table["x_dot"]):
            self.assertEqual(mode, 2 if v > 0 else -2)

    def test_columns_come_in_the_order_in_which_they_are_asked_for(self):
        table, _ = self.go(BOUNCE, "--duration", "1", "--outputs", "modes.floor,z_dot,z")
        self.assertEqual(list(table), ["t", "modes.floor", "z_dot", "z"])

    def test_a_mode_of_nothing_is_refused(self):
        self.write("model.yaml", BOUNCE)
        said = self.refused(2, "run", "model.yaml", "--outputs", "modes.flor", "-o", "x.csv")
        self.assertIn("modes.flor", said)

    def test_outputs_of_which_one_is_unknown_are_listed_with_modes(self):
        self.write("model.yaml", BOUNCE)
        said = self.refused(2, "run", "model.yaml", "--outputs", "mods", "-o", "x.csv")
        self.assertIn("did you mean 'modes'?", said)
        said = self.refused(2, "run", "model.yaml", "--outputs", "colour", "-o", "x.csv")
        self.assertRegex(said, r"there are .*\bmodes\b")

    def test_methods_that_do_not_tell_their_steps_are_refused_with_those_that_do(self):
        self.write("model.yaml", BOUNCE)
        for method in ("taylor", "rk4", "bulirsch_stoer", "gauss_legendre4"):
            said = self.refused(2, "run", "model.yaml", "--method", method, "-o", "x.csv")
            self.assertIn(f"'{method}' does not tell its steps", said)
            self.assertIn("take prince87, dopri5 or fehlberg78", said)

    def test_a_contact_that_overlaps_at_the_start_is_said(self):
        self.write("model.yaml", BOUNCE)
        said = self.refused(5, "run", "model.yaml", "--set", "z=-0.1", "-o", "x.csv")
        self.assertIn("the contact 'floor' begins with a gap of -0.1", said)

    def test_more_contacts_at_once_than_can_be_tried_in_all_ways(self):
        count = 13
        text = "gauss: 1\nname: many\nparameters: {m: 1}\ncoordinates:\n"
        text += "".join(f"  x{i}: {{initial: 0}}\n" for i in range(count)) + "particles:\n"
        text += "".join(f"  p{i}: {{mass: m, position: [x{i}, 0, 0]}}\n" for i in range(count)) + "contacts:\n"
        text += "".join(f"  c{i}: {{gap: x{i}}}\n" for i in range(count)) + "forces: {push: {generalized: {"
        text += ", ".join(f"x{i}: {'-1' if i else '1'}" for i in range(count)) + "}}}\n"
        self.write("model.yaml", text)
        self.ok("run", "model.yaml", "--duration", "0.1", "-o", "x.csv", timeout=60)
        table = self.table("x.csv")  # x0 goes, and the others stay
        self.assertAlmostEqual(table["x0"][-1], 0.005, delta=1e-12)
        self.assertEqual(table["x1"][-1], 0)

    def test_many_contacts_at_once_move_as_the_convex_programme_says(self):
        """Gauss's principle with inequalities: least (a - a0)' M (a - a0)/2 with a >= 0, by relaxation of one acceleration after the other."""
        count, coupling = 14, 0.6
        pushes = [math.sin(2.3 * i + 1) - 0.2 for i in range(count)]
        text = "gauss: 1\nname: many\nparameters: {m: 1}\ncoordinates:\n"
        text += "".join(f"  z{i}: {{}}\n" for i in range(count)) + "particles:\n"
        places = [f"z{i}" + (f" + {coupling}*z{i + 1}" if i + 1 < count else "") for i in range(count)]
        text += "".join(f'  p{i}: {{mass: m, position: [0, 0, "{place}"]}}\n' for i, place in enumerate(places)) + "contacts:\n"
        text += "".join(f"  c{i}: {{gap: z{i}}}\n" for i in range(count)) + "forces: {push: {generalized: {"
        text += ", ".join(f"z{i}: {push!r}" for i, push in enumerate(pushes)) + "}}}\n"
        table, events = self.go(text, "--duration", "0.01", "--samples", "2", "--outputs", "accelerations,modes,reactions", timeout=60)
        a = [0.0] * count
        for _ in range(2000):
            for i in range(count):
                before, after = (a[i - 1] if i > 0 else 0), (a[i + 1] if i + 1 < count else 0)
                a[i] = max(0, (pushes[i] - coupling * (before + after)) / (1 + (coupling**2 if i > 0 else 0)))
        closed = [i for i in range(count) if a[i] == 0]
        self.assertGreater(len(closed), 3)
        self.assertGreater(count - len(closed), 3)
        for i in range(count):
            self.assertAlmostEqual(table[f"z{i}_ddot"][0], a[i], delta=1e-12)
            self.assertEqual(table[f"modes.c{i}"][0], 1 if i in closed else 0)
            press = (1 + (coupling**2 if i > 0 else 0)) * a[i] - pushes[i]
            press += coupling * ((a[i - 1] if i > 0 else 0) + (a[i + 1] if i + 1 < count else 0))
            self.assertAlmostEqual(table[f"reactions.c{i}.multiplier"][0], press if i in closed else 0, delta=1e-12)
        self.assertLessEqual(self.summary("x.json")["regimes"], 2)

    def test_steps_of_all_regimes_count_together(self):
        self.write("model.yaml", BOUNCE)
        result = self.run_it("run", "model.yaml", "-q", "--duration", "2", "--max-steps", "300", "-o", "x.csv")
        self.assertEqual(result.returncode, 5, result.stderr)
        self.assertEqual(self.summary("x.json")["steps"], 300)

    def in_two_parts(self, text, steps, duration):
        """The last rows of a run and of one that was interrupted after some steps; and their events."""
        self.write("model.yaml", text)
        self.ok("run", "model.yaml", "-q", "--duration", duration, "-o", "whole.csv")
        result = self.run_it("run", "model.yaml", "-q", "--duration", duration, "--max-steps", steps, "-o", "x.csv")
        self.assertEqual(result.returncode, 5, result.stderr)
        self.ok("run", "model.yaml", "-q", "--duration", duration, "--max-steps", "100000", "--resume", "-o", "x.csv")
        return self.table("whole.csv"), self.table("x.csv"), self.events("whole.events.csv"), self.events("x.events.csv")

    def test_a_run_that_goes_on_moves_as_one_that_was_never_interrupted(self):
        for text in (STOP, POOL, BOUNCE):
            whole, parts, _, _ = self.in_two_parts(text, 160, 1.5)
            self.assertEqual(whole.keys(), parts.keys())
            for name in whole:
                for one, other in zip(whole[name], parts[name], strict=True):
                    self.assertAlmostEqual(one, other, delta=1e-9)

    def test_what_is_broken_stays_so_when_a_run_goes_on(self):
        whole, parts, _, _ = self.in_two_parts(BY_EQUATION, 200, 1)
        self.assertAlmostEqual(whole["z"][-1], parts["z"][-1], delta=1e-9)

    def test_events_of_a_run_that_goes_on_are_those_of_the_whole(self):
        _, _, whole, parts = self.in_two_parts(STOP, 250, 2)
        self.assertEqual([words for _, words, _ in whole], [words for _, words, _ in parts])

    def test_an_ensemble_of_a_model_with_regimes_is_refused(self):
        self.write("model.yaml", BOUNCE)
        self.write("many.yaml", """gauss: 1
scene: many
model: model.yaml
duration: 2
samples: 3
outputs: [z]
ensemble: {trajectories: 4, parameters: {e: {uniform: [0.4, 0.9]}}}
""")
        result = self.run_it("ensemble", "many.yaml", "-q")
        self.assertNotEqual(result.returncode, 0)
        self.assertRegex(result.stderr, "contact")
        self.assertEqual(self.files(), ["many.yaml", "model.yaml"])

    def test_an_error_that_is_asked_for_is_kept_across_impacts(self):
        self.write("model.yaml", STOP)
        self.ok("run", "model.yaml", "-q", "--duration", "2", "--error", "1e-8", "-o", "x.csv", timeout=60)
        (first, _, _), (second, _, _) = self.events("x.events.csv")
        w = math.sqrt(G / 0.5)
        t = swing(1.2, 1.2, w) + swing(1.2, 0.2, w)
        self.assertAlmostEqual(first, t, delta=1e-7)
        amplitude = math.acos(math.cos(0.2) - 0.25 * (math.cos(0.2) - math.cos(1.2)))
        self.assertAlmostEqual(second, t + 2 * (swing(amplitude, amplitude, w) + swing(amplitude, 0.2, w)), delta=1e-7)


if __name__ == "__main__":
    unittest.main()
