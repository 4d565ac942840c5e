"""``[torque]``: a torque diagram alone, in place of a mechanism."""

import math
from typing import Annotated, Literal

from pydantic import Field, PrivateAttr

from tmmcalc.spec.identifiers import Name
from tmmcalc.spec.quantities import Angle, Inertia, Moment, Number, Quantity, ShaftSpeed
from tmmcalc.spec.table import Table

DiagramName = Annotated[str, Name("torque diagram")]
ConstantName = Annotated[str, Name("constant")]
Constant = Annotated[float, Number("a constant", "500")]
Order = Annotated[float, Number("an order", "2", above=0)]
Period = Annotated[float, Quantity("angle", at_least_zero=True, nonzero=True)]
Place = Annotated[float, Quantity("angle", at_least_zero=True)]
Interpolation = Literal["linear", "pchip", "spline"]
# An angle, then a moment: lists of one kind of value are what editors follow; the checks tell the two apart.
Piece = Annotated[list[Annotated[float, Quantity("angle", "moment")]], Field(min_length=2, max_length=2)]


def with_powers(formula: str) -> str:
    """Return a formula with its powers as ``**``, which is how formulas are read; in a spec ``^`` is one, as in units.

    >>> with_powers("sin(theta)^2")
    'sin(theta)**2'
    """
    return formula.replace("^", "**")


class HarmonicTable(Table):
    """One harmonic: cos cos(k theta) + sin sin(k theta)."""

    order: Order = Field(description="Order: how often it repeats in a turn.")
    cos: Moment = Field(default=0.0, description="Amplitude of cos(order theta).")
    sin: Moment = Field(default=0.0, description="Amplitude of sin(order theta).")


class HarmonicsTable(Table):
    """A constant moment and harmonics."""

    constant: Moment = Field(default=0.0, description="Constant part.")
    terms: list[HarmonicTable] = Field(min_length=1, description="The harmonics, which are added to it.")


class TorqueCurveTable(Table):
    """Moments at given angles, in the table itself or in a file."""

    theta: list[Place] | None = Field(
        default=None,
        min_length=2,
        description="Angles, ascending within the period (default: n values are n equal steps of the period).",
    )
    moment: list[Moment] | None = Field(default=None, min_length=2, description="Moment at each angle.")
    file: str | None = Field(
        default=None,
        description="CSV file in place of the values: two columns under a header such as `theta[deg],M[N*m]`; "
        "its path counts from the folder of the spec.",
    )
    columns: str | None = Field(
        default=None,
        description="Columns of a file that has more than two: of the values, or of both, as `--columns` names them, "
        '`"phi,M_red"`.',
    )
    interpolation: Interpolation = Field(
        default="linear",
        description='`"linear"`: straight lines, `"pchip"`, a smooth monotone curve, or `"spline"`, the cubic spline, '
        "which is the nearest to a smooth moment.",
    )


class InertiaCurveTable(Table):
    """The reduced inertia at given angles, in the table itself or in a file."""

    theta: list[Place] | None = Field(
        default=None,
        min_length=2,
        description="Angles, ascending within the period (default: n values are n equal steps of the period).",
    )
    inertia: list[Inertia] | None = Field(default=None, min_length=2, description="Reduced inertia at each angle.")
    file: str | None = Field(
        default=None,
        description="CSV file in place of the values: two columns under a header such as `theta[deg],J[kg*m^2]`; "
        "its path counts from the folder of the spec.",
    )
    columns: str | None = Field(
        default=None,
        description="Columns of a file that has more than two: of the values, or of both, as `--columns` names them, "
        '`"phi,J_red"`.',
    )
    interpolation: Interpolation = Field(
        default="spline",
        description='`"spline"`: the cubic spline, `"pchip"`, a smooth monotone curve, or `"linear"`, straight lines.',
    )
    period: Period | None = Field(
        default=None, description="Angle after which it repeats, a whole part of the cycle (default: the cycle)."
    )


class TorqueTable(Table):
    """The moment on the input shaft over one cycle, by exactly one law; a positive moment drives."""

    name: DiagramName = Field(default="torque", description="What the diagram is called in tables.")
    speed: ShaftSpeed = Field(
        description='Mean speed of the shaft; `"by the motor"`: that of the motion that the motor gives it through the '
        "ratio that is given."
    )
    period: Period = Field(default=2 * math.pi, description='Angle of the cycle; `"720 deg"` for a four-stroke engine.')
    formula: str | None = Field(
        default=None, description='Moment in N*m over `theta` (or `phi`) in rad, such as `"500*sin(theta)^2 - 120"`.'
    )
    constants: dict[ConstantName, Constant] = Field(
        default={}, description="Beside a formula: numbers that it names, `{ M0 = 500 }`."
    )
    harmonics: HarmonicsTable | None = Field(
        default=None,
        description='A constant moment and harmonics: `{ constant = "20 N*m", terms = [{ order = 2, cos = "-57 N*m", '
        'sin = "95 N*m" }] }`.',
    )
    pieces: list[Piece] | None = Field(
        default=None,
        min_length=2,
        description='Straight pieces through points `[theta, moment]`: `[["0 deg", "100 N*m"], ["90 deg", "100 '
        'N*m"], ["90 deg", "-50 N*m"]]`; two points at one angle are a jump. '
        "The last point is joined to the first of the next cycle.",
    )
    table: TorqueCurveTable | None = Field(
        default=None, description='Values at angles: `{ theta = ["0 deg", "90 deg", "270 deg"], moment = [...] }`.'
    )
    delays: list[Angle] | None = Field(
        default=None,
        min_length=1,
        description='Several equal diagrams on one shaft: the delay of each, `["0 deg", "180 deg"]`.',
    )
    count: int | None = Field(
        default=None, ge=1, le=1000, description="Or only how many equal diagrams, with even delays over the period."
    )
    inertia: Inertia = Field(default=0.0, description="Constant moment of inertia of the shaft and what turns with it.")
    reduced_inertia: InertiaCurveTable | None = Field(
        default=None,
        description="Beside `inertia`: the reduced inertia that varies with the angle, as that of a linkage does; of "
        'several equal diagrams each has it. `{ file = "reduction.csv", columns = "phi,J_red" }`.',
    )
    balanced: bool = Field(
        default=False,
        description="Whether the constant moment is added that makes the work of a cycle zero: "
        "the load of an engine, the drive of a working machine. `reduce` and `power` keep its work and "
        "power apart from those of the diagram.",
    )
    _by_motor: bool = PrivateAttr(default=False)  # the speed is that of the motion that the motor gives

    @property
    def by_motor(self) -> bool:
        """Whether the spec leaves the speed to the motor: the number here is found, not given."""
        return self._by_motor

    def run_by(self, speed: float) -> "TorqueTable":
        """The table with the speed [rad/s] that the motor gives."""
        found = self.model_copy(update={"speed": speed})
        found._by_motor = True
        return found
