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
    from tmmcalc.api import (
        list_assemblies,
        run,
        solve_balance,
        solve_bearing,
        solve_blocking,
        solve_cam_elastic,
        solve_cam_forces,
        solve_cam_law,
        solve_cam_optimum,
        solve_cam_pressure,
        solve_cam_profile,
        solve_cam_strength,
        solve_cam_synthesis,
        solve_contact,
        solve_criteria,
        solve_falling_ball,
        solve_feasibility,
        solve_flywheel,
        solve_forces,
        solve_gearing,
        solve_indexing,
        solve_kinematics,
        solve_manipulator,
        solve_motion,
        solve_pairs,
        solve_pendulum,
        solve_power,
        solve_profiles,
        solve_reduction,
        solve_reliability,
        solve_strength,
        solve_structure,
        solve_synthesis,
        solve_tie_down,
        solve_train,
        solve_transients,
        solve_unsteady,
        solve_vibrator,
    )
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
    from tmmcalc.feasibility.judge import Feasibility
    from tmmcalc.feasibility.regions import characteristic, complement, conjunction, disjunction, negation
    from tmmcalc.gears.factors import euclid, prime_factors
    from tmmcalc.gears.gearing import Gearing
    from tmmcalc.gears.involute.internal.ring import Cutter
    from tmmcalc.gears.involute.quality.verdicts import QualityLimits
    from tmmcalc.gears.involute.rack import RACKS, Rack
    from tmmcalc.gears.meshing.contours import Blocking
    from tmmcalc.gears.meshing.profiles import Profiles
    from tmmcalc.gears.meshing.results import MeshPair, Pairs
    from tmmcalc.gears.meshing.solve import solve_pair
    from tmmcalc.gears.meshing.task import PairTask
    from tmmcalc.gears.model import Demands, Interval, Limits, ToothSets, TrainTask
    from tmmcalc.gears.network.builder import Train, bevel_differential, efficiency_of, flow_of, network_of, ratio_of
    from tmmcalc.gears.network.efficiency import DriveEfficiency
    from tmmcalc.gears.network.model import Mesh, Network
    from tmmcalc.gears.search.search import Synthesis, synthesise
    from tmmcalc.gears.selection.results import Selection
    from tmmcalc.gears.sizing import Sizing
    from tmmcalc.gears.train import Trains
    from tmmcalc.linkage.dyad import DyadMotion, solve_dyad
    from tmmcalc.linkage.dyads import PRP, RPP, RPR, RRP, RRR
    from tmmcalc.linkage.forces.results import Forces
    from tmmcalc.linkage.listing import Listing
    from tmmcalc.linkage.loading import (
        Body,
        Constant,
        Coupling,
        GearDrive,
        Indicator,
        Load,
        Loading,
        Pair,
        Polynomial,
        Quadratic,
        Spring,
        Tabulated,
        Viscous,
        Window,
    )
    from tmmcalc.linkage.model import Assembly, Grid, Input, Joint, Link, Mechanism, Output
    from tmmcalc.linkage.plan import position_plan
    from tmmcalc.linkage.plane import Guide, Point
    from tmmcalc.linkage.reduction.results import Reduction
    from tmmcalc.linkage.results import Kinematics, Method
    from tmmcalc.linkage.structure import Structure
    from tmmcalc.linkage.unsteady.results import Unsteady
    from tmmcalc.machine.cycle import Cycle
    from tmmcalc.machine.flywheel.task import Flywheel
    from tmmcalc.machine.motion import Motion
    from tmmcalc.machine.power import Power
    from tmmcalc.machine.transient.timed import TimedMotions
    from tmmcalc.manipulators.results import Manipulator
    from tmmcalc.spec import Spec, load_spec, parse_spec
    from tmmcalc.stages.balance import Balances
    from tmmcalc.timelaw import TimeLaw

__all__ = [
    "PRP",
    "RACKS",
    "RPP",
    "RPR",
    "RRP",
    "RRR",
    "AccuracyError",
    "Assembly",
    "AssemblyError",
    "Balances",
    "Blocking",
    "Body",
    "Constant",
    "Coupling",
    "Cutter",
    "Cycle",
    "Demands",
    "DriveEfficiency",
    "DyadMotion",
    "Feasibility",
    "Flywheel",
    "Forces",
    "GearDrive",
    "Gearing",
    "Grid",
    "Guide",
    "Indicator",
    "Input",
    "Interval",
    "Joint",
    "Kinematics",
    "LimitError",
    "Limits",
    "Link",
    "Listing",
    "Load",
    "Loading",
    "Manipulator",
    "Mechanism",
    "Mesh",
    "MeshPair",
    "Method",
    "Motion",
    "Network",
    "NoSolutionError",
    "Output",
    "Pair",
    "PairTask",
    "Pairs",
    "Point",
    "Polynomial",
    "Power",
    "Profiles",
    "Quadratic",
    "QualityLimits",
    "Rack",
    "Reduction",
    "Selection",
    "SingularityError",
    "Sizing",
    "Spec",
    "SpecError",
    "Spring",
    "Structure",
    "StructureError",
    "Synthesis",
    "Tabulated",
    "TimeLaw",
    "TimedMotions",
    "TmmError",
    "ToothSets",
    "Train",
    "TrainTask",
    "Trains",
    "Unsteady",
    "UsageError",
    "Viscous",
    "Window",
    "__version__",
    "bevel_differential",
    "characteristic",
    "complement",
    "conjunction",
    "disjunction",
    "efficiency_of",
    "euclid",
    "flow_of",
    "list_assemblies",
    "load_spec",
    "negation",
    "network_of",
    "parse_spec",
    "position_plan",
    "prime_factors",
    "ratio_of",
    "run",
    "solve_balance",
    "solve_bearing",
    "solve_blocking",
    "solve_cam_elastic",
    "solve_cam_forces",
    "solve_cam_law",
    "solve_cam_optimum",
    "solve_cam_pressure",
    "solve_cam_profile",
    "solve_cam_strength",
    "solve_cam_synthesis",
    "solve_contact",
    "solve_criteria",
    "solve_dyad",
    "solve_falling_ball",
    "solve_feasibility",
    "solve_flywheel",
    "solve_forces",
    "solve_gearing",
    "solve_indexing",
    "solve_kinematics",
    "solve_manipulator",
    "solve_motion",
    "solve_pair",
    "solve_pairs",
    "solve_pendulum",
    "solve_power",
    "solve_profiles",
    "solve_reduction",
    "solve_reliability",
    "solve_strength",
    "solve_structure",
    "solve_synthesis",
    "solve_tie_down",
    "solve_train",
    "solve_transients",
    "solve_unsteady",
    "solve_vibrator",
    "synthesise",
]

_ELSEWHERE = ("solve_dyad", "solve_pair")  # functions of one part, not of a spec

_HOMES = {
    "tmmcalc.api": (
        "list_assemblies",
        "run",
        *(name for name in __all__ if name.startswith("solve_") and name not in _ELSEWHERE),
    ),
    "tmmcalc.gears.factors": ("euclid", "prime_factors"),
    "tmmcalc.gears.gearing": ("Gearing",),
    "tmmcalc.gears.involute.internal.ring": ("Cutter",),
    "tmmcalc.gears.involute.quality.verdicts": ("QualityLimits",),
    "tmmcalc.gears.involute.rack": ("RACKS", "Rack"),
    "tmmcalc.gears.meshing.contours": ("Blocking",),
    "tmmcalc.gears.meshing.profiles": ("Profiles",),
    "tmmcalc.gears.meshing.results": ("MeshPair", "Pairs"),
    "tmmcalc.gears.meshing.solve": ("solve_pair",),
    "tmmcalc.gears.meshing.task": ("PairTask",),
    "tmmcalc.gears.model": (
        "Demands",
        "Interval",
        "Limits",
        "ToothSets",
        "TrainTask",
    ),
    "tmmcalc.gears.network.builder": (
        "Train",
        "bevel_differential",
        "efficiency_of",
        "flow_of",
        "network_of",
        "ratio_of",
    ),
    "tmmcalc.gears.network.efficiency": ("DriveEfficiency",),
    "tmmcalc.gears.network.model": (
        "Mesh",
        "Network",
    ),
    "tmmcalc.gears.search.search": (
        "Synthesis",
        "synthesise",
    ),
    "tmmcalc.gears.selection.results": ("Selection",),
    "tmmcalc.gears.sizing": ("Sizing",),
    "tmmcalc.gears.train": ("Trains",),
    "tmmcalc.linkage.dyad": ("DyadMotion", "solve_dyad"),
    "tmmcalc.linkage.dyads": ("PRP", "RPP", "RPR", "RRP", "RRR"),
    "tmmcalc.linkage.forces.results": ("Forces",),
    "tmmcalc.linkage.listing": ("Listing",),
    "tmmcalc.linkage.loading": (
        "Body",
        "Constant",
        "Coupling",
        "GearDrive",
        "Indicator",
        "Load",
        "Loading",
        "Pair",
        "Polynomial",
        "Quadratic",
        "Spring",
        "Tabulated",
        "Viscous",
        "Window",
    ),
    "tmmcalc.linkage.reduction.results": ("Reduction",),
    "tmmcalc.feasibility.judge": ("Feasibility",),
    "tmmcalc.feasibility.regions": ("characteristic", "complement", "conjunction", "disjunction", "negation"),
    "tmmcalc.machine.cycle": ("Cycle",),
    "tmmcalc.stages.balance": ("Balances",),
    "tmmcalc.machine.flywheel.task": ("Flywheel",),
    "tmmcalc.machine.motion": ("Motion",),
    "tmmcalc.machine.power": ("Power",),
    "tmmcalc.machine.transient.timed": ("TimedMotions",),
    "tmmcalc.linkage.model": ("Assembly", "Grid", "Input", "Joint", "Link", "Mechanism", "Output"),
    "tmmcalc.linkage.plan": ("position_plan",),
    "tmmcalc.linkage.plane": ("Guide", "Point"),
    "tmmcalc.linkage.results": ("Kinematics", "Method"),
    "tmmcalc.linkage.structure": ("Structure",),
    "tmmcalc.linkage.unsteady.results": ("Unsteady",),
    "tmmcalc.manipulators.results": ("Manipulator",),
    "tmmcalc.timelaw": ("TimeLaw",),
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
