#!/usr/bin/python3
"""Two pendulums with a law in time: of the length (in x and z, where Newton's law needs no polar terms), and of the pivot."""

import random

import numpy as np

import reference_file
from newton_euler import EY, EZ, GROUND, Frame, System, across, number, real, vec

LENGTH = {"m": "0.4", "l": "0.9", "stroke": "0.15", "Omega": "6.2", "g": "9.81"}
PIVOT = {"m": "0.3", "l": "0.4", "stroke": "0.02", "Omega": "200", "g": "9.81"}


def varying_length(t, q, u):
    """The bob in x and z; along the rod its place, velocity and acceleration follow the law of the length."""
    p = {key: number(value) for key, value in LENGTH.items()}
    r = p["l"] + p["stroke"] * np.sin(p["Omega"] * t)
    r1 = p["stroke"] * p["Omega"] * np.cos(p["Omega"] * t)
    r2 = -p["stroke"] * p["Omega"] ** 2 * np.sin(p["Omega"] * t)
    n, across_n = np.array([np.sin(q[0]), -np.cos(q[0])]), np.array([np.cos(q[0]), np.sin(q[0])])
    v = r1 * n + r * u[0] * across_n
    # r r' = x.v, differentiated: r'^2 + r r'' = v.v + x.a
    along = (r1 * r1 + r * r2 - v @ v) / r
    gravity = np.array([real(0), -p["g"]])
    force = p["m"] * (along - n @ gravity)
    a = gravity + force / p["m"] * n
    # x across_n stays 0 in the turning axes: a.across_n = r theta'' + 2 r' theta'
    return np.array([(a @ across_n - 2 * r1 * u[0]) / r]), {"rod": vec(force * n[0], 0, force * n[1])}


def moving_pivot(t, q, u):
    p = {key: number(value) for key, value in PIVOT.items()}
    h = p["stroke"] * np.cos(p["Omega"] * t)
    shaker = Frame(r=h * EZ, v=-p["stroke"] * p["Omega"] * np.sin(p["Omega"] * t) * EZ)
    s = System(-p["g"] * EZ)
    rod = s.body(p["m"], p["m"] * p["l"] ** 2 / 12, shaker.turned(EY, q[0], u[0]), p["l"] / 2 * EZ)
    s.pin("pivot", GROUND, rod, shaker.r, moves=-(p["Omega"] ** 2) * h * EZ)
    s.align("pivot.moment", GROUND, rod, across(EY))
    found, forces = s.solve()
    return np.array([found[0][1] @ EY]), forces


def make(name, title, conventions, params, accelerations, start, times, step, seed):
    pick = random.Random(seed)
    states = []
    for _ in range(4):
        draw = lambda size: real(str(round(pick.uniform(-size, size), 3)))
        state, t = np.array([draw(3), draw(6)]), abs(draw(2))
        states.append({**reference_file.at_state(["theta"], accelerations, state, t), "t": t})
    start = np.array([real(x) for x in start])
    motion, off = reference_file.follow(["theta"], accelerations, start, times, step)
    reference_file.write(name, title, conventions, params, states, motion, off, 1e-13)


def main():
    make("pendulum_varying_length", "Pendulum with a length that is given in time",
         "theta from the downward vertical z towards x; force of the rod on the bob, in space axes", LENGTH, varying_length,
         ["0.4", "0"], ["0.5", "1", "2", "5"], real("0.05"), 4)
    make("pendulum_moving_pivot", "Rod on a pivot that shakes vertically",
         "theta about y from the upward vertical z; force and moment of the pivot on the rod, in space axes", PIVOT, moving_pivot,
         ["0.15", "0"], ["0.1", "0.25", "0.5", "1"], real("0.004"), 5)


if __name__ == "__main__":
    main()
