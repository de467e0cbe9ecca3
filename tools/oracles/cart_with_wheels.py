#!/usr/bin/python3
"""A cart with two driven wheels and a castor on an incline: three bodies, three places where they stand."""

import random

import numpy as np

import reference_file
from newton_euler import EX, EY, EZ, GROUND, Frame, System, number, real, vec

PARAMS = {"m": "8", "Jx": "0.12", "Jy": "0.25", "Jz": "0.31", "xc": "0.08", "zc": "0.05", "mw": "0.9", "Jw": "0.006", "Jd": "0.0035",
          "r": "0.11", "b": "0.2", "a": "0.3", "slope": "0.2", "g": "9.81"}
P = {key: number(value) for key, value in PARAMS.items()}
NAMES = ["x", "y", "yaw", "left", "right"]


def complete(q, forward, turning):
    """The rates by rolling: the hubs move forwards with the angular velocity of the wheels times r."""
    left, right = (forward - P["b"] * turning) / P["r"], (forward + P["b"] * turning) / P["r"]
    return np.array([*q, forward * np.cos(q[2]), forward * np.sin(q[2]), turning, left, right])


def accelerations(q, u, left_torque, right_torque):
    chassis = Frame(vec(q[0], q[1], P["r"]), v=vec(u[0], u[1], 0)).turned(EZ, q[2], u[2])
    left = chassis.at(P["b"] * EY).turned(EY, q[3], u[3])
    right = chassis.at(-P["b"] * EY).turned(EY, q[4], u[4])
    s = System(P["g"] * vec(-np.sin(P["slope"]), 0, -np.cos(P["slope"])))
    c = s.body(P["m"], [P["Jx"], P["Jy"], P["Jz"]], chassis, vec(P["xc"], 0, P["zc"]))
    ahead, side = chassis.R @ EX, chassis.R @ EY
    turns = []
    for name, wheel, torque in (("left", left, left_torque), ("right", right, right_torque)):
        b = s.body(P["mw"], [P["Jd"], P["Jw"], P["Jd"]], wheel)
        s.hinge(f"{name}_axle", c, b, wheel.r, side)
        directions = (ahead, side, EZ) if name == "left" else (ahead, EZ)
        # A wheel that stays upright touches straight below its hub.
        s.roll(f"{name}_contact", b, wheel.r - P["r"] * EZ, wheel.v, directions)
        s.twist(b, torque * side)
        s.twist(c, -torque * side)
        turns.append(b)
    s.pin("castor", GROUND, c, chassis.r + chassis.R @ vec(P["a"], 0, -P["r"]), (EZ,))
    found, forces = s.solve()
    axle = s.acceleration(found, c, chassis.r)
    alpha = found[c][1]
    return np.array([axle[0], axle[1], alpha[2], *((found[b][1] - alpha) @ side for b in turns)]), forces


def main():
    pick = random.Random(6)
    draw = lambda size: str(round(pick.uniform(-size, size), 3))
    states = []
    for _ in range(5):
        state = complete([real(draw(3)) for _ in NAMES], real(draw(2)), real(draw(2)))
        torques = {"left_torque": draw(3), "right_torque": draw(3)}
        run = lambda t, q, u: accelerations(q, u, *(real(x) for x in torques.values()))
        states.append({"inputs": torques, **reference_file.at_state(NAMES, run, state)})
    # The right wheel turns at 3 rad/s, the cart at -0.6.
    turning = real("-0.6")
    start = complete([real(0), real(0), real("0.5"), real(0), real(0)], 3 * P["r"] - P["b"] * turning, turning)
    run = lambda t, q, u: accelerations(q, u, real("1.5"), real("1.1"))
    motion, off = reference_file.follow(NAMES, run, start, ["0.5", "1", "2", "4"], real("0.125"))
    for entry in states + motion:
        entry["state"].update({"z": P["r"], "z_dot": 0, "pitch": 0, "pitch_dot": 0, "roll": 0, "roll_dot": 0})
    reference_file.write(
        "cart_with_wheels", "Cart with two driven wheels and a castor on an incline",
        "x up the slope, z away from the plane; left and right turn about y of the chassis; forces of the plane on wheels and castor, "
        "all of the sideways force on the left wheel; force and moment of the chassis on the wheels about their hubs; space axes; the "
        "motion starts with right_dot 3, yaw 0.5, yaw_dot -0.6 under torques of 1.5 left and 1.1 right",
        PARAMS, states, motion, off, 1e-13)


if __name__ == "__main__":
    main()
