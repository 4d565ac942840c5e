"""What the resistances against a velocity have in common; a bare number is of a force if the load has a point."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from tmmcalc.linkage.loadlaws.law import Called, Key, Kind, Law

if TYPE_CHECKING:
    from tmmcalc.core.plane import Real
    from tmmcalc.report.manuscript import Datum
    from tmmcalc.spec.findings import Finding
    from tmmcalc.spec.outline import Raw
    from tmmcalc.spec.phrases import Path


class Resistance(Law):
    """Against the velocity of the point along the direction, or the link's speed; it acts all the time."""

    key: ClassVar[str]
    formula: ClassVar[str]
    dimensions: ClassVar[tuple[str, str]]  # of the coefficient of a force, of a moment
    examples: ClassVar[tuple[str, str]]  # of these
    order: ClassVar[int]  # of the speed that it goes with
    coefficient: float

    @classmethod
    def spec_keys(cls) -> Mapping[str, Key]:
        """Its coefficient."""
        from tmmcalc.spec.quantities import Quantity

        of_force, of_moment = cls.examples
        says = (
            f'Resistance {cls.formula} of the point along the direction, `"{of_force}"`; or of the link, '
            f'`"{of_moment}"`. A bare number is a force if there is a `point`, else a moment.'
        )
        return {cls.key: Key(Annotated[float, Quantity(*cls.dimensions, at_least_zero=True)], says)}

    @classmethod
    def kind_of(cls, load: Raw, key: str) -> Kind | None:
        """What the dimension of its coefficient is of; without one a force has a point."""
        from tmmcalc.spec.units import dimension_of

        dimension = dimension_of(load[key])
        of_force, of_moment = cls.dimensions
        if dimension in (None, of_force):
            return "force" if "point" in load or dimension else "moment"
        return "moment" if dimension == of_moment else None

    @classmethod
    def from_table(cls, load: Any, key: str) -> tuple[Kind, Law]:
        """The law of a table: that of a force if there is a point."""
        made: Callable[[float], Law] = cls
        return "moment" if load.point is None else "force", made(getattr(load, key))

    @classmethod
    def check_kind(cls, load: Raw, key: str, path: Path) -> Iterator[Finding]:
        """A coefficient of a moment has no point."""
        from tmmcalc.spec.dimensions import DIMENSIONS
        from tmmcalc.spec.findings import Finding
        from tmmcalc.spec.phrases import show

        if cls.kind_of(load, key) == "moment" and "point" in load:
            needed, given = (DIMENSIONS[name] for name in cls.dimensions)
            yield Finding(
                (*path, key),
                f"{show(load[key])} is {given.noun}, but the load has a point, so it is a force",
                f'write {needed.noun}, such as "{needed.example}", or remove point',
            )

    def given(self, table: Any, called: Called) -> Iterator[Datum]:
        """The law as a formula, and its coefficient."""
        from tmmcalc.report.language import tr
        from tmmcalc.report.manuscript import Datum
        from tmmcalc.spec.dimensions import DIMENSIONS

        of_force, of_moment = self.dimensions
        words = {"name": called.load, "link": called.against}
        if called.kind == "force":
            letter, dimension = "v", of_force
            said = tr("given load {name}; $v$ – velocity of its point along its direction", **words)
            relative = tr("given load {name}; $v$ – velocity of its point along its direction, relative to link {link}",
                          **words)  # fmt: skip
        else:
            letter, dimension = "omega", of_moment
            said = tr("given load {name}; $omega$ – angular velocity of its link", **words)
            relative = tr("given load {name}; $omega$ – angular velocity of its link relative to link {link}", **words)
        size = letter if self.order == 1 else f"{letter}*abs({letter})"
        said = relative if called.against else said
        yield Datum(said, (called.key,), text=f"$-c_{{{called.index}}}*{size}$")
        about = tr("coefficient of load {name}", name=called.load)
        yield Datum(about, (f"c_{{{called.index}}}",), (self.coefficient,), DIMENSIONS[dimension].si)

    def against(self, factor: float, rate: Real) -> Real:
        """Its size (n,) with a load factor against a velocity (n,) per unit of input speed."""
        raise NotImplementedError
