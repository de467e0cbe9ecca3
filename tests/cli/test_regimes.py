"""--regime: what is emitted and evaluated for each mode of contacts, dry friction and links that break; against closed forms."""

import re
import unittest
from math import cos, pi, sin

from gauss_gen import Evaluate

G = 9.81

BLOCK = """gauss: 1
name: block
parameters: {m: 2, mu: 0.2, alpha: pi/9, g: 9.81}
coordinates: {x: {initial: 0}, z: {initial: 0}}
particles: {block: {mass: m, position: [x, 0, z]}}
contacts: {plane: {gap: z}}
forces:
  gravity: {uniform: [g*sin(alpha), 0, -g*cos(alpha)]}
  friction: {friction: dot(x), limit: mu*plane.reaction}
"""

# What rubs whatever it touches: constant friction, that sticks unless something else is said.
RUBS = """gauss: 1
name: rubs
parameters: {m: 2, F: 3}
coordinates: {x: {initial: 1}}
particles: {block: {mass: m, position: [x, 0, 0]}}
forces: {pull: {generalized: {x: 5*x}}, friction: {friction: dot(x), limit: F}}
"""

LINK = """gauss: 1
name: link
parameters: {m: 2, l: 0.7, g: 9.81}
coordinates: {x: {initial: l}, z: {initial: 0}}
particles: {bob: {mass: m, position: [x, 0, z]}}
constraints: {rod: {distance: [space, bob], is: l, breaks_at: 2*m*g}}
forces: {gravity: {uniform: [0, 0, -g]}}
"""


class Regimes(Evaluate):
    def setUp(self):
        super().setUp()
        for name, text in (("block", BLOCK), ("rubs", RUBS), ("link", LINK)):
            self.write(f"{name}.yaml", text)

    def acceleration(self, model, name, *regime, sets=()):
        arguments = [word for mode in regime for word in ("--regime", mode)] + [word for one in sets for word in ("--set", one)]
        return float(self.value("accelerations", name, model, *arguments))

    def test_what_is_not_said_is_open_sticks_and_holds(self):
        self.assertAlmostEqual(self.acceleration("block.yaml", "x_ddot"), G * sin(pi / 9), delta=1e-14)
        self.assertAlmostEqual(self.acceleration("block.yaml", "z_ddot"), -G * cos(pi / 9), delta=1e-14)
        self.assertEqual(self.acceleration("rubs.yaml", "x_ddot"), 0)
        self.assertAlmostEqual(self.acceleration("link.yaml", "x_ddot"), 0, delta=1e-15)

    def test_each_mode_has_its_motion(self):
        s, c = G * sin(pi / 9), G * cos(pi / 9)
        for way, expected in (("sticks", 0), ("forwards", s - 0.2 * c), ("backwards", s + 0.2 * c), ("free", s)):
            found = self.acceleration("block.yaml", "x_ddot", "plane=closed", f"friction={way}")
            self.assertAlmostEqual(found, expected, delta=1e-14, msg=way)
        for way, expected in (("sticks", 0), ("forwards", 1), ("backwards", 4), ("free", 2.5)):
            self.assertAlmostEqual(self.acceleration("rubs.yaml", "x_ddot", f"friction={way}"), expected, delta=1e-15, msg=way)
        self.assertAlmostEqual(self.acceleration("link.yaml", "z_ddot", "rod=holds"), -G, delta=1e-14)
        self.assertAlmostEqual(self.acceleration("link.yaml", "x_ddot", "rod=holds", sets=["z_dot=3", "x_dot=0"]), -9 / 0.7, delta=1e-13)
        self.assertAlmostEqual(self.acceleration("link.yaml", "x_ddot", "rod=broken", sets=["z_dot=3", "x_dot=0"]), 0, delta=1e-14)

    def test_reactions_of_what_is_closed_and_sticks_are_told(self):
        regime = ["--regime", "plane=closed", "--regime", "friction=sticks"]
        self.close(self.value("multipliers", "plane", "block.yaml", *regime), 2 * G * cos(pi / 9))
        self.close(self.value("multipliers", "friction", "block.yaml", *regime), -2 * G * sin(pi / 9))
        self.assertEqual(self.document("block.yaml").get("multipliers", {}), {})

    def test_headers_have_the_constraints_of_their_regime_and_say_which(self):
        for regime, count in (([], 0), (["plane=closed", "friction=sticks"], 2), (["plane=closed", "friction=forwards"], 1)):
            arguments = [word for mode in regime for word in ("--regime", mode)]
            header = self.ok("block.yaml", "-o", "-", *arguments)
            self.assertEqual(int(re.search(r"n_constraints = (\d+);", header)[1]), count, regime)
            for mode in regime:
                self.assertIn(f"--regime {mode}", header)

    def test_a_variant_may_be_a_regime_and_shares_the_code_of_an_equal_one(self):
        outputs = "--outputs=rhs,initial_state,guards,impact_system"
        self.write("high.yaml", BLOCK.replace("z: {initial: 0}", "z: {initial: 1}"))
        self.assertEqual(self.run_it("high.yaml", "--regime", "ground", "--variant", "flying=", "--variant", "sliding=plane=closed,friction=forwards",
                                     "--variant", "again=friction=forwards,plane=closed", outputs, "-o", "sets").stderr, "")
        texts = {path.stem: path.read_text() for path in (self.folder / "sets").iterdir()}
        self.assertEqual(set(texts), {"block_flying", "block_sliding", "block_again", "block_variants"})
        self.assertIn("namespace block_again = ::gauss::block_sliding;", texts["block_again"])
        for name in ("flying", "sliding"):
            alone = self.ok("high.yaml", "-o", "-", "--regime", "ground", *(["--regime", "plane=closed", "--regime", "friction=forwards"] if name == "sliding" else []),
                            "--outputs=rhs,guards" if name == "sliding" else outputs)
            own = texts[f"block_{name}"].replace(f"BLOCK_{name.upper()}", "BLOCK").replace(f"block_{name}", "block")
            code = [text[text.index("namespace gauss::block {"):] for text in (own, alone)]
            self.assertEqual(*code, name)
        table = texts["block_variants"]
        self.assertIn('_guards[] = {"plane_opens", "friction_slip1", nullptr};', table)
        self.assertIn('"sliding", "", "friction=forwards, plane=closed"', table)
        # Outputs are asked for once for all: of a start in the air there is none on the plane, and impacts are told of the ground.
        self.assertIn("initial_state(", texts["block_flying"])
        self.assertIn("impact_system(", texts["block_flying"])
        self.assertNotIn("initial_state(", texts["block_sliding"])
        self.assertNotIn("impact_system(", texts["block_sliding"])

    def test_mistakes_in_modes_of_variants_name_them(self):
        for said, variant in (("--variant up: 'plane' is never 'close': it is one of open, closed", "up=plane=close"),
                              ("--variant up: 'plane' is given twice", "up=plane=open,plane=closed"),
                              ("--variant up: one value each", "up=plane=open=closed")):
            self.assertIn(said, self.refused(2, "block.yaml", "--variant", variant))

    def test_a_start_in_another_regime_is_none_of_this_one(self):
        self.write("high.yaml", BLOCK.replace("z: {initial: 0}", "z: {initial: 1}"))
        closed = ["--regime", "plane=closed", "--regime", "friction=free"]
        header = self.ok("high.yaml", "-o", "-", *closed)
        self.assertNotIn("initial_state(", header)
        self.assertIn("// The motion starts in another regime, so there is no initial_state.", header)
        self.assertIn("error[E070]", self.refused(1, "high.yaml", "-o", "-", *closed, "--outputs=rhs,initial_state"))
        self.assertIn("initial_state(", self.ok("block.yaml", "-o", "-", *closed))
        self.assertNotIn("another regime", self.ok("block.yaml", "-o", "-", *closed))

    def test_words_that_are_no_mode_are_refused_with_those_that_are(self):
        for regime, said in (("plane=close", "'plane' is never 'close': it is one of open, closed"),
                             ("friction=slides", "'friction' is never 'slides': it is one of sticks, forwards, backwards, free"),
                             ("plain=closed", "'plain' is nothing that changes its mode; there are friction, plane"),
                             ("plane", "expected name=value, not 'plane'"),
                             ("plane=closed=open", "one value each")):
            self.assertIn(f"--regime: {said}", self.refused(2, "block.yaml", "--regime", regime), regime)
        self.assertIn("'rod' is never 'closed': it is one of holds, broken", self.refused(2, "link.yaml", "--regime", "rod=closed"))
        self.assertIn("'plane' is given twice", self.refused(2, "block.yaml", "--regime", "plane=open", "--regime", "plane=closed"))
        self.write("plain.yaml", LINK.replace(", breaks_at: 2*m*g", ""))
        self.assertIn("the model has no contacts, dry friction or links that break", self.refused(2, "plain.yaml", "--regime", "rod=broken"))

    def test_slip_in_two_directions_slides_and_has_no_sense(self):
        self.write("two.yaml", RUBS.replace("{x: {initial: 1}}", "{x: {initial: 1}, y: {}}").replace("[x, 0, 0]", "[x, y, 0]")
                   .replace("friction: dot(x)", "friction: [dot(x), dot(y)]"))
        self.assertIn("it is one of sticks, slides, free", self.refused(2, "two.yaml", "--regime", "friction=forwards"))
        # 5 - 3*3/5 and 3*4/5 of 3/2 along the slip (3, -4)
        sets = ["x_dot=3", "y_dot=-4"]
        self.assertAlmostEqual(self.acceleration("two.yaml", "x_ddot", "friction=slides", sets=sets), (5 - 1.8) / 2, delta=1e-14)
        self.assertAlmostEqual(self.acceleration("two.yaml", "y_ddot", "friction=slides", sets=sets), 1.2, delta=1e-14)

    def test_friction_that_fades_has_no_modes(self):
        self.write("soft.yaml", RUBS.replace("limit: F", "limit: F, smooth: 0.5"))
        self.assertIn("'friction' is nothing that changes its mode", self.refused(2, "soft.yaml", "--regime", "friction=sticks"))
        slow, fast = (self.acceleration("soft.yaml", "x_ddot", sets=[f"x_dot={v}"]) for v in (0.001, 50))
        self.assertAlmostEqual(fast, 1, delta=1e-3)
        self.assertTrue(2.4 < slow < 2.5, slow)

    def test_a_limit_that_is_not_linear_in_reactions_is_said_where_it_acts(self):
        self.write("square.yaml", BLOCK.replace("mu*plane.reaction", "mu*plane.reaction^2"))
        said = self.refused(1, "square.yaml", "--regime", "plane=closed", "--regime", "friction=forwards")
        self.assertIn("error[E044]", said)

    def test_no_speed_of_a_start_is_refused_for_friction_that_nobody_said_sticks(self):
        self.write("moves.yaml", RUBS.replace("{initial: 1}", "{initial: 1, initial_rate: 2}"))
        self.assertAlmostEqual(self.acceleration("moves.yaml", "x_ddot", "friction=forwards"), 1, delta=1e-15)
        self.assertNotIn("constraint 'friction'", self.run_it("moves.yaml", "-o", "-").stderr)

    def test_the_strength_of_a_link_is_checked_for_its_unit(self):
        units = LINK.replace("m: 2", "m: {value: 2, unit: kg}").replace("l: 0.7", "l: {value: 0.7, unit: m}").replace(
            "g: 9.81", "g: {value: 9.81, unit: m/s^2}").replace("{initial: l}", "{unit: m, initial: l}").replace(
            "{initial: 0}", "{unit: m, initial: 0}")
        self.write("units.yaml", units)
        self.ok("units.yaml", "-o", "-")
        self.write("wrong.yaml", units.replace("2*m*g", "2*m"))
        said = self.refused(1, "wrong.yaml")
        self.assertIn("error[E064]: the reaction at which a constraint breaks is in N, and this is in kg", said)
        self.assertEqual(said.count("error["), 1)
        with self.subTest("of an angle it is a torque"):
            torque = units.replace("distance: [space, bob], is: l, breaks_at: 2*m*g", "equation: atan2(x, z) - pi/2, breaks_at: {}")
            self.write("torque.yaml", torque.replace("{}", "2*m*g*l"))
            self.ok("torque.yaml", "-o", "-")
            self.write("torque.yaml", torque.replace("{}", "2*m*g"))
            self.assertIn("breaks is in N*m, and this is in N\n", self.refused(1, "torque.yaml"))

    def test_a_restitution_is_a_plain_number(self):
        bounce = ("gauss: 1\nname: bounce\nparameters: {m: {value: 1, unit: kg}, e: {value: 0.5, unit: 1}, v: {value: 0.5, unit: m/s}}\n"
                  "coordinates: {z: {unit: m}}\nparticles: {p: {mass: m, position: [0, 0, z]}}\ncontacts: {floor: {gap: z, restitution: e}}\n")
        self.write("bounce.yaml", bounce.replace("restitution: e", "restitution: e/2"))
        self.assertNotIn("E064", self.run_it("bounce.yaml", "-o", "-").stderr)
        self.write("bounce.yaml", bounce.replace("restitution: e", "restitution: v"))
        said = self.refused(1, "bounce.yaml")
        self.assertIn("error[E064]: a restitution is a plain number, and this is in m/s", said)
        self.assertEqual(said.count("error["), 1)

    def test_a_parameter_of_what_is_broken_is_not_unused(self):
        self.write("named.yaml", LINK.replace("g: 9.81", "g: 9.81, T: 3").replace("2*m*g", "T"))
        self.ok("named.yaml", "-o", "-", "--regime", "rod=broken")
        self.write("rest.yaml", LINK.replace("g: 9.81", "g: 9.81, T: 3"))
        self.assertIn("W064", self.run_it("rest.yaml", "-o", "-", "--regime", "rod=broken").stderr)

    def test_a_parameter_that_two_absent_effects_share_is_not_unused(self):
        effects = ("effects:\n  wind: {forces: {wind: {generalized: {x: c}}}}\n  tide: {forces: {tide: {generalized: {x: -c}}}}\n")
        model = RUBS.replace("F: 3", "F: 3, c: 1") + effects
        self.write("shared.yaml", model)
        self.ok("shared.yaml", "-o", "-")
        self.write("alone.yaml", model.replace("-c}", "-2}"))
        self.assertIn("the effect 'wind', which does not act, mentions it", self.run_it("alone.yaml", "-o", "-").stderr)

    def test_smooth_friction_of_what_is_open_is_no_force_that_nothing_feels(self):
        soft = BLOCK.replace("limit: mu*plane.reaction", "limit: mu*plane.reaction, smooth: 0.01")
        self.write("soft.yaml", soft)
        self.ok("soft.yaml", "-o", "-")
        self.ok("soft.yaml", "-o", "-", "--regime", "plane=closed")
        self.write("idle.yaml", soft.replace("mu*plane.reaction", "0*mu*m"))
        self.assertIn("W067", self.run_it("idle.yaml", "-o", "-").stderr)

    def test_the_key_outputs_takes_guards(self):
        self.write("guarded.yaml", BLOCK + "outputs: [rhs, guards]\n")
        self.assertIn("struct Guards {", self.ok("guarded.yaml", "-o", "-"))
        self.assertNotIn("struct Guards {", self.ok("block.yaml", "-o", "-"))
        self.assertEqual(self.document("guarded.yaml")["status"], "ok")

    def test_outputs_that_a_regime_does_not_have_say_why(self):
        for model, output, why in (("block.yaml", "impact_system", "it is of the regime in which all contacts are open and all friction is free"),
                                   ("link.yaml", "impact_system", "it has no contact and no dry friction"),
                                   ("block.yaml", "load_system", "all reactions that its guards judge are unique, or it has none"),
                                   ("plain.yaml", "guards", "it has no contact, dry friction or link that breaks"),
                                   ("pressed.yaml", "inverse_dynamics", "a force in it depends on reactions")):
            self.write("plain.yaml", LINK.replace(", breaks_at: 2*m*g", ""))
            self.write("pressed.yaml", BLOCK.replace("contacts: {plane: {gap: z}}", "constraints: {plane: {equation: z}}").replace(
                "friction: {friction: dot(x), limit: mu*plane.reaction}", "friction: {generalized: {x: -mu*plane.reaction}}"))
            self.assertIn(f"the output '{output}' is left out, as this model has nothing for it: {why}",
                          self.run_it(model, "-o", "-", f"--outputs=rhs,{output}").stderr)

    def test_what_holds_more_than_it_needs_has_its_loads(self):
        self.write("brakes.yaml", RUBS.replace("friction: {friction: dot(x), limit: F}",
                                               "one: {friction: dot(x), limit: F}, two: {friction: dot(x), limit: 2*F}"))
        outputs = "--outputs=rhs,guards,load_system"
        emitted = self.run_it("brakes.yaml", "-o", "-", outputs)
        self.assertIn("W054", emitted.stderr)
        text = emitted.stdout
        for field in ("S g[1][1];", "S rows[2][1];", "S reactions[2];", "S limits[2];", "S per_reaction[2][2];"):
            self.assertIn(field, text)
        # Where one of them slides, the other one is alone.
        alone = self.run_it("brakes.yaml", "-o", "-", outputs, "--regime", "one=forwards")
        self.assertNotIn("struct LoadSystem", alone.stdout)
        self.assertIn("all reactions that its guards judge are unique", alone.stderr)

    def test_a_restitution_that_no_impact_has_is_refused(self):
        for e in ("1.5", "-0.1"):
            self.write("bounce.yaml", BLOCK.replace("gap: z", f"gap: z, restitution: {e}"))
            self.assertIn("restitution", self.run_it("bounce.yaml", "-o", "-").stderr)

    def test_a_gap_that_nothing_changes_is_said(self):
        for gap in ("m - 1", "sin(3*t) + 2"):
            self.write("fixed.yaml", BLOCK.replace("gap: z", f"gap: {gap}"))
            said = self.refused(1, "fixed.yaml")
            self.assertIn("no free coordinate appears in the gap of the contact 'plane'", said)
            self.assertEqual(said.count("error["), 1)
            # As a constraint it is said likewise.
            self.assertEqual(self.refused(1, "fixed.yaml", "--regime", "plane=closed").count("error["), 1)

    def test_a_rate_in_a_gap_is_said_once(self):
        self.write("rate.yaml", BLOCK.replace("gap: z", "gap: z + dot(z)/100"))
        self.assertEqual(self.refused(1, "rate.yaml").count("error["), 1)

    def test_a_misspelt_reaction_of_an_open_contact_is_counted_once_and_its_name_is_proposed(self):
        self.write("typo.yaml", BLOCK.replace("plane.reaction", "plan.reaction"))
        said = self.refused(1, "typo.yaml")
        self.assertIn("did you mean 'plane.reaction'?", said)
        self.assertNotIn("used 2 times", said)

    @unittest.expectedFailure  # three times, at the components of gravity
    def test_the_weight_of_a_medium_with_a_wrong_unit_is_said_at_that_unit(self):
        text = """gauss: 1
name: floats
parameters: {m: {value: 1, unit: kg}, V: {value: 1, unit: m^3}, g: {value: 9.81, unit: m/s^2}}
coordinates: {z: {unit: m}}
particles: {p: {mass: m, position: [0, 0, z]}}
forces: {weight: {uniform: [0, 0, -g]}, water: {buoyancy: p, displaced: V}}
"""
        self.write("float.yaml", text)
        place = text.splitlines()[5].index("V}}") + 1
        said = self.refused(1, "float.yaml")
        self.assertEqual(said.count("error["), 1)
        self.assertIn(f"float.yaml:6:{place}: error[E064]", said)


if __name__ == "__main__":
    unittest.main()
