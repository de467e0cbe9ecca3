"""Why a figure is not reached, and what would be needed: text beside measured numbers, for the rows of targets.py that are missed."""

from .targets import number


def share_of_sines(document, model, size):
    sines, whole = (document.value(model, size, "gauss", f"ns_{what}") for what in ("sines", "rhs"))
    return f"{number(sines)} of {number(whole)} ns are sines and cosines of the C library if they are called alone" if sines and whole else ""


def chain(document, size):
    uniform = document.value("planar_chain", size, "sympy", "operations")
    uneven = document.value("planar_pendulum", size, "sympy, symbols", "operations")
    text = f"{share_of_sines(document, 'planar_chain', size)}; both sides call the same {size} of them. "
    text += (f"All rods are alike and numbers stand in the code, which suits SymPy: {number(uniform)} operations, where bobs with a mass and a length each, read at "
             f"run time, take it {number(uneven)}. The figure was set by such code (`anchors.md`), and the row of planar_pendulum with symbols is the same comparison. "
             if uniform and uneven else "")
    return text + ("What is left of ours is one link waiting for the next, some 48 cycles each. Needed: both halves of the chain at once, at about twice the "
                   "operations for one of them.")


def spatial(document, _size):
    return (f"{share_of_sines(document, 'spatial_chain', 6)}; twelve angles on both sides. Next is the wait of each of twelve joints for the one before, some 55 cycles. Needed: shorter "
            "chains of operations at a joint (decision 0009 does that for bars in a plane only).")


def bicycle(document, _size):
    theirs = [number(document.value("bicycle", 1, "sympy", f"{metric}")) for metric in ("operations", "instructions_rhs")]
    ours = [number(document.value("bicycle", 1, "gauss", f"{metric}")) for metric in ("operations", "instructions_rhs")]
    return (f"{ours[0]} operations against {theirs[0]}, {ours[1]} instructions against {theirs[1]}: the operations are as many times fewer as the figure asks. Guarded pivots, a status and fifteen values "
            f"that are looked at come on top, which SymPy's code does not have; {share_of_sines(document, 'bicycle', 1)}. Needed: some 200 instructions less.")


def by_hand(document, size):
    if size == 1:
        return "The code by hand is one product with a sine. Ours looks whether the result is finite and returns a status, and copies the rate; nothing else is left."
    return "Statuses (is something infinite, is a pivot lost) and the rates are all that ours has beyond the code by hand."


def four_bar(document, _size):
    sines = document.value("four_bar", 1, "gauss", "instructions_sines")
    whole = document.value("four_bar", 1, "gauss", "instructions_rhs")
    return (f"{number(sines)} of {number(whole)} instructions are the same three sines and cosines on both sides. The rest: the person divides by the sine between coupler and rocker; ours solves for two multipliers and looks, "
            "with a bound, whether each pivot is lost, as at a folded linkage; then statuses, and the rates. Without these it would be the code by hand.")


def growth(document, _size):
    memory = [number(document.value("planar_chain_relative", n, "gauss", "derive_memory")) for n in (50, 200)]
    return (f"Operations grow 4.1 times, and so do the instructions of the generator on this family (callgrind); memory goes from {memory[0]} to {memory[1]} MB, out of the "
            "processor's second cache. Needed: passes that work on a part of the graph at a time. Families with rolling grow faster: "
            "each wheel's row is formed over all speeds before it.")


def everything(_document, _size):
    return ("A row of our own, of twelve functions: the issue's figure is met by `rhs`. Two thirds of the time are passes over the operations of all of them, some 20 µs each.")


REASONS = [("the same with sines together, planar_chain", chain), ("time against SymPy, planar_chain", chain), ("time against SymPy, planar_pendulum", chain),
           ("the same with sines together, planar_pendulum", chain),
           ("time against SymPy, spatial_chain", spatial), ("the same with sines together, spatial_chain", spatial), ("time against SymPy, bicycle", bicycle),
           ("the same with sines together, bicycle", bicycle), ("the same with parameters as symbols in both, bicycle", bicycle), ("instructions against code by hand, four_bar", four_bar),
           ("time against code by hand, four_bar", four_bar), ("instructions against code by hand", by_hand), ("time against code by hand", by_hand),
           ("growth of time", growth), ("generate", everything)]


def of(document, outcome):
    """Empty where nothing is known beyond the figure."""
    for begin, why in REASONS:
        if outcome.work.startswith(begin):
            last = outcome.work.split(", ")[-1]
            return why(document, int(last) if last.isdigit() else 0)
    return ""
