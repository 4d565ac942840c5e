"""The manifest of the gear room: tooth numbers, strength and choice of trains, pairs of gears, tooth profiles."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.manifest import Command, Group, Room, table
from tmmcalc.core.stage import Picture, Stage

if TYPE_CHECKING:
    from tmmcalc.gears.tables.criteria import CriteriaTable
    from tmmcalc.gears.tables.gearing import GearingTable
    from tmmcalc.gears.tables.open_pair import OpenPairTable
    from tmmcalc.gears.tables.pair import PairTable
    from tmmcalc.gears.tables.strength import StrengthTable
    from tmmcalc.gears.tables.train import TrainTable
    from tmmcalc.gears.tables.wheel import WheelTable
    from tmmcalc.linkage.room import LinkageTables
else:
    LinkageTables = object


class GearTables(LinkageTables):
    """The tables of the room, beside those that its stages read of others."""

    train: TrainTable | None = table(
        "The gear train: layout, ratio, tooth numbers.", subject=True, describes="gears", after="pendulum"
    )
    gearing: GearingTable | None = table(
        "A train of gears that is written out: its meshes, known speeds and torques.", subject=True, describes="gears"
    )
    strength: StrengthTable | None = table(
        "Strength of the train: torque, materials, modules and face widths.",
        belongs_to=("train",),
        why="it is that of the wheels of a gear train",
    )
    criteria: CriteriaTable | None = table(
        "By what the best train is chosen.", belongs_to=("train",), why="they choose one of the gear trains"
    )
    open_pair: OpenPairTable | None = table(
        "The open pair of gears between the reducer and the crank.",
        belongs_to=("mechanism", "torque"),
        why="its gear stands on the crank of a machine",
    )
    pair: PairTable | None = table(
        "Pairs of gears: written out, or those of the train that is chosen.", subject=True, describes="gears"
    )
    wheel: WheelTable | None = table("A wheel without a mate, external or a ring.", subject=True, describes="gears")


ROOM = Room(
    "gears",
    GearTables,
    (
        Stage(
            "train",
            "tooth numbers of the gear train: all sets within the constraints",
            asked=("train", "no tooth numbers are asked for"),
            uses=("drive",),
            reads="read_by_train",
            by_name={"advised": False},
            after="drive",
            picture=Picture(
                "a tooth set to scale from two sides, its plans of velocities and speeds, all sets by size and error, "
                "what constraints removed, curves of choice",
                ("--choose",),
                beside="criteria",
                pieces="tmmcalc.gears.pictures.pieces:train",
            ),
            moves=True,
            studied=True,
            chapter="gears",
        ),
        Stage(
            "gearing",
            "a written train: speeds, torques, power flow, efficiency",
            asked=("gearing", "no train is written out"),
            picture=Picture(
                "the scheme to scale, the plan of velocities and the plan of speeds",
                pieces="tmmcalc.gears.pictures.pieces:gearing",
            ),
            moves=True,
            chapter="gears",
        ),
        Stage(
            "strength",
            "modules and face widths of all tooth sets by the endurance of the teeth",
            needs=("train",),
            uses=("reduction",),
            reads="read_by_strength",
            wanted="strength",
            chapter="gears",
        ),
        Stage(
            "criteria",
            "the best gear train; its inertia and ratio for the machine",
            needs=("train", "strength"),
            wanted="strength",
            picture=Picture(
                "inertia against mass with the Pareto front, pairs of criteria, the chosen train to scale",
                ("--choose",),
            ),
            chapter="gears",
        ),
        Stage(
            "pair",
            "geometry, checks and measures of pairs of gears",
            uses=("criteria",),
            reads="read_by_pair",
            wanted="pair",
            picture=Picture(
                "teeth in mesh with the line of action, sliding and pressure along it",
                ("--choose", "--phase"),
                pieces="tmmcalc.gears.pictures.pieces:pair",
            ),
            chapter="gears",
            moves=True,
            studied=True,
        ),
        Stage(
            "open_pair",
            "the open pair on the crank: ratio, efficiency, inertia, load of its teeth",
            needs=("pair",),
            uses=("reduction",),
            reads="read_by_open_pair",
            wanted="open_pair",
            chapter="gears",
        ),
        Stage(
            "blocking",
            "blocking contours of the pairs: all admissible shifts",
            needs=("pair",),
            wanted="blocking",
            picture=Picture(
                "the blocking contour with its numbered lines and points",
                ("--choose",),
                pieces="tmmcalc.gears.pictures.pieces:blocking",
            ),
            moves=True,
            chapter="gears",
            studied=True,
        ),
        Stage(
            "profile",
            "tooth profiles of the wheels of all pairs",
            needs=("pair",),
            wanted="pair",
            picture=Picture(
                "how the rack cuts the teeth, each tooth enlarged, each by the textbook's points",
                ("--choose",),
                pieces="tmmcalc.gears.pictures.pieces:profile",
            ),
            chapter="gears",
            studied=True,
        ),
        Stage(
            "wheel",
            "a wheel without a mate: circles, limits, measures, profile",
            asked=("wheel", "no wheel by itself"),
            picture=Picture("how the tool cuts the teeth, half a tooth enlarged"),
            chapter="gears",
        ),
    ),
    (
        Command("synth", "Every set of tooth numbers within the constraints."),
        Command("planetary", "Speeds, torques, power flow, efficiency of any train."),
        Command("strength", "Modules and face widths of all tooth sets."),
        Command("compare", "Mass, inertia, size, efficiency; the best train."),
        Command("pair", "Geometry, shifts and checks of pairs of gears."),
        Command("open", "The open pair on the crank: ratio, losses, inertia, load."),
        Command("blocking", "Blocking contours: all admissible shifts of a pair."),
        Command("profile", "Tooth profiles; svg, dxf and csv files of gears."),
        Command("wheel", "A wheel without a mate: circles, limits, measures."),
        Command("measure", "Span, size over balls, chords of the teeth."),
    ),
    group=Group(
        "gears",
        "Gears: trains, strength, pairs, blocking contours, profiles.",
        "Gears: tooth numbers of trains within all constraints, strength, pairs, contours, tooth profiles, measures.",
        "tmmcalc gears synth my.toml",
    ),
    chapters={"gears": "Gears"},
    gives=True,
)
