"""Headers and drivers, made once: what lies in the build folder is kept under a name that its contents have given."""

import hashlib
import os
import shutil
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DRIVERS = ROOT / "bench/drivers"
COMPILER = os.environ.get("CXX", "g++")
# The same for all: what a program that wants to be fast is compiled with.
FLAGS = ["-std=c++17", "-O3", "-march=native", "-DNDEBUG"]
# For callgrind, which does not know the newest instructions; and the same instructions on every machine.
PORTABLE_FLAGS = ["-std=c++17", "-O3", "-march=x86-64-v3", "-DNDEBUG"]
SYMBOLS = "with_symbols"  # namespace of the one that stands beside another of the same model in a program
# For what is only counted.
COUNTING_FLAGS = ["-std=c++17", "-O0", "-DCOUNT"]
LINKED = {"mujoco": ["-lmujoco"], "simbody": ["-lSimTKsimbody", "-lSimTKmath", "-lSimTKcommon"]}


class BuildError(RuntimeError):
    pass


def run(command, timeout=None, **more):
    try:
        result = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False,
                                timeout=timeout, **more)
    except subprocess.TimeoutExpired as expired:
        raise BuildError(f"took more than {expired.timeout:.0f} s: {Path(str(command[0])).name}") from expired
    if result.returncode != 0:
        raise BuildError(f"{' '.join(str(word) for word in command)}\nended with {result.returncode}:\n{result.stdout}{result.stderr}")
    return result.stdout


def version(command):
    """The first line of what a program says of its version; empty where there is none."""
    if not shutil.which(command[0]):
        return ""
    return run(command).splitlines()[0].strip()


def digest(*parts):
    found = hashlib.sha256()
    for part in parts:
        found.update(part if isinstance(part, bytes) else str(part).encode())
        found.update(b"\0")
    return found.hexdigest()[:24]


def contents(folder):
    return b"\0".join(path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file())


class Builder:
    def __init__(self, folder, generator, max_seconds):
        self.folder = folder
        self.generator = generator
        self.max_seconds = max_seconds
        self.headers = folder / "headers"
        self.headers.mkdir(parents=True, exist_ok=True)
        self.common = digest(contents(DRIVERS), contents(ROOT / "src"), version([COMPILER, "--version"]), machine_flags())
        self.generator_digest = digest(generator.read_bytes())

    # --- headers -----------------------------------------------------------------------------------------

    def generator_arguments(self, emitted, size, outputs):
        parameters = ["--fold"] if emitted.is_folded else ["--namespace", SYMBOLS]
        counts = ["--count", f"{emitted.count}={size}"] if emitted.count else []
        return [ROOT / f"models/{emitted.model}.yaml", *counts, *parameters, "--outputs", ",".join(outputs)]

    def header(self, emitted, size, outputs=("rhs", "initial_state")):
        """Path and namespace of the emitted code."""
        arguments = self.generator_arguments(emitted, size, outputs)
        model = (ROOT / f"models/{emitted.model}.yaml").read_bytes()
        folder = self.headers / digest(self.generator_digest, model, *arguments[1:])
        found = list(folder.glob("*.hpp"))
        if not found:
            # Into place once it is whole.
            scratch = folder.with_suffix(f".{os.getpid()}")
            scratch.mkdir(parents=True, exist_ok=True)
            try:
                run([self.generator, *arguments, "-o", scratch, "--max-seconds", self.max_seconds], timeout=2 * self.max_seconds)
                scratch.rename(folder)
            finally:
                shutil.rmtree(scratch, ignore_errors=True)
            found = list(folder.glob("*.hpp"))
        return found[0], f"gauss::{found[0].stem}" if emitted.is_folded else SYMBOLS

    # --- objects and programs ----------------------------------------------------------------------------

    def object(self, source, flags, defines=(), includes=(), text=b""):
        """`text`: what is included beside the drivers and src/."""
        command = [COMPILER, *flags, *(f"-D{define}" for define in defines), f"-I{DRIVERS}", f"-I{ROOT / 'src'}",
                   *(f"-I{include}" for include in includes), "-w", "-c", DRIVERS / source]
        path = self.folder / "objects" / f"{digest(self.common, text, *command)}.o"
        if not path.exists():
            path.parent.mkdir(parents=True, exist_ok=True)
            scratch = path.with_suffix(f".{os.getpid()}")
            run([*command, "-o", scratch], timeout=self.max_seconds)
            scratch.rename(path)
        return path

    def emitted_object(self, source, flags, emitted, size, outputs, defines=()):
        header, name_space = self.header(emitted, size, outputs)
        return self.object(source, flags, (f'HEADER="{header}"', f"MODEL={name_space}", f'TOOL="{emitted.tool}"',
                                           *emitted.defines, *defines), [header.parent], header.read_bytes())

    def program(self, name, objects, libraries=()):
        path = self.folder / "programs" / f"{name}_{digest(*objects)}"
        if not path.exists():
            path.parent.mkdir(parents=True, exist_ok=True)
            linked = [flag for library in libraries for flag in LINKED[library]]
            run([COMPILER, *objects, "-o", path, *linked])
        return path

    def library_object(self, library, flags):
        includes = []
        if library == "simbody":
            # Debian's library is compiled without it, and its classes are others with it.
            flags = [flag for flag in flags if flag != "-DNDEBUG"]
            includes = [word[2:] for word in run(["pkg-config", "--cflags-only-I", "simbody"]).split()]
        return self.object(f"{library}.cpp", flags, includes=includes)

    def launcher(self):
        return self.program("launch", [self.object("launch.cpp", ["-std=c++17", "-O2"])])


def machine_flags():
    """What -march=native means here, so that objects of another machine are not taken."""
    return run([COMPILER, "-march=native", "-Q", "--help=target"])


def lanes():
    """Instruction sets of xsimd that this machine has, by how many doubles they take."""
    flags = Path("/proc/cpuinfo").read_text(encoding="utf-8") if Path("/proc/cpuinfo").exists() else ""
    found = {}
    if " avx2 " in flags:
        found[4] = "xsimd::avx2"
    if " avx512f " in flags and " avx512bw " in flags:
        found[8] = "xsimd::default_arch"
    return found
