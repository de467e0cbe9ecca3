#!/usr/bin/python3
"""A rigid body whose reference point stays at a height and does not slip across a skate; its attitude is a quaternion."""

import random

import numpy as np

import reference_file
from newton_euler import EX, EY, EZ, GROUND, Frame, System, cross, number, real, unit, vec

PARAMS = {"m": "3", "dx": "0.2", "dz": "0.4", "A": "0.05", "B": "0.07", "C": "0.04", "E": "0.01", "g": "9.81", "k": "40"}
P = {key: number(value) for key, value in PARAMS.items()}
NAMES = ["x", "y", "e0", "e1", "e2", "e3"]
SPEEDS = ["x_dot", "y_dot", "p", "q", "s"]
HEIGHT = real("0.1")


def attitude(e):
    """From body to space axes: the sandwich e v e*, column by column."""
    e0, e1 = e[0], np.array(e[1:4])
    columns = [v + 2 * e0 * cross(e1, v) + 2 * cross(e1, cross(e1, v)) for v in (EX, EY, EZ)]
    return np.array(columns).T


def rates(q, u):
    """e' = e w / 2, w in body axes."""
    e0, e, w = q[2], q[3:6], u[2:5]
    return np.array([u[0], u[1], -(e @ w) / 2, *((e0 * w + cross(e, w)) / 2)])


def accelerations(q, u, thrust):
    R = attitude(q[2:6])
    body = Frame(vec(q[0], q[1], HEIGHT), R, vec(u[0], u[1], 0), R @ u[2:5])
    s = System(-P["g"] * EZ)
    b = s.body(P["m"], [[P["A"], 0, P["E"]], [0, P["B"], 0], [P["E"], 0, P["C"]]], body, vec(P["dx"], 0, P["dz"]))
    s.push(b, thrust * EX, body.r)
    # k (e1^2 + e2^2) is k/2 (1 - cos of the tilt).
    up = R @ EZ
    s.twist(b, P["k"] / 2 * cross(up, EZ))
    s.pin("z", GROUND, b, body.r, (EZ,))
    ahead, turning = R @ EX, cross(body.w, R @ EX)
    side, side_rate = cross(EZ, ahead), cross(EZ, turning)
    s._row("blade", [s._entry(b, side, body.r, 1)], -side @ s._centripetal(b, body.r) - side_rate @ body.v)
    found, forces = s.solve()
    a, alpha = s.acceleration(found, b, body.r), found[b][1]
    # In body axes the rates are the components of the angular acceleration: w x w = 0.
    return np.array([a[0], a[1], *(R.T @ alpha)]), forces


def consistent(e, w, place, along):
    """Along the heading of the skate; `along` is the rate of x."""
    e = unit(np.array([real(c) for c in e]))
    ahead = attitude(e) @ EX
    return np.array([*place, *e, along, along * ahead[1] / ahead[0], *w])


def main():
    pick = random.Random(9)
    draw = lambda size: str(round(pick.uniform(-size, size), 3))
    states = []
    for _ in range(5):
        some = lambda n, size: np.array([real(draw(size)) for _ in range(n)])
        state, inputs = consistent(some(4, 1), some(3, 4), some(2, 2), real(draw(2))), {"thrust": draw(3)}
        run = lambda t, q, u: accelerations(q, u, real(inputs["thrust"]))
        states.append({"inputs": inputs, **reference_file.at_state(NAMES, run, state, speeds=SPEEDS)})
    # At 0.45 s it stands on its nose, where the skate points nowhere.
    start = consistent(["0.9", "0.1", "-0.3", "0.3"], [real(c) for c in ("0.3", "-0.2", "0.5")], [real(0), real(0)], real("1.2"))
    run = lambda t, q, u: accelerations(q, u, real("1.5"))
    motion, off = reference_file.follow(NAMES, run, start, ["0.1", "0.2", "0.3"], real("0.0125"), SPEEDS, rates)
    reference_file.write(
        "skater_quaternion", "Rigid body on a skate, attitude by quaternion",
        "e0 is the scalar part, the quaternion turns body into space axes, p, q, s in body axes; forces on the body at the skate, in space "
        "axes: `z` keeps its height, `blade` is level and keeps it from slipping; motion under a thrust of 1.5",
        PARAMS, states, motion, off, 1e-13)


if __name__ == "__main__":
    main()
