"""``[gearing]``: a train of gears written out, member by member and mesh by mesh, or by its layout and teeth."""

import re
from typing import Annotated, Any

from pydantic import Field

from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.spec.choices import Known, Listed, OneOrMore
from tmmcalc.spec.phrases import show
from tmmcalc.spec.quantities import Number, Quantity
from tmmcalc.spec.reader import Reader
from tmmcalc.spec.table import Table
from tmmcalc.spec.units import UnitError

MOST_TEETH = 100_000
MOST = 100  # planets side by side


class MemberName(Reader):
    """A name of a member: Latin letters and digits, ``_`` or ``'``; a whole number is one as well."""

    PATTERN = "[A-Za-z0-9][A-Za-z0-9_']*"

    def __init__(self, frame: bool = False) -> None:
        self.frame = frame

    def read(self, value: object) -> str:
        """Return the name; raise UnitError with the fault in plain words."""
        written = str(value) if isinstance(value, int) and not isinstance(value, bool) else value
        if not isinstance(written, str) or not re.fullmatch(self.PATTERN, written):
            remedy = 'a name is Latin letters and digits, _ or \', such as "sun" or "2\'"'
            raise UnitError(f"{show(value)} cannot name a member", remedy)
        if written == "frame" and not self.frame:
            raise UnitError("'frame' stands still and is no member here", "name a member that turns")
        return written

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a name or a whole number."""
        kinds = [{"type": "string", "pattern": f"^{self.PATTERN}$"}, {"type": "integer", "minimum": 0}]
        return {"anyOf": kinds, "description": "Name of a member."}


class MemberKey(MemberName):
    """The same as a key of a table, which TOML reads as text."""

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema of the key."""
        return {"type": "string", "pattern": f"^{self.PATTERN}$"}


class OneOrEach(Reader):
    """A number for all, or a list with one for each."""

    def __init__(self, item: Reader, example: str) -> None:
        self.item = item
        self.each = Listed(item, example)

    def read(self, value: object) -> Any:
        """Return the number or the list; raise UnitError with the fault in plain words."""
        return self.each.read(value) if isinstance(value, list) else self.item.read(value)

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: the number or a list."""
        one = self.item.describe()
        return {"anyOf": [one, self.each.describe()], "description": one["description"]}


_EFFICIENCY = Number("an efficiency", "0.98", above=0, at_most=1)

Member = Annotated[str, MemberName()]
Wheel = Annotated[str, MemberName(frame=True)]
Members = Annotated[list[str], OneOrMore(MemberName())]
Key = Annotated[str, MemberKey()]
Pair = Annotated[list[str], Listed(MemberName(frame=True), '["sun", "H"]', 2)]
Teeth = Annotated[int, Field(ge=1, le=MOST_TEETH)]
Count = Annotated[int, Field(ge=1, le=MOST)]
Efficiency = Annotated[float, _EFFICIENCY]
Efficiencies = Annotated[float | list[float], OneOrEach(_EFFICIENCY, "[0.97, 0.98]")]
Friction = Annotated[float, Number("a coefficient of friction of teeth", "0.08", at_least=0, at_most=0.5)]
Sharing = Annotated[float, Number("a load-sharing factor", "1.1", at_least=1, at_most=100)]
Speed = Annotated[float, Quantity("angular speed")]
Torque = Annotated[float, Quantity("moment")]
Resistance = Annotated[float, Quantity("moment", at_least_zero=True)]
Power = Annotated[float, Quantity("power")]


class MemberTable(Table):
    """A member that is not simply one shaft in the frame: a planet, or several layshafts."""

    name: Member = Field(description="Name of the member, as the meshes have it.")
    carrier: Wheel = Field(default="frame", description="The member that bears its axis.")
    count: Count = Field(default=1, description="How many of them there are side by side.")
    tilted: bool = Field(
        default=False,
        description="Whether it is a bevel wheel whose axis is not parallel to the others; "
        "its speed is counted on its own axis, against its carrier.",
    )
    sharing: Sharing = Field(default=1.0, description="Torque of the most loaded of them over the mean.")


class MeshTable(Table):
    """Two wheels in mesh, each on its member."""

    first: Wheel = Field(description='Member of the one wheel; a ring fixed in the housing is on `"frame"`.')
    first_teeth: Teeth = Field(description="Number of teeth of the one wheel.")
    second: Wheel = Field(description='Member of the other wheel; a ring fixed in the housing is on `"frame"`.')
    second_teeth: Teeth = Field(description="Number of teeth of the other wheel.")
    internal: bool = Field(default=False, description="Whether one of the wheels is a ring about the other.")
    opposite: bool = Field(
        default=False,
        description="Mesh with a tilted member: whether it is on its far side. The two side wheels of a differential "
        "differ in it.",
    )
    efficiency: Efficiency | None = Field(
        default=None, description="Efficiency of this mesh, carrier held (default: that of `[gearing]`)."
    )


class GearingTable(Table):
    """A train of gears: what meshes with what, which speeds and torques are known."""

    layout: Annotated[str | None, Known("layout", tuple(LAYOUTS))] = Field(
        default=None, description='A layout of `[train]` in place of the meshes, such as `"AI"`.'
    )
    teeth: list[Teeth] | None = Field(
        default=None,
        min_length=1,
        description="Numbers of teeth of a layout in the order of its wheels 1, 2, 2', 3 ...: `[22, 118, 17, 97]`.",
    )
    planets: Count | None = Field(
        default=None, description="With a layout: number of planets or layshafts (default: 1)."
    )
    sharing: Sharing | None = Field(
        default=None, description="With a layout: torque of the most loaded planet over the mean (default: 1)."
    )
    efficiency: Efficiencies | None = Field(
        default=None,
        description="Efficiency of meshes that have none of their own; of a layout it may be a list, mesh by mesh "
        "(default: 0.975, internal 0.985).",
    )
    friction: Friction | None = Field(
        default=None,
        description="Or the coefficient of friction of teeth, 0.05 to 0.1 in oil: "
        "efficiencies are 1 - 2.3 f (1/z1 +- 1/z2) by the numbers of teeth, - for an internal mesh.",
    )
    input: Member | None = Field(
        default=None, description="Member that drives (default: the member of known speed, not 0)."
    )
    output: Members | None = Field(
        default=None,
        description='Member that is driven, or several: `["left", "right"]` (default: '
        "the loaded one, or the only shaft of unknown speed).",
    )
    speeds: dict[Key, Speed] = Field(
        default={},
        description='Known speeds by member, `{ sun = "1500 rpm", ring = 0 }`; 0 holds it. '
        "As many as the train has degrees of freedom.",
    )
    torques: dict[Key, Torque] = Field(
        default={},
        description='Known torques from outside by member, positive along positive speed: `{ sun = "20 N*m" }`.',
    )
    load: dict[Key, Resistance] = Field(
        default={}, description='Known resistances by member, torques against its motion: `{ H = "150 N*m" }`.'
    )
    powers: dict[Key, Power] = Field(
        default={}, description='Known powers by member, put in (positive) or taken out (negative): `{ sun = "4 kW" }`.'
    )
    locked: list[Pair] = Field(default=[], description='Pairs of members locked to one another, `[["sun", "H"]]`.')
    members: list[MemberTable] = Field(default=[], description="Planets, and members of which there are several.")
    meshes: list[MeshTable] = Field(default=[], description="All pairs of wheels in mesh.")
