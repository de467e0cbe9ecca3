#!/usr/bin/python3
"""A six-axis arm with a gripper: eight bodies and a load, each with its own equations, joined by hinges and slides."""

import random

import numpy as np

import reference_file
from newton_euler import EX, EY, EZ, GROUND, Frame, System, across, cross, number, real, unit, vec

PARAMS = {"h": "0.4", "l2": "0.42", "l3": "0.38", "l5": "0.09", "load": "0.6", "g": "9.81"}
P = {key: number(value) for key, value in PARAMS.items()}
INPUTS = ["tau1", "tau2", "tau3", "tau4", "tau5", "tau6", "grip1", "grip2"]
NAMES = ["q1", "q2", "q3", "q4", "q5", "q6", "s1", "s2"]
# joint, body, parent, place in the parent, axis, mass, centre, moments of inertia xx xy xz yy yz zz
LINKS = [
    ("base", "column", None, (0, 0, 0), EZ, "12", ("0.01", "-0.02", "0.25"), ("0.35", "0.01", "-0.02", "0.33", "0.015", "0.12")),
    ("shoulder", "upper", "column", ("0.03", 0, "0.4"), EY, "7.5", ("0.02", "0.06", "0.2"),
     ("0.14", "-0.004", "0.006", "0.15", "0.003", "0.03")),
    ("elbow", "fore", "upper", (0, 0, "0.42"), EY, "4.2", ("0.03", "-0.05", "0.15"),
     ("0.06", "0.002", "-0.003", "0.058", "0.001", "0.012")),
    ("roll", "tube", "fore", ("0.05", 0, "0.38"), EZ, "1.6", ("0.005", "0.01", "-0.04"),
     ("0.004", "1e-4", "-2e-4", "0.0045", "3e-4", "0.002")),
    ("wrist", "hand", "tube", (0, 0, 0), EY, "1.1", (0, "-0.01", "0.03"), ("0.0021", "-1e-4", "5e-5", "0.0018", "1e-4", "0.0012")),
    ("flange", "tool", "hand", (0, 0, "0.09"), EZ, "0.8", ("0.01", "0.005", "0.04"),
     ("0.0011", "4e-5", "-3e-5", "9e-4", "2e-5", "6e-4")),
    ("left", "left_finger", "tool", (0, "0.01", "0.08"), EY, "0.15", (0, 0, "0.03"), ("6e-5", 0, 0, "5e-5", 0, "2e-5")),
    ("right", "right_finger", "tool", (0, "-0.01", "0.08"), -EY, "0.15", (0, 0, "0.03"), ("6e-5", 0, 0, "5e-5", 0, "2e-5")),
]
SLIDES = ("left", "right")


def matrix(moments):
    xx, xy, xz, yy, yz, zz = (real(m) for m in moments)
    return [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]


def slide(s, name, parent, child, place, axis, rate):
    """No relative motion but along the axis, which turns with the parent: Coriolis's acceleration comes in."""
    n = across(axis)
    s.pin(name, parent, child, place, n, moves=2 * rate * cross(s.frame(parent).w, axis))
    s.align(name + ".moment", parent, child, (EX, EY, EZ))


def accelerations(q, u, drives):
    s = System(-P["g"] * EZ)
    frames, numbers, axes = {None: Frame()}, {None: GROUND}, []
    for (joint, name, parent, place, axis, mass, centre, moments), value, rate in zip(LINKS, q, u):
        seat = frames[parent].at(vec(*place))
        e = seat.R @ unit(axis)
        frames[name] = seat.slid(axis, value, rate) if joint in SLIDES else seat.turned(axis, value, rate)
        b = numbers[name] = s.body(mass, matrix(moments), frames[name], vec(*centre))
        if joint in SLIDES:
            slide(s, joint, numbers[parent], b, frames[name].r, e, rate)
        else:
            s.hinge(joint, numbers[parent], b, seat.r, e)
        axes.append((joint, numbers[parent], b, e, frames[name].r))
    load = s.body(P["load"], 0, frames["left_finger"], vec(0, "-0.01", "0.06"))
    s.pin("grasp", numbers["left_finger"], load, s.frame(load).r)
    s.align("grasp.moment", numbers["left_finger"], load, (EX, EY, EZ))
    for (joint, parent, b, e, place), drive in zip(axes, drives):
        for body, sign in ((b, 1), (parent, -1)):
            s.push(body, sign * drive * e, place) if joint in SLIDES else s.twist(body, sign * drive * e)
    found, forces = s.solve()
    result = []
    for (joint, parent, b, e, place), drive, rate in zip(axes, drives, u):
        if joint in SLIDES:
            moved = s.acceleration(found, b, place) - s.acceleration(found, parent, place)
            forces[joint] = forces[joint] + drive * e
        else:
            moved = found[b][1] - (0 if parent is GROUND else found[parent][1])
            forces[joint + ".moment"] = forces[joint + ".moment"] + drive * e
        result.append(moved @ e)
    return np.array(result), {name: force for name, force in forces.items() if not name.startswith("grasp")}


def main():
    pick = random.Random(7)
    draw = lambda size: str(round(pick.uniform(-size, size), 3))
    states = []
    for _ in range(4):
        state = np.array([real(draw(size)) for size in [3] * 6 + [0.04] * 2 + [4] * 6 + [0.5] * 2])
        drives = {name: draw(size) for name, size in zip(INPUTS, [40, 60, 30, 5, 5, 2, 10, 10])}
        run = lambda t, q, u: accelerations(q, u, [real(x) for x in drives.values()])
        states.append({"inputs": drives, **reference_file.at_state(NAMES, run, state)})
    start = np.array([real(x) for x in ("0.3", "0.4", "0.9", "-0.5", "0.7", "0.2", "0.02", "0.015",
                                        "0.5", "-0.4", "0.8", "1", "-1.2", "2", "0.1", "-0.05")])
    drives = [real(x) for x in ("3", "-60", "-15", "0.5", "-1", "0.2", "4", "-2")]
    run = lambda t, q, u: accelerations(q, u, drives)
    motion, off = reference_file.follow(NAMES, run, start, ["0.1", "0.2", "0.3"], real("0.02"))
    reference_file.write(
        "robot_arm", "Six-axis arm with a two-finger gripper",
        "angles and shifts of the joints; force and moment on the later body of each joint about its origin, what the motor there "
        "exerts included, in space axes; the motion starts at the initial state and inputs of models/robot_arm.yaml",
        PARAMS, states, motion, off, 1e-13)


if __name__ == "__main__":
    main()
