#!/usr/bin/python3
"""A wagon on a curved track with a pendulum on a rod of given length and a disc behind a clutch; forces with kinks, jumps and tables.

Wagon, bob and disc by themselves; every force of the model acts where its work says: forces along x on the wagon, forces along phi as a
pair across the rod.
"""

import random

import numpy as np

import reference_file
from newton_euler import EX, EY, EZ, GROUND, ZERO, Frame, System, number, real, solve, vec

PARAMS = {"m": "1.5", "l": "1.2", "k": "40", "least": "5", "mu": "0.3", "c": "0.2", "d": "0.2", "e": "1", "a": "1/3", "b": "1", "v": "12",
          "u": "0.05", "w": "1", "tau": "1", "torque": "1", "g": "9.81"}
P = {key: real(1) / 3 if value == "1/3" else number(value) for key, value in PARAMS.items()}
NAMES = ["x", "phi", "spin"]


class Line:
    """Straight between points and, where asked, beyond them."""

    def __init__(self, places, values):
        self.x, self.y = [real(x) for x in places], [real(y) for y in values]

    def slope(self, x):
        k = max(0, min(len(self.x) - 2, sum(1 for place in self.x if place <= x) - 1))
        return (self.y[k + 1] - self.y[k]) / (self.x[k + 1] - self.x[k]), k

    def __call__(self, x):
        slope, k = self.slope(x)
        return self.y[k] + slope * (x - self.x[k])


class Spline(Line):
    """The natural cubic spline (Press et al., Numerical Recipes, section 3.3), by its second derivatives at the points."""

    def __init__(self, places, values):
        super().__init__(places, values)
        n, x, y = len(self.x), self.x, self.y
        matrix, right = np.eye(n, dtype=real), np.zeros(n, dtype=real)
        for i in range(1, n - 1):
            before, after = x[i] - x[i - 1], x[i + 1] - x[i]
            matrix[i, i - 1 : i + 2] = [before / 6, (before + after) / 3, after / 6]
            right[i] = (y[i + 1] - y[i]) / after - (y[i] - y[i - 1]) / before
        self.bend = solve(matrix, right)

    def derivatives(self, x):
        """Value, slope and bend."""
        _, k = Line.slope(self, x)
        h = self.x[k + 1] - self.x[k]
        A, B = (self.x[k + 1] - x) / h, (x - self.x[k]) / h
        M0, M1 = self.bend[k], self.bend[k + 1]
        value = A * self.y[k] + B * self.y[k + 1] + ((A**3 - A) * M0 + (B**3 - B) * M1) * h * h / 6
        slope = (self.y[k + 1] - self.y[k]) / h + ((1 - 3 * A * A) * M0 + (3 * B * B - 1) * M1) * h / 6
        return value, slope, A * M0 + B * M1

    def __call__(self, x):
        return self.derivatives(min(max(x, self.x[0]), self.x[-1]))[0]


third = real(1) / 3
MOTOR = Line([-10, 0, 4, 12], [9, 7.5, 6, 0])
HILL = Spline([-2, -1, 0.5, 1, 3], [real("0.1"), 0, real("0.45"), third, real("-0.2")])
STOP = Line([-1, 0, 1], [0, 0, 30])
GUST = Spline([0, 1, 2, 4], [0, 2, 1, 0])


def along_track(t, x, rate, push):
    """Of the wagon: spring, buffers, dry friction, drag, gust, push."""
    if x < 0:
        spring = -P["k"] * x
    else:
        spring = real(0) if x <= P["l"] / 4 else -max(P["k"] / 4, P["least"]) * (x - P["l"] / 4)
    left, size = STOP(-x - P["b"]), abs(x) / P["b"]
    buffer = -STOP.slope(x - P["b"])[0] + STOP.slope(-x - P["b"])[0] * size - left * np.sign(x) / P["b"]
    return spring + buffer - P["mu"] * P["m"] * P["g"] * np.sign(rate) - P["c"] * abs(rate) * rate + GUST(t) + push


def at_pendulum(phi, rate):
    damper = -min(P["d"], P["d"] / 5, P["e"] * abs(rate)) * rate
    if phi > 0:
        return damper + P["torque"] * np.log(phi) / 50
    return damper + (P["torque"] * np.sqrt(rate / P["w"] - 1) if rate > P["w"] else 0)


def at_disc(t, rate):
    if t <= 0:
        return real(0)
    return MOTOR(rate) * (1 if t >= P["tau"] else np.exp(1 - P["tau"] / t))


def accelerations(t, q, u, push):
    x, phi, _ = q
    height, slope, bend = HILL.derivatives(x)
    swing = 2 * P["w"] * t
    rod, rod_rate, rod_change = (P["l"] + P["u"] * np.sin(P["w"] * t) ** 2, P["u"] * P["w"] * np.sin(swing),
                                 2 * P["u"] * P["w"] ** 2 * np.cos(swing))
    out, over = vec(np.sin(phi), 0, -np.cos(phi)), vec(np.cos(phi), 0, np.sin(phi))
    at, rate = vec(x, 0, height), u[0] * vec(1, 0, slope)
    s = System(-P["g"] * EZ)
    # Particles have no attitude; a moment of inertia of 1 about a mass centre that no moment reaches says nothing.
    wagon = s.body(P["m"], 1, Frame(at, v=rate))
    bob = s.body(P["m"] / 3, 1, Frame(at + rod * out, v=rate + rod_rate * out + rod * u[1] * over))
    disc = s.body(P["m"] / 2, P["m"] * P["l"] ** 2 / 80, Frame(at, v=rate, w=u[2] * EY))
    s.push(wagon, along_track(t, x, u[0], push) * EX)
    across_rod = at_pendulum(phi, u[1]) / rod * over
    s.push(bob, across_rod)
    s.push(wagon, -across_rod)
    s.twist(disc, at_disc(t, u[2]) * EY)

    def row(name, entries, right):
        s._row(name, [(body, direction, ZERO) for body, direction in entries], right)

    normal = vec(-slope, 0, 1)
    row("z", [(wagon, normal)], bend * u[0] ** 2)
    row("r", [(bob, out), (wagon, -out)], rod_change - rod * u[1] ** 2)
    s.pin("hub", wagon, disc, at)
    s.align("hub.moment", wagon, disc, (EX, EZ))
    for body in (wagon, bob):
        row("plane", [(body, EY)], real(0))
    # a spin' = x' + max(x', 0) |x'| / v, differentiated; its force along what it asks of x' and spin' (Chetaev).
    asked = 1 + 2 * max(u[0], real(0)) / P["v"]
    s._row("clutch", [(disc, ZERO, P["a"] * EY), (wagon, -asked * EX, ZERO)], real(0))
    found, forces = s.solve()
    a_wagon, a_bob, alpha = found[wagon][0], found[bob][0], found[disc][1]
    turning = ((a_bob - a_wagon) @ over - 2 * rod_rate * u[1]) / rod
    multiplier = forces["clutch"][1] / P["a"]
    return np.array([a_wagon[0], turning, alpha[1]]), {
        # The track carries wagon, disc and bob where it lifts: what its normal force does per height.
        "z": vec(0, 0, forces["z"][2]), "r": forces["r"], "clutch": vec(-asked * multiplier, 0, 0)}


def main():
    # One on each side of every kink and jump: x about 0, 0.3 and the buffers at -1 and 1, phi about 0, each rate about 0, t about 0 and 1.
    pick = random.Random(10)
    states = []
    for x in ("-1.6", "-0.7", "0.15", "0.8", "1.3", "2.6"):
        for phi, phi_dot, x_dot, t in (("0.6", "-0.02", "1.7", "0.4"), ("-0.6", "2.3", "-1.3", "1.5"), ("-0.9", "0.4", "0.3", "2.7"),
                                       ("1.2", "-1.7", "-0.4", "0")):
            vary = lambda text: real(str(round(float(text) * pick.uniform(0.9, 1.1), 4)))
            rate = vary(x_dot)
            spin_dot = (rate + max(rate, real(0)) * abs(rate) / P["v"]) / P["a"]
            state = np.array([vary(x), vary(phi), vary("0.5"), rate, vary(phi_dot), spin_dot])
            inputs = {"push": str(round(pick.uniform(-3, 3), 2))}
            run = lambda t, q, u: accelerations(t, q, u, real(inputs["push"]))
            states.append({"inputs": inputs, **reference_file.at_state(NAMES, run, state, real(t))})
    reference_file.write(
        "functions", "Wagon, pendulum and disc under forces with kinks, jumps and tables",
        "x along the track, phi from the downward vertical towards x; `z` vertical component of the force of the track, `r` force of the rod "
        "on the bob, `clutch` its generalized force along x as the first component", PARAMS, states, [], 0, 1e-13)


if __name__ == "__main__":
    main()
