"""``[liner]``: a wet cylinder liner, its collar as a ring, the cylinder as a shell."""

from typing import Annotated, Literal

from pydantic import Field

from tmmcalc.spec.choices import Known, Whole
from tmmcalc.spec.quantities import Number, Quantity, Size
from tmmcalc.spec.table import Table

_POSITIVE = {"at_least_zero": True, "nonzero": True}

Pressure = Annotated[float, Quantity("pressure", **_POSITIVE)]
Inside = Annotated[float, Quantity("pressure")]
Poisson = Annotated[float, Number("a Poisson's ratio", "0.25", at_least=0, at_most=0.5)]
LineLoad = Annotated[float, Quantity("stiffness")]  # N/m
LineMoment = Annotated[float, Quantity("force")]  # N*m/m
Arm = Annotated[float, Quantity("length")]
Factor = Annotated[float, Number("a multiple of the gas force", "1.8", above=0, at_most=100)]
Continuity = Annotated[Literal["edge", "centre"], Known("part of the ring that the shell follows", ("edge", "centre"))]
Rows = Annotated[int, Whole("a number of rows", 2, 100_000)]


class ClampTable(Table):
    """The force that holds the collar between the head and the block."""

    gas_pressure: Pressure = Field(description="p_max: largest pressure of the gas.")
    bore: Size = Field(description="Diameter of the area F_h that the gas acts on.")
    arm: Arm = Field(
        description="How much farther from the axis the block carries the collar than the head presses on it."
    )
    factor: Factor = Field(default=1.8, description="P = factor p_max F_h holds the collar.")


class LinerTable(Table):
    """The shell, the ring, what loads them."""

    radius: Size = Field(description="r1: radius of the shell, at which the ring joins it.")
    thickness: Size = Field(description="h: wall of the shell.")
    ring_outer: Size = Field(description="r2: outer radius of the ring.")
    ring_width: Size = Field(description="b: width of the ring along the bore.")
    length: Size | None = Field(
        default=None, description="L: length of the shell, its far end free (default: a long one, by the formulas)."
    )
    young: Pressure = Field(default=1e11, description="E: modulus of elasticity.")
    poisson: Poisson = Field(default=0.25, description="mu: Poisson's ratio.")
    load: LineLoad = Field(
        default=0.0, description="q: force on the ring outwards, on a unit of its circumference at r1, in N/m."
    )
    moment: LineMoment | None = Field(
        default=None,
        description="m: moment on the ring, on a unit of its circumference at r1, in N*m/m = N, towards larger "
        "dw/dx (default: 0); or `[liner.clamp]`.",
    )
    clamp: ClampTable | None = Field(default=None, description="The force that clamps the collar, which gives m.")
    pressure: Inside = Field(default=0.0, description="p: pressure in the shell below the ring.")
    continuity: Continuity = Field(
        default="edge",
        description='What of the ring the shell follows: its `"edge"`, which the turn of the ring moves by psi b/2, '
        'or its `"centre"`, as in the source.',
    )
    allowed: Pressure | None = Field(default=None, description="Allowed equivalent stress of the shell.")
    rows: Rows = Field(default=200, description="Equal steps of the table along the bore.")
