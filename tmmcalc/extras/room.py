"""The manifest of the small calculators of neighbouring fields."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.manifest import Command, Group, Room, table
from tmmcalc.core.stage import Picture, Stage

if TYPE_CHECKING:
    from tmmcalc.extras.tables.bearing import BearingTable
    from tmmcalc.extras.tables.contact import ContactTable
    from tmmcalc.extras.tables.falling_ball import FallingBallTable
    from tmmcalc.extras.tables.liner import LinerTable
    from tmmcalc.extras.tables.reliability import ReliabilityTable
    from tmmcalc.extras.tables.tie_down import TieDownTable
    from tmmcalc.extras.tables.transloader import TransloaderTable


class ExtraTables:
    """The tables of the room."""

    contact: ContactTable | None = table("Two elastic bodies that are pressed together.", subject=True)
    reliability: ReliabilityTable | None = table(
        "A product whose strength falls while shock loads strike it.", subject=True
    )
    tie_down: TieDownTable | None = table("Ties that hold a load on a vehicle.", subject=True)
    falling_ball: FallingBallTable | None = table("A ball that falls while its radius decreases.", subject=True)
    bearing: BearingTable | None = table("A rolling bearing and the frequencies of its defects.", subject=True)
    liner: LinerTable | None = table("A cylinder liner, its collar as a ring, the cylinder as a shell.", subject=True)
    transloader: TransloaderTable | None = table(
        "A grab transloader, its speeds, loads and the stresses of its parts.", subject=True
    )


ROOM = Room(
    "extras",
    ExtraTables,
    (
        Stage(
            "contact",
            "elastic contact: pressure, approach, Hertz as check",
            asked=("contact", "no bodies are pressed together"),
            picture=Picture("the field of pressure, and along the axis of x beside Hertz"),
            studied=True,
            chapter="extras",
            tells_data=True,
        ),
        Stage(
            "reliability",
            "reliability under shock loads while the strength falls",
            asked=("reliability", "no life is asked for"),
            picture=Picture("reliability and density of failures over the time"),
            chapter="extras",
            tells_data=True,
        ),
        Stage(
            "tie_down",
            "forces in the ties of a transported load",
            asked=("tie_down", "no load is tied down"),
            picture=Picture("forces of the ties over the inertia"),
            chapter="extras",
            tells_data=True,
        ),
        Stage(
            "falling_ball",
            "fall of a ball whose radius decreases",
            asked=("falling_ball", "no ball falls"),
            picture=Picture("speed and way of the ball over the time"),
            studied=True,
            chapter="extras",
            tells_data=True,
        ),
        Stage(
            "bearing",
            "speeds and frequencies of the defects of a bearing",
            asked=("bearing", "no bearing is asked for"),
            chapter="extras",
            tells_data=True,
        ),
        Stage(
            "liner",
            "cylinder liner as ring and shell: deflection, moments, stresses",
            asked=("liner", "no cylinder liner"),
            picture=Picture("deflection, moment and stresses along the bore"),
            chapter="extras",
            tells_data=True,
        ),
        Stage(
            "transloader",
            "grab transloader: speeds with their limits, loads by case, stresses",
            asked=("transloader", "no transloader"),
            moves=True,
            picture=Picture("speeds of the ways, loads by case, stresses of the parts"),
            chapter="extras",
            tells_data=True,
        ),
    ),
    (
        Command("contact", "Pressure of two elastic bodies, with Hertz as check."),
        Command("reliability", "Reliability and life under shock loads."),
        Command("tie-down", "Forces in the ties of a transported load."),
        Command("ball", "Fall of a ball whose radius decreases."),
        Command("bearing", "Frequencies of the defects of a rolling bearing."),
        Command("liner", "Stresses of a cylinder liner as ring and shell."),
        Command("transloader", "Speeds, loads by case and stresses of a grab transloader."),
    ),
    group=Group(
        "extra",
        "Contact, reliability, tie-down, falling ball, bearing, liner, transloader.",
        "Small calculators: elastic contact, reliability, tie-down of loads, a falling ball, rolling bearings, "
        "cylinder liners, grab transloaders.",
        "tmmcalc extra contact my.toml",
    ),
    chapters={"extras": "Further calculations"},
)
