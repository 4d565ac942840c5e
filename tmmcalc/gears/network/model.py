"""A train of gears as members that turn and pairs of wheels in mesh.

A *member* is a rigid body that turns: a shaft with its wheels, a block of planets, a carrier. The frame is the member
that stands. A mesh ties the speeds of two members to that of the carrier which keeps their axes apart (Willis):

    z1 (w1 - wc) = sign z2 (w2 - wc)        sign -1: external wheels, +1: an internal one

Parallel axes share one positive direction. A planet of bevel wheels turns about a *tilted* axis; its speed is counted
on that axis relative to its carrier, and the two side wheels of a differential take opposite signs:

    left  z1 (w1 - wH) = + z2 wp            right  z3 (w3 - wH) = - z2 wp

Many like members side by side (planets of one carrier, layshafts) are one member with a ``count``.
"""

from __future__ import annotations

from functools import cached_property
from math import isfinite

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record

FRAME = "frame"
EXTERNAL = -1
INTERNAL = +1
WHERE = "gear network"


@record
class Body:
    """A member that is not simply one shaft in the frame: a planet, or one of several layshafts."""

    name: str
    carrier: str = FRAME  # the member that bears its axis
    count: int = 1  # K, how many there are side by side
    tilted: bool = False  # a bevel planet: its axis is not parallel to that of its carrier
    sharing: float = 1.0  # load-sharing factor: torque of the most loaded one to the mean [-]

    def __post_init__(self) -> None:
        """Refuse what cannot be a member."""
        if self.name == FRAME or self.name == self.carrier:
            raise UsageError(f"member {self.name!r} cannot be borne by {self.carrier!r}", where=WHERE)
        if self.count < 1:
            raise UsageError(f"there are {self.count} members {self.name!r}, at least 1 is needed", where=WHERE)
        if not (isfinite(self.sharing) and self.sharing >= 1):
            raise UsageError(
                f"the load-sharing factor of {self.name!r} is {self.sharing:g}, it is at least 1",
                where=WHERE,
                value=self.sharing,
                limit=1.0,
            )


@record
class Mesh:
    """Two wheels in mesh, each fixed to a member."""

    first: str
    first_teeth: int
    second: str
    second_teeth: int
    sign: int = EXTERNAL  # +1 or -1; for bevel wheels as the positive directions of the axes make it
    efficiency: float = 1.0  # with the carrier held [-]

    def __post_init__(self) -> None:
        """Refuse what cannot be in mesh."""
        if self.first == self.second:
            raise UsageError(f"member {self.first!r} is in mesh with itself", where=WHERE)
        if min(self.first_teeth, self.second_teeth) < 1:
            raise UsageError(f"mesh {self} has tooth numbers below 1", where=WHERE)
        if self.sign not in (EXTERNAL, INTERNAL):
            raise UsageError(
                f"the sign of mesh {self} is {self.sign}",
                where=WHERE,
                remedy="-1: external wheels, +1: an internal one",
            )
        if not 0 < self.efficiency <= 1:
            raise UsageError(
                f"the efficiency of mesh {self} is {self.efficiency:g}",
                where=WHERE,
                value=self.efficiency,
                limit=1.0,
                remedy="above 0 and at most 1",
            )

    def __str__(self) -> str:
        return f"{self.first}-{self.second} ({self.first_teeth}/{self.second_teeth})"


@record
class Network:
    """A train; members named by meshes alone are single and turn in the frame.

    >>> Network((Mesh("1", 18, "2", 48), Mesh("2", 48, "3", 114, INTERNAL)), (Body("2", "H", count=3),)).members
    ('1', '2', '3', 'H')
    """

    meshes: tuple[Mesh, ...]
    bodies: tuple[Body, ...] = ()  # members that another one bears, or that are several

    def __post_init__(self) -> None:
        """Refuse bearings that do not make a train."""
        names = [body.name for body in self.bodies]
        twice = sorted({name for name in names if names.count(name) > 1})
        if twice:
            raise UsageError(f"member {', '.join(twice)} is described twice", where=WHERE)
        for body in self.bodies:
            self._check_bearing(body)
        for mesh in self.meshes:
            self.carrier(mesh)

    def _check_bearing(self, body: Body) -> None:
        if self.tilted(body.carrier):
            raise UsageError(
                f"the tilted member {body.carrier!r} bears {body.name!r}, only one of parallel axis can",
                where=WHERE,
            )
        bearer, passed = body.carrier, [body.name]
        while bearer != FRAME:
            if bearer in passed:
                raise UsageError(f"members {', '.join(passed)} bear each other in a ring", where=WHERE)
            passed.append(bearer)
            bearer = self.bearer(bearer)

    @cached_property
    def members(self) -> tuple[str, ...]:
        """Names of all members but the frame: those in mesh in the order of the meshes, then mere carriers."""
        meshed = (name for mesh in self.meshes for name in (mesh.first, mesh.second))
        borne = (name for body in self.bodies for name in (body.name, body.carrier))
        return tuple(name for name in dict.fromkeys((*meshed, *borne)) if name != FRAME)

    @cached_property
    def _described(self) -> dict[str, Body]:
        return {body.name: body for body in self.bodies}

    @cached_property
    def place(self) -> dict[str, int]:
        """Index of a member in all arrays."""
        return {name: i for i, name in enumerate(self.members)}

    @cached_property
    def carriers(self) -> tuple[str, ...]:
        """The carrier of every mesh."""
        return tuple(self.carrier(mesh) for mesh in self.meshes)

    def bearer(self, name: str) -> str:
        """The member that bears the axis of this one; of the frame the frame."""
        body = self._described.get(name)
        return body.carrier if body else FRAME

    def count(self, name: str) -> int:
        """How many members of this name there are side by side."""
        body = self._described.get(name)
        return body.count if body else 1

    def tilted(self, name: str) -> bool:
        """Whether the member's speed is that on its own axis relative to its carrier."""
        body = self._described.get(name)
        return body is not None and body.tilted

    def sharing(self, name: str) -> float:
        """Load-sharing factor of a member [-]."""
        body = self._described.get(name)
        return body.sharing if body else 1.0

    def known(self, name: str) -> str:
        """The name, if there is such a member; raises `UsageError` with the known ones."""
        if name in self.place:
            return name
        raise UsageError(
            f"there is no member {name!r}", where=WHERE, remedy=f"members: {', '.join(self.members) or 'none'}"
        )

    def carrier(self, mesh: Mesh) -> str:
        """The member that keeps the axes of a mesh apart: it bears both, or one turns on its own axis.

        Raises `UsageError` if no member does.
        """
        first, second = self.bearer(mesh.first), self.bearer(mesh.second)
        if first == second:
            return first
        for carrier, other in ((second, first), (first, second)):
            if carrier != FRAME and self.bearer(carrier) == other:
                return carrier
        raise UsageError(
            f"no member keeps the axes of mesh {mesh} apart: they are borne by {first} and {second}",
            where=WHERE,
            remedy="wheels mesh on one carrier, or with a wheel that turns on the carrier's own axis",
        )
