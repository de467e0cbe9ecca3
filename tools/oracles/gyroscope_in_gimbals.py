#!/usr/bin/python3
"""A gyroscope in two gimbals: three bodies on three hinges in a row."""

import random

import numpy as np

import reference_file
from newton_euler import EX, EZ, GROUND, Frame, System, number, real

PARAMS = {"m": "1.1", "l": "0.03", "A": "0.0025", "C": "0.004", "mi": "0.3", "Ai": "0.0011", "Bi": "0.0009", "Ci": "0.0017",
          "mo": "0.5", "Ao": "0.0021", "Co": "0.0019", "g": "9.81"}
P = {key: number(value) for key, value in PARAMS.items()}
NAMES = ["psi", "theta", "phi"]


def accelerations(t, q, u):
    outer = Frame().turned(EZ, q[0], u[0])
    inner = outer.turned(EX, q[1], u[1])
    rotor = inner.turned(EZ, q[2], u[2])
    s = System(-P["g"] * EZ)
    o = s.body(P["mo"], [P["Ao"], P["Ao"], P["Co"]], outer)
    i = s.body(P["mi"], [P["Ai"], P["Bi"], P["Ci"]], inner)
    r = s.body(P["m"], [P["A"], P["A"], P["C"]], rotor, P["l"] * EZ)
    s.hinge("column", GROUND, o, outer.r, EZ)
    s.hinge("trunnion", o, i, inner.r, outer.R @ EX)
    s.hinge("spindle", i, r, rotor.r, inner.R @ EZ)
    found, forces = s.solve()
    (_, a_o), (_, a_i), (_, a_r) = found
    return np.array([a_o @ EZ, (a_i - a_o) @ (outer.R @ EX), (a_r - a_i) @ (inner.R @ EZ)]), forces


def main():
    pick = random.Random(3)
    states = []
    for _ in range(4):
        draw = lambda size: real(str(round(pick.uniform(-size, size), 3)))
        state = np.array([draw(3), draw(1.4), draw(3), draw(5), draw(5), draw(150)])
        states.append(reference_file.at_state(NAMES, accelerations, state))
    start = np.array([real(x) for x in ("0", "0.8", "0", "0.5", "-0.3", "120")])
    motion, off = reference_file.follow(NAMES, accelerations, start, ["0.1", "0.25", "0.5", "1"], real("0.01"))
    reference_file.write(
        "gyroscope_in_gimbals", "Unbalanced gyroscope in two gimbals",
        "psi about z, theta about x of the outer gimbal, phi about z of the inner one; force and moment about the crossing of the axes "
        "on the later body of each joint, in space axes", PARAMS, states, motion, off, 1e-13)


if __name__ == "__main__":
    main()
