"""A load by its values at given abscissae: of the angle, of positions, of the displacement of an output."""

import math
from collections.abc import Iterator, Mapping
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from pydantic import Field

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.records import record
from tmmcalc.linkage.loadlaws.law import Called, Key, Kind, Law, kind_of_values, values_of
from tmmcalc.linkage.loadlaws.placed import Placed
from tmmcalc.spec.quantities import Force, InputDistance, Moment, Quantity
from tmmcalc.spec.table import Table

if TYPE_CHECKING:
    from tmmcalc.core.plane import Real
    from tmmcalc.linkage.chain import Configuration
    from tmmcalc.linkage.loads.travel import Travel
    from tmmcalc.linkage.loads.values import Acting, Value
    from tmmcalc.report.manuscript import Datum
    from tmmcalc.spec.findings import Finding
    from tmmcalc.spec.outline import Outline, Raw
    from tmmcalc.spec.phrases import Path

TURN = 2 * math.pi
Period = Annotated[float, Quantity("angle", at_least_zero=True, nonzero=True)]


class LoadCurveTable(Table):
    """Values at given abscissae, in the table itself or in a file."""

    of: Literal["angle", "position", "displacement", "stroke"] = Field(
        default="angle",
        description='What `x` is: `"angle"` from position 0 along the motion, `"position"` numbers, `"displacement"` '
        'of an output from its lesser extreme, `"stroke"` that displacement from 0 to 1.',
    )
    x: list[InputDistance] | None = Field(
        default=None,
        min_length=2,
        description="Abscissae, ascending; two equal angles are a jump of straight lines (default: equal steps of the "
        "period, the positions 0, 1, 2 ..., or the stroke from 0 to 1).",
    )
    force: list[Force] | None = Field(default=None, min_length=2, description="Values of a force, one for each `x`.")
    moment: list[Moment] | None = Field(default=None, min_length=2, description="Values of a moment, one for each `x`.")
    file: str | None = Field(
        default=None,
        description="CSV file of two columns with a header `name[unit]`, in place of `x` and the values; "
        "its path counts from the folder of the spec.",
    )
    columns: str | None = Field(
        default=None,
        description="Columns of a file that has more than two: of the values, or of both, as `--columns` names them, "
        '`"phi,M_drive"`.',
    )
    interpolation: Literal["linear", "pchip"] = Field(
        default="linear", description='`"linear"`: straight lines, or `"pchip"`, a smooth monotone curve.'
    )
    output: str | None = Field(default=None, description="Output whose displacement `x` is (default: the first).")
    period: Period | None = Field(
        default=None,
        description="Angle after which the values repeat (default: 360 deg), also of `position` numbers, which then "
        'count on; `"720 deg"` for a four-stroke engine.',
    )


@record
class Tabulated(Placed):
    """Values at the abscissae ``x``, ascending.

    ``of``: "angle" theta [rad]; "position" numbers of the grid; "displacement" S of an output from its lesser
    extreme [m or rad]; "stroke" the same from 0 to 1. ``period``: of theta and the
    positions [rad]; None: a turn.
    """

    of: Literal["angle", "position", "displacement", "stroke"]
    x: tuple[float, ...]
    values: tuple[float, ...]
    interpolation: Literal["linear", "pchip"] = "linear"
    output: str | None = None  # whose displacement; None: the first output
    period: float | None = None

    rank = 50
    lists: ClassVar = {
        "table.x": ("a list of two abscissae or more", 'x = ["0 deg", "90 deg", "270 deg"]'),
        "table.force": ("a list of two forces or more", 'force = [0, "1.5 kN", 0]'),
        "table.moment": ("a list of two moments or more", 'moment = [0, "40 N*m", 0]'),
    }

    @classmethod
    def spec_keys(cls) -> Mapping[str, Key]:
        """The table of its values."""
        return {"table": Key(LoadCurveTable, "Values at given abscissae, of a force or a moment.")}

    @classmethod
    def kind_of(cls, load: "Raw", key: str) -> Kind | None:
        """What its values are of."""
        return kind_of_values(load, key)

    @classmethod
    def from_table(cls, load: Any, key: str) -> tuple[Kind, Law]:
        """The law of a table."""
        table = getattr(load, key)
        kind, values = values_of(table)
        period = (table.period or TURN) if table.of == "angle" else table.period
        x = _abscissae(table, len(values)) if table.x is None else tuple(table.x)
        return kind, cls(table.of, x, values, table.interpolation, table.output, period)

    @classmethod
    def check(cls, outline: "Outline", load: "Raw", path: "Path") -> Iterator["Finding"]:
        """Its abscissae ascend within their range, with one value for each."""
        from tmmcalc.linkage.tables.checks.curves import check_table

        return check_table(outline, load["table"], (*path, "table"))

    @classmethod
    def cycle(cls, load: "Raw") -> float:
        """Its period."""
        from tmmcalc.spec.outline import subtable
        from tmmcalc.spec.values import amount

        return amount(subtable(load, "table").get("period"), "angle") or 0.0

    @classmethod
    def smooth(cls, load: Any) -> bool:
        """Of the interpolation of that name."""
        return load.table is not None and load.table.interpolation == "pchip"

    @property
    def turns(self) -> int:
        """Of its period."""
        return max(1, round(self.period / TURN)) if self.period is not None else 1

    @property
    def alike(self) -> bool:
        """Where no stroke of an output is asked for."""
        return self.of in ("angle", "position")

    def given(self, table: Any, called: Called) -> "Iterator[Datum]":
        """The points, what is between them, when they come back."""
        from tmmcalc.report.language import tr
        from tmmcalc.report.manuscript import Datum
        from tmmcalc.report.telling import between, in_rows

        values = tr("values of load {name} there", name=called.load)
        yield from in_rows(self._abscissae_given(called), Datum(values, (called.key,), self.values, called.unit))
        yield Datum(tr("load {name} between its points", name=called.load), text=between(self.interpolation))
        if table.table.period is not None:
            said = tr("angle of the crank after which the values of load {name} come back", name=called.load)
            yield Datum(said, (), (math.degrees(table.table.period),), "deg")

    def _abscissae_given(self, called: Called) -> "Datum":
        """The abscissae with their meaning."""
        from tmmcalc.report.language import tr
        from tmmcalc.report.manuscript import Datum

        name = called.load
        if self.of == "position":
            return Datum(tr("points of load {name}: positions", name=name), values=self.x)
        if self.of == "angle":
            if not called.turns:
                return Datum(tr("points of load {name}: travel of the drive from the first position", name=name),
                             ("Deltas",), self.x, "m")  # fmt: skip
            return Datum(tr("points of load {name}: angle of the crank from the first position", name=name),
                         ("phi",), tuple(map(math.degrees, self.x)), "deg")  # fmt: skip
        own = called.outputs.get(self.output)
        whose = tr("coordinate of the output") if own is None else own.said
        if self.of == "stroke":
            said = tr("points of load {name}: {coordinate}, from its lesser extreme, in parts of the stroke",
                      name=name, coordinate=whose)  # fmt: skip
            return Datum(said, (f"xi_{{{called.index}}}",), self.x)
        said = tr("points of load {name}: {coordinate}, from its lesser extreme", name=name, coordinate=whose)
        if own is not None and own.angular:
            return Datum(said, (f"psi_{{{called.index}}}",), tuple(map(math.degrees, self.x)), "deg")
        return Datum(said, (f"s_{{{called.index}}}",), self.x, "m")

    def along(self, acting: "Acting") -> "Value":
        """The values, with lines or a curve between them."""
        return self._of_angle(acting) if self.of in ("angle", "position") else self._of_displacement(acting)

    def _of_angle(self, acting: "Acting") -> "Value":
        import numpy as np

        from tmmcalc.linkage.loads.coverage import of_range
        from tmmcalc.linkage.loads.interpolation import interpolant
        from tmmcalc.linkage.loads.values import Value

        travel = acting.travel
        x = self.x if self.of == "angle" else self._positions(travel, acting.where)
        period = (self.period or TURN) if travel.whole else None
        f = interpolant(x, self.values, self.interpolation, period)
        grades = () if period else tuple(of_range(acting, np.array(x), self.values))
        return Value(lambda place: f(place.theta), travel.repeated(x, period or TURN), [], grades)

    def _of_displacement(self, acting: "Acting") -> "Value":
        from tmmcalc.linkage.loads.coverage import of_displacement
        from tmmcalc.linkage.loads.interpolation import interpolant
        from tmmcalc.linkage.loads.strokes import displacement_of
        from tmmcalc.linkage.loads.travel import EDGE
        from tmmcalc.linkage.loads.values import Knot, Value

        displacement = displacement_of(
            acting.chain, acting.kinematics, acting.travel, acting.dense, self.output, acting.where
        )
        unit = displacement.reach if self.of == "stroke" else 1.0
        f = interpolant(self.x, self.values, self.interpolation)

        def from_knot(at: float, configuration: "Configuration") -> "Real":
            return displacement.at(configuration) - at

        inner = [x * unit for x in self.x if EDGE < x * unit / displacement.reach < 1 - EDGE]
        return Value(
            lambda place: f(displacement.at(place.configuration) / unit),
            acting.travel.repeated(displacement.turning),
            [Knot(partial(from_knot, at), displacement.reach) for at in inner],
            tuple(of_displacement(acting, self.x, self.values, displacement, unit)),
        )

    def _positions(self, travel: "Travel", where: str) -> tuple[float, ...]:
        """theta of the numbered positions that the table names."""
        labels = travel.labels
        missing = next((x for x in self.x if f"{x:g}" not in labels), None)
        if missing is not None:
            raise NoSolutionError(
                f"there is no position {missing:g}; the grid has {len(labels)} positions",
                where=where,
                remedy="give one value a position, or a table of the angle",
            )
        return tuple(labels[f"{x:g}"] for x in self.x)


def _abscissae(table: LoadCurveTable, n: int) -> tuple[float, ...]:
    """n equal steps over the period, the whole stroke with both its ends, or the positions from 0 on."""
    step = {"angle": (table.period or TURN) / n, "stroke": 1 / (n - 1)}.get(table.of, 1.0)
    return tuple(k * step for k in range(n))
