"""What is measured: models and sizes, and who takes part."""

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Emitted:
    """One of our models of a case."""
    tool: str
    model: str  # below models/
    count: str = "n"  # which of its counts is the size; empty: none
    defines: tuple = ()

    @property
    def is_folded(self):
        """Parameters as numbers in the code."""
        return "SYMBOLS" not in self.defines


@dataclass(frozen=True)
class Case:
    kind: str  # of bench/drivers/cases.hpp
    size: int
    emitted: tuple
    is_by_hand: bool = False
    libraries: tuple = ()  # mujoco, simbody
    sympy: str = ""  # its coordinates; empty: not measured
    is_long: bool = False  # SymPy takes minutes: in the full run only
    is_quick: bool = False  # in the quick run, too
    reactions: tuple = ()  # functions of emitted code besides rhs
    has_batches: bool = False
    has_symbols: bool = False  # code of SymPy's that reads its parameters is measured, too
    has_many_angles: bool = False  # sines and cosines several at a time are measured, too

    @property
    def name(self):
        return f"{self.kind}_{self.size}"


LIBRARIES = ("mujoco", "simbody")


def in_symbols(model, count="n"):
    return (Emitted("gauss, symbols", model, count, ("SYMBOLS",)),)


def planar(size):
    relative = Emitted("gauss", "families/planar_chain_relative")
    absolute = Emitted("gauss, absolute", "families/planar_chain_absolute", defines=("ABSOLUTE",))
    return Case("planar_chain", size, (relative, absolute), True, LIBRARIES, "absolute angles" if size in (2, 5, 10, 20) else "",
                is_quick=size in (2, 10), reactions=("joint_reactions",) if size in (2, 10) else (), has_batches=size in (2, 10),
                has_many_angles=size >= 10)


def spatial(size):
    return Case("spatial_chain", size, (Emitted("gauss", "families/spatial_chain"),), True, LIBRARIES, "joint angles", size > 4,
                is_quick=size == 2, reactions=("joint_reactions",) if size == 2 else (), has_batches=size in (2, 6),
                has_many_angles=size == 6)


def pendulum(size):
    """With a mass and a length of its own for each bob, as users have it who do not write a generator for their one chain."""
    model = "families/planar_pendulum"
    return Case("planar_pendulum", size, (Emitted("gauss", model), *in_symbols(model)), sympy="absolute angles", has_symbols=True,
                has_many_angles=True)


def single(kind, model, **more):
    return Case(kind, 1, (Emitted("gauss", model, ""),), **more)


def alone(model, size, count="n", **more):
    """Nobody else takes part."""
    return Case(model.split("/")[-1], size, (Emitted("gauss", model, count, ("FROM_START",)),), **more)


CASES = [
    *(planar(size) for size in (1, 2, 5, 10, 20, 50)),
    *(pendulum(size) for size in (10, 20)),
    *(spatial(size) for size in (2, 4, 6)),
    single("four_bar", "four_bar", is_by_hand=True, libraries=LIBRARIES, is_quick=True, has_batches=True,
           reactions=("rhs_and_reactions", "joint_reactions")),
    single("sphere", "sphere_in_cylinder", is_by_hand=True, sympy="z-x-z Euler angles", is_quick=True, has_batches=True,
           reactions=("rhs_and_reactions",)),
    single("sphere_quaternion", "sphere_in_cylinder_quaternion", is_by_hand=True, has_batches=True, reactions=("rhs_and_reactions",)),
    single("rolling_disc", "rolling_disc", is_by_hand=True, sympy="those of the model", reactions=("rhs_and_reactions",)),
    Case("bicycle", 1, (Emitted("gauss", "bicycle", ""), *in_symbols("bicycle", "")), sympy="those of SymPy's own model",
         reactions=("rhs_and_reactions",), has_many_angles=True, has_symbols=True),
    alone("families/planar_chain_maximal", 10),
    alone("families/n_four_bar", 2),
    alone("families/balls_in_cylinder", 4),
    alone("families/road_train", 5),
    alone("families/tree", 30),
    alone("families/quadruped", 4, "legs"),
    alone("families/humanoid", 1, ""),
    # Long enough to be emitted in parts.
    alone("families/planar_chain_relative", 200),
]


@dataclass(frozen=True)
class Generation:
    """A header whose making is measured."""
    model: str
    size: int = 1
    count: str = "n"
    is_quick: bool = False
    outputs: tuple = field(default=("rhs",))

    @property
    def kind(self):
        return self.model.split("/")[-1]


GENERATIONS = [
    *(Generation("families/planar_chain_relative", size, is_quick=size == 10) for size in (5, 10, 20, 50, 100, 200)),
    *(Generation("families/spatial_chain", size, is_quick=size == 6) for size in (2, 4, 6, 12, 24)),
    Generation("sphere_in_cylinder", count="", is_quick=True),
    Generation("sphere_in_cylinder_quaternion", count=""),
    Generation("rolling_disc", count=""),
    Generation("four_bar", count=""),
    Generation("bicycle", count="", is_quick=True),
    Generation("families/tree", 30),
    Generation("families/quadruped", 4, "legs"),
    Generation("families/humanoid", count=""),
    Generation("families/road_train", 5),
]


def selected(entries, options):
    """By --quick and --only: a word that the kind contains, or kind_size."""
    def is_wanted(entry):
        if options.only:
            return any(word in entry.kind or word == f"{entry.kind}_{entry.size}" for word in options.only)
        return entry.is_quick or not options.quick
    return [entry for entry in entries if is_wanted(entry)]
