#!/usr/bin/python3
"""A heavy rotor in a massless gimbal on a platform that a drive turns as a law in time says."""

import random

import numpy as np

import reference_file
from newton_euler import EX, EZ, GROUND, ZERO, Frame, System, cross, number, real

PARAMS = {"m": "2.4", "l": "0.15", "Ixx": "0.021", "Iyy": "0.018", "Izz": "0.035", "Ixz": "0.002", "g": "9.81", "rate": "2",
          "swing": "0.3", "frequency": "5", "d": "0.05"}
P = {key: number(value) for key, value in PARAMS.items()}
NAMES = ["gimbal", "spin"]


def accelerations(t, q, u, motor):
    swing, frequency = P["swing"], P["frequency"]
    angle = P["rate"] * t + swing * np.sin(frequency * t)
    rate = P["rate"] + swing * frequency * np.cos(frequency * t)
    change = -swing * frequency**2 * np.sin(frequency * t)
    platform = Frame().turned(EZ, angle, rate)
    gimbal = platform.turned(EX, q[0], u[0])
    rotor = gimbal.turned(EZ, q[1], u[1])
    bearing, axle = gimbal.R @ EX, rotor.R @ EZ
    s = System(-P["g"] * EZ)
    r = s.body(P["m"], [[P["Ixx"], 0, P["Ixz"]], [0, P["Iyy"], 0], [P["Ixz"], 0, P["Izz"]]], rotor, P["l"] * EZ)
    s.pin("centre", GROUND, r, rotor.r)
    # Without mass, the gimbal passes on: the motor about the axle, the damper about the bearing, and the drive across both.
    passed_on = motor * axle - P["d"] * u[0] * bearing
    s.twist(r, passed_on)
    across = cross(bearing, axle)
    carried = change * EZ + cross(platform.w, bearing * u[0]) + cross(gimbal.w, axle * u[1])
    s._row("drive", [(r, ZERO, across)], carried @ across)
    found, forces = s.solve()
    own = found[0][1] - carried
    about_vertical = (forces.pop("drive") + passed_on) @ EZ
    return np.array([own @ bearing, own @ axle]), {**forces, "platform": [ZERO[0], ZERO[0], about_vertical]}


def main():
    pick = random.Random(8)
    draw = lambda size: str(round(pick.uniform(-size, size), 3))
    states = []
    for _ in range(5):
        inputs, t = {"motor": draw(1)}, abs(real(draw(3)))
        state = np.array([real(draw(3)), real(draw(3)), real(draw(5)), real(draw(60))])
        run = lambda t, q, u: accelerations(t, q, u, real(inputs["motor"]))
        states.append({"inputs": inputs, **reference_file.at_state(NAMES, run, state, t)})
    start = np.array([real(x) for x in ("0.7", "0.1", "0.4", "30")])
    run = lambda t, q, u: accelerations(t, q, u, real("0.2"))
    motion, off = reference_file.follow(NAMES, run, start, ["0.25", "0.5", "1", "2"], real("0.015625"))
    reference_file.write(
        "rotor_on_platform", "Rotor in a massless gimbal on a driven platform",
        "3-1-3 angles platform, gimbal, spin; `platform` is the moment of its drive about the vertical, as the last component of a vector; "
        "`centre` the force on the rotor where the axes cross, in space axes; motion under a motor torque of 0.2",
        PARAMS, states, motion, off, 1e-13)


if __name__ == "__main__":
    main()
