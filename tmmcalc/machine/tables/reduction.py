"""``[reduction]``: how forces and masses are reduced to the crank."""

from typing import Literal

from pydantic import Field

from tmmcalc.spec.table import Table


class ReductionTable(Table):
    """How forces and masses are reduced to the crank."""

    rods: Literal["exact", "lumped"] = Field(
        default="exact",
        description='`"exact"`, connecting rods as they are, or `"lumped"`: their masses put into their pins, which '
        "keeps the centre of mass but not the moment of inertia.",
    )
