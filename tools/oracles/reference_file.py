"""Writes tests/reference/NAME.json: parameters, states with their accelerations and forces, a motion."""

import json
import platform
from pathlib import Path

import numpy as np

from newton_euler import integrate, real

FOLDER = Path(__file__).resolve().parents[2] / "tests" / "reference"
HOW = (
    "Newton-Euler equations of every body by itself, with the forces and moments of all joints as unknowns, solved at once in "
    "long double; motion by Gragg's extrapolation"
)


def text(value):
    """19 digits, which is what long double has; structures keep their shape."""
    if isinstance(value, dict):
        return {key: text(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)) or (isinstance(value, np.ndarray) and value.ndim):
        return [text(entry) for entry in value]
    if isinstance(value, str) or isinstance(value, int):
        return value
    return np.format_float_scientific(real(value), precision=18, unique=False)


def named(names, values):
    return dict(zip(names, values))


def rates_of(names):
    return [name + "_dot" for name in names]


def state_entry(names, speeds, state):
    n = len(names)
    return {**named(names, state[:n]), **named(speeds, state[n:])}


def follow(names, accelerations, start, times, step, speeds=None, rates=lambda q, u: u):
    """Samples of the motion, and by how much they change with half the step. accelerations(t, q, u) -> (u', forces); u are the
    rates of q unless `speeds` names them and rates(q, u) gives q'."""
    n, speeds = len(names), speeds or rates_of(names)

    def rate(t, y):
        return np.concatenate([rates(y[:n], y[n:]), accelerations(t, y[:n], y[n:])[0]])

    fine = integrate(rate, start, times, step / 2)
    coarse = integrate(rate, start, times, step)
    off = max(float(np.max(np.abs(a - b))) for a, b in zip(fine, coarse))
    samples = []
    for t, y in zip(times, fine):
        samples.append({"t": t, "state": state_entry(names, speeds, y), "forces": accelerations(real(t), y[:n], y[n:])[1]})
    return samples, off


def at_state(names, accelerations, state, t=0, speeds=None):
    """An acceleration is named after its speed: x_ddot after x_dot, p_dot after p."""
    n, speeds = len(names), speeds or rates_of(names)
    found, forces = accelerations(real(t), state[:n], state[n:])
    changes = [speed[:-4] + "_ddot" if speed.endswith("_dot") else speed + "_dot" for speed in speeds]
    return {"t": t, "state": state_entry(names, speeds, state), "accelerations": named(changes, found), "forces": forces}


def write(name, title, conventions, params, states, motion, off, tolerance, published=None):
    content = {
        "name": title,
        "source": ["own derivation"],
        "units": "SI",
        "conventions": conventions,
        "params": params,
        "expected": {"states": text(states), "motion": text(motion), "tolerance": tolerance},
        "verified": {
            "how": HOW,
            "script": f"tools/oracles/{name}.py",
            "versions": f"Python {platform.python_version()}, numpy {np.__version__}",
            "motion_changes_with_half_the_step": off,
        },
    }
    if published:
        content["expected"]["published"] = text(published)
    path = FOLDER / f"{name}.json"
    path.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")
    print(f"{path.name}: half the step changes {off:.1e}")
