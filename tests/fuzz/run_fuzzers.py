"""Builds the fuzzers with clang (preset `fuzz`) and runs them: run_fuzzers.py [--seconds N] [--fresh].

Exit code 0: nothing found, 1: something found (its path is printed), 77: this machine cannot build fuzzers.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "fuzz"
FINDINGS = BUILD / "findings"
SEEDS = [ROOT / "models", ROOT / "tests" / "diagnostics"]
SKIPPED = 77

# An input may take 2 s and 512 MB. Instrumented code is five to ten times slower, and processors of a busy machine, which share what a
# core has, are half as fast: models/cart_with_wheels.yaml takes 1.1 s as it is and more than 10 s there. Checks and what they keep
# back of freed memory take 512 MB more.
SECONDS = 30
LIMITS = [f"-timeout={SECONDS}", "-rss_limit_mb=1024", "-malloc_limit_mb=512"]


def say(text):
    print(f"fuzz: {text}", flush=True)


def has_libfuzzer():
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "empty.cpp"
        source.write_text('extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }\n')
        command = ["clang++", "-fsanitize=fuzzer,address,undefined", str(source), "-o", str(source.with_suffix(""))]
        try:
            return subprocess.run(command, capture_output=True, check=False).returncode == 0
        except OSError:
            return False


def build(*targets):
    """All of the preset, or these targets."""
    launcher = "ccache" if shutil.which("ccache") else ""
    configure = ["cmake", "--preset", "fuzz", f"-DCMAKE_CXX_COMPILER_LAUNCHER={launcher}"]
    compile_all = ["cmake", "--build", "--preset", "fuzz", "--parallel", str(os.cpu_count() or 1),
                   *(["--target", *targets] if targets else [])]
    for command in (configure, compile_all):
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(done.stdout[-4000:] + done.stderr[-4000:])


def expressions():
    """A folder with what stands behind colons and in lists of all seeds: beginnings for the reader of expressions."""
    folder = BUILD / "seeds"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    found = set()
    for path in sorted(path for seeds in SEEDS for path in seeds.rglob("*.yaml")):
        text = path.read_text(encoding="utf-8", errors="ignore")
        found.update(piece.strip(" \"'") for piece in re.findall(r"[:\[,] *([^\[\]{},\n]{2,200})", text))
    for number, piece in enumerate(sorted(found)):
        (folder / f"{number}").write_text(piece, encoding="utf-8")
    return [folder]


def environment():
    quiet = {"ASAN_OPTIONS": "quarantine_size_mb=16:allocator_may_return_null=0",
             "UBSAN_OPTIONS": "print_stacktrace=1",
             "LSAN_OPTIONS": f"suppressions={ROOT}/tools/lsan.supp:print_suppressions=0"}
    return {**os.environ, **quiet}


def run(name, arguments, log):
    """The exit code, and the seconds of a processor."""
    command = [BUILD / "bin" / f"fuzz_{name}", *LIMITS, f"-artifact_prefix={FINDINGS}/{name}-", *arguments]
    with open(log, "w", encoding="utf-8", errors="replace") as out:
        child = subprocess.Popen(list(map(str, command)), stdout=out, stderr=out, env=environment(), cwd=BUILD)
        _, status, used = os.wait4(child.pid, 0)  # of this one: the other fuzzer runs beside it
        child.returncode = os.waitstatus_to_exitcode(status)
    return child.returncode, used.ru_utime


def is_slow(name, path):
    """Whether it takes the time of a processor, and not that of a busy machine."""
    return run(name, ["-timeout=600", path], BUILD / f"{name}-again.log")[1] > SECONDS


def findings(name):
    return set(FINDINGS.glob(f"{name}-*"))


def report(name, before):
    """What is new among the findings and holds when it is looked at again."""
    found = []
    for path in sorted(findings(name) - before):
        if "slow-unit" in path.name or ("timeout" in path.name and not is_slow(name, path)):
            path.unlink()
            continue
        found.append(path)
        say(f"found: {path.relative_to(ROOT)}; again: build/fuzz/bin/fuzz_{name} {path.relative_to(ROOT)}")
    return found


def fuzz(name, seeds, longest, seconds, is_fresh):
    """True if nothing was found. A finding ends libFuzzer, so it begins again as long as there is time."""
    corpus = BUILD / "corpus" / name
    if is_fresh:
        shutil.rmtree(corpus, ignore_errors=True)
    corpus.mkdir(parents=True, exist_ok=True)
    log = BUILD / f"{name}.log"
    end = time.monotonic() + seconds
    is_clean = True
    while True:
        before = findings(name)
        left = max(1, int(end - time.monotonic()))
        code, _ = run(name, [f"-max_total_time={left}", f"-max_len={longest}", f"-seed={int(is_fresh)}", f"-dict={BUILD}/words.dict",
                          "-print_final_stats=1", corpus, *seeds], log)
        text = log.read_text(encoding="utf-8", errors="replace")
        executed = re.search(r"stat::number_of_executed_units: *(\d+)", text)
        say(f"{name}: {executed.group(1) if executed else '?'} inputs; log: {log.relative_to(ROOT)}")
        new = findings(name) - before
        found = report(name, before)
        if found or (code != 0 and not new):
            is_clean = False
            print(text[-3000:])
        if code == 0 or time.monotonic() + 10 > end:
            return is_clean


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seconds", type=int, default=60, help="of a processor, of both fuzzers together")
    parser.add_argument("--fresh", action="store_true", help="begin with the files of this repository alone, and always alike")
    options = parser.parse_args()
    if not has_libfuzzer():
        say("skipped: clang++ with its libFuzzer (Debian: clang, libclang-rt-14-dev) is not here")
        return SKIPPED
    build()
    FINDINGS.mkdir(exist_ok=True)
    half = max(1, options.seconds // 2)
    # One on each of two processors.
    with ThreadPoolExecutor(2) as pool:
        each = [("expression", expressions(), 400), ("model", SEEDS, 8192)]
        results = list(pool.map(lambda one: fuzz(*one, half, options.fresh), each))
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
