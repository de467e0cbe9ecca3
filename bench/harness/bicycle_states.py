"""bicycle_states.py GAUSS_GEN: states of models/bicycle.yaml at which both wheels stand and roll, for bench/drivers/bicycle_states.inc."""

import json
import random
import subprocess
import sys
from pathlib import Path

MODEL = Path(__file__).resolve().parents[2] / "models/bicycle.yaml"
NAMES = ["x", "y", "z", "yaw", "lean", "pitch", "steer", "rear_turn", "front_turn"]


def main():
    random.seed(1817)
    for _ in range(16):
        given = {"lean": random.uniform(-0.3, 0.3), "steer": random.uniform(-0.4, 0.4), "yaw": random.uniform(-3, 3),
                 "dot(lean)": random.gauss(0, 0.5), "dot(steer)": random.gauss(0, 0.5), "dot(rear_turn)": -random.uniform(2, 8) / 0.3}
        words = [word for name, value in given.items() for word in ("--set", f"{name}={value:.6f}")]
        found = json.loads(subprocess.run([sys.argv[1], "evaluate", MODEL, "--format=json", *words], capture_output=True, check=True).stdout)
        assert found["status"] == "ok", found["status"]
        values = [found["state"][name + ending]["value"] for ending in ("", "_dot") for name in NAMES]
        print("{" + ", ".join(values) + "},")


if __name__ == "__main__":
    main()
