"""tmmcalc: the calculator for a course project in the Theory of Mechanisms and Machines.

    >>> import tmmcalc
    >>> spec = tmmcalc.load_spec("configs/shaper.toml")
    >>> result = tmmcalc.solve_kinematics(spec)
    >>> round(result.summaries[0].stroke, 9)  # m
    0.658064516

Everything that the command line does is here on numpy arrays. Names are loaded when they are first used.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc._version import __version__

if TYPE_CHECKING:
    from tmmcalc.api import run, solve_kinematics, solve_structure
    from tmmcalc.errors import (
        AccuracyError,
        AssemblyError,
        LimitError,
        NoSolutionError,
        SingularityError,
        SpecError,
        StructureError,
        TmmError,
        UsageError,
    )
    from tmmcalc.linkage.dyad import DyadMotion, solve_dyad
    from tmmcalc.linkage.dyads import PRP, RPP, RPR, RRP, RRR
    from tmmcalc.linkage.model import Assembly, Grid, Input, Joint, Link, Mechanism, Output
    from tmmcalc.linkage.plane import Guide, Point
    from tmmcalc.linkage.results import Kinematics, Method
    from tmmcalc.linkage.structure import Structure
    from tmmcalc.spec import Spec, load_spec, parse_spec

__all__ = [
    "PRP",
    "RPP",
    "RPR",
    "RRP",
    "RRR",
    "AccuracyError",
    "Assembly",
    "AssemblyError",
    "DyadMotion",
    "Grid",
    "Guide",
    "Input",
    "Joint",
    "Kinematics",
    "LimitError",
    "Link",
    "Mechanism",
    "Method",
    "NoSolutionError",
    "Output",
    "Point",
    "SingularityError",
    "Spec",
    "SpecError",
    "Structure",
    "StructureError",
    "TmmError",
    "UsageError",
    "__version__",
    "load_spec",
    "parse_spec",
    "run",
    "solve_dyad",
    "solve_kinematics",
    "solve_structure",
]

_HOMES = {
    "tmmcalc.api": ("run", "solve_kinematics", "solve_structure"),
    "tmmcalc.linkage.dyad": ("DyadMotion", "solve_dyad"),
    "tmmcalc.linkage.dyads": ("PRP", "RPP", "RPR", "RRP", "RRR"),
    "tmmcalc.linkage.model": ("Assembly", "Grid", "Input", "Joint", "Link", "Mechanism", "Output"),
    "tmmcalc.linkage.plane": ("Guide", "Point"),
    "tmmcalc.linkage.results": ("Kinematics", "Method"),
    "tmmcalc.linkage.structure": ("Structure",),
    "tmmcalc.spec": ("Spec", "load_spec", "parse_spec"),
    "tmmcalc.errors": tuple(name for name in __all__ if name.endswith("Error")),
}


def __getattr__(name: str) -> object:
    home = next((module for module, names in _HOMES.items() if name in names), None)
    if home is None:
        raise AttributeError(f"module 'tmmcalc' has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(home), name)


def __dir__() -> list[str]:
    return __all__
