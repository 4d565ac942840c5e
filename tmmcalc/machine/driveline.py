"""The drive line: all that stands between the motor and the input shaft, gathered in one place.

What the spec gives of the reducer wins; else ratio, efficiency and inertia are those of the gear train that was chosen;
without a train nothing is lost and nothing turns. An open pair between the reducer and the input shaft multiplies ratio
and efficiency and adds to the inertia, and every machine stage has it:

    u = u_r u_p,   eta = eta_r eta_p,   J = J_r u_p^2 + J_p

with J_r on the output shaft of the reducer and J_p on the input shaft.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.gears.openpair import OpenPair
    from tmmcalc.gears.selection.results import Winner
    from tmmcalc.machine.model import Gears


GIVEN, SPEEDS, NOTHING = "as given", "of the speeds of motor and crank", "none is given"


@record
class DrivePart:
    """The reducer or the open pair: what it gives to the drive line, each with where it comes from."""

    name: str = quantity("part", "part of the drive line")
    ratio: float | None = quantity("u_part", "ratio of the part")  # None: not known yet, `DriveLine.with_ratio`
    ratio_of: str = quantity("u_part_of", "where its ratio comes from")
    efficiency: float = quantity("eta_part", "efficiency of the part")
    efficiency_of: str = quantity("eta_part_of", "where its efficiency comes from")
    inertia: float = quantity("J_part[kg*m^2]", "inertia of the part reduced to the crank")
    inertia_of: str = quantity("J_part_of", "where its inertia comes from")


@record
class DriveLine:
    """Ratio, efficiency and inertia of the drive line as a whole, each with the gear train that it is of."""

    ratio: float | None = None  # motor speed over input speed; None: rated speed over the mean input speed
    efficiency: float = quantity("eta_gears", "efficiency of the gears to the motor", default=1.0)
    inertia: float = 0.0  # reduced to the input shaft [kg*m^2]
    ratio_of: str = ""  # empty: given, or of the speeds
    efficiency_of: str = quantity(
        "eta_gears_of", "gear train whose efficiency that of the gears is; empty: as given", default=""
    )
    inertia_of: str = ""  # empty: as given
    open: str = quantity("open_pair", "open pair that is in it; empty: none", default="")
    parts: tuple[DrivePart, ...] = ()  # reducer and open pair; none: without an open pair there is one part

    def with_ratio(self, ratio: float) -> tuple[DrivePart, ...]:
        """The parts, the reducer with what a total ``ratio`` of the speeds leaves to it."""
        if not self.parts:
            return ()
        reducer, on_crank = self.parts
        if reducer.ratio is not None or on_crank.ratio is None:
            return self.parts
        return replace(reducer, ratio=ratio / on_crank.ratio), on_crank


@record
class Round:
    """A round in which motor, ratio and train are settled: the motor, and the train that its speed leads to."""

    motor: str = quantity("motor", "name of the motor")
    ratio: float = quantity("u", "speed of the motor over that of the input shaft")
    train: str = quantity("gear_train", "gear train of this ratio")
    efficiency: float = quantity("eta_gears", "efficiency of the gears to the motor")
    inertia: float = quantity("J_gears[kg*m^2]", "inertia of the gears")


def drive_line(given: Gears, train: Winner | None = None) -> DriveLine:
    """The drive line of what the spec gives and of the ``train`` that was chosen, None: there is none."""
    name = "" if train is None else train.name
    ratio, efficiency, inertia = given.ratio, given.efficiency, given.inertia
    reducer = DriveLine(
        ratio if ratio is not None or train is None else train.to_crank,
        efficiency if efficiency is not None else 1.0 if train is None else train.values["efficiency"],
        inertia if inertia is not None else 0.0 if train is None else train.on_crank,
        "" if ratio is not None else name,
        "" if efficiency is not None else name,
        "" if inertia is not None else name,
    )
    return reducer if given.open is None else _with_open(reducer, given, given.open)


def _with_open(reducer: DriveLine, given: Gears, pair: OpenPair) -> DriveLine:
    """The drive line of a reducer, whose ratio has the pair's in it already, with an open pair behind it."""
    train = f"of gear train {reducer.efficiency_of or reducer.ratio_of or reducer.inertia_of}"
    first = DrivePart(
        "reducer",
        None if reducer.ratio is None else reducer.ratio / pair.ratio,
        train if reducer.ratio_of else SPEEDS if reducer.ratio is None else GIVEN,
        reducer.efficiency,
        train if reducer.efficiency_of else NOTHING if given.efficiency is None else GIVEN,
        reducer.inertia,
        train if reducer.inertia_of else NOTHING if given.inertia is None else GIVEN,
    )
    by_sizes = "by module, teeth and face width" if pair.inertia is None else GIVEN
    second = DrivePart(
        pair.name, pair.ratio, "of its teeth", pair.efficiency, pair.efficiency_of, pair.on_crank, by_sizes
    )
    return replace(
        reducer,
        efficiency=reducer.efficiency * pair.efficiency,
        inertia=reducer.inertia + pair.on_crank,
        open=pair.name,
        parts=(first, second),
    )
