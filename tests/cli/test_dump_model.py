"""gauss-gen --dump=model: everything that the file says, and what it leaves out."""

import unittest

from gauss_gen import MODELS, NO_UNITS, PARTICLE, Program

MODEL = """gauss: 1
name: everything
about: a plate and a bob
parameters:
  m: {value: 2, unit: kg, about: of each}
  l: {value: 1, unit: m}
  w: {value: 1, unit: rad/s}
  d: {value: 1, unit: N*m*s}
  J: 2/5*m*l^2
inputs: {push: {value: 3, unit: N}, idle: {unit: 1}}
tables:
  torque: {of: [0, 1/2], values: [3, 4], of_unit: rad/s, unit: N*m, about: of the motor}
  hill: {of: [0, 1, 2], values: [0, 1, 0], kind: spline, of_unit: s, unit: 1}
coordinates:
  h: {unit: m, held_at: l*sin(w*t), about: height}
  x: {unit: m, initial: 1/2, initial_rate: 3}
  y: {unit: m, initial_rate_guess: 4}
  a: {unit: rad}
orientations:
  attitude: {quaternion: [e0, e1, e2, e3], angular_velocity: [p, q, r], frame: body, initial_angular_velocity: {q: 5}}
bodies:
  plate:
    about: thin
    mass: m
    inertia: [J, J, 2*J]
    position: [x,
               y, h]
    orientation: attitude
  wheel: {mass: m, inertia: J, position: [0, 0, 0], orientation: {euler: zxz, angles: [a, 0, 0]}}
  rod: {mass: m, inertia: [[J, 0, J/9], [0, J, 0], [J/9, 0, J]], position: [0, 0, 0], orientation: {euler: xyz, angles: [a, 0, 0]}}
particles:
  bob: {mass: m, position: [x, 0, 0]}
constraints:
  blade: {velocity: dot(x) - 2*dot(y), point: [x, y, 0], about: sharp}
forces:
  gravity: {uniform: [0, 0, -9.81]}
  spring: {potential: m*w^2*x^2, about: soft}
  motor: {generalized: {x: push, p: -d*p, q: torque(q)*hill(t)}}
elimination: {dependent: [x]}
rank_tolerance: 1e-6
outputs: [rhs, energy]
"""

DUMP = """model everything  # a plate and a bob
parameters
  m = 2  [kg]  # of each
  l = 1  [m]
  w = 1  [rad/s]
  d = 1  [N*m*s]
  J = 2/5*m*l^2  [kg*m^2]
inputs
  push = 3  [N]
  idle = 0  [1]
tables
  torque: linear, held outside  # of the motor
    of [0, 1/2]  [rad/s]
    values [3, 4]  [N*m]
  hill: spline, extended outside
    of [0, 1, 2]  [s]
    values [0, 1, 0]  [1]
coordinates
  h: held at l*sin(w*t)  [m]  # height
  x: initial 1/2, initial rate 3  [m]
  y: initial 0, initial rate left open, guess 4  [m]
  a: initial 0, initial rate left open  [rad]
orientations
  attitude: unit quaternion, body to space
    quaternion [e0, e1, e2, e3], initial [1, 0, 0, 0]
    angular velocity [p, q, r] in the body frame, initial [left open, 5, left open]  [rad/s]
bodies
  plate: rigid body  # thin
    mass m
    position [x, y, h]
    orientation attitude
    inertia [J, J, 2*J]
  wheel: rigid body
    mass m
    position [0, 0, 0]
    orientation euler zxz [a, 0, 0]
    inertia J
  rod: rigid body
    mass m
    position [0, 0, 0]
    orientation euler xyz [a, 0, 0]
    inertia [[J, 0, J/9], [0, J, 0], [J/9, 0, J]]
  bob: particle
    mass m
    position [x, 0, 0]
constraints
  blade: dot(x) - 2*dot(y) = 0  # sharp
    point [x, y, 0]
forces
  gravity: uniform [0, 0, -9.81]
  spring: potential m*w^2*x^2  # soft
  motor: generalized {x: push, p: -d*p, q: torque(q)*hill(t)}
elimination
  dependent: x
outputs
  rhs, energy
rank_tolerance
  1/1000000
"""


class DumpModel(Program):
    def dump(self, text):
        return self.run_it("-", "--dump=model", stdin=text).stdout

    def test_a_tolerance_of_ranks_may_be_made_of_numbers(self):
        for text in ("1/1000000", "10^-6", "(1 + 1)/2e6", "0.001^2"):
            self.assertEqual(self.dump(MODEL.replace("1e-6", text)), self.dump(MODEL), text)

    def test_everything_that_the_file_says_is_there(self):
        self.assertEqual(self.dump(MODEL).splitlines(), DUMP.splitlines())

    def test_what_is_left_out_is_filled_in(self):
        text = self.dump(PARTICLE)
        self.assertIn("outputs\n  all\n", text)
        self.assertNotIn("elimination", text)
        self.assertIn("  dependent: as the generator chooses\n", self.ok(MODELS / "skater_quaternion.yaml", "--dump=model"))

    def test_units_that_are_not_there_are_named_as_such(self):
        remark = "units\n  none are stated, so none are checked\n"
        self.assertNotIn(remark, self.dump(PARTICLE))
        self.assertIn(remark, self.dump(NO_UNITS))

    def test_an_expression_over_two_lines_is_one(self):
        text = PARTICLE.replace("[x, y, 0]", "[x, y,\n    x\n      + y]")
        self.assertIn("    position [x, y, x + y]\n", self.dump(text))

    def test_no_line_of_any_model_ends_with_a_blank(self):
        for model in sorted(MODELS.rglob("*.yaml")):
            self.assertNotRegex(self.ok(model, "--dump=model"), r"(?m) $", model)


    def test_an_orientation_says_what_it_is_against(self):
        arm = NO_UNITS + """
joints:
  hinge: {type: revolute, child: arm, axis: z}
  ball: {type: spherical, parent: arm, child: rod, at: [1, 0, 0]}
bodies: {arm: {mass: 1, inertia: 1}, rod: {mass: 1, inertia: [1, 2, 2]}}
"""
        text = self.dump(arm)
        self.assertIn("ball: unit quaternion, body to arm", text)
        self.assertIn("angular velocity [ball_wx, ball_wy, ball_wz] relative to arm in the body frame", text)
        self.ok("-", "-o", ".", stdin=arm)
        header = (self.folder / "particle.hpp").read_text()
        self.assertIn('"unit quaternion ball, body to arm"', header)
        self.assertIn('"angular velocity of ball relative to arm, body frame"', header)

if __name__ == "__main__":
    unittest.main()
