"""A load by an indicator diagram: the pressure in a cylinder, stroke by stroke."""

import math
from collections.abc import Iterator, Mapping
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from pydantic import Field

from tmmcalc.core.records import record
from tmmcalc.linkage.loadlaws.law import Called, Key, Kind, Law
from tmmcalc.linkage.loadlaws.placed import Placed
from tmmcalc.spec.quantities import Number, Quantity, Size
from tmmcalc.spec.table import Table

if TYPE_CHECKING:
    from tmmcalc.core.plane import Real
    from tmmcalc.linkage.chain import Configuration
    from tmmcalc.linkage.loads.values import Acting, Value
    from tmmcalc.report.manuscript import Datum
    from tmmcalc.spec.findings import Finding
    from tmmcalc.spec.outline import Outline, Raw
    from tmmcalc.spec.phrases import Path

TURN = 2 * math.pi
MEGA = 1e6
Part = Annotated[float, Number("a part of the stroke", "0.1", at_least=0, at_most=1)]
Area = Annotated[float, Quantity("area", at_least_zero=True, nonzero=True)]
Delay = Annotated[float, Quantity("angle", at_least_zero=True)]
Pressure = Annotated[float, Quantity("pressure", at_least_zero=True)]


class StrokeTable(Table):
    """Pressures over one stroke of a piston."""

    x: list[Part] = Field(
        min_length=2, description="Distances of the piston from the closed end, from 0 to 1 or from 1 to 0."
    )
    p: list[Pressure] = Field(min_length=2, description="Absolute pressure at each `x`.")


class IndicatorTable(Table):
    """An indicator diagram: the pressure in a cylinder, stroke by stroke."""

    diameter: Size | None = Field(default=None, description="Diameter of the piston; or `area`.")
    area: Area | None = Field(default=None, description="Area of the piston, in place of its diameter.")
    back_pressure: Pressure = Field(default=101325.0, description="Absolute pressure on the other side of the piston.")
    delay: Delay = Field(
        default=0.0,
        description="The first stroke begins at the first dead centre at the closed end from this angle on.",
    )
    strokes: list[StrokeTable] = Field(
        description="Two or four strokes in the order of the motion, the first leads away from the closed end: "
        '`[{ x = [0, 0.1, 1], p = ["5 MPa", "2 MPa", "0.2 MPa"] }, ...]`.'
    )


@record
class Indicator(Placed):
    """Pressure in a cylinder, one table a stroke, in the order of the motion from the outer dead centre on.

    ``x`` of each table: distance of the piston from the outer dead centre (the cylinder's closed end) as a part
    of the stroke, from 0 to 1 or from 1 to 0; ``p`` absolute pressure [Pa]. Two tables: a cycle of one turn; four:
    of two turns. The load is (p - back) area along its direction, which points from the closed end to the crank.
    ``delay`` [rad]: the first stroke begins at the first outer dead centre at or after theta = delay.
    """

    strokes: tuple[tuple[tuple[float, ...], tuple[float, ...]], ...]
    area: float  # [m^2]
    back: float = 101325.0  # pressure on the other side [Pa]
    delay: float = 0.0

    rank = 60
    judged = False  # gas drives on some strokes by its nature
    missing: ClassVar = {
        "indicator.strokes": (
            "an indicator diagram has two or four strokes",
            'add strokes = [{ x = [0, 1], p = ["5 MPa", "0.3 MPa"] }, ...]',
        ),
        "indicator.strokes.x": ("every stroke has its distances from 0 to 1", "add x = [0, 0.5, 1]"),
        "indicator.strokes.p": ("every stroke has its pressures", 'add p = ["5 MPa", "1 MPa", "0.3 MPa"]'),
    }
    lists: ClassVar = {
        "indicator.strokes.x": ("a list of two distances or more, from 0 to 1", "x = [0, 0.1, 0.5, 1]"),
        "indicator.strokes.p": ("a list of two pressures or more", 'p = ["5 MPa", "1 MPa", "0.3 MPa"]'),
    }
    inline: ClassVar = {"indicator.strokes": 'strokes = [{ x = [0, 1], p = ["5 MPa", "0.3 MPa"] }, ...]'}

    @classmethod
    def spec_keys(cls) -> Mapping[str, Key]:
        """The diagram."""
        return {"indicator": Key(IndicatorTable, "Indicator diagram of a cylinder.")}

    @classmethod
    def kind_of(cls, load: "Raw", key: str) -> Kind | None:
        """A force."""
        return "force"

    @classmethod
    def from_table(cls, load: Any, key: str) -> tuple[Kind, Law]:
        """The law of a table."""
        table = getattr(load, key)
        area = table.area if table.area is not None else math.pi / 4 * (table.diameter or 0.0) ** 2
        strokes = tuple((tuple(stroke.x), tuple(stroke.p)) for stroke in table.strokes)
        return "force", cls(strokes, area, table.back_pressure, table.delay)

    @classmethod
    def check(cls, outline: "Outline", load: "Raw", path: "Path") -> Iterator["Finding"]:
        """The piston has a size, and strokes run over their whole way."""
        from tmmcalc.linkage.tables.checks.indicator import check_indicator

        return check_indicator(outline, load, (*path, "indicator"))

    @classmethod
    def cycle(cls, load: "Raw") -> float:
        """Two turns of a four-stroke engine."""
        from tmmcalc.spec.outline import subtable

        strokes = subtable(load, "indicator").get("strokes")
        return 2 * TURN if isinstance(strokes, list) and len(strokes) == 4 else 0.0

    def given(self, table: Any, called: Called) -> "Iterator[Datum]":
        """The piston, the pressure behind it, the diagram stroke by stroke."""
        from tmmcalc.report.language import tr
        from tmmcalc.report.manuscript import Datum
        from tmmcalc.report.telling import in_rows

        name, index = called.load, called.index
        pressure, back, area = f"p_{{{index}}}", f"p_{{{index},0}}", f"A_{{{index}}}"
        said = tr("given load {name}; ${pressure}$ – pressure by the indicator diagram, ${area}$ – area of the piston",
                  name=name, pressure=pressure, area=area)  # fmt: skip
        yield Datum(said, (called.key,), text=f"$({pressure} - {back})*{area}$")
        diameter = table.indicator.diameter
        if table.indicator.area is None and diameter is not None:
            yield Datum(tr("diameter of the piston, load {name}", name=name), (f"d_{{{index}}}",), (diameter,), "m")
        else:
            yield Datum(tr("area of the piston, load {name}", name=name), (area,), (self.area,), "m^2")
        said = tr("absolute pressure on the other side of the piston, load {name}", name=name)
        yield Datum(said, (back,), (self.back / MEGA,), "MPa")
        yield Datum(tr("first stroke of load {name}", name=name), text=self._first())
        for number, (x, p) in enumerate(self.strokes, 1):
            words = {"name": name, "number": number}
            parts = tr("load {name}, stroke {number}: distance of the piston from the closed end of the cylinder over "
                       "the stroke", **words)  # fmt: skip
            there = tr("load {name}, stroke {number}: absolute pressure there, straight lines between", **words)
            yield from in_rows(
                Datum(parts, (f"xi_{{{index},{number}}}",), x),
                Datum(there, (f"p_{{{index},{number}}}",), tuple(each / MEGA for each in p), "MPa"),
            )

    def _first(self) -> str:
        """Where the first stroke begins; strokes lead away from the closed end and back in turn."""
        from tmmcalc.report.formula.digits import digits_given
        from tmmcalc.report.language import tr
        from tmmcalc.report.telling import numeral

        if not self.delay:
            return tr("from the first dead centre at the closed end on; the load is directed away from this end")
        after = math.degrees(self.delay)
        return tr("from the first dead centre at the closed end on that the crank passes after {angle}° from the first "
                  "position; the load is directed away from this end",
                  angle=f"${numeral(after, digits_given(after))}$")  # fmt: skip

    @property
    def turns(self) -> int:
        """One for two strokes."""
        return len(self.strokes) // 2

    def along(self, acting: "Acting") -> "Value":
        """(p - back) area, of the place of the piston and its stroke."""
        from tmmcalc.linkage.loads.pressure import pressure_of
        from tmmcalc.linkage.loads.strokes import piston_of
        from tmmcalc.linkage.loads.travel import EDGE
        from tmmcalc.linkage.loads.values import Knot, Value

        piston = piston_of(acting.chain, acting.travel, acting.load, acting.dense)
        pressure = pressure_of(self.strokes, self.back, self.delay, piston)
        reach = piston.high - piston.low

        def from_knot(at: float, configuration: "Configuration") -> "Real":
            return piston.coordinate(configuration) - at

        inner = sorted({x for at, _ in self.strokes for x in at if EDGE < x < 1 - EDGE})
        return Value(
            lambda place: self.area * pressure(place.theta, piston.coordinate(place.configuration)),
            acting.travel.repeated(pressure.edges, pressure.period),
            [Knot(partial(from_knot, piston.low + x * reach), reach) for x in inner],
        )
