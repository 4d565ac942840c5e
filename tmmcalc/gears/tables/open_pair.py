"""``[open_pair]``: the open pair of gears between the output shaft of the reducer and the crank."""

from typing import Annotated

from pydantic import Field

from tmmcalc.gears.tables.gearing import Efficiency, Friction
from tmmcalc.gears.tables.pair import PairKeys
from tmmcalc.gears.tables.strength import MaterialTable, RowForm
from tmmcalc.spec.quantities import Inertia

Row = Annotated[int, RowForm()]


class OpenPairTable(PairKeys):
    """A pinion on the output shaft of the reducer and a gear on the crank: teeth, losses, inertia, materials."""

    efficiency: Efficiency | None = Field(
        default=None, description="Efficiency of the pair (default: 0.975, of a ring 0.985, or by `friction`)."
    )
    friction: Friction | None = Field(
        default=None,
        description="Or the coefficient of friction of its teeth: the efficiency is 1 - 2.3 f (1/z1 +- 1/z2), - for "
        "a ring.",
    )
    inertia: Inertia | None = Field(
        default=None,
        description="Moment of inertia of both wheels, reduced to the crank (default: by module, teeth and width, as "
        "that of a train).",
    )
    material: MaterialTable | None = Field(
        default=None, description="Material of both wheels; or `pinion` and `gear` apart (default: as in `[strength]`)."
    )
    pinion: MaterialTable | None = Field(default=None, description="Material of the pinion, in place of `material`.")
    gear: MaterialTable | None = Field(
        default=None, description="Material of the gear on the crank, in place of `material` (default: as the pinion)."
    )
    arrangement: Row = Field(
        default=1, description="Row of Table D.4.1, 1 to 7: where the wheels stand between their bearings."
    )
