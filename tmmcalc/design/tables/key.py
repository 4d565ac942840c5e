"""Keys of the spec and names of results as values of its tables."""

from typing import Annotated, Any

from tmmcalc.core.errors import UsageError
from tmmcalc.naming.language import parse
from tmmcalc.spec.choices import OneOrMore
from tmmcalc.spec.phrases import show
from tmmcalc.spec.reader import Reader
from tmmcalc.spec.units import UnitError


class Key(Reader):
    """A key of the spec as an override has it, or several by wildcards."""

    def read(self, value: object) -> str:
        """Return the key; raise UnitError with the fault in plain words."""
        if not isinstance(value, str) or not value.strip() or "=" in value.rpartition("]")[2]:
            rule = f"{show(value)} is no key of a spec"
            raise UnitError(rule, 'write it as an override has it: "mechanism.links[id=1].points.A[0]"')
        return value.strip()

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema of a key."""
        return {"type": "string", "description": "A key of the spec, as in --set; * and ? stand for any letters."}


class Result(Reader):
    """The name of one result."""

    def read(self, value: object) -> str:
        """Return the name; raise UnitError with the fault in plain words."""
        if not isinstance(value, str):
            raise UnitError(f"{show(value)} is no name of a result", 'write one: "kinematics.stroke_D"')
        try:
            name = parse(value)
        except UsageError as error:
            raise UnitError(error.message, error.remedy) from None
        if name.wild:
            rule = f"{show(value)} may name several results: one is meant"
            raise UnitError(rule, "write its name without * and ?")
        return value.strip()

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema of a name."""
        return {"type": "string", "description": 'Name of a result: "forces.max(R_A)".'}


Keys = Annotated[list[str], OneOrMore(Key())]
Results = Annotated[list[str], OneOrMore(Result())]
