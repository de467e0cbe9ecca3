#!/usr/bin/python3
"""The benchmark bicycle: four bodies, two axles, a steering axis and two rims that roll, by Newton and Euler."""

import json
import random

import numpy as np

import reference_file
from newton_euler import EX, EY, EZ, Frame, System, cross, number, pi, real, solve, vec

PARAMS = json.loads((reference_file.FOLDER / "bicycle_whipple_linear.json").read_text())["params"]
P = {key: number(value) for key, value in PARAMS.items()}
NAMES = ["x", "y", "yaw", "lean", "pitch", "steer", "rear_turn", "front_turn"]
DEPENDENT = ["x", "y", "yaw", "pitch", "front_turn"]
AXIS = vec(np.sin(P["lam"]), 0, np.cos(P["lam"]))


def symmetric(part):
    xx, yy, zz, xz = (P[f"I{part}{e}"] for e in ("xx", "yy", "zz", "xz"))
    return [[xx, 0, xz], [0, yy, 0], [xz, 0, zz]]


def lowest(wheel, axle, radius):
    """Where a rim touches: straight down within the plane of the wheel; and how that place moves."""
    e, e_rate = axle, cross(wheel.w, axle)
    down = EZ - (EZ @ e) * e
    rate = -(EZ @ e_rate) * e - (EZ @ e) * e_rate
    size = np.sqrt(down @ down)
    n = down / size
    return wheel.r + radius * n, wheel.v + radius * (rate - (n @ rate) * n) / size


def frames(q, u):
    value, rate = dict(zip(NAMES, q)), dict(zip(NAMES, u))
    contact = Frame(vec(value["x"], value["y"], 0), v=vec(rate["x"], rate["y"], 0))
    leaning = contact.turned(EZ, value["yaw"], rate["yaw"]).turned(EX, value["lean"], rate["lean"])
    hub = leaning.at(-P["rR"] * EZ)
    rear = hub.turned(EY, value["pitch"], rate["pitch"])
    rear_wheel = rear.turned(EY, value["rear_turn"], rate["rear_turn"])
    # The steering axis meets the plane ahead of the front contact by the trail, while the bicycle stands upright.
    steering = rear.at(vec(P["w"] + P["c"], 0, P["rR"]))
    front = steering.turned(AXIS, value["steer"], rate["steer"])
    front_hub = front.at(vec(-P["c"], 0, -P["rF"]))
    return rear, rear_wheel, front, front_hub.turned(EY, value["front_turn"], rate["front_turn"])


def system(q, u, torque=0):
    rear, rear_wheel, front, front_wheel = frames(q, u)
    s = System(P["g"] * EZ)
    b = s.body(P["mB"], symmetric("B"), rear, vec(P["xB"], 0, P["zB"] + P["rR"]))
    h = s.body(P["mH"], symmetric("H"), front, vec(P["xH"] - P["w"] - P["c"], 0, P["zH"]))
    r = s.body(P["mR"], [P["IRxx"], P["IRyy"], P["IRxx"]], rear_wheel)
    f = s.body(P["mF"], [P["IFxx"], P["IFyy"], P["IFxx"]], front_wheel)
    s.hinge("rear_axle", b, r, rear_wheel.r, rear.R @ EY)
    s.hinge("head_set", b, h, front.r, rear.R @ AXIS)
    s.hinge("front_axle", h, f, front_wheel.r, front.R @ EY)
    s.roll("rear_contact", r, *lowest(rear_wheel, rear.R @ EY, P["rR"]))
    s.roll("front_contact", f, *lowest(front_wheel, front.R @ EY, P["rF"]))
    s.twist(h, torque * (rear.R @ AXIS))
    s.twist(b, -torque * (rear.R @ AXIS))
    return s


def accelerations(q, u, torque=0):
    s = system(q, u, torque)
    found, forces = s.solve()
    (_, b), (_, h), (r_a, r), (_, f) = found
    rear, rear_wheel, front, _ = frames(q, u)
    yaw, lean = q[2], q[3]
    # Of the rear body: alpha = sum of e_k q_k'' and of what turns the axes e_k.
    ahead = vec(np.cos(yaw), np.sin(yaw), 0)
    side = rear.R @ EY
    drift = cross(u[2] * EZ, u[3] * ahead) + cross(u[2] * EZ + u[3] * ahead, u[4] * side)
    yaw_a, lean_a, pitch_a = solve(np.array([EZ, ahead, side]).T, b - drift)
    # The contact is at the wheel's centre plus rR times the axis z of `leaning`, which turns without the pitch.
    down = cross(ahead, side)
    w, w_rate = u[2] * EZ + u[3] * ahead, yaw_a * EZ + lean_a * ahead + cross(u[2] * EZ, u[3] * ahead)
    contact = r_a + P["rR"] * (cross(w_rate, down) + cross(w, cross(w, down)))
    turns = [(h - b) @ (rear.R @ AXIS), (r - b) @ side, (f - h) @ (front.R @ EY)]
    forces["head_set.moment"] = forces["head_set.moment"] + torque * (rear.R @ AXIS)
    return np.array([contact[0], contact[1], yaw_a, lean_a, pitch_a, *turns]), forces


def complete(value, rate):
    """The pitch that puts the front rim onto the plane, then the rates that rolling determines."""
    q = np.array([real(value.get(n, 0)) for n in NAMES])
    for _ in range(8):
        rears = frames(q, np.zeros(8, dtype=real)), frames(q, np.eye(8, dtype=real)[4])
        place, _ = lowest(rears[0][3], rears[0][2].R @ EY, P["rF"])
        slope = (rears[1][3].v + cross(rears[1][3].w, place - rears[1][3].r))[2]
        q[4] -= place[2] / slope
    rows = lambda u: np.array(sum((system(q, u).velocities(n) for n in ("rear_contact", "front_contact")), []))
    given = np.array([real(rate.get(n, 0)) for n in NAMES])
    columns = [NAMES.index(n) for n in DEPENDENT]
    # Six rows, of which the vertical one of the rear wheel says nothing.
    keep = [0, 1, 3, 4, 5]
    matrix = np.array([rows(np.eye(8, dtype=real)[k])[keep] for k in columns]).T
    u = given.copy()
    u[columns] = solve(matrix, -rows(given)[keep])
    return np.concatenate([q, u])


def random_states():
    pick = random.Random(1)
    for _ in range(5):
        draw = lambda size: str(round(pick.uniform(-size, size), 3))
        value = {"x": draw(2), "y": draw(2), "yaw": draw(3), "lean": draw(0.6), "steer": draw(0.7)}
        rate = {"lean": draw(1), "steer": draw(2), "rear_turn": str(-round(pick.uniform(5, 20), 3))}
        yield complete(value, rate), draw(3)


def published():
    """Basu-Mandal, Chatterjee, Papadopoulos 2007, Table 1: their psi counts from the horizontal, and their turns are opposite."""
    state = complete(
        {"lean": pi / 2 - real("0.9501292851472"), "steer": "-0.2311385135743"},
        {"lean": "-0.6068425835418", "steer": "-0.4859824687093", "rear_turn": "-8.9129896614890"})
    found = {"yaw": "-0.8353281706379", "lean": "7.8555281128244", "pitch": "-0.1205543897884",
             "steer": "4.6198904039403", "rear_turn": "-1.8472554144217", "front_turn": "-2.4548072904550"}
    return {"t": 0, "state": {**reference_file.state_entry(NAMES, state), "z": 0, "z_dot": 0},
            "accelerations": {f"{n}_ddot": a for n, a in found.items()},
            "source": "Basu-Mandal, Chatterjee, Papadopoulos 2007, Proc. R. Soc. A 463:1983-2003, Table 1"}


def main():
    states = []
    for state, torque in random_states():
        entry = reference_file.at_state(NAMES, lambda t, q, u: accelerations(q, u, real(torque)), state)
        states.append({"inputs": {"steer_torque": torque}, **entry})
    start = complete({"lean": "0.1", "steer": "-0.05"}, {"rear_turn": -5 / P["rR"]})
    motion, off = reference_file.follow(NAMES, lambda t, q, u: accelerations(q, u), start, ["0.25", "0.5", "1", "2"], real("0.125"))
    for entry in states + motion:
        entry["state"].update(z=0, z_dot=0)
    reference_file.write(
        "bicycle",
        "Carvallo-Whipple benchmark bicycle, nonlinear",
        "x forward, y right, z down; pitch, rear_turn and front_turn about y; forces of the plane on the wheels and of the first "
        "named body on the second, in space axes; the motion starts without turns, with lean 0.1, steer -0.05, 5 m/s",
        PARAMS, states, motion, off, 1e-13, published=published())


if __name__ == "__main__":
    main()
