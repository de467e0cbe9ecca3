"""The figures that were to be reached, and what was: each target is a row of the page."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Outcome:
    work: str
    target: str
    reached: str
    is_met: bool


def number(value, digits=3):
    """Three digits, and whole numbers as they are."""
    if value is None:
        return "–"
    if value >= 100 or value == int(value):
        return f"{value:,.0f}".replace(",", " ")
    return f"{value:.{digits}g}"


def at_most(work, value, limit, unit=""):
    if value is None:
        return Outcome(work, f"≤ {number(limit)}{unit}", "not measured", False)
    return Outcome(work, f"≤ {number(limit)}{unit}", f"{number(value)}{unit}", value <= limit)


def faster(work, ours, theirs, times):
    """Ours takes at most one part in `times` of theirs."""
    target = f"≤ 1/{times:g}"
    if ours is None or theirs is None:
        return Outcome(work, target, "not measured", False)
    factor = theirs / ours
    return Outcome(work, target, f"1/{number(factor)}" if factor >= 1 else f"{number(1 / factor)} times slower", factor >= times)


def quotient(a, b):
    return None if a is None or not b else a / b


def generation(document):
    cases = [("planar_chain_relative", 10, 0.05), ("planar_chain_relative", 50, 0.5), ("spatial_chain", 6, 0.2), ("bicycle", 1, 0.5),
             ("quadruped", 4, 0.5)]
    for model, size, limit in cases:
        for metric, words in (("derive", "rhs"), ("derive_all", "all usual outputs")):
            yield at_most(f"generate {model}, {size}: {words}", document.value(model, size, "gauss", f"{metric}_wall"), limit, " s")
        yield at_most(f"memory for all of {model}, {size}", document.value(model, size, "gauss", "derive_all_memory"), 150, " MB")
    for metric, words in (("derive_wall", "time"), ("operations_by_header", "operations")):
        values = [document.value("planar_chain_relative", n, "gauss", metric) for n in (200, 50)]
        yield at_most(f"growth of {words} from n = 50 to 200", quotient(*values), 4.5, " times")


def operations(document):
    limits = [("sphere", 1, 85), ("rolling_disc", 1, 50), ("bicycle", 1, 1000), ("planar_chain", 5, 220), ("planar_chain", 10, 520),
              ("planar_chain", 20, 1090), ("planar_chain", 50, 2780), ("spatial_chain", 2, 280), ("spatial_chain", 4, 960),
              ("spatial_chain", 6, 1620)]
    for model, size, limit in limits:
        yield at_most(f"operations, {model}, {size}", document.value(model, size, "gauss", "operations"), limit)


def against_peers(document):
    def ours(model, size):
        return document.value(model, size, "gauss", "ns_rhs")
    for model, size, times in [("planar_chain", 10, 3), ("planar_chain", 20, 8), ("spatial_chain", 6, 12), ("sphere", 1, 5),
                               ("rolling_disc", 1, 4), ("bicycle", 1, 2.5), ("planar_pendulum", 10, 3), ("planar_pendulum", 20, 8)]:
        theirs = document.value(model, size, "sympy", "ns_rhs")
        yield faster(f"time against SymPy, {model}, {size}", ours(model, size), theirs, times)
        together = document.value(model, size, "gauss", "ns_rhs_vectorised")
        if together is not None:
            yield faster(f"the same with sines together, {model}, {size}", together, theirs, times)
        symbols = [document.value(model, size, f"{tool}, symbols", "ns_rhs") for tool in ("gauss", "sympy")]
        if any(symbols):
            yield faster(f"the same with parameters as symbols in both, {model}, {size}", *symbols, times)
    for model, size, times in [("planar_chain", 2, 20), ("planar_chain", 10, 12), ("planar_chain", 50, 22), ("spatial_chain", 6, 8),
                               ("four_bar", 1, 25)]:
        yield faster(f"time against MuJoCo, {model}, {size}", ours(model, size), document.best(model, size, "ns_rhs", "mujoco"), times)


def against_by_hand(document):
    for model, size in [*(("planar_chain", n) for n in (1, 2, 5, 10, 20, 50)), ("four_bar", 1)]:
        for metric, limit, words in (("instructions_rhs", 1.00, "instructions"), ("ns_rhs", 1.03, "time")):
            value = quotient(document.value(model, size, "gauss", metric), document.best(model, size, metric, "by hand"))
            yield at_most(f"{words} against code by hand, {model}, {size}", value, limit, " times")


def additions(document):
    for model, size, metric in [("sphere", 1, "rhs_and_reactions"), ("four_bar", 1, "rhs_and_reactions"), ("four_bar", 1, "joint_reactions"),
                                ("planar_chain", 10, "joint_reactions")]:
        value = quotient(document.value(model, size, "gauss", f"ns_{metric}"), document.value(model, size, "gauss", "ns_rhs"))
        yield at_most(f"{metric} against rhs, {model}, {size}", value, 1.25, " times")
    for model, size in [("planar_chain", 10), ("spatial_chain", 6), ("sphere", 1), ("four_bar", 1)]:
        for lanes, times in ((4, 4), (8, 6)):
            yield faster(f"a trajectory of {lanes} lanes against one, {model}, {size}",
                         document.value(model, size, "gauss", f"ns_batch_{lanes}"), document.value(model, size, "gauss", "ns_rhs"), times)
    for model, size in [("planar_chain", 10), ("planar_chain", 20), ("planar_chain", 50), ("spatial_chain", 6)]:
        yield faster(f"sines and cosines together, {model}, {size}", document.value(model, size, "gauss", "ns_rhs_vectorised"),
                     document.value(model, size, "gauss", "ns_rhs"), 1)


def compilers(document):
    """Budgets for one right-hand side: what large models cost those who compile them."""
    for model, size, seconds, kilobytes in [("planar_chain", 50, 3, 60), ("spatial_chain", 6, 2, 40), ("planar_chain_relative", 200, 6, 240),
                                            ("humanoid", 1, 4, 120)]:
        yield at_most(f"compile, g++ -O2, {model}, {size}", document.value(model, size, "gauss", "compile"), seconds, " s")
        code = document.value(model, size, "gauss", "code")
        yield at_most(f"code, {model}, {size}", None if code is None else code / 1000, kilobytes, " kB")
    values = [document.value(model, size, "gauss", "compile") for model, size in (("planar_chain_relative", 200), ("planar_chain", 50))]
    yield at_most("growth of compile time from n = 50 to 200", quotient(*values), 5, " times")


def all_of(document):
    return [outcome for part in (generation, operations, against_peers, against_by_hand, additions, compilers) for outcome in part(document)]
