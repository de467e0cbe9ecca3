#!/usr/bin/python3
"""The slider-crank: three bodies in a plane, each with its own equations."""

import random

import numpy as np

import reference_file
from newton_euler import EX, EY, EZ, GROUND, Frame, System, number, real

PARAMS = {"r": "0.1", "l": "0.35", "e": "0.02", "rc": "0.03", "lc": "0.12", "mc": "1.8", "mr": "0.7", "ms": "0.5",
          "Jc": "0.004", "Jr": "0.009", "Js": "0.0004", "g": "9.81"}
P = {key: number(value) for key, value in PARAMS.items()}
NAMES = ["alpha", "beta", "s"]


def complete(alpha, rate):
    """beta and s by the triangle, the slider to the right; their rates from the velocity of the pin."""
    rod = np.arcsin((P["e"] - P["r"] * np.sin(alpha)) / P["l"])
    s = P["r"] * np.cos(alpha) + P["l"] * np.cos(rod)
    rod_rate = -P["r"] * np.cos(alpha) * rate / (P["l"] * np.cos(rod))
    s_rate = -P["r"] * np.sin(alpha) * rate - P["l"] * np.sin(rod) * rod_rate
    return np.array([alpha, rod - alpha, s, rate, rod_rate - rate, s_rate])


def accelerations(q, u, torque, push):
    crank = Frame().turned(EZ, q[0], u[0])
    rod = crank.at(P["r"] * EX).turned(EZ, q[1], u[1])
    slider = Frame().at(P["e"] * EY).slid(EX, q[2], u[2])
    s = System(-P["g"] * EY)
    c = s.body(P["mc"], P["Jc"], crank, P["rc"] * EX)
    r = s.body(P["mr"], P["Jr"], rod, P["lc"] * EX)
    b = s.body(P["ms"], P["Js"], slider)
    s.hinge("O", GROUND, c, crank.r, EZ)
    s.hinge("A", c, r, rod.r, EZ)
    s.pin("guide", GROUND, b, slider.r, (EY, EZ))
    s.align("guide.moment", GROUND, b, (EX, EY, EZ))
    s.pin("B", b, r, slider.r, (EX, EY))
    s.twist(c, torque * EZ)
    s.push(b, push * EX)
    found, forces = s.solve()
    (_, c_a), (_, r_a), (b_a, _) = found
    return np.array([c_a[2], r_a[2] - c_a[2], b_a[0]]), forces


def main():
    pick = random.Random(2)
    states = []
    for _ in range(5):
        draw = lambda size: str(round(pick.uniform(-size, size), 3))
        state, torque, push = complete(real(draw(3)), real(draw(60))), draw(5), draw(200)
        entry = reference_file.at_state(NAMES, lambda t, q, u: accelerations(q, u, real(torque), real(push)), state)
        states.append({"inputs": {"torque": torque, "push": push}, **entry})
    start = complete(real("0.7"), real(30))
    run = lambda t, q, u: accelerations(q, u, real(2), real(-30))
    motion, off = reference_file.follow(NAMES, run, start, ["0.05", "0.1", "0.2", "0.3"], real("0.004"))
    reference_file.write(
        "slider_crank", "Slider-crank with a force on the slider",
        "crank about the origin, guide along x at height e; force of the ground or of the earlier body on the later one in O, A and "
        "guide, of the slider on the rod in B; moments about the joint; the motion starts at alpha = 0.7 with 30 rad/s under a torque "
        "of 2 on the crank and a push of -30 on the slider",
        PARAMS, states, motion, off, 1e-13)


if __name__ == "__main__":
    main()
