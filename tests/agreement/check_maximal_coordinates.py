"""Random mechanisms through gauss-gen and a compiler, held against a hundred digits by maximal_coordinates.

Usage: check_maximal_coordinates.py GAUSS_GEN MAXIMAL_COORDINATES CXX [COUNT]; GAUSS_SEED in the environment begins elsewhere.
"""

import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile

FIRST_SEED = 20261124
MODELS_A_UNIT = 10
MOST_TRIED = 2  # times as many as are wanted
PARTS = os.cpu_count() or 1

CALL = """
extern "C" int gauss_{name}(double t, double* state, double* accelerations, double* reactions, int* statuses) {{
  namespace model = gauss::{name};
  const auto prepared = model::prepare(model::Parameters<double>{{}});
  const model::Inputs<double> inputs{{}};
  model::State<double> y{{}};
  for (int i = 0; i < model::n_q + model::n_v; ++i) y.values[i] = state[i];
{project}  model::Derivative<double> derivative{{}};
  statuses[0] = static_cast<int>(rhs(t, y, inputs, prepared, derivative));
  for (int i = 0; i < model::n_v; ++i) accelerations[i] = derivative.values[model::n_q + i];
  for (int i = 0; i < model::n_v; ++i) reactions[i] = 0;
{reactions}  return model::n_v;
}}
"""

# A state that no search brings onto the constraints stays as it is.
PROJECT = """  model::State<double> projected{};
  statuses[2] = static_cast<int>(project(t, y, prepared, projected));
  if (statuses[2] == 0 || statuses[2] == 2) y = projected;
  for (int i = 0; i < model::n_q + model::n_v; ++i) state[i] = y.values[i];
"""

REACTIONS = """  model::Reactions<double> found{{}};
  statuses[1] = static_cast<int>(model::reactions(t, y, inputs, prepared, found));
  for (int i = 0; i < model::n_v; ++i) {{
{sums}  }}
"""


def run(command: list[str]) -> subprocess.CompletedProcess:
    return subprocess.run(command, capture_output=True, text=True, check=False)


def call(header: pathlib.Path) -> str:
    """A function with a plain interface; members of Reactions that have no force along speeds are held coordinates."""
    text = header.read_text(encoding="utf-8")
    if " rhs(" not in text:
        return ""  # all is held: nothing is to be found
    members = re.findall(r"S generalized\[\d+\];[^}]*\} (\w+);", text)
    sums = "".join(f"    reactions[i] += found.{member}.generalized[i];\n" for member in members)
    project = PROJECT if " project(" in text else ""
    reactions = REACTIONS.format(sums=sums) if members else ""
    return CALL.format(name=header.stem, project=project, reactions=reactions)


def compiled(unit: pathlib.Path, compiler: str) -> pathlib.Path:
    target = unit.with_suffix(".o")
    # Sums in the order of the source: a multiply-add would be another arithmetic than the one that is promised.
    done = run([compiler, "-std=c++17", "-O0", "-ffp-contract=off", "-fPIC", "-c", str(unit), "-o", str(target)])
    if done.returncode != 0:
        raise SystemExit(f"{unit} does not compile:\n{done.stderr}")
    return target


def are_right(parts: list[subprocess.CompletedProcess]) -> bool:
    """Whether nothing is wrong in any part, and all of them together say enough."""
    total = [0] * 5
    for part in parts:
        print(part.stdout + part.stderr, flush=True)
        counted = re.search(r"(?m)^counted: (.*)$", part.stdout)
        if part.returncode != 0 or not counted:
            return False
        total = [a + int(b) for a, b in zip(total, counted[1].split())]
    models, refused, states, compared, left_open = total
    print(f"{models} mechanisms, {refused} refused; {states} states, {compared} compared, {left_open} left open")
    return refused <= models // 2 and compared >= states * 3 // 5 and left_open <= states // 20


def main() -> int:
    generator, checker, compiler = sys.argv[1:4]
    count = int(sys.argv[4]) if len(sys.argv) > 4 else 200
    seed = int(os.environ.get("GAUSS_SEED", FIRST_SEED))
    print(f"random mechanisms: {count} from seed {seed} on", flush=True)
    with tempfile.TemporaryDirectory() as name, concurrent.futures.ThreadPoolExecutor(PARTS) as pool:
        folder = pathlib.Path(os.environ.get("GAUSS_KEEP", name))
        folder.mkdir(exist_ok=True)
        most = MOST_TRIED * count
        subprocess.run([checker, "write", str(seed), str(most), str(folder)], check=True)

        def generate(number: int) -> pathlib.Path | None:
            model = folder / f"m{number}.yaml"
            done = run([generator, "--outputs", "rhs,reactions,project", "-o", str(folder), str(model)])
            if done.returncode not in (0, 1):
                raise SystemExit(f"{model}: exit code {done.returncode}\n{done.stderr}")
            if done.returncode == 1 and "GAUSS_VERBOSE" in os.environ:
                print(f"seed {number}:\n{done.stderr}")
            return model.with_suffix(".hpp") if done.returncode == 0 else None

        # Some are refused, as where nothing can move: the next ones take their places.
        headers, tried = [], 0
        while len(headers) < count and tried < most:
            more = range(seed + tried, seed + min(tried + count - len(headers), most))
            headers += [header for header in pool.map(generate, more) if header]
            tried += len(more)
        units = []
        for i in range(0, len(headers), MODELS_A_UNIT):
            some = headers[i : i + MODELS_A_UNIT]
            unit = folder / f"unit{i}.cpp"
            includes = "".join(f'#include "{header.name}"\n' for header in some)
            unit.write_text(includes + "".join(map(call, some)), encoding="utf-8")
            units.append(unit)
        objects = list(pool.map(lambda unit: compiled(unit, compiler), units))
        library = folder / "mechanisms.so"
        subprocess.run([compiler, "-shared", "-o", str(library), *map(str, objects)], check=True)
        # A range of seeds for each processor.
        bounds = [seed + tried * i // PARTS for i in range(PARTS + 1)]
        parts = pool.map(lambda a, b: run([checker, "check", str(a), str(b - a), str(library)]), bounds, bounds[1:])
        return 0 if are_right(list(parts)) else 1


if __name__ == "__main__":
    sys.exit(main())
