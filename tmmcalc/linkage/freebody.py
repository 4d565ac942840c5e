"""Free bodies of one position: everything that acts on each group and on the input link (textbook 3.2, fig. 3.3).

Names are those of `acting`. The forces of a group stand in the order in which they close its polygon: those given on
link a, those given on link b, the outer reaction of b, the outer reaction of a. The inner reaction is then a chord of
the polygon.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.records import record
from tmmcalc.linkage.acting import LETTERS, Kind, sides
from tmmcalc.linkage.forces.kinetostatics import ForceState, Statics
from tmmcalc.linkage.forces.wrench import Seat, Slideway, Wrench
from tmmcalc.linkage.loading import GearDrive
from tmmcalc.linkage.loads.sources import Action, Place, Source
from tmmcalc.linkage.model import Joint
from tmmcalc.linkage.structure import Group

NOTHING = 1e-9  # what is smaller than this part of the largest is left out
FAR, ENDLESS = 0.3, 100.0  # an arm longer than so many reaches of the mechanism is a couple: drawn, and in equations


@record
class Acting:
    """A force on a link: its name in letter and index, where its line passes, the vector [N].

    ``joint`` of a reaction; ``arm`` h of a normal force from the slider's point along the line [m].
    """

    letter: str
    index: str
    kind: Kind
    link: int
    at: complex
    value: complex
    joint: str = ""
    arm: float | None = None


@record
class Couple:
    """A couple on a link [N*m], and the point that it is drawn about."""

    letter: str
    index: str
    kind: Kind
    link: int
    at: complex
    value: float
    joint: str = ""


@record
class FreeBody:
    """A dyad, a link of a higher group, or the input link, cut out: forces in the order of the polygon, couples.

    ``inner`` is the reaction of link a on link b of a group; its chord leads from the vertex after ``closing``
    forces to the vertex after ``parting`` forces.
    """

    name: str
    links: tuple[int, ...]
    forces: tuple[Acting, ...]
    couples: tuple[Couple, ...]
    inner: Acting | None = None
    parting: int = 0  # forces given on link a
    closing: int = 0  # and those given on link b with the outer reaction of b

    @property
    def vertices(self) -> np.ndarray[Any, Any]:
        """Vertices of the force polygon (m + 1,) [N]: it starts at 0 and must end there."""
        return np.concatenate(([0j], np.cumsum([force.value for force in self.forces])))


@record
class Known:
    """A force or a couple over n positions that is known before bodies are cut, as `Acting` and `Couple` have it."""

    letter: str
    index: str
    kind: Kind
    link: int
    at: list[complex]
    value: list[complex]
    couple: bool = False


class Held(NamedTuple):
    """What a joint does to its higher-numbered link over n positions; ``e`` of a prismatic one."""

    r: list[complex]
    e: list[complex] | None
    force: list[complex]
    moment: list[float]


class Solved(NamedTuple):
    """A mechanism at n positions with all that acts there."""

    statics: Statics
    place: Place
    state: ForceState
    given: dict[int, list[Known]]  # by link; of each source the force and the couple
    drive: dict[int, list[Known]]
    held: dict[str, Held]
    reach: list[float]  # of the joints from the first of them

    @property
    def known(self) -> Iterator[Known]:
        """What is no reaction, link by link."""
        for link, given in self.given.items():
            yield from (*given, *self.drive.get(link, ()))


def solved(statics: Statics, theta: Real, side: Real) -> Solved:
    """All that acts at theta (n,); where friction jumps ``side`` (n,) -1 is the limit before, +1 after."""
    place, speed = statics.scene.place(theta, side), statics.scene.travel.speed
    state = statics.solve(place, side)
    over = _Over(statics, place, state, len(theta))
    given: dict[int, list[Known]] = {link.id: [] for link in over.mechanism.links}
    for source in statics.sources:
        for action in source.actions(place):
            given[action.link] += over.acted(source, action, source.factor(speed))
    held = {name: over.held(reaction.seat, reaction.wrench) for name, reaction in state.reactions.items()}
    seats = np.array([each.r for each in held.values()])
    reach = np.abs(seats - seats[0]).max(axis=0).tolist()
    return Solved(statics, place, state, given, over.driven(), held, reach)


class _Over:
    """A mechanism at n positions while what acts there is put down for all of them."""

    def __init__(self, statics: Statics, place: Place, state: ForceState, count: int) -> None:
        self.statics, self.place, self.state, self.count = statics, place, state, count
        self.mechanism = statics.scene.chain.mechanism

    def _all(self, z: Any) -> Plane:
        """The values (n,) of what may be the same at all positions."""
        return np.broadcast_to(np.ravel(np.asarray(z, complex)), self.count)

    def acted(self, source: Source, action: Action, factor: float) -> Iterator[Known]:
        """The force and the couple of an action, so many times."""
        kind: Any = source.kind
        index = str(action.link) if kind in LETTERS else ""
        force, couple = LETTERS.get(kind, (source.name, source.name))
        at, moment = self._all(action.at.r), self._all(action.moment).real
        about = at if kind == "inertia" else self._middle(action.link)
        values = (self._all(action.force) * factor).tolist()
        yield Known(force, index, kind, action.link, at.tolist(), values)
        yield Known(couple, index, kind, action.link, about.tolist(), (moment * factor).tolist(), couple=True)

    def _middle(self, link: int) -> Plane:
        """The middle of a link's joints, where a moment that has no point is drawn."""
        own = [self.state.reactions[joint.name].seat.r for joint in self.mechanism.joints if link in joint.links]
        return np.sum([self._all(r) for r in own], axis=0) / len(own)

    def held(self, seat: Seat, wrench: Wrench) -> Held:
        """What a joint does."""
        e = self._all(seat.e).tolist() if isinstance(seat, Slideway) else None
        moment = self._all(wrench.moment).real.tolist()
        return Held(self._all(seat.r).tolist(), e, self._all(wrench.force).tolist(), moment)

    def driven(self) -> dict[int, list[Known]]:
        """What the drive does to the input link, or to the two links that it drives apart."""
        structure, joint = self.statics.scene.chain.structure, self.statics.scene.chain.input_joint
        if structure.driven is None:
            link = structure.input_link
            return {link: [self._drive(link, joint)]}
        return {link: [self._push(link, joint)] for link in joint.links}

    def _drive(self, link: int, joint: Joint) -> Known:
        """What the drive does to the input link."""
        pivot, drive = self._all(self.state.reactions[joint.name].seat.r), self._all(self.state.drive).real
        if joint.kind == "prismatic":
            along = self._all(self.place.configuration.motions[link].v)  # unit vector of the positive coordinate
            return Known("F", "d", "drive", link, pivot.tolist(), (drive * along).tolist())
        gear = self.statics.scene.loading.drive
        if isinstance(gear, GearDrive) and self.state.mesh is not None:
            at = pivot + gear.radius * complex(np.exp(1j * gear.pinion))
            return Known("F", "mesh", "drive", link, at.tolist(), self._all(self.state.mesh).tolist())
        return Known("M", "d", "drive", link, pivot.tolist(), drive.tolist(), couple=True)

    def _push(self, link: int, joint: Joint) -> Known:
        """What the drive of a driven length does to a link: it pushes the slider ahead, and the guide back."""
        seat = self.state.reactions[joint.name].seat
        assert isinstance(seat, Slideway)
        ahead = 1.0 if link == joint.links[0] else -1.0
        force = ahead * self._all(self.state.drive).real * self._all(seat.e)
        return Known("F", "d", "drive", link, self._all(seat.r).tolist(), force.tolist())


def free_bodies(statics: Statics, theta: float, side: float) -> tuple[FreeBody, ...]:
    """The input link, every dyad and every link of higher groups at theta.

    Where friction jumps, ``side`` -1 is the limit before, +1 after.
    """
    return bodies_at(solved(statics, np.array([theta]), np.array([side])), 0)


def bodies_at(found: Solved, row: int) -> tuple[FreeBody, ...]:
    """`free_bodies` at one of the positions."""
    cut = _Cut(found, row, FAR)
    structure = found.statics.scene.chain.structure
    bodies = [] if structure.driven else [cut.input_link()]
    for group in structure.groups:
        bodies += [cut.dyad(group)] if group.kind else [cut.alone(f"{group.name}, {k}", k) for k in group.links]
    return cleared(bodies, NOTHING)


def link_bodies(found: Solved, row: int) -> tuple[FreeBody, ...]:
    """Every moving link by itself at one of the positions with all that acts on it, however small."""
    cut = _Cut(found, row, ENDLESS)
    structure = found.statics.scene.chain.structure
    whole = None if structure.driven else structure.input_link
    links = [link.id for link in cut.mechanism.links]
    return tuple(cut.input_link() if k == whole else cut.alone(f"link {k}", k) for k in links)


def cleared(bodies: Sequence[FreeBody], part: float) -> tuple[FreeBody, ...]:
    """The bodies without forces and couples smaller than this part of the largest of their kind."""
    force = max((abs(f.value) for body in bodies for f in body.forces), default=0.0)
    couple = max((abs(c.value) for body in bodies for c in body.couples), default=0.0)
    return tuple(_without(body, part * force, part * couple) for body in bodies)


def _without(body: FreeBody, force: float, couple: float) -> FreeBody:
    counts = [abs(f.value) > force for f in body.forces]
    return replace(
        body,
        forces=tuple(f for f, kept in zip(body.forces, counts, strict=True) if kept),
        couples=tuple(c for c in body.couples if abs(c.value) > couple),
        parting=sum(counts[: body.parting]),
        closing=sum(counts[: body.closing]),
    )


class _Cut:
    """The mechanism at one position while it is cut into free bodies."""

    def __init__(self, found: Solved, row: int, far: float) -> None:
        self.found, self.row, self.far = found, row, far
        self.chain = found.statics.scene.chain
        self.mechanism = self.chain.mechanism

    def _here(self, known: Sequence[Known]) -> list[Acting | Couple]:
        """What is known, at the position."""
        row, found = self.row, list[Acting | Couple]()
        for each in known:
            name = (each.letter, each.index, each.kind, each.link, each.at[row])
            value = each.value[row]
            found.append(Couple(*name, value.real, "") if each.couple else Acting(*name, value, "", None))
        return found

    def alone(self, name: str, link: int) -> FreeBody:
        """A link that is not the input link with its loads, all its reactions, and the drive if it acts on it."""
        parts = [*self._loads(link, set()), *self._here(self.found.drive.get(link, ()))]
        forces = tuple(x for x in parts if isinstance(x, Acting))
        return FreeBody(name, (link,), forces, tuple(x for x in parts if isinstance(x, Couple)))

    def dyad(self, group: Group) -> FreeBody:
        """A dyad with the loads of its links, the reactions of what hangs on them, and its outer reactions."""
        a, b = group.links
        inner = self.mechanism.joint(group.inner[0])
        outer_a, outer_b = (self.mechanism.joint(name) for name in group.outer)
        own = {inner.name, outer_a.name, outer_b.name}
        parts = [self._loads(a, own), self._loads(b, own), self._reaction(outer_b, b), self._reaction(outer_a, a)]
        forces = [[x for x in part if isinstance(x, Acting)] for part in parts]
        parting, closing = len(forces[0]), sum(map(len, forces[:3]))
        return FreeBody(
            group.name,
            group.links,
            tuple(x for part in forces for x in part),
            tuple(x for part in parts for x in part if isinstance(x, Couple)),
            self._whole(inner, b),
            parting,
            closing,
        )

    def input_link(self) -> FreeBody:
        """The input link with its loads, the reactions of the groups, the drive, and the reaction of the frame."""
        link, joint = self.chain.structure.input_link, self.chain.input_joint
        drive = self._here(self.found.drive[link])
        parts = [*self._loads(link, {joint.name}), *drive, *self._reaction(joint, link)]
        forces = tuple(x for x in parts if isinstance(x, Acting))
        return FreeBody(f"I(0,{link})", (link,), forces, tuple(x for x in parts if isinstance(x, Couple)))

    def _loads(self, link: int, own: set[str]) -> list[Acting | Couple]:
        """What is given on a link: its loads, and the reactions in all joints but its group's own."""
        found = self._here(self.found.given[link])
        for joint in self.mechanism.joints:
            if link in joint.links and joint.name not in own:
                found += self._reaction(joint, link)
        return found

    def _whole(self, joint: Joint, link: int) -> Acting:
        """The whole force in a joint on a link."""
        sign, index = sides(joint, link)
        held, row = self.found.held[joint.name], self.row
        return Acting("R", index, "reaction", link, held.r[row], sign * held.force[row], joint.name, None)

    def _reaction(self, joint: Joint, link: int) -> list[Acting | Couple]:
        """Force and friction moment of a revolute pair on a link; normal force, friction, couple of a prismatic one."""
        sign, index = sides(joint, link)
        held, row = self.found.held[joint.name], self.row
        at, moment = held.r[row], sign * held.moment[row]
        if held.e is None:
            return [self._whole(joint, link), Couple("M", index, "friction", link, at, moment, joint.name)]
        e, force = held.e[row], sign * held.force[row]
        normal, along = ((1j * e).conjugate() * force).real, (e.conjugate() * force).real
        size = self.found.reach[row] * abs(normal)
        near = abs(moment) <= self.far * size
        arm = moment / normal if near and abs(moment) > NOTHING * size else 0.0
        parts: list[Acting | Couple] = [
            Acting("N", index, "reaction", link, at + arm * e, normal * 1j * e, joint.name, arm if near else None),
            Acting("F", index, "friction", link, at, along * e, joint.name, None),
        ]
        return parts if near else [*parts, Couple("M", index, "reaction", link, at, moment, joint.name)]
