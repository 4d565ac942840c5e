"""Keys of the spec as values of its tables."""

from typing import Annotated, Any

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


Keys = Annotated[list[str], OneOrMore(Key())]
