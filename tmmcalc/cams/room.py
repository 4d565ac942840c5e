"""The manifest of the cam room: laws of motion, synthesis, profile, forces, strength, optimum, indexing drives."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.manifest import Command, Group, Room, table
from tmmcalc.core.stage import Picture, Stage

if TYPE_CHECKING:
    from tmmcalc.cams.tables.cam import CamTable
    from tmmcalc.cams.tables.indexing import IndexingTable
    from tmmcalc.machine.room import MachineTables
else:
    MachineTables = object

CAM = ("cam", "no cam is asked for")


class CamTables(MachineTables):
    """The tables of the room, beside those that its stages read of others."""

    cam: CamTable | None = table(
        "A disk cam and its follower.",
        subject=True,
        describes="cams",
        checks=("cam", "cam_laws", "cam_sizes", "cam_loads", "cam_shaft", "cam_search"),
        files=("law.file", "rise_law.file", "return_law.file", "loads.force_table.file"),
        after="pair",
    )
    indexing: IndexingTable | None = table(
        "Two paired cams that turn a wheel of rollers step by step.",
        subject=True,
        describes="cams",
        files=("law.file",),
    )


ROOM = Room(
    "cams",
    CamTables,
    (
        Stage(
            "cam_law",
            "law of motion of the cam's follower, its constants and jumps",
            asked=CAM,
            after="forces",
            picture=Picture(
                "displacement and its derivatives over the turn, their graphical integration",
                pieces="tmmcalc.cams.pictures.pieces:law_pieces",
            ),
            chapter="cams",
            studied=True,
        ),
        Stage(
            "cam_synthesis",
            "sizes of cam and follower within their limits",
            asked=CAM,
            picture=Picture(
                "the admissible places of the cam's axis", pieces="tmmcalc.cams.pictures.pieces:synthesis_pieces"
            ),
            chapter="cams",
            studied=True,
        ),
        Stage(
            "cam_load",
            "what the cam asks of the shaft that drives it",
            needs=("cam_synthesis",),
            wanted="load",
            feeds=("reduction", "transient"),
        ),
        Stage(
            "cam_profile",
            "pitch and working profile of the cam",
            needs=("cam_synthesis",),
            asked=CAM,
            after="balance",
            picture=Picture("the cam to scale, its curvature", pieces="tmmcalc.cams.pictures.pieces:profile_pieces"),
            chapter="cams",
            moves=True,
            studied=True,
        ),
        Stage(
            "cam_pressure",
            "pressure angle over the turn",
            needs=("cam_synthesis",),
            asked=CAM,
            picture=Picture("the pressure angle over the turn", pieces="tmmcalc.cams.pictures.pieces:pressure_pieces"),
            chapter="cams",
            studied=True,
        ),
        Stage(
            "cam_forces",
            "spring, reactions and torque of the cam",
            needs=("cam_synthesis",),
            uses=("motion",),
            reads="read_at_speed",
            wanted="forces",
            chapter="cams",
            picture=Picture("spring, reactions, torque"),
            studied=True,
        ),
        Stage(
            "cam_strength",
            "slip, shaft, stem, pin and contact stress of the cam",
            needs=("cam_synthesis", "cam_forces"),
            uses=("motion",),
            reads="read_at_speed",
            wanted="strength",
            chapter="cams",
            picture=Picture("slip and contact stress"),
        ),
        Stage(
            "cam_optimum",
            "the smallest cam mechanism within all constraints",
            needs=("cam_synthesis",),
            uses=("motion",),
            reads="read_at_speed",
            wanted="optimum",
            chapter="cams",
            picture=Picture("the blocking contour"),
            studied=True,
        ),
        Stage(
            "cam_elastic",
            "vibration of the follower on an elastic train",
            needs=("cam_synthesis",),
            uses=("motion",),
            reads="read_at_speed",
            wanted="elastic",
            chapter="cams",
            picture=Picture("the follower's vibration over the turn, what the laws leave of it"),
            studied=True,
        ),
        Stage(
            "indexing",
            "cam-lantern indexing drive: limits, profiles, pressure angles, efficiency",
            asked=("indexing", "no indexing drive is asked for"),
            chapter="cams",
            moves=True,
            picture=Picture(
                "scheme at --phase of a step, pressure angles, tip of the lobe, efficiency, what lambda and the step "
                "decide",
                ("--phase",),
                pieces="tmmcalc.cams.pictures.pieces:indexing_pieces",
            ),
            studied=True,
        ),
    ),
    (
        Command("law", "Law of motion of the follower, its constants and jumps."),
        Command("synth", "Sizes within the limits of the pressure angle."),
        Command("profile", "Pitch and working profile; svg, dxf and csv files."),
        Command("forces", "Spring, reactions, friction, torque of the cam."),
        Command("strength", "Slip, shaft, stem, pin, contact stress with margins."),
        Command("elastic", "Vibration of a follower on an elastic train."),
        Command("optimize", "The lowest mechanism; blocking contour; what limits it."),
        Command("indexing", "Cam-lantern indexing drive: limits, profiles, efficiency."),
    ),
    group=Group(
        "cam",
        "Cams: laws, synthesis, profile, forces, strength, optimum.",
        "Cams: laws of motion, sizes, profiles, forces, strength, the lowest mechanism.",
        "tmmcalc cam synth my.toml",
    ),
    chapters={"cams": "Synthesis of the cam mechanism"},
    gives=True,
)
