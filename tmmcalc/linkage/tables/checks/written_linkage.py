"""The linkage of a spec as it is written: its links and joints as far as they can be read, the rest None."""

from __future__ import annotations

from functools import cached_property

from tmmcalc.core.records import record
from tmmcalc.spec.identifiers import NAME
from tmmcalc.spec.outline import Outline, Raw, is_integer, subtable, tables
from tmmcalc.spec.phrases import Path

FRAME = 0


@record
class WrittenLink:
    """A link as written: its index in the file, its id, and its points (own and centre of mass)."""

    index: int
    table: Raw
    id: int | None
    points: Raw | None

    @property
    def path(self) -> Path:
        """Place of the link in the document."""
        return ("mechanism", "links", self.index)


@record
class WrittenJoint:
    """A joint as written; ``pins`` are the names of a revolute joint's point on its two links."""

    index: int
    table: Raw
    name: str | None
    kind: str | None
    links: tuple[int, int] | None
    pins: tuple[str, str] | None

    @property
    def path(self) -> Path:
        """Place of the joint in the document."""
        return ("mechanism", "joints", self.index)

    @property
    def title(self) -> str:
        """The joint in a sentence: with its name, or by its number in the file."""
        return f'joint "{self.name}"' if self.name else f"joint number {self.index + 1}"

    def pin_on(self, link: int) -> str | None:
        """Return the name of a revolute joint's point on one of its links."""
        if self.links is None or self.pins is None:
            return None
        return self.pins[self.links.index(link)]


class WrittenLinkage:
    """``[mechanism]``."""

    def __init__(self, outline: Outline) -> None:
        self._document = outline.document

    @cached_property
    def table(self) -> Raw:
        """The mechanism."""
        return subtable(self._document, "mechanism")

    @cached_property
    def links(self) -> list[WrittenLink]:
        """The moving links in the order of the file."""
        return [_link(index, table) for index, table in tables(self.table, "links")]

    @cached_property
    def joints(self) -> list[WrittenJoint]:
        """The joints in the order of the file."""
        return [_joint(index, table) for index, table in tables(self.table, "joints")]

    @cached_property
    def ids(self) -> list[int]:
        """Ids of the frame and of the links that have one."""
        return sorted({FRAME, *(link.id for link in self.links if link.id is not None)})

    @cached_property
    def ids_complete(self) -> bool:
        """Whether every link has a number of its own: only then can a link be said to be absent."""
        listed = self.table.get("links")
        return isinstance(listed, list) and len(listed) == sum(id_ > FRAME for id_ in self.ids) > 0

    @cached_property
    def joints_complete(self) -> bool:
        """Whether every joint names two links that exist: only then can a link be said to be left out."""
        listed = self.table.get("joints")
        whole = isinstance(listed, list) and len(listed) == len(self.joints) > 0
        return whole and all(self.connects(joint) for joint in self.joints)

    @cached_property
    def points(self) -> dict[int, Raw | None]:
        """Points by link id, the frame under 0; None for a link whose points cannot be read."""
        fixed = self.table.get("fixed", {})
        found: dict[int, Raw | None] = {FRAME: fixed if isinstance(fixed, dict) else None}
        for link in self.links:
            if link.id is not None:
                found.setdefault(link.id, link.points)
        return found

    @cached_property
    def names(self) -> list[str]:
        """Names of all points of all links and the frame."""
        return sorted({name for points in self.points.values() if points for name in points})

    def connects(self, joint: WrittenJoint) -> bool:
        """Return whether a joint names two different links that exist."""
        return joint.links is not None and len({*joint.links} & {*self.ids}) == 2

    def is_pinned(self, joint: WrittenJoint) -> bool:
        """Return whether a joint is revolute and both its links have its pin."""
        if joint.links is None or joint.pins is None or not self.connects(joint):
            return False
        return all(self.has_point(link, pin) for link, pin in zip(joint.links, joint.pins, strict=True))

    def joint_named(self, name: str) -> WrittenJoint | None:
        """Return the first joint of this name."""
        return next((joint for joint in self.joints if joint.name == name), None)

    def has_point(self, link: int, name: str) -> bool:
        """Return whether a link has a point; True where its points cannot be read."""
        points = self.points.get(link)
        return points is None or name in points

    @cached_property
    def input_joint(self) -> WrittenJoint | None:
        """The joint of the input."""
        name = subtable(self.table, "input").get("joint")
        return self.joint_named(name) if isinstance(name, str) else None

    @property
    def slides(self) -> bool:
        """Whether the input is a driven slider."""
        return self.input_joint is not None and self.input_joint.kind == "prismatic"


def written_linkage(outline: Outline) -> WrittenLinkage:
    """The linkage, read once for all checks."""
    return outline.once(WrittenLinkage)


def link_words(link: int) -> str:
    """Return the words for a link: "link 3", or "the frame"."""
    return "the frame" if link == FRAME else f"link {link}"


def _link(index: int, table: Raw) -> WrittenLink:
    written, points = table.get("id"), table.get("points", {})
    id_ = written if is_integer(written) else None
    if not isinstance(points, dict):
        return WrittenLink(index, table, id_, None)
    centre = {f"S{id_}": table["center"]} if "center" in table and id_ is not None else {}
    return WrittenLink(index, table, id_, {**points, **centre})


def _joint(index: int, table: Raw) -> WrittenJoint:
    written, kind, pair = table.get("name"), table.get("kind"), table.get("links")
    name = written if isinstance(written, str) else None
    links = (pair[0], pair[1]) if isinstance(pair, list) and len(pair) == 2 and all(map(is_integer, pair)) else None
    kind = kind if isinstance(kind, str) else None
    return WrittenJoint(index, table, name, kind, links, _pins(table, name) if kind == "revolute" else None)


def _pins(table: Raw, name: str | None) -> tuple[str, str] | None:
    if "points" in table:
        pair = table["points"]
        both = isinstance(pair, list) and len(pair) == 2 and all(isinstance(pin, str) for pin in pair)
        return (pair[0], pair[1]) if both else None
    pin = table.get("point", name)
    # What is no name has that fault alone; a joint with a guide is prismatic, whatever its kind says.
    if not isinstance(pin, str) or not NAME.fullmatch(pin) or "guide" in table:
        return None
    return pin, pin
