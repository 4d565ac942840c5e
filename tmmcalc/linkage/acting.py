"""What acts on every link, by the names of load diagrams; all of them are known before a position is solved.

The index of a name is the link that it acts on and the link that it comes from:

    R_21   reaction in a revolute pair            N_50 F_50   normal force and friction in a prismatic pair
    G_4    weight       P_4  inertia force        M_21        friction moment;  M_4  inertia couple
    M_d    moment of the drive, F_d its force     F_mesh      mesh force

Loads, springs and dampers have names of their own, a damper that of its spring.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Literal

from tmmcalc.core.notes import Phrase
from tmmcalc.core.records import record
from tmmcalc.linkage.loading import GearDrive, Loading, Pair
from tmmcalc.linkage.model import FRAME, Joint, Mechanism
from tmmcalc.linkage.structure import Structure

Kind = Literal["load", "weight", "inertia", "spring", "damper", "reaction", "friction", "drive"]

LETTERS = {"weight": ("G", "G"), "inertia": ("P", "M")}  # of force and couple; others bear their own name
WORDS = {  # of force and couple
    "load": ("load", "moment"),
    "weight": ("weight", "weight"),
    "inertia": ("inertia force", "inertia couple"),
    "spring": ("spring", "spring"),
    "damper": ("damper", "damper"),
    "reaction": ("reaction", "couple"),
    "friction": ("friction force", "friction moment"),
    "drive": ("force of the drive", "moment of the drive"),
}


@record
class Acts:
    """A force or couple on a link by its name; ``joint`` of a reaction or friction."""

    link: int
    name: str
    kind: Kind
    couple: bool
    joint: str = ""

    @property
    def said(self) -> str:
        """What it is, in words."""
        kind = WORDS[self.kind][self.couple]
        if self.joint:
            return Phrase("{kind} {name} in {joint}", kind=kind, name=self.name, joint=self.joint)
        return Phrase("{kind} {name}", kind=kind, name=self.name)


def sides(joint: Joint, link: int) -> tuple[float, str]:
    """Sign of the stored reaction, which acts on the higher-numbered link; index of the force on this link."""
    other = joint.other(link)
    comma = "," if max(joint.links) > 9 else ""
    return (1.0 if link > other else -1.0), f"{link}{comma}{other}"


def acting_on(mechanism: Mechanism, structure: Structure, loading: Loading) -> tuple[Acts, ...]:
    """All that may act on the moving links, link by link: what is given, then reactions with friction, the drive."""
    given = [*_given(loading)]
    pairs = {pair.joint: pair for pair in loading.pairs}
    found: list[Acts] = []
    for link in mechanism.links:
        found += [each for each in given if each.link == link.id]
        for joint in mechanism.joints:
            if link.id in joint.links:
                found += _in_joint(joint, link.id, pairs.get(joint.name))
        found += _drive(mechanism, structure, loading, link.id)
    return tuple(found)


def told_apart(acting: Sequence[Acts]) -> list[str]:
    """Their names; those that share one are told apart by their kinds, and those of one kind by their links.

    >>> on = [Acts(5, "Q", "load", False), Acts(3, "Q", "load", False), Acts(3, "k", "spring", False)]
    >>> told_apart([*on, Acts(3, "k", "damper", False)])
    ['Q_5', 'Q_3', 'k_spring', 'k_damper']
    """
    names = [each.name for each in acting]
    for more in ("kind", "link"):
        own = [str(getattr(each, more)) for each in acting]
        differ = {name: {word for one, word in zip(names, own, strict=True) if one == name} for name in names}
        names = [f"{name}_{word}" if len(differ[name]) > 1 else name for name, word in zip(names, own, strict=True)]
    return names


def _given(loading: Loading) -> Iterator[Acts]:
    """Weights, loads, springs and dampers, inertia."""
    for body in loading.bodies:
        if body.mass > 0 and loading.gravity:
            yield Acts(body.link, f"G{body.link}", "weight", False)
    for load in loading.loads:
        for link in (load.link, load.against):
            if load.factor and link != FRAME:
                yield Acts(link, load.name, "load", load.kind == "moment")
    for spring in loading.springs:
        kinds: list[tuple[float, Kind]] = [(spring.stiffness, "spring"), (spring.damping, "damper")]
        for factor, kind in kinds:
            for link in spring.links:
                if factor and link != FRAME:
                    yield Acts(link, spring.name, kind, spring.kind == "torsion")
    for body in loading.heavy:
        force, couple = LETTERS["inertia"]
        if body.mass > 0:
            yield Acts(body.link, f"{force}{body.link}", "inertia", False)
        if body.inertia > 0:
            yield Acts(body.link, f"{couple}{body.link}", "inertia", True)


def _in_joint(joint: Joint, link: int, pair: Pair | None) -> Iterator[Acts]:
    """What a joint does to a link; a prismatic one has a couple where the arm of its normal force would be long."""
    index, pair = sides(joint, link)[1], pair or Pair(joint.name)
    if joint.kind == "revolute":
        yield Acts(link, f"R{index}", "reaction", False, joint.name)
        if pair.friction > 0 and pair.radius > 0:
            yield Acts(link, f"M{index}", "friction", True, joint.name)
        return
    yield Acts(link, f"N{index}", "reaction", False, joint.name)
    if pair.friction > 0:
        yield Acts(link, f"F{index}", "friction", False, joint.name)
    yield Acts(link, f"M{index}", "reaction", True, joint.name)


def _drive(mechanism: Mechanism, structure: Structure, loading: Loading, link: int) -> Iterator[Acts]:
    """What the drive does to the input link, or to the two links that it drives apart."""
    joint = mechanism.joint(mechanism.input.joint)
    if structure.driven is not None:
        if link in joint.links:
            yield Acts(link, "Fd", "drive", False)
    elif link == structure.input_link:
        if joint.kind == "prismatic":
            yield Acts(link, "Fd", "drive", False)
        elif isinstance(loading.drive, GearDrive):
            yield Acts(link, "Fmesh", "drive", False)
        else:
            yield Acts(link, "Md", "drive", True)
