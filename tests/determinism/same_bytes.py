"""What gauss-gen prints for every model, warnings included, both routes, --fold and both derivations, as hashes that can be compared.

$GAUSS_GEN is the program, $GAUSS_SOURCE_DIR the checkout.
"""

import hashlib
import os
import subprocess
from pathlib import Path

PROGRAM = os.environ["GAUSS_GEN"]
FOLDER = Path(os.environ["GAUSS_SOURCE_DIR"]) / "models"
# Of the families, the ones that take little time at the size of their file.
FAMILIES = ["planar_chain_absolute", "n_four_bar", "balls_in_cylinder"]
MODELS = sorted(path for path in FOLDER.rglob("*.yaml") if path.parent.name != "families" or path.stem in FAMILIES)

# The paper's route takes seconds of these, and would take minutes of fifty processes.
LARGE = {"bicycle", "cart_with_wheels", "iftomm_a02", "robot_arm", *FAMILIES}
BY_PAPER = {"paper", "folded paper", "markdown", "latex", "stages"}

COMMANDS = {
    "emitted": ["{model}", "-o", "-"],
    "folded": ["{model}", "-o", "-", "--fold"],
    "paper": ["{model}", "-o", "-", "--route=paper"],
    "folded paper": ["{model}", "-o", "-", "--route=paper", "--fold"],
    "markdown": ["derivation", "{model}"],
    "latex": ["derivation", "{model}", "--format=latex"],
    "stages": ["{model}", "--dump=model,kinematics,paper,strategy,artefacts"],
    "numbers": ["evaluate", "{model}", "--digits=40"],
}


def run(arguments, **more):
    result = subprocess.run([PROGRAM, *arguments], capture_output=True, check=False, timeout=120, **more)
    if result.returncode != 0:
        raise AssertionError(f"{arguments}: exit code {result.returncode}: {result.stderr.decode()}")
    return hashlib.sha256(result.stdout + result.stderr).hexdigest()


def cases(commands=tuple(COMMANDS), without=frozenset()):
    """Name and arguments of everything that must not change."""
    for model in MODELS:
        for command in commands:
            if model.stem in without or (command in BY_PAPER and model.stem in LARGE):
                continue
            form = COMMANDS[command]
            yield f"{model.stem}, {command}", [part.format(model=model) for part in form]


def hashes(*commands, without=frozenset(), each=map, **more):
    """`each`: map, or that of a pool where a test has several processors."""
    names, arguments = zip(*cases(*commands, without=without))
    return dict(zip(names, each(lambda one: run(one, **more), arguments)))


def differences(expected, found):
    return sorted(name for name in expected if expected[name] != found.get(name))
