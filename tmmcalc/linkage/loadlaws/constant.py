"""A constant load."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.records import record
from tmmcalc.linkage.loadlaws.law import Called, Key, Kind, Law
from tmmcalc.linkage.loadlaws.placed import Placed

if TYPE_CHECKING:
    from tmmcalc.linkage.loads.values import Acting, Value
    from tmmcalc.report.manuscript import Datum
    from tmmcalc.spec.outline import Raw


@record
class Constant(Placed):
    """The same value wherever the load acts [N or N*m]."""

    value: float

    rank = 10
    alike = True

    @classmethod
    def spec_keys(cls) -> Mapping[str, Key]:
        """A force, or a moment."""
        from tmmcalc.spec.quantities import Force, Moment

        return {
            "force": Key(Force, 'Constant force, `"1500 N"`.'),
            "moment": Key(Moment, 'Constant moment, `"40 N*m"`.'),
        }

    @classmethod
    def kind_of(cls, load: Raw, key: str) -> Kind | None:
        """What its key says."""
        return "force" if key == "force" else "moment"

    @classmethod
    def from_table(cls, load: Any, key: str) -> tuple[Kind, Law]:
        """The law of a table."""
        return "force" if key == "force" else "moment", cls(getattr(load, key))

    def given(self, table: Any, called: Called) -> Iterator[Datum]:
        """Its value."""
        from tmmcalc.report.language import tr
        from tmmcalc.report.manuscript import Datum

        yield Datum(tr("given load {name}", name=called.load), (called.key,), (self.value,), called.unit)

    def along(self, acting: Acting) -> Value:
        """The value, everywhere."""
        import numpy as np

        from tmmcalc.linkage.loads.values import Value

        return Value(lambda place: np.full(np.shape(place.theta), self.value), [], [])
