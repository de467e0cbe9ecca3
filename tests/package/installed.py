"""gauss installed into a folder of its own, as `cmake --install` does it."""

import os
import subprocess

CMAKE = os.environ["CMAKE"]
BINARY = os.environ["GAUSS_BINARY_DIR"]


def run(*command):
    result = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            check=False, timeout=300)
    if result.returncode != 0:
        raise AssertionError(f"{command}:\n{result.stdout}")
    return result.stdout


def install(prefix):
    run(CMAKE, "--install", BINARY, "--prefix", prefix)
