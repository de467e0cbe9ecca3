#!/usr/bin/env python3
"""./run bench: measures emitted code and its generation beside peers, and writes what was found. README.md says how."""

import argparse
import datetime
import shutil
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from harness import build, cases, generation, machine, measure, remedies, report, results  # noqa: E402

RESULTS = build.ROOT / "bench/results/latest.json"
PAGE = build.ROOT / "docs/performance.md"
PEERS = {"mujoco": "libmujoco-dev", "simbody": "libsimbody-dev", "sympy": "python3-sympy", "valgrind": "valgrind", "xsimd": "libxsimd-dev"}


def parsed():
    parser = argparse.ArgumentParser(prog="./run bench", description=__doc__)
    parser.add_argument("--quick", action="store_true", help="some minutes: small sizes, fewer rounds")
    parser.add_argument("--only", action="append", default=[], metavar="WORD",
                        help="cases whose name has this word in it, such as chain, spatial_chain_6 or sphere; may be repeated")
    parser.add_argument("--without", action="append", default=[], choices=sorted(PEERS), metavar="PEER",
                        help="leave a peer or a tool out: " + ", ".join(sorted(PEERS)))
    parser.add_argument("--output", type=Path, metavar="FILE",
                        help="where to write the JSON; default: bench/results/latest.json, and of a part build/bench/part.json")
    parser.add_argument("--update", action="store_true", help="put the cases of a part into bench/results/latest.json in place of what is there")
    parser.add_argument("--report", action="store_true", help="measure nothing, write the page from the JSON anew")
    parser.add_argument("--remedies", action="store_true",
                        help="measure only what remedies and rules against cancellation cost, into bench/results/remedies.json")
    parser.add_argument("--check", action="store_true",
                        help="measure next to nothing, write nothing: emitted code and code by hand agree, the page is that of the JSON")
    parser.add_argument("--max-seconds", type=int, default=0, metavar="N",
                        help="leave out what takes longer to generate or to compile; default 120, of --quick 30")
    parser.add_argument("--gauss-gen", type=Path, default=build.ROOT / "build/release/bin/gauss-gen", metavar="FILE")
    parser.add_argument("--build-dir", type=Path, default=build.ROOT / "build/bench", metavar="DIR")
    options = parser.parse_args()
    options.rounds, options.milliseconds = (7, 2) if options.quick else (31, 4)
    options.generations = 3 if options.quick else 7
    options.max_seconds = options.max_seconds or (30 if options.quick else 120)
    return options


def prepare(options, found):
    """Who is here, and what our generator emits."""
    for peer, package in PEERS.items():
        if peer not in options.without and not machine.package_version(package):
            options.without.append(peer)
            found.skip(peer, f"the package {package} is not installed")
    options.has = lambda peer: peer not in options.without
    options.builder = build.Builder(options.build_dir.resolve(), options.gauss_gen.resolve(), options.max_seconds)
    options.outputs = build.run([options.gauss_gen.resolve(), "--help"]).replace(",", " ").split()
    if "jacobian" not in options.outputs:
        found.skip("jacobian", "this gauss-gen has no such output")


def measure_all(options):
    found = results.Results()
    prepare(options, found)
    wanted = cases.selected(cases.CASES, options)
    generations = cases.selected(cases.GENERATIONS, options)
    if not wanted and not generations:
        sys.exit(f"bench: no case has {' or '.join(options.only)} in its name")
    where = machine.description()
    selection = " ".join(["quick"] * options.quick + options.only) or "all"
    path = options.output or (RESULTS if selection == "all" else options.build_dir / "part.json")

    def save(so_far):
        results.write(path, found, where, datetime.date.today().isoformat(), selection + so_far)
    for number, case in enumerate(wanted, 1):
        print(f"bench: {number}/{len(wanted)} {case.name}", flush=True)
        try:
            measure.Driver(case, options.builder, found, options).measure()
        except build.BuildError as error:
            found.skip(case.name, str(error))
        save(f", not finished: {number} of {len(wanted)} cases")
    print("bench: generation", flush=True)
    generation.measure_all(generations, options.builder, found, options)
    save("")
    if options.update:
        results.write(RESULTS, *results.merged(report.load(RESULTS), report.load(path)))
        path = RESULTS
    print(f"bench: wrote {path}", flush=True)
    return path


def measure_remedies(options):
    found = results.Results()
    prepare(options, found)
    remedies.measure_all(options, found)
    return found


def check(options):
    """What a test can see in half a minute."""
    options.quick, options.rounds, options.milliseconds = True, 1, 0.01
    options.without = sorted(PEERS)
    found = results.Results()
    prepare(options, found)
    for case in cases.CASES:
        if case.name in ("planar_chain_2", "planar_chain_5", "spatial_chain_2", "four_bar_1", "rolling_disc_1", "sphere_1",
                         "sphere_quaternion_1"):
            driver = measure.Driver(case, options.builder, found, options)
            driver.check(driver.linked("", build.COUNTING_FLAGS))
    document = report.load(RESULTS)
    faults = results.faults(document) + report.differences(results.Document(document), PAGE)
    for fault in faults:
        print(f"bench: {fault}")
    sys.exit(1 if faults else 0)


def main():
    options = parsed()
    if not shutil.which(build.COMPILER):
        sys.exit(f"bench: there is no compiler '{build.COMPILER}'")
    try:
        if options.check:
            check(options)
        if options.remedies:
            found = measure_remedies(options)
            if options.only:
                print(remedies.block(results.Document({"date": "", "selection": "", "machine": {}, "skipped": [], "rows": found.rows})))
                return
        path = RESULTS if options.report or options.remedies else measure_all(options)
    except measure.Disagreement as error:
        sys.exit(f"bench: {error}")
    document = results.read(path)
    if path == RESULTS:
        report.write(document, PAGE)
        print(f"bench: wrote {PAGE.relative_to(build.ROOT)} and its charts")
    else:
        print(report.text_of(document, has_charts=False))


if __name__ == "__main__":
    main()
