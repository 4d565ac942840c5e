"""The manifest of the linkage room: structure, kinematics, forces, unsteady motion and synthesis of plane linkages."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError
from tmmcalc.core.manifest import Command, Room, table
from tmmcalc.core.stage import Picture, Stage

if TYPE_CHECKING:
    from tmmcalc.feasibility.room import FeasibilityTables
    from tmmcalc.linkage.tables.drive import DriveTable
    from tmmcalc.linkage.tables.dyad import DyadTable
    from tmmcalc.linkage.tables.loads import LoadTable
    from tmmcalc.linkage.tables.mechanism import MechanismTable
    from tmmcalc.linkage.tables.paths import PathTable
    from tmmcalc.linkage.tables.springs import SpringTable
    from tmmcalc.linkage.tables.synthesis import LinkSynthesisTable
    from tmmcalc.linkage.tables.unsteady import UnsteadyTable
else:
    FeasibilityTables = object

LINKS = ("mechanism",)


class LinkageTables(FeasibilityTables):
    """The tables of the room, beside those that its stages read of others."""

    mechanism: MechanismTable | None = table("The linkage.", subject=True, describes="a mechanism")
    synthesis: LinkSynthesisTable | None = table(
        "A linkage to be found by what it is to do.",
        subject=True,
        describes="a linkage to be found",
        checks=("synthesis", "dwell"),
        gives="mechanism",
    )
    dyad: DyadTable | None = table(
        "A dyad by itself, moved by its outer joints.", subject=True, describes="a dyad by itself"
    )
    loads: list[LoadTable] = table(
        "Technological forces and moments on the links.",
        belongs_to=LINKS,
        why="loads act on the links of a mechanism",
        checks=("loads", "laws"),
        files=("table.file",),
        named=("load_names", "name", "link"),
        after="torque",
    )
    springs: list[SpringTable] = table(
        "Springs and dampers between links.",
        belongs_to=LINKS,
        why="springs join the links of a mechanism",
        named=("spring_names", "name"),
    )
    paths: list[PathTable] = table(
        "Wanted paths of points of the links.",
        belongs_to=LINKS,
        why="they are those of points of a mechanism",
        named=("path_names", "name", "point"),
    )
    drive: DriveTable | None = table(
        "How the drive acts on the crank.", belongs_to=LINKS, why="it drives the crank of a mechanism"
    )
    unsteady: UnsteadyTable | None = table(
        "A motion of the mechanism from rest to rest by the time-optimal law.",
        belongs_to=LINKS,
        why="it is the motion of a mechanism",
        after="transients",
    )

    @property
    def linkage(self) -> MechanismTable:
        """The mechanism, where one is needed; raises UsageError if the spec has none."""
        if self.mechanism is None:
            raise UsageError(
                "the spec has no [mechanism]", remedy="add [mechanism], or ask for a stage that needs none"
            )
        return self.mechanism


ROOM = Room(
    "linkage",
    LinkageTables,
    (
        Stage(
            "synthesis",
            "a linkage by what it is to do; checks; ready specs",
            chapter="synthesis",
            tells_data=True,
            asked=("synthesis", "no linkage is to be found"),
            settles=True,
            moves=True,
            another=True,
            picture=Picture(
                "the linkage found in its extreme positions with dimensions, or at its points with the coupler curve",
                ("--choose",),
            ),
        ),
        Stage(
            "structure",
            "mobility, Assur groups, structural formula, class and order",
            wanted="moves",
            chapter="structure",
        ),
        Stage(
            "kinematics",
            "positions, velocities and accelerations over the cycle",
            needs=("structure",),
            wanted="moves",
            settings={"method": "closed", "step": 0.0, "decimals": 0},  # 0: the default step, no rounding
            chapter="kinematics",
            moves=True,
            picture=Picture(
                "scheme in its positions, paths of points, diagrams of the outputs; with --polygons plans of "
                "velocities and accelerations",
                ("--positions", "--polygons"),
                pieces="tmmcalc.linkage.pictures.pieces:of_kinematics",
            ),
            studied=True,
        ),
        Stage(
            "paths",
            "how far the paths of points are from wanted ones",
            needs=("kinematics",),
            wanted="paths",
            chapter="kinematics",
            picture=Picture("the paths with the wanted points, and how far each is"),
        ),
        Stage(
            "forces",
            "reactions in all pairs and the drive, with friction",
            needs=("kinematics",),
            wanted="forces",
            chapter="forces",
            picture=Picture(
                "reactions, hodographs, drive; with --polygons load diagrams, force polygons, lever of Zhukovsky",
                ("--polygons",),
                pieces="tmmcalc.linkage.pictures.pieces:of_forces",
            ),
            studied=True,
        ),
        Stage(
            "unsteady",
            "motion from rest to rest by the time-optimal law",
            needs=("kinematics",),
            wanted="unsteady",
            after="transient",
            picture=Picture("input, outputs and links over the time"),
            chapter="unsteady",
            moves=True,
        ),
        Stage(
            "dyad",
            "motion of a dyad with given states of its outer joints",
            asked=("dyad", "no dyad by itself is asked for"),
            chapter="dyad",
            tells_data=True,
            picture=Picture("the dyad to scale with the velocities and the accelerations of its points"),
        ),
    ),
    (
        Command("synth", "Linkages by stroke, swing, path, function or motion."),
        Command("dyad", "A dyad with given states of its outer joints."),
        Command("structure", "Mobility, Assur groups, structural formula."),
        Command("kinematics", "Positions, velocities, accelerations, dead centres, strokes."),
        Command("paths", "How far the path of a point is from a wanted one."),
        Command("forces", "Reactions in the pairs, friction, driving moment."),
        Command("unsteady", "Motion from rest to rest by the time-optimal law."),
    ),
    section="Linkages",
    chapters={
        "synthesis": "Synthesis of the linkage",
        "structure": "Structural analysis",
        "kinematics": "Kinematic analysis",
        "forces": "Force analysis",
        "unsteady": "Unsteady motion of the mechanism",
        "dyad": "Motion of the dyad",
    },
    gives=True,
)
