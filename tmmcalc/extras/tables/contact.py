"""``[contact]``: two elastic bodies that are pressed together."""

from typing import Annotated

from pydantic import Field

from tmmcalc.spec.choices import Listed, OneOrMore, Whole, Within
from tmmcalc.spec.quantities import Length, Number, Quantity
from tmmcalc.spec.table import Table

_POSITIVE = {"at_least_zero": True, "nonzero": True}

Load = Annotated[float, Quantity("force", **_POSITIVE)]
Modulus = Annotated[float, Quantity("pressure", **_POSITIVE)]
Moduli = Annotated[list[float], Listed(Quantity("pressure", **_POSITIVE), '["206000 MPa", "206000 MPa"]', 2)]
Poissons = Annotated[list[float], Listed(Number("Poisson's ratio", "0.3", above=-1, at_most=0.5), "[0.3, 0.3]", 2)]
Radii = Annotated[list[float], OneOrMore(Quantity("length", **_POSITIVE))]
Cells = Annotated[int, Whole("a number of steps", 6, 40)]
Size = Annotated[float, Within("length", "mm", 1e-3, 1e-6, 1e7)]
Places = Annotated[list[float], Listed(Quantity("length"), '["-1 mm", 0, "1 mm"]')]


class GapTableTable(Table):
    """A gap on a rectangle."""

    x: Places = Field(description="Places along x, ascending.")
    y: Places = Field(description="Places along y, ascending.")
    h: list[list[Length]] = Field(description="The gap: a row for each y, a value for each x.")


class ContactTable(Table):
    """Load, elasticity, the gap of the unloaded bodies, the grid."""

    load: Load = Field(description="P: force that presses the bodies together.")
    modulus: Modulus | None = Field(
        default=None,
        description="E*: composite modulus, 1/E* = sum of (1 - nu^2)/E, in place of those of the bodies (default: "
        "by the bodies).",
    )
    young: Moduli = Field(
        default=[206e9, 206e9],
        description='E of the two bodies: `young = ["206000 MPa", "115000 MPa"]`.',
    )
    poisson: Poissons = Field(default=[0.3, 0.3], description="Poisson's ratios of the two bodies.")
    radii: Radii | None = Field(
        default=None,
        description="The gap of the unloaded bodies: radii of the relative paraboloid in the planes xz and yz (one "
        "for both).",
    )
    gap: str | None = Field(
        default=None,
        description='Or a formula of the gap in `x` and `y`, all in metres, such as `"x**2/0.04 + y**4/1e-4"`.',
    )
    table: GapTableTable | None = Field(default=None, description="Or a table of the gap on a rectangle.")
    cells: Cells = Field(
        default=24,
        description="N, 6 to 40: steps of the grid from its middle to a corner; it has 3 N (N + 1) + 1 nodes.",
    )
    size: Size | None = Field(
        default=None,
        description="From the middle of the grid to its corners on the axis of x (default: "
        "1.5 of Hertz's larger half-axis); of a table as far as it reaches.",
    )
