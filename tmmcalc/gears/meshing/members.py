"""The wheels of the pairs of a project, each once, with what is needed to draw them; lengths in normal modules."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from math import pi
from typing import Literal

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.records import record
from tmmcalc.gears.involute.internal.ring import Ring
from tmmcalc.gears.involute.profile.flank import Flank, flank_of
from tmmcalc.gears.involute.profile.outline import Element, tooth
from tmmcalc.gears.involute.profile.ring import RingFlank, ring_flank
from tmmcalc.gears.involute.profile.rounding import ProfileError, Rounding, rounding
from tmmcalc.gears.involute.profile.rounding import Shape as Section
from tmmcalc.gears.involute.profile.shaping import ShapedRing, shaped_ring
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.meshing.geometry import external_pair, internal_pair, pinion_on_rack, wheel_of
from tmmcalc.gears.meshing.refusal import millimetres
from tmmcalc.gears.meshing.results import MeshPair, Pairs

Shape = Literal["external", "ring", "rack"]


class Toothed(ABC):
    """One wheel, ring or rack: how it is called, and its teeth as they are cut."""

    @property
    @abstractmethod
    def name(self) -> str:
        """The name of the wheel."""

    @property
    @abstractmethod
    def pair(self) -> str:
        """The name of its pair, empty for a single one, for a wheel that may be in several, and for one in none."""

    @property
    @abstractmethod
    def shape(self) -> Shape:
        """What it is."""

    @property
    @abstractmethod
    def module(self) -> float:
        """Normal module [m]."""

    @property
    @abstractmethod
    def wheel(self) -> Wheel:
        """An external wheel as its rack cuts it; of a ring the wheel whose teeth fill its spaces; a rack's pinion."""

    @property
    @abstractmethod
    def ring(self) -> Ring:
        """The ring, of a member that is one."""

    @property
    @abstractmethod
    def tip(self) -> float:
        """Radius of the tip circle; of a rack the height of its tip line above the datum line."""

    @property
    @abstractmethod
    def fillet(self) -> Section:
        """Section of the rounding of its rack across helical teeth."""

    @property
    @abstractmethod
    def shift(self) -> float:
        """Its shift; of a ring with the sign of ISO 21771."""

    @property
    @abstractmethod
    def angle(self) -> float:
        """Operating transverse pressure angle [rad]; without a mate that of its rack."""

    @property
    def label(self) -> str:
        """Both names, as files and flags have them."""
        return f"{self.pair}/{self.name}" if self.pair else self.name

    @property
    def flank(self) -> Flank:
        """The flank of an external wheel; raises `NoSolutionError` where no tooth is left."""
        with self.told():
            return flank_of(self.wheel, self.tip, self.fillet)

    @property
    def ring_flank(self) -> RingFlank | ShapedRing:
        """The flank of a ring, beside a space; raises `NoSolutionError` if no involute is left."""
        with self.told():
            ring = self.ring
            if ring.cutter is not None:
                return shaped_ring(ring, ring.cutter, self.tip)
            return ring_flank(self.wheel, self.tip, ring.root)

    @property
    def tool(self) -> Rounding:
        """The tip of the basic rack: what fills the spaces of a rack."""
        return rounding(replace(self.wheel, shift=0.0), self.fillet)

    @property
    def element(self) -> Element:
        """A tooth of an external wheel, a space of a ring, on +Y; raises `NoSolutionError` if there is none."""
        with self.told():
            return self.ring_flank.element if self.shape == "ring" else tooth(self.flank)

    @contextmanager
    def told(self) -> Iterator[None]:
        """Let errors about the tooth name the wheel, and say lengths in millimetres."""
        where = f"wheel {self.label}"
        try:
            yield
        except NoSolutionError as error:
            if error.where == where:
                raise
            text, (value, limit) = error.message, (error.value, error.limit)
            if isinstance(error, ProfileError):
                value, limit = (self.module * length for length in error.lengths)
                text = f"{error.what}: {millimetres(value)} against {millimetres(limit)}"
            raise NoSolutionError(text, where=where, value=value, limit=limit, remedy=error.remedy) from None

    @property
    def half_pitch(self) -> float:
        """Half the angle [rad] from tooth to tooth; of a rack half its transverse pitch."""
        return pi / 2 * self.wheel.section.module if self.shape == "rack" else pi / self.wheel.teeth


@record
class Member(Toothed):
    """One wheel, ring or rack of a pair."""

    found: MeshPair
    place: int  # 0: first, 1: second of the pair
    apart: bool = False  # its name is enough to tell it from all others, as in a train

    @property
    def name(self) -> str:
        """The name of the wheel."""
        return self.found.task.wheels[self.place]

    @property
    def pair(self) -> str:
        """The name of the pair, empty for a single one and for a wheel that may be in several."""
        return "" if self.apart else self.found.task.name

    @property
    def shape(self) -> Shape:
        """What it is."""
        kind = self.found.task.kind
        if self.place == 0 or kind == "external":
            return "external"
        return "ring" if kind == "internal" else "rack"

    @property
    def module(self) -> float:
        """Normal module [m]."""
        return self.found.task.module

    @property
    def wheel(self) -> Wheel:
        """An external wheel as its rack cuts it; of a ring the wheel whose teeth fill its spaces; a rack's pinion."""
        if self.shape == "ring":
            ring = self.ring
            return Wheel(ring.teeth, -ring.shift, ring.helix, ring.rack)
        place = 0 if self.shape == "rack" else self.place
        return wheel_of(self.found.task, place + 1, self.found.shifts[place])

    @property
    def ring(self) -> Ring:
        """The ring of an internal pair."""
        return internal_pair(self.found).ring

    @property
    def tip(self) -> float:
        """Radius of the tip circle; of a rack the height of its tip line above the datum line."""
        kind = self.found.task.kind
        if kind == "rack":
            rack = pinion_on_rack(self.found)
            return rack.tip if self.place == 0 else rack.addendum
        pair = external_pair(self.found) if kind == "external" else internal_pair(self.found)
        return float(pair.tips[self.place])

    @property
    def fillet(self) -> Section:
        """Section of the rounding of its rack across helical teeth."""
        return self.found.task.fillet

    @property
    def shift(self) -> float:
        """Its shift."""
        return float(self.found.shifts[self.place])

    @property
    def angle(self) -> float:
        """Operating transverse pressure angle [rad] of the pair."""
        return self.found.angle_w


def both(found: MeshPair) -> tuple[Member, Member]:
    """The members of one pair."""
    return Member(found, 0), Member(found, 1)


def members(found: Pairs) -> tuple[Member, ...]:
    """All of them; a wheel of a train that is in several meshes once."""
    return tuple(_distinct(found))


def _distinct(found: Pairs) -> Iterator[Member]:
    seen: set[str] = set()
    for pair in found.pairs:
        for member in both(pair):
            if not found.train:
                yield member
            elif member.name not in seen:
                seen.add(member.name)
                yield replace(member, apart=True)
