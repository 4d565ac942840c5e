"""tmmcalc: the calculator for a course project in the Theory of Mechanisms and Machines.

    >>> import tmmcalc
    >>> spec = tmmcalc.load_spec("configs/shaper.toml")
    >>> result = tmmcalc.solve_kinematics(spec)
    >>> round(result.summaries[0].stroke, 9)  # m
    0.658064516

Everything that the command line does is here on numpy arrays. Names are loaded when they are first used.
"""

from __future__ import annotations

from tmmcalc._version import __version__

# Public names by their modules, which are imported when a name is first used; `__init__.pyi` has their types.
_HOMES = {
    "tmmcalc.api": ("run", "settle"),
    "tmmcalc.api.named": ("columns", "told"),
    "tmmcalc.api.batches": ("sweep",),
    "tmmcalc.api.results": ("Run",),
    "tmmcalc.api.stageresult": ("StageResult",),
    "tmmcalc.api.cams": (
        "solve_cam_elastic",
        "solve_cam_forces",
        "solve_cam_law",
        "solve_cam_load",
        "solve_cam_optimum",
        "solve_cam_pressure",
        "solve_cam_profile",
        "solve_cam_strength",
        "solve_cam_synthesis",
        "solve_indexing",
    ),
    "tmmcalc.api.extras": (
        "solve_bearing",
        "solve_contact",
        "solve_falling_ball",
        "solve_feasibility",
        "solve_liner",
        "solve_reliability",
        "solve_tie_down",
        "solve_transloader",
    ),
    "tmmcalc.api.gears": (
        "solve_blocking",
        "solve_criteria",
        "solve_gearing",
        "solve_pairs",
        "solve_profiles",
        "solve_strength",
        "solve_train",
        "solve_wheel",
    ),
    "tmmcalc.api.linkages": (
        "list_assemblies",
        "solve_forces",
        "solve_kinematics",
        "solve_manipulator",
        "solve_reduction",
        "solve_paths",
        "solve_structure",
        "solve_synthesis",
        "solve_unsteady",
    ),
    "tmmcalc.api.machines": (
        "solve_balance",
        "solve_flywheel",
        "solve_motion",
        "solve_pendulum",
        "solve_power",
        "solve_transients",
        "solve_vibrator",
    ),
    "tmmcalc.batch.regions": ("map_feasibility",),
    "tmmcalc.batch.sheet": ("Sheet",),
    "tmmcalc.core.errors": (
        "AccuracyError",
        "AssemblyError",
        "LimitError",
        "NoSolutionError",
        "SingularityError",
        "SpecError",
        "StructureError",
        "TmmError",
        "UsageError",
    ),
    "tmmcalc.feasibility.judge": ("Feasibility",),
    "tmmcalc.feasibility.maps": ("RegionMap",),
    "tmmcalc.feasibility.regions": (
        "characteristic",
        "complement",
        "conjunction",
        "disjunction",
        "negation",
    ),
    "tmmcalc.gears.factors": (
        "euclid",
        "prime_factors",
    ),
    "tmmcalc.gears.gearing": ("Gearing",),
    "tmmcalc.gears.involute.internal.ring": ("Cutter",),
    "tmmcalc.gears.involute.quality.verdicts": ("QualityLimits",),
    "tmmcalc.gears.involute.rack": (
        "RACKS",
        "Rack",
    ),
    "tmmcalc.gears.meshing.contours": ("Blocking",),
    "tmmcalc.gears.meshing.profiles": ("Profiles",),
    "tmmcalc.gears.meshing.results": (
        "MeshPair",
        "Pairs",
    ),
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
    "tmmcalc.gears.trains": ("Trains",),
    "tmmcalc.linkage.dyad": (
        "DyadMotion",
        "solve_dyad",
    ),
    "tmmcalc.linkage.dyads": (
        "PRP",
        "RPP",
        "RPR",
        "RRP",
        "RRR",
    ),
    "tmmcalc.linkage.forces.results": ("Forces",),
    "tmmcalc.linkage.listing": ("Listing",),
    "tmmcalc.linkage.loadlaws.constant": ("Constant",),
    "tmmcalc.linkage.loadlaws.indicator": ("Indicator",),
    "tmmcalc.linkage.loadlaws.polynomial": ("Polynomial",),
    "tmmcalc.linkage.loadlaws.quadratic": ("Quadratic",),
    "tmmcalc.linkage.loadlaws.tabulated": ("Tabulated",),
    "tmmcalc.linkage.loadlaws.viscous": ("Viscous",),
    "tmmcalc.linkage.loading": (
        "Body",
        "Coupling",
        "GearDrive",
        "Load",
        "Loading",
        "Pair",
        "Spring",
        "Window",
    ),
    "tmmcalc.linkage.model": (
        "Assembly",
        "Grid",
        "Input",
        "Joint",
        "Link",
        "Mechanism",
        "Output",
    ),
    "tmmcalc.linkage.plan": ("position_plan",),
    "tmmcalc.core.plane": (
        "Guide",
        "Point",
    ),
    "tmmcalc.machine.reduction.results": ("Reduction",),
    "tmmcalc.linkage.results": (
        "Kinematics",
        "Method",
    ),
    "tmmcalc.linkage.paths.results": ("Paths",),
    "tmmcalc.linkage.structure": ("Structure",),
    "tmmcalc.linkage.unsteady.results": ("Unsteady",),
    "tmmcalc.machine.cycle": ("Cycle",),
    "tmmcalc.machine.flywheel.results": ("Flywheel",),
    "tmmcalc.machine.motion": ("Motion",),
    "tmmcalc.machine.power": ("Power",),
    "tmmcalc.machine.transient.timed": ("TimedMotions",),
    "tmmcalc.manipulators.results": ("Manipulator",),
    "tmmcalc.project": (
        "Spec",
        "load_spec",
        "parse_spec",
    ),
    "tmmcalc.machine.stages.balance": ("Balances",),
    "tmmcalc.core.timelaw": ("TimeLaw",),
}
_HOME = {name: home for home, names in _HOMES.items() for name in names}

__all__ = ["__version__", *sorted(_HOME)]


def __getattr__(name: str) -> object:
    if name not in _HOME:
        raise AttributeError(f"module 'tmmcalc' has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(_HOME[name]), name)


def __dir__() -> list[str]:
    return __all__
