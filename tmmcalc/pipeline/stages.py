"""The registry: every stage by name, in the order of the pipeline (each stage after the ones it needs)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from tmmcalc.core.stage import Stage

_ROOMS = {
    "synthesis": "linkage",
    "structure": "linkage",
    "kinematics": "linkage",
    "forces": "linkage",
    "unsteady": "linkage",
    "reduction": "machine",
    "power": "machine",
    "flywheel": "machine",
    "motion": "machine",
    "transient": "machine",
    "balance": "machine",
    "vibrator": "vibration",
    "pendulum": "vibration",
    "train": "gears",
    "gearing": "gears",
    "strength": "gears",
    "criteria": "gears",
    "pair": "gears",
    "blocking": "gears",
    "profile": "gears",
    "cam_law": "cams",
    "cam_synthesis": "cams",
    "cam_profile": "cams",
    "cam_pressure": "cams",
    "cam_forces": "cams",
    "cam_strength": "cams",
    "cam_optimum": "cams",
    "cam_elastic": "cams",
    "indexing": "cams",
    "manipulator": "manipulators",
    "contact": "extras",
    "reliability": "extras",
    "tie_down": "extras",
    "falling_ball": "extras",
    "bearing": "extras",
    "feasibility": "feasibility",
}


def _stage(
    name: str,
    title: str,
    *,
    needs: tuple[str, ...] = (),
    uses: tuple[str, ...] = (),
    spares: bool = False,
    wanted: bool = False,
    omits: bool = False,
    packages: bool = False,
    settings: Mapping[str, Any] | None = None,
    table: bool = True,
) -> Stage:
    """Declare a stage whose functions live in the module of its name.

    ``wanted``: not every scene has it; ``spares``: not every scene needs what it uses; ``omits``: it leaves something
    out within itself where the scene has it not; ``packages``: some scenes need a heavy package.
    """
    home = f"tmmcalc.{_ROOMS[name]}.stages.{name}"
    return Stage(
        name=name,
        title=title,
        needs=needs,
        uses=uses,
        spares=f"tmmcalc.pipeline.spared:{name}" if spares else "",
        wanted=f"tmmcalc.pipeline.wanted:{name}" if wanted else "",
        omits=f"tmmcalc.pipeline.omitted:{name}" if omits else "",
        packages=f"tmmcalc.pipeline.packages:{name}" if packages else "",
        inputs=f"{home}:inputs",
        solve=f"{home}:solve",
        dump=f"{home}:dump",
        load=f"{home}:load",
        table=f"{home}:table" if table else "",
        settings=settings or {},
    )


TOLERANCE = {"tolerance": 0.0}  # relative error asked for; 0: that of the method

STAGES: dict[str, Stage] = {
    stage.name: stage
    for stage in (
        _stage(
            "synthesis", "a linkage by what it is to do; checks; ready specs", wanted=True, omits=True, packages=True
        ),
        _stage("structure", "mobility, Assur groups, structural formula, class and order", wanted=True, table=False),
        _stage(
            "kinematics",
            "positions, velocities and accelerations over the cycle",
            needs=("structure",),
            wanted=True,
            omits=True,
            settings={"method": "closed", "step": 0.0, "decimals": 0},  # 0: the default step, no rounding
        ),
        _stage(
            "forces",
            "reactions in all pairs and the drive, with friction",
            needs=("kinematics",),
            wanted=True,
            omits=True,
            packages=True,
        ),
        _stage(
            "reduction",
            "reduced moments and inertia, work per cycle",
            uses=("kinematics",),
            wanted=True,
            omits=True,
            packages=True,
        ),
        _stage("train", "tooth numbers of the gear train: all sets within the constraints", wanted=True, omits=True),
        _stage("gearing", "a written train: speeds, torques, power flow, efficiency", wanted=True),
        _stage(
            "strength",
            "modules and face widths of all tooth sets by the endurance of the teeth",
            needs=("train",),
            uses=("reduction",),
            spares=True,
            wanted=True,
        ),
        _stage(
            "criteria",
            "the best gear train; its inertia and ratio for the machine",
            needs=("train", "strength"),
            wanted=True,
            omits=True,
        ),
        _stage(
            "pair",
            "geometry, checks and measures of pairs of gears",
            uses=("criteria",),
            spares=True,
            wanted=True,
        ),
        _stage(
            "blocking",
            "blocking contours of the pairs: all admissible shifts",
            needs=("pair",),
            wanted=True,
        ),
        _stage(
            "profile",
            "tooth profiles of the wheels of all pairs",
            needs=("pair",),
            wanted=True,
        ),
        _stage(
            "power",
            "work per cycle, efficiency, power, the motor",
            needs=("reduction",),
            uses=("criteria",),
            spares=True,
            wanted=True,
            omits=True,
            packages=True,
            table=False,
        ),
        _stage(
            "flywheel",
            "the flywheel for the allowed unevenness, by all methods",
            needs=("reduction", "power"),
            uses=("criteria",),
            spares=True,
            wanted=True,
            omits=True,
            packages=True,
            table=False,
        ),
        _stage(
            "motion",
            "steady motion of the machine: speed over the cycle",
            needs=("reduction", "power"),
            uses=("criteria", "flywheel"),
            spares=True,
            wanted=True,
            omits=True,
            packages=True,
            settings=TOLERANCE,
        ),
        _stage(
            "transient",
            "start-up, braking, run-down, load changes in time",
            needs=("reduction", "power"),
            uses=("criteria", "flywheel"),
            spares=True,
            wanted=True,
            omits=True,
            packages=True,
            settings=TOLERANCE,
        ),
        _stage(
            "unsteady",
            "motion from rest to rest by the time-optimal law",
            needs=("kinematics",),
            wanted=True,
        ),
        _stage(
            "manipulator", "gripper and joints of a manipulator over the time", wanted=True, omits=True, packages=True
        ),
        _stage(
            "balance",
            "shaking forces of linkage, engine, rotor; counterweights",
            uses=("kinematics",),
            wanted=True,
            omits=True,
        ),
        _stage("cam_law", "law of motion of the cam's follower, its constants and jumps", wanted=True, packages=True),
        _stage("cam_synthesis", "sizes of cam and follower within their limits", wanted=True, table=False),
        _stage("cam_profile", "pitch and working profile of the cam", needs=("cam_synthesis",), wanted=True),
        _stage("cam_pressure", "pressure angle over the turn", needs=("cam_synthesis",), wanted=True),
        _stage(
            "cam_forces",
            "spring, reactions and torque of the cam",
            needs=("cam_synthesis",),
            uses=("motion",),
            spares=True,
            wanted=True,
        ),
        _stage(
            "cam_strength",
            "slip, shaft, stem, pin and contact stress of the cam",
            needs=("cam_synthesis", "cam_forces"),
            uses=("motion",),
            spares=True,
            wanted=True,
        ),
        _stage(
            "cam_optimum",
            "the lowest cam mechanism within all constraints",
            needs=("cam_synthesis",),
            uses=("motion",),
            spares=True,
            wanted=True,
            table=False,
        ),
        _stage(
            "cam_elastic",
            "vibration of the follower on an elastic train",
            needs=("cam_synthesis",),
            uses=("motion",),
            spares=True,
            wanted=True,
        ),
        _stage("indexing", "cam-lantern indexing drive: limits, profiles, pressure angles, efficiency", wanted=True),
        _stage(
            "vibrator",
            "vibratory device: natural frequencies, steady vibration, starts",
            wanted=True,
            omits=True,
            packages=True,
        ),
        _stage("pendulum", "pendulum-rotor: whirl, critical speeds, torsion, motion in time", wanted=True),
        _stage("contact", "elastic contact: pressure, approach, Hertz as check", wanted=True, packages=True),
        _stage("reliability", "reliability under shock loads while the strength falls", wanted=True, packages=True),
        _stage("tie_down", "forces in the ties of a transported load", wanted=True, table=False),
        _stage("falling_ball", "fall of a ball whose radius decreases", wanted=True, packages=True),
        _stage("bearing", "speeds and frequencies of the defects of a bearing", wanted=True, table=False),
    )
}
STAGES["feasibility"] = _stage(
    "feasibility",
    "whether results keep the named constraints",
    uses=tuple(STAGES),
    spares=True,
    wanted=True,
    table=False,
)
