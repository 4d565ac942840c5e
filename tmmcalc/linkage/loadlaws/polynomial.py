"""A load that is a polynomial of the angle."""

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from pydantic import Field

from tmmcalc.core.records import record
from tmmcalc.linkage.loadlaws.law import Called, Key, Kind, Law, kind_of_values, values_of
from tmmcalc.linkage.loadlaws.placed import Placed
from tmmcalc.spec.quantities import Number
from tmmcalc.spec.table import Table

if TYPE_CHECKING:
    from tmmcalc.core.plane import Real
    from tmmcalc.linkage.loads.values import Acting, Value
    from tmmcalc.report.manuscript import Datum
    from tmmcalc.spec.findings import Finding
    from tmmcalc.spec.outline import Raw
    from tmmcalc.spec.phrases import Path

Coefficient = Annotated[float, Number("a coefficient", "1.5")]


class PolynomialTable(Table):
    """A polynomial of the angle from the beginning of the load's window: c0, c1, ... in SI per rad^k."""

    force: list[Coefficient] | None = Field(
        default=None, min_length=1, description="Coefficients c0, c1, c2, ... of a force, in N/rad^k."
    )
    moment: list[Coefficient] | None = Field(
        default=None, min_length=1, description="Coefficients c0, c1, c2, ... of a moment, in N*m/rad^k."
    )


@record
class Polynomial(Placed):
    """sum c_k (theta - theta_0)^k, theta_0 the beginning of the load's window [N or N*m, per rad^k]."""

    coefficients: tuple[float, ...]

    rank = 20
    counted = True
    alike = True
    lists: ClassVar = {
        "polynomial.force": ("a list of coefficients", "force = [0, 250, -12.5]"),
        "polynomial.moment": ("a list of coefficients", "moment = [0, 25, -1.2]"),
    }
    inline: ClassVar = {"polynomial": "polynomial = { force = [0, 250, -12.5] }"}

    @classmethod
    def spec_keys(cls) -> Mapping[str, Key]:
        """The table of its coefficients."""
        says = (
            "`{ force = [c0, c1, c2] }` (or `moment`): c0 + c1 theta + c2 theta^2 ..., numbers in SI per rad^k; theta "
            "counts from the beginning of the window."
        )
        return {"polynomial": Key(PolynomialTable, says)}

    @classmethod
    def kind_of(cls, load: "Raw", key: str) -> Kind | None:
        """What its coefficients are of."""
        return kind_of_values(load, key)

    @classmethod
    def from_table(cls, load: Any, key: str) -> tuple[Kind, Law]:
        """The law of a table."""
        kind, coefficients = values_of(getattr(load, key))
        return kind, cls(coefficients)

    @classmethod
    def check_kind(cls, load: "Raw", key: str, path: "Path") -> Iterator["Finding"]:
        """Its coefficients are of a force or of a moment."""
        from tmmcalc.spec.findings import Finding

        if not isinstance(load[key], dict) or len({"force", "moment"} & {*load[key]}) == 1:
            return
        both = "force" in load[key]
        yield Finding(
            (*path, key),
            "force and moment together: a load is one of them" if both else "missing key: force or moment",
            "write one [[loads]] for each" if both else "write polynomial = { force = [0, 250, -12.5] }",
        )

    def given(self, table: Any, called: Called) -> "Iterator[Datum]":
        """The polynomial as a formula."""
        from tmmcalc.report.language import tr, tr_unit
        from tmmcalc.report.manuscript import Datum

        name = called.load
        if called.windowed:
            said = (
                tr("given load {name}; $theta$ – angle of the crank from its beginning, rad", name=name)
                if called.turns
                else tr("given load {name}; $theta$ – travel of the drive from its beginning, m", name=name)
            )
        else:
            said = (
                tr("given load {name}; $theta$ – angle of the crank from the first position, rad", name=name)
                if called.turns
                else tr("given load {name}; $theta$ – travel of the drive from the first position, m", name=name)
            )
        yield Datum(said, (called.key,), text=f"${written(self.coefficients)}$ {tr_unit(called.unit)}")

    def along(self, acting: "Acting") -> "Value":
        """The sum, of the angle from the beginning of the load's window."""
        from tmmcalc.linkage.loads.values import Value

        return Value(lambda place: self.at(acting.window.since(place.theta)), [], [])

    def at(self, d: "Real") -> "Real":
        """sum c_k d^k of the angle d (n,) from the beginning of the load's window."""
        import numpy as np

        value = np.zeros_like(d)
        for c in reversed(self.coefficients):
            value = value * d + c
        return value


def written(coefficients: Sequence[float]) -> str:
    """A polynomial of the angle as a formula.

    >>> written([0.0, -180.0, 68.75493542])
    '- 180*theta + 68.75493542*theta**2'
    """
    from tmmcalc.report.formula.digits import WHOLE
    from tmmcalc.report.telling import numeral

    terms = []
    for power, value in enumerate(coefficients):
        if value:
            angle = ["", "*theta"][power] if power < 2 else f"*theta**{power}"
            terms.append(f"{'-' if value < 0 else '+'} {numeral(abs(value), WHOLE)}{angle}")
    return " ".join(terms).removeprefix("+ ") or "0"
